// A shape that moves: where it is at any time, and how fast it can get there.
//
// Motion is given in polynomial pieces, the form in which it is solved: the place of the pivot (the
// centre of mass) and a quaternion that is normalised after evaluation. From these come poses,
// velocities and bounds that hold over a whole interval.
#pragma once

#include "geometry/pose.h"
#include "geometry/shape.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace collision {

using geometry::Matrix;
using geometry::Pose;
using geometry::Quaternion;
using geometry::Vector;

inline constexpr std::size_t maximumDegree = 8;

// Coefficients of powers of s = (t - from) / scale; [0] is the value at `from`.
struct MotionPiece {
    double from = 0, until = 0, scale = 1;
    std::vector<Vector> position;          // of the pivot, world; one coefficient: it does not move
    std::vector<Eigen::Vector4d> attitude; // w x y z; one coefficient: it does not turn
};

struct Velocity {
    Vector linear = Vector::Zero();  // of the pivot
    Vector angular = Vector::Zero(); // world axes
};

[[nodiscard]] Vector positionAt(const MotionPiece& piece, double t);
[[nodiscard]] Quaternion attitudeAt(const MotionPiece& piece, double t);
[[nodiscard]] Velocity velocityAt(const MotionPiece& piece, double t);

// Bounds over from <= t <= to, a part of the piece (or a little beyond it).
struct TurnBounds {
    double angularSpeed = 0;
    double angularAcceleration = 0;
};
[[nodiscard]] TurnBounds turnBounds(const MotionPiece& piece, double from, double to);
// The same bounds for the part of the turning across the axis n, a unit vector: n x w and n x w'.
[[nodiscard]] TurnBounds turnBoundsAcross(const MotionPiece& piece, const Vector& axis, double from,
                                          double to);

class MovingShape {
public:
    virtual ~MovingShape() = default;
    [[nodiscard]] virtual const geometry::Shape& shape() const = 0;
    // The point that `position` is the place of, in the shape's frame: the centroid.
    [[nodiscard]] virtual Vector pivot() const = 0;
    // The piece that holds t, the later one at a joint. Valid until the next call.
    [[nodiscard]] virtual const MotionPiece& pieceAt(double t) const = 0;
};

// Pose of the shape's frame.
[[nodiscard]] Pose poseAt(const MovingShape& moving, double t);

} // namespace collision
