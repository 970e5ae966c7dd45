// A sphere, the end of a capsule or a vertex touches one piece of a hollow part, inside of it
// (geometry/hollow.h); a sphere outside, too.
#pragma once

#include "surfaces/piece_touch.h"

namespace simulation {

// A sphere, an end of a capsule or a vertex, by its number, and a hollow part.
[[nodiscard]] PieceTouch vertexAtWall(const Placed& body, std::size_t bodyPart,
                                      const Placed& support, std::size_t supportPart,
                                      std::size_t vertex);

} // namespace simulation
