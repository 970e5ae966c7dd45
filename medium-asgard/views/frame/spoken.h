// The words of a screen reader for fields that show a value: their name and the value.
#pragma once

namespace views {

// From now on, of all widgets that are asked for. Once is enough.
void speakValues();

} // namespace views
