// What does a medium's process learn of the user's desktop?
// One with windows of its own: the display, the theme, scale, input method and language, so that
// its windows look and type like all others. A confined one: nothing, but a path and a locale.
// Numbers are C's in both: what users and programs read in a scene has points.
#pragma once

#include "ipc/messages.h"

#include <string>
#include <vector>

namespace media {

// NAME=value, from this process's own environment.
[[nodiscard]] std::vector<std::string> environmentFor(ipc::Mode mode);

} // namespace media
