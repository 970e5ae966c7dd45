// What a screen reader is told of fields that show a value: their name and the value.
#pragma once

namespace views {

// From now on, of all widgets that are asked for. Once is enough.
void speakValues();

} // namespace views
