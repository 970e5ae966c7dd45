// The convex hull of points, as a polyhedron with maximal faces, or the reason why there is none.
//
// Quickhull (Barber, Dobkin, Huhdanpaa 1996) on triangles, every decision made by the exact
// predicate (predicates.h), so that degenerate input cannot make it inconsistent; then triangles
// that lie in one plane within `flatness` times the size of the points become one polygon.
// Why not the qhull library: docs/decisions, "Convex hulls".
#pragma once

#include "geometry/polyhedron.h"

#include <cstddef>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace geometry {

struct Hull {
    Polyhedron polyhedron;
    std::vector<std::size_t> sources; // of each vertex: the first input point at that place
};

struct HullRefusal {
    std::string sentence; // without a full stop, to follow the name of what was read
};

inline constexpr double flatness = 1e-12;         // of the size: this far from a plane is in it
inline constexpr double smallestThickness = 1e-9; // of the size: flatter than this is refused
inline constexpr std::size_t mostHullPoints = 100'000;

// `meanwhile` is called every now and then, and may throw.
[[nodiscard]] std::variant<Hull, HullRefusal>
convexHull(const std::vector<Vector>& points, const std::function<void()>& meanwhile = {});

} // namespace geometry
