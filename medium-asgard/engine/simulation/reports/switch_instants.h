// At which instants does an expression of the scene switch: a comparison, ?:, abs, sign, min, max,
// floor or ceil that a body's rates read?
//
// The solver ends a step at each switch, so the branches that a step's middle implies change where
// one is. LIMIT: expressions that read coordinates or forces of joints, springs, ropes or contacts
// are left out; so is what switches to and fro within one step.
#pragma once

#include "motion/computed_motion.h"
#include "scene/scene.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace simulation {

// By body, of those that have equations.
[[nodiscard]] std::vector<std::pair<double, std::size_t>>
switchInstants(const scene::Scene& scene, const ComputedMotion& motion);

} // namespace simulation
