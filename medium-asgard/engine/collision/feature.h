// The pieces of a convex part's surface on each of which all is smooth: what touches, where two
// parts do.
//
// Seen from outside, a piece is a set of points with the outward normals that they have:
//     point      one point, normals in a cone; with a radius around it, a piece of a sphere
//     segment    normals across it; with a radius, the tube of a capsule or the side of a cylinder
//     face       one normal: of a polyhedron, an end of a cylinder, a cone's base, a half space
//     circle     the rim of an end or a base
//     cone       its side: normals n with n.axis = sine, one for each line through the apex
//     ellipsoid  one normal at each point
// Of a hollow part they are its hull's; a bowl's outside is a piece of a sphere.
// On each the support function h(n) = max n.x is smooth, so that closest pairs of two pieces are
// found by Newton's method (curved_separation.h), and those who keep a contact know what rolls or
// slides on what.
#pragma once

#include "collision/posed.h"

#include <cstddef>
#include <vector>

namespace collision {

struct Feature {
    enum class Kind { point, segment, face, circle, cone, ellipsoid };
    Kind kind = Kind::point;
    // The point; the middle of the segment; a point of the face, of a round one its centre; the
    // centre of the circle and of the ellipsoid; the apex of the cone.
    Vector place = Vector::Zero();
    // Along the segment; the face's normal, outward; across the circle; of the cone to its apex.
    Vector axis = Vector::UnitY();
    // Around a point and a segment; of a circle, of a round face and of the cone's base.
    double radius = 0;
    double length = 0;                // of the segment; of the cone from base to apex
    double sine = 0;                  // of the cone
    Matrix axes = Matrix::Zero();     // of the ellipsoid: its half axes are the columns
    std::vector<Vector> outline = {}; // of a face of a polyhedron, counter-clockwise from outside
};

// The pieces that have points within `depth` of the part's furthest extent along a direction and
// may have a normal near it; in the part's frame, as the direction. Not empty.
[[nodiscard]] std::vector<Feature> featuresAlong(const Part& part, const Vector& direction,
                                                 double depth);

// The same piece with the part at its place.
[[nodiscard]] Feature placed(Feature feature, const Posed& posed);

} // namespace collision
