// The integrators by their names.
#pragma once

#include "integrators/method.h"

#include <memory>
#include <string>
#include <vector>

namespace solution {

// Every name that there is a method for.
[[nodiscard]] const std::vector<std::string>& methodNames();

// The method of that name; null for an unknown one.
[[nodiscard]] std::unique_ptr<Method> makeMethod(const std::string& name, System& system,
                                                 ErrorControl& control, bool fixed);

} // namespace solution
