// The patch in which two parts touch: what of the one's furthest face, edge or vertex lies over the
// other's.
#pragma once

#include "collision/separation.h"

#include <vector>

namespace collision {

// Vertices of the part within `tolerance` of its furthest extent along a direction, in order around
// the direction; all in one plane up to the tolerance.
[[nodiscard]] std::vector<Vector> furthestFeature(const Posed& posed, const Vector& direction,
                                                  double tolerance);

struct Patch {
    std::vector<Vector> corners; // halfway between the surfaces; not empty
    Vector centre = Vector::Zero();
};

// `normal` points from second to first. `tolerance` is along it; less than `beside` across it is no
// overlap.
[[nodiscard]] Patch patchOf(const Posed& first, const Posed& second, const Vector& normal,
                            double tolerance, double beside);

} // namespace collision
