// Copies put into a scene where one sees them.
#pragma once

#include "element_edits/copying.h"

namespace gestures {

// Commands of bodies stand beside those that have their names, along x. What is added are the
// bodies, where there are any: one goes on with them.
[[nodiscard]] editing::Pasted pastedBeside(const std::string& text, const scene::Scene& scene,
                                           const std::string& commands);

} // namespace gestures
