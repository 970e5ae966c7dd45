// Planes that a piece of a solid could be cut by.
#pragma once

#include "meshes/clipping.h"

namespace meshes {

// Along the faces beside concave edges, and through those edges in the middle between the faces;
// those with most of such edges first, of those in one plane one.
[[nodiscard]] std::vector<Plane> concavePlanes(const Solid& solid, std::size_t most);

// Those of them that pass through the piece's points, and some across the axes.
[[nodiscard]] std::vector<Plane> cutsOf(const std::vector<Vector>& points,
                                        const std::vector<Plane>& concave, double tolerance);

} // namespace meshes
