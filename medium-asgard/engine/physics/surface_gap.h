// How far apart are two pieces of surfaces, and where do they come nearest?
//
// The pieces are those of which smooth surfaces of bodies are made, each with the points around it:
//
//     plane      of a flat face, with its outward normal
//     point      a vertex, a tip; with a radius, a sphere
//     line       an edge; with a radius, the side of a cylinder or a capsule
//     circle     the rim of a cylinder or a cone
//     cone       its side
//     ellipsoid
//
// For two of them the gap g, the normal n from the support to the body, and the point x of contact
// are closed forms of the bodies' places, as smooth as the pieces are. With d from the one piece's
// place to the other's:
//
//     plane and point     g = n.d - r                         x = p - r n
//     plane and circle    g = n.d - R |a x n|                 x: the lowest point of the circle
//     plane, ellipsoid    g = n.d - |A'n|                     x = c - A A'n / |A'n|
//     point and point     g = |d| - r
//     point and line      g = |d - b (b.d)| - r
//     point and circle    g = |p - f| - r                     f: the foot on the circle
//     point and cone      g = n.d - r                         n.a = sine of the cone
//     line and line       g = n.d - r, n along a x b          x where they cross
//
// A circle has no closed form with a line or a circle (a rim across an edge, a side or another
// rim). Four steps of Newton's method find the two nearest points p and q. They begin
//
//     on the sphere   about one circle, with its radius, which another circle leaves at the point
//                     they share: exact wherever they touch (`branch`)
//     at the feet     the points of the circles where they touched: exact to rounding near them
//                     (nearFoot()). For lines, and where a circle only grazes that sphere
//
// and the gap is as smooth as what it comes from:
//
//     two curves          g = n.(p - q), n along both tangents' product        x = p
//     round line, circle  g = |p - q| - r                                      x on the circle
//
// A point or a line with a radius below 0 is the inside of a shell or a tube; with a point within
// it
//     g = -r - |d|, -r - |d - b (b.d)|       r: both radii together, and below 0.
//
// That holds for expressions (contact_rows.h) and for numbers alike: surface_nearest.h has the
// formulas once.
#pragma once

#include "physics/surface_piece.h"

namespace physics {

// There is a formula.
[[nodiscard]] bool haveGap(SurfacePiece::Kind body, SurfacePiece::Kind support);

struct SurfacePose {                // of a body
    Vector centre = Vector::Zero(); // of mass
    Matrix rotation = Matrix::Identity();
};

struct NearestSurfaces {
    double gap = 0;
    Vector normal = Vector::UnitX(); // from the support to the body
    Vector contact = Vector::Zero(); // on one of the surfaces, world
    // Of a point its place, within its radius; else `contact`.
    Vector place = Vector::Zero();
    // Of a crossing with a circle how well the two points are determined, else 1. From feet it is
    // the determinant of their distance's half square by both points' ways; of edges that cross it
    // is the square of the sine of their angle. From the sphere it is the square of the sine of the
    // angle at which the circle leaves it; of circles that touch that is never more.
    double steady = 1;
    // How far, in rad, a circle's point may be from its foot.
    [[nodiscard]] double nearFoot() const;
};
[[nodiscard]] NearestSurfaces nearest(const SurfaceGap& gap, const SurfacePose& body,
                                      const SurfacePose& support);

// A crossing of two circles that touch at its feet: from the sphere where that is as steady.
[[nodiscard]] SurfaceGap fromSphereIfSteady(const SurfaceGap& gap, const SurfacePose& body,
                                            const SurfacePose& support);

struct SurfaceMotion { // of a body, along the world's axes
    SurfacePose pose;
    Vector velocity = Vector::Zero(), spin = Vector::Zero();
    Vector acceleration = Vector::Zero(), spinRate = Vector::Zero();
};
// How the gap accelerates as the bodies move on: also by the curvature of what slides on what.
[[nodiscard]] double accelerationOf(const SurfaceGap& gap, const SurfaceMotion& body,
                                    const SurfaceMotion& support);

// How far the piece reaches from its place against a normal, all in one frame.
[[nodiscard]] double reachBelow(const SurfacePiece& piece, const Vector& normal);

} // namespace physics
