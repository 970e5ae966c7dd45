// Where and along which line two shapes touch.
//
// The normal is that of the face when one touches, the common perpendicular of two edges that
// cross, and else (vertex on vertex or edge, parallel edges, spheres) the line between the closest
// points just before. The point is the centre of the patch in which they touch: two convex polygons
// clipped against each other, two segments, or a point.
#pragma once

#include "collision/moving_shape.h"

#include <cstddef>
#include <vector>

namespace collision {

// Of the two bodies' radii: nearer than this they are in contact at an impact.
inline constexpr double touchingGap = 1e-10;

struct Contact {
    Vector point = Vector::Zero();   // world; halfway between the surfaces
    Vector normal = Vector::UnitX(); // unit, from the second shape towards the first
    double gap = 0;                  // along the normal; negative: overlap by round-off
    double closingSpeed = 0;         // largest over the patch; negative: they part
    std::vector<Vector> patch;       // corners of the patch: 1, 2 or more
    std::size_t firstPart = 0, secondPart = 0;
};

// Contacts of all pairs of parts that are within `tolerance` of each other at time t, under the
// motion that holds from t on, whether they approach or part. Parts that overlap by more than the
// tolerance give none.
[[nodiscard]] std::vector<Contact> contactsAt(const MovingShape& first, const MovingShape& second,
                                              double t, double tolerance);

// How fast the surfaces approach at a point along the contact's normal (negative: they part).
[[nodiscard]] double closingSpeed(const Velocity& first, const Vector& firstPivot,
                                  const Velocity& second, const Vector& secondPivot,
                                  const Vector& point, const Vector& normal);

} // namespace collision
