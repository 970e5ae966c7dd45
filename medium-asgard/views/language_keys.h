// What keys and pointer do in a language viewer: Help tells it.
#pragma once

#include <QString>

namespace views {

[[nodiscard]] QString languageKeys(); // rich text

} // namespace views
