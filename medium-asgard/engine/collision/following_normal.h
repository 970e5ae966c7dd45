// How must a direction turn to stay the normal of what touches?
//
// The distance of two parts is that along the line of closest points, and no smaller than along any
// other. Where a face, an edge or a side touches, it juts out beyond a direction that stands still
// as soon as it turns. Along a direction that turns with it, its points rise and fall by second
// order alone: the normal of a face turns with the face; that of an edge, or of the line in which a
// side touches, stays across it (feature.h); of two edges, across both.
#pragma once

#include "collision/part_motion.h"

#include <optional>

namespace collision {

// The angular velocity at which the direction `normal` (a unit vector from the second part towards
// the first, along which they are nearest at t) follows what touches; nothing: no feature wants it
// to turn.
[[nodiscard]] std::optional<Vector> followingTurn(const PartPair& pair, const Vector& normal,
                                                  double t);

} // namespace collision
