// Quantities of a whole scene: energy, momentum, angular momentum (command lines, "simulate").
//
//     energy = kinetic energy of the bodies that are neither fixed nor held
//              - m g.r for each -gravitational force, r being the point that it acts on
//              + k |d|²/2 for each link, and k (|d| - L)²/2 for each spring while it acts
// Momenta are those of the bodies that are neither fixed nor held, angular momentum about the
// origin. A body counts as held while a trajectory holds any part of its state.
#pragma once

#include "physics/equations_of_motion.h"

namespace physics {

[[nodiscard]] SceneNodes sceneNodes(EquationsOfMotion& motion, const scene::Scene& scene);

} // namespace physics
