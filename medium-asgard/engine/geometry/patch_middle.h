// The middle of a patch on which two bodies touch, and how far its points are from there.
#pragma once

#include "geometry/pose.h"

#include <vector>

namespace geometry {

// In order of the angle about their middle, seen along the normal.
[[nodiscard]] std::vector<Vector> inOrder(std::vector<Vector> corners, const Vector& normal);

// The mean distance of the points of a convex patch from its middle; of two points, of the line.
struct PatchMiddle {
    Vector centre = Vector::Zero();
    double reach = 0;
};
[[nodiscard]] PatchMiddle middleOf(const std::vector<Vector>& corners, const Vector& normal);

} // namespace geometry
