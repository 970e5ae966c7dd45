// The value of an element's option in a scene, if it is made of numbers or names another element.
#pragma once

#include "editing/element.h"

#include <optional>
#include <string>
#include <vector>

namespace editing {

// None: expressions that change, options without numbers. An option that is not in the text has its
// default.
[[nodiscard]] std::optional<std::vector<double>>
valuesOf(const scene::Scene& scene, const Element& element, const std::string& option);

// The name that an option gives of a body, shape set, trajectory or joint. None: it gives none.
[[nodiscard]] std::optional<std::string> namedBy(const scene::Scene& scene, const Element& element,
                                                 const std::string& option);

} // namespace editing
