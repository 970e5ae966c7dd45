// The pieces of which surfaces of bodies are made, and which two of them may touch.
#pragma once

#include "geometry/pose.h"

namespace physics {

using geometry::Matrix;
using geometry::Vector;

struct SurfacePiece {
    enum class Kind { point, line, circle, cone, ellipsoid, plane };
    Kind kind = Kind::point;
    // In the body's frame, from its centre of mass: the point; one of the line or the plane; the
    // centre; the apex.
    Vector place = Vector::Zero();
    Vector axis = Vector::UnitX(); // outward; along the line; across the circle; to the apex
    double radius = 0;             // around a point or a line, below 0: hollow; of the circle
    Vector foot = Vector::UnitY(); // circle: from its centre to where it touched a curve
    double sine = 0;               // cone: of the angle between its axis and its side
    Matrix axes = Matrix::Zero();  // ellipsoid: its half axes are the columns
};

struct SurfaceGap {
    SurfacePiece body, support;
    bool isFlipped = false; // curves: the normal is along support x body
    // Of two circles: 1 or -1 for one of the two points on the sphere, 0 for the feet.
    double branch = 0;

    // A curve across a curve, of which one is a circle.
    [[nodiscard]] bool isCrossing() const {
        const auto isCurve = [](const SurfacePiece& piece) {
            return piece.kind == SurfacePiece::Kind::line ||
                   piece.kind == SurfacePiece::Kind::circle;
        };
        return isCurve(body) && isCurve(support) &&
               (body.kind == SurfacePiece::Kind::circle ||
                support.kind == SurfacePiece::Kind::circle);
    }

    [[nodiscard]] bool hasFeet() const { return isCrossing() && branch == 0; }

    [[nodiscard]] bool isOnPlane() const {
        return body.kind == SurfacePiece::Kind::plane || support.kind == SurfacePiece::Kind::plane;
    }
};

// Curves that cross less steadily (surface_gap.h, NearestSurfaces) have no gap.
inline constexpr double leastSteady = 1e-4;

} // namespace physics
