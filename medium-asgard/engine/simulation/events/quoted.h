// Names as sentences show them.
#pragma once

#include <string>

namespace simulation {

[[nodiscard]] inline std::string quoted(const std::string& name) { return "\"" + name + "\""; }

} // namespace simulation
