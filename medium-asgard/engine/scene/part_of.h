// Some bodies of a scene with all that they move by, as a scene of its own.
#pragma once

#include "scene/difference.h"

#include <vector>

namespace scene {

// The chosen bodies in the scene's order, with the shapes, forces, links, joints, gears, ropes,
// constraints, trajectories and parameters that they need and the scene's simulator. Whole groups
// of moving bodies (connections.h) and the fixed ones that they read must be chosen. Forces on
// fixed bodies are left out: they move nothing.
[[nodiscard]] Scene partOf(const Version& version, const std::vector<std::size_t>& bodies);

} // namespace scene
