// Can this process open a window?
//
// Told by the environment as X11 and Wayland read it, and by asking whether anything listens where
// it points to. A display of another machine is taken at its word.
#pragma once

#include <functional>
#include <string>

namespace screen {

using Environment = std::function<std::string(const char* name)>; // "" where it is not set

// "" when windows can be opened, else why not: "there is no display to open a window on",
// "the display :7 does not answer".
[[nodiscard]] std::string displayFault(const Environment& environment);
[[nodiscard]] std::string displayFault(); // of this process

} // namespace screen
