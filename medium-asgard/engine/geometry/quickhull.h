// Quickhull on triangles with exact decisions; hull.h merges its triangles into faces.
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace geometry {

using Triangle = std::array<std::size_t, 3>; // counter-clockwise seen from outside

struct Triangulation {
    std::vector<Triangle> triangles;
    std::vector<std::array<std::size_t, 3>> across; // the triangle beyond each edge corner i -> i+1
    std::size_t visits = 0; // how often a point was asked whether it sees a triangle
};

// The boundary of the hull of distinct grid points (predicates.h). `first` are four of them that
// are not in one plane. `meanwhile` is called once in some thousand visits, and may throw.
[[nodiscard]] Triangulation quickhull(const std::vector<Vector>& points,
                                      std::array<std::size_t, 4> first,
                                      const std::function<void()>& meanwhile = {});

} // namespace geometry
