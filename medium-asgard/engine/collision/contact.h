// The place and the line of contact of two shapes.
//
// If edges or vertices touch, there are several axes along which the gap is 0: each is a normal of
// the Minkowski difference at one of its own edges or vertices, on which the difference of places
// lies. Convex bodies penetrate only when they approach along every one of them: an axis
// along which they do not is a proof that they stay apart, as any separating axis is. So a box that
// slides over the seam of two boxes in one plane touches the second one's edge and does not hit it:
// along the side's normal they approach, along the upper face's they do not. That is also what a
// gap of any size at the seam, however small, tends to. Hence
//     the normal is that axis along which they approach least, if they do not approach there, or if
//         at most one of them has a face there: a box slides onto a ramp that begins where the
//         floor ends as onto one that begins in the floor;
//     else that of the face when one touches, the common perpendicular of two edges that cross,
//     and else (vertex on vertex or edge, parallel edges) the line between the closest points just
//     before; of a sphere, that from the feature to its centre (nearest_feature.h).
// If one of the parts is curved, the normal is that of separation.h, along which surfaces that
// are not flat touch in one point and along one axis.
// The point is the centre of the patch in which they touch: two convex polygons clipped against
// each other, two segments, or a point.
//
// LIMIT: a capsule or a curved part that slides over a seam hits the second body's edge there.
// LIMIT: a surface that near is touched and not hit: a body slides over a step in a floor that is
// lower than 1e-10 of the smaller part's size, or than the slack.
#pragma once

#include "collision/moving_shape.h"
#include "collision/part_motion.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace collision {

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
// tolerance give none; nor do those that touch along several axes and do not approach along each:
// along which of them they may come to approach is not known yet.
[[nodiscard]] std::vector<Contact> contactsAt(const MovingShape& first, const MovingShape& second,
                                              double t, double tolerance, Slack slack = 0);

// The contact of two parts that touch at t along (or all but along) the separation's normal, as if
// they hit.
[[nodiscard]] Contact contactOf(const PartPair& pair, double t, const Separation& separation);

// Their contact along that axis along which they approach least, if they do not approach there.
[[nodiscard]] std::optional<Contact> passing(const PartPair& pair, double t);

// How fast the surfaces approach at a point along the contact's normal (negative: they part).
[[nodiscard]] double closingSpeed(const Velocity& first, const Vector& firstPivot,
                                  const Velocity& second, const Vector& secondPivot,
                                  const Vector& point, const Vector& normal);

} // namespace collision
