// Which way are numbers written here? With points, whatever the user's language is: what stands in
// a scene, a table or a field is read again by programs and by people of other languages.
#pragma once

namespace screen {

// Makes LC_NUMERIC C in this process's environment and leaves the rest of the user's language. Call
// it before Qt is started, which takes its locale from there, and before there are threads.
void keepNumbersC();

} // namespace screen
