// A link that its author may have meant as a joint (docs/scene-language.md, "Links").
#pragma once

#include "simulation/simulation.h"

#include <string>

namespace batch {

// Of the links that are closed at the start, as a pin is, the one that stretched most, where that
// is more than `allowed`: a sentence with a joint in its place. Empty: there is none.
[[nodiscard]] std::string softLinkLine(const scene::Scene& scene,
                                       const simulation::MotionPointer& motion, double allowed);

} // namespace batch
