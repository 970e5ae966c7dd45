// The unit of an option's value, for forms. Lengths, times and masses are in any units that go
// together; these are the ones that samples and words of the programs take.
#pragma once

#include "editing/element.h"

#include <string>
#include <string_view>

namespace editing {

// "m/s"; "": it has none, or one that follows from what else the element says.
[[nodiscard]] std::string_view unitOf(const scene::Scene& scene, const Element& element,
                                      std::string_view option);

} // namespace editing
