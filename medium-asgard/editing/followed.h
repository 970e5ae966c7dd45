// Selected elements stay selected while the text changes.
#pragma once

#include "editing/changes.h"

namespace editing {

// The elements that those of the scene before are now; what is gone is left out, what has another
// name at its place is there still.
[[nodiscard]] std::vector<Element> followed(const std::vector<Element>& elements,
                                            const Reading& before, const Reading& after,
                                            const std::vector<Renamed>& renamed);

} // namespace editing
