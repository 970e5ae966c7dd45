// The plain event loop of a medium's process: two pipes, a session, nothing else.
#pragma once

#include "service/session.h"

namespace service {

// Serves a host over the two descriptors until it says exit, its end of the pipe closes, or it
// sends what is not the protocol (then a sentence goes to standard error). Returns the exit code.
[[nodiscard]] int serve(Platform platform, int input, int output);

} // namespace service
