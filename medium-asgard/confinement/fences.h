// The fences one by one; confinement.h says what they are for. Each returns why it is not in force,
// or nothing.
#pragma once

#include "confinement/confinement.h"

#include <string>

namespace confinement {

[[nodiscard]] std::string setLimits(Role role, const Limits& limits);
[[nodiscard]] std::string dropPrivileges(Role role);
[[nodiscard]] std::string forbidPaths(Role role, int& landlockVersion);
[[nodiscard]] std::string filterCalls(Role role);

} // namespace confinement
