// Which bodies stand on the grid alone, and fall through it? Is there nothing that moves any body?
//
// The grid shows places and holds nothing. A ball that is put on it has its lowest point at height
// 0; with a weight, and with no floor, it leaves the picture at once.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace gestures {

// Bodies with a weight whose lowest point is at height 0 where they start, that nothing holds, and
// that have no fixed or led body below.
[[nodiscard]] std::vector<std::size_t> unsupported(const scene::Scene& scene);

// There are bodies that could move, all of them rest, and nothing acts that would move one.
[[nodiscard]] bool nothingMoves(const scene::Scene& scene);

} // namespace gestures
