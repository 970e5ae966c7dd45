// The value of an element's option in a scene, if it is made of numbers.
#pragma once

#include "editing/element.h"

#include <optional>
#include <vector>

namespace editing {

// None: expressions that change, options without numbers. An option that is not in the text has its
// default.
[[nodiscard]] std::optional<std::vector<double>>
valuesOf(const scene::Scene& scene, const Element& element, const std::string& option);

} // namespace editing
