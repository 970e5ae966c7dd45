// A solid cut by planes, so that volumes and hulls of the pieces can be told.
//
// A piece is a chain of triangles without a border: parts of the solid's surface, and caps where it
// was cut. A cap is a fan over the cut's directed edges from any of their points: where the cut is
// not convex its triangles cover places twice and cancel each other. That is no surface to be
// drawn, but integrals over it are exact, and no polygon with holes has to be found. What a piece's
// hull is of: corners of what is left of the surface, and corners of the cuts that lie inside the
// solid, which the surface alone does not tell.
#pragma once

#include "meshes/solids.h"

#include <optional>

namespace meshes {

struct Plane { // normal . x = offset
    Vector normal;
    double offset = 0;
    [[nodiscard]] double distance(const Vector& x) const { return normal.dot(x) - offset; }
    [[nodiscard]] Plane flipped() const { return {-normal, -offset}; }
};

struct Piece {
    struct Facet {
        Vector a, b, c;
        bool cap = false;
    };
    std::vector<Facet> facets;
    std::vector<Plane> cuts;     // the piece lies below all of them
    std::vector<Vector> corners; // where three cuts meet inside the solid
    [[nodiscard]] double volume() const;
    [[nodiscard]] std::vector<Vector> points() const;
};

[[nodiscard]] Piece pieceOf(const Solid& solid);

// The part below the plane. Places nearer to it than `tolerance` lie in it.
[[nodiscard]] Piece below(const Piece& piece, const Plane& plane, const Solid& solid,
                          double tolerance);

} // namespace meshes
