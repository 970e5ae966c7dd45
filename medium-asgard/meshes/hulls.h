// Hulls of many points, fewer of their points, and their volumes.
#pragma once

#include "geometry/hull.h"

namespace meshes {

using geometry::Vector;

// The vertices alone; empty for points in a plane.
[[nodiscard]] std::vector<Vector> hullPoints(const std::vector<Vector>& points);
[[nodiscard]] double volumeOf(const geometry::Polyhedron& polyhedron);
// Those furthest in so many directions all around, where there are more: nearly the same hull in
// less time.
[[nodiscard]] std::vector<Vector> extremes(const std::vector<Vector>& points,
                                           std::size_t directions);

} // namespace meshes
