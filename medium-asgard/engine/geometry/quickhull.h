// Quickhull on triangles with exact decisions; hull.h merges its triangles into faces.
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstddef>
#include <vector>

namespace geometry {

using Triangle = std::array<std::size_t, 3>; // counter-clockwise seen from outside

// The boundary of the hull of distinct grid points (predicates.h). `first` are four of them that
// are not in one plane.
[[nodiscard]] std::vector<Triangle> quickhull(const std::vector<Vector>& points,
                                              std::array<std::size_t, 4> first);

} // namespace geometry
