// A polygon in space as triangles on its own corners.
#pragma once

#include "meshes/mesh.h"

#include <functional>
#include <span>

namespace meshes {

// Ears are cut off, seen along the polygon's mean normal, so that concave polygons are covered
// once. What crosses itself has no ears at some point: the rest is a fan. One with many corners is
// a fan when it is convex, which costs no more than looking at each corner once. `goOn` is asked
// for each corner that is looked at; false ends it, and there are no triangles.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>>
trianglesOf(const std::vector<Vector>& vertices, std::span<const std::uint32_t> corners,
            const std::function<bool()>& goOn = {});

} // namespace meshes
