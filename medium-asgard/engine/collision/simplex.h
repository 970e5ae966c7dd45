// The point of a simplex that is nearest to the origin, and the smallest part of it that has the
// point.
//
// Every vertex, edge and face is a candidate, each with the projection of the origin in the form
// that loses fewest digits; the nearest valid one wins. Slower than walking the regions of the
// simplex one by one, but a flat or thin simplex cannot send it astray.
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstddef>

namespace collision {

using geometry::Vector;

struct SimplexPoint {
    Vector place = Vector::Zero();
    std::size_t a = 0, b = 0; // the vertices whose difference it is
};

struct Simplex {
    std::array<SimplexPoint, 4> points;
    std::size_t count = 0;
    bool holdsOrigin = false; // a tetrahedron around it

    void add(const SimplexPoint& p) { points[count++] = p; }
    [[nodiscard]] bool has(const SimplexPoint& p) const;
    // Keeps the part that is nearest to the origin and returns its nearest point.
    Vector reduce();
};

} // namespace collision
