// Random and degenerate point sets, and an independent check of their hulls. For tests: the unit
// test runs a few thousand, tests/endurance any number.
#pragma once

#include "geometry/hull.h"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace geometry {

// Generic, on a sphere, on a coarse grid, near a plane, near a line, with duplicates, thin, far
// from the origin, tiny, huge, rotated boxes: the kind is drawn too.
[[nodiscard]] std::vector<Vector> drawPoints(std::mt19937_64& random);

// "" when the hull is closed, convex and contains all points within 4 times its flatness, or was
// refused although it should be: else what is wrong.
[[nodiscard]] std::string faultOf(const std::vector<Vector>& points,
                                  const std::variant<Hull, HullRefusal>& result);

} // namespace geometry
