// Convex bodies with curved surfaces, without a polygon in them: cylinder, cone, ellipsoid; and the
// half space. Of the hollow ones, tube and bowl (hollow.h), all here but mass and rays is of what
// holds them, their convex hull.
//
// Each stands about its own origin: a cylinder and a cone have it half way up their axis, the own y
// (a cone's apex is at +y), an ellipsoid in its centre; a half space is all below y = 0. A tube
// stands as a cylinder does; a bowl is the lower half of a shell about its origin. All that
// searches need is the support function h(n) = max n.x over the body and the point that has it:
//     cylinder    half |n_y| + r |n_xz|
//     cone        the larger of  half n_y  and  r |n_xz| - half n_y
//     ellipsoid   |(a n_x, b n_y, c n_z)|
//     bowl        R where n_y < 0, else R |n_xz|
#pragma once

#include "geometry/pose.h"

#include <optional>
#include <utility>

namespace geometry {

struct Curved {
    enum class Kind { cylinder, cone, ellipsoid, plane, tube, bowl };
    Kind kind = Kind::ellipsoid;
    // Cylinder, cone, tube: radius, half the height, radius; half axes; a bowl has no height.
    Vector sizes = Vector::Zero();

    Vector center = Vector::Zero();    // the own origin, in the shape's frame
    Matrix frame = Matrix::Identity(); // own axes in the shape's frame
    double inner = 0;                  // of a tube and a bowl: the radius of the hollow
    [[nodiscard]] double radius() const { return sizes.x(); }
    [[nodiscard]] double half() const { return sizes.y(); }
    [[nodiscard]] Vector axis() const { return frame.col(1); }
};

// The point of the body that lies furthest along a direction, and one of those where there are
// several; shape's frame. Of a half space: its origin.
[[nodiscard]] Vector supportPoint(const Curved& curved, const Vector& direction);

// How far the body reaches from a point of the shape's frame. A half space counts as its origin.
[[nodiscard]] double radiusAbout(const Curved& curved, const Vector& center);

// Where the line origin + s direction is inside: from, to; none: nowhere. Infinite ends are
// possible in a half space. Of a hollow one: in its hull.
[[nodiscard]] std::optional<std::pair<double, double>>
insideAlong(const Curved& curved, const Vector& origin, const Vector& direction);

// Outward, at a point on the surface; of a hollow one that is nearestOf() (hollow.h).
[[nodiscard]] Vector normalAt(const Curved& curved, const Vector& point);

} // namespace geometry
