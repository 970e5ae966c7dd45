// How far inside or beside a convex outline does something lie? All places are taken along the
// normal of the outline's plane.
#pragma once

#include "geometry/pose.h"

#include <vector>

namespace geometry {

// Of a point; negative: it lies outside. The vertices go around the normal, either way.
[[nodiscard]] double depthInside(const std::vector<Vector>& outline, const Vector& normal,
                                 const Vector& point);

// Of a vertex, an edge or a face, by its vertices; 0: some of it is over the outline.
[[nodiscard]] double besideOutline(const std::vector<Vector>& feature,
                                   const std::vector<Vector>& outline, const Vector& normal);

} // namespace geometry
