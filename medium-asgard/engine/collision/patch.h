// The contact patch of two parts: the part of one's furthest face, edge or vertex that lies over
// the other's.
//
// LIMIT: round ends of cylinders and bases of cones are polygons of 64 corners in the patch, and
// nowhere else: the centre of a patch that is a whole disc is right, that of a part of one to 1e-3.
#pragma once

#include "collision/separation.h"

#include <cstddef>
#include <vector>

namespace collision {

// Vertices of the part within `tolerance` of its furthest extent along a direction. Rounding does
// not divide those that are equally far.
[[nodiscard]] std::vector<std::size_t> furthestVertices(const Posed& posed, const Vector& direction,
                                                        double tolerance);

// The same in order around the direction; all in one plane up to the tolerance.
[[nodiscard]] std::vector<Vector> furthestFeature(const Posed& posed, const Vector& direction,
                                                  double tolerance);

// The features of both that face each other along the normal from second to first. Of a half space
// a square under, or over, the other's. Those that are round are drawn with many corners.
struct FacingFeatures {
    std::vector<Vector> first, second; // each around its own outward direction
};
[[nodiscard]] FacingFeatures facingFeatures(const Posed& first, const Posed& second,
                                            const Vector& normal, double tolerance);

struct Patch {
    std::vector<Vector> corners; // halfway between the surfaces; not empty
    Vector centre = Vector::Zero();
};

// `normal` points from second to first. `tolerance` is along it. Features that overlap by less than
// `beside` across it do not overlap.
[[nodiscard]] Patch patchOf(const Posed& first, const Posed& second, const Vector& normal,
                            double tolerance, double beside);

} // namespace collision
