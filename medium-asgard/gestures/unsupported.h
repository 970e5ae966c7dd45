// Which bodies fall through the grid, as no floor is there? Is there nothing that moves any body?
//
// The grid shows places and holds nothing. A ball that is put on it has its lowest point at height
// 0; with a weight, and with no floor, it leaves the picture at once. One that rolls off a table
// leaves it later.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace gestures {

// Bodies with a weight that no joint, link, rope or path holds, of a scene without an endless
// floor. They start on the grid, and at the end of the motion they fall below it; or they start
// above it in a scene of fixed, led or held bodies, and fall far below all of these. `motion`: null
// while there is none; then those on the grid count that have none of these bodies below.
[[nodiscard]] std::vector<std::size_t> unsupported(const scene::Scene& scene,
                                                   const simulation::Motion* motion);

// There are bodies that could move, all of them rest, and nothing acts that would move one.
[[nodiscard]] bool nothingMoves(const scene::Scene& scene);

// Nothing acts that would move a body, and yet there is a fixed one, and a free one that a weight
// would pull down: it hangs in the air, lies on another one, or moves up or down.
[[nodiscard]] bool lacksWeight(const scene::Scene& scene);

} // namespace gestures
