// Copies put into a scene where one sees them.
#pragma once

#include "element_edits/copying.h"

namespace gestures {

// Bodies stand where their commands say, and where they would be inside of others, beside: at the
// first place along x that has room, by steps as wide as those of the scene that have their names.
// `added` has the bodies alone, if there are any: one goes on with them.
[[nodiscard]] editing::Pasted pastedBeside(const std::string& text, const scene::Scene& scene,
                                           const std::string& commands);

} // namespace gestures
