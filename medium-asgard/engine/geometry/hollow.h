// Hollow round bodies: a tube about its own y, and a bowl, the lower half of a shell about its own
// origin.
//
// In the half plane of the distance from the axis and the height a tube's wall is a rectangle, a
// bowl's half a ring. So which piece of its surface is nearest to a point, and how far, is known in
// closed form:
//
//     hollow   inside of the wall     d = r - |across|, r - |p|       the normal points inward
//     rim      of the hollow          d = |p - foot on the circle|
//     end      the ring between       d = height over it
//     edge     of the outside         d = |p - foot on the circle|
//     outside                         d = |across| - R, |p| - R
#pragma once

#include "geometry/curved.h"

#include <vector>

namespace geometry {

[[nodiscard]] inline bool isHollow(const Curved& curved) {
    return curved.kind == Curved::Kind::tube || curved.kind == Curved::Kind::bowl;
}

struct HollowNearest {
    enum class Piece { hollow, rim, end, edge, outside };
    Piece piece = Piece::outside;
    double distance = 0;             // negative: within the wall
    Vector normal = Vector::UnitY(); // out of the wall at the nearest place, shape's frame
    double end = 1;                  // of rim, end, edge: which of a tube's, 1 above, -1 below
    // From what the hollow turns about, a tube's axis or a bowl's centre, of a rim its axis.
    double across = 0;
    double above = 0; // over the plane of the nearest end; negative: between the ends
    // The nearest place is the hollow's own, its rim included; else it is one of the outside.
    [[nodiscard]] bool isInside() const { return piece == Piece::hollow || piece == Piece::rim; }
};
// Of a point of the shape's frame.
[[nodiscard]] HollowNearest nearestOf(const Curved& hollow, const Vector& point);

// The values of s between 0 and 1, without the ends, at which the distance of a + s way from a
// circle has a minimum. The circle lies about the origin in the plane y = 0.
[[nodiscard]] std::vector<double> nearestToCircle(const Vector& a, const Vector& way,
                                                  double radius);

} // namespace geometry
