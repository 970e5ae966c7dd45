// The environment of a medium's process, from which it learns of the user's desktop.
// A process with windows of its own: the display, the theme, scale, input method and language, so
// that its windows look and type like all others. A confined one: nothing, but a path and a locale.
// Numbers are C's in both: numbers that users and programs read in a scene have points.
#pragma once

#include "ipc/messages.h"

#include <string>
#include <vector>

namespace media {

// NAME=value, from this process's own environment.
[[nodiscard]] std::vector<std::string> environmentFor(ipc::Mode mode);

} // namespace media
