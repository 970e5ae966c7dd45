// The keys and gestures of a language viewer, for Help.
#pragma once

#include <QString>

namespace views {

[[nodiscard]] QString languageKeys(); // rich text

} // namespace views
