// On which side of a plane does a point lie, decided exactly?
//
// The sign of the determinant |b-a, c-a, d-a| with no rounding: floating point where a bound on its
// error allows (Shewchuk 1997, "Adaptive precision floating-point arithmetic"), else expansions,
// sums of doubles that do not overlap. Hulls built on it cannot become inconsistent.
//
// LIMIT: coordinates must be multiples of 2^-60 below 1 in size (see toGrid), so that no product
// underflows.
#pragma once

#include "geometry/pose.h"

#include <vector>

namespace geometry {

// +1: d lies on the side of the plane abc from which a, b, c are seen clockwise (the determinant is
// positive); 0: exactly in the plane; -1: on the other side.
[[nodiscard]] int orientation(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

// The points scaled by a power of two into the unit cube and rounded to multiples of 2^-60: for
// all but the coordinates that are 2^-7 times the largest or less this moves nothing, and those
// by less than 1e-18 of the largest.
[[nodiscard]] std::vector<Vector> toGrid(const std::vector<Vector>& points);

} // namespace geometry
