// A surface of triangles, as files of other programs hold it.
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace meshes {

using geometry::Vector;

// Asked now and then with how far the work is, 0..1; false ends it.
using GoOn = std::function<bool(double share)>;

struct Mesh {
    std::vector<Vector> vertices;
    // Counter-clockwise seen from outside, where the file keeps to that.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Places that are the same number for number become one vertex, and with a `tolerance` also those
// that the same cell of a grid of that step holds; triangles that two corners of are then one go.
[[nodiscard]] Mesh welded(const Mesh& mesh, double tolerance = 0);

// Edge lengths of the box about it, along the axes.
[[nodiscard]] Vector extentOf(const Mesh& mesh);

} // namespace meshes
