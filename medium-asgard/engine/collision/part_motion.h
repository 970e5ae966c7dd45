// One part of a moving shape during one piece of its motion, and what counts as nothing between
// two.
#pragma once

#include "collision/moving_shape.h"
#include "collision/separation.h"

namespace collision {

// Of the two bodies' radii: nearer than this they are in contact at an impact.
inline constexpr double touchingGap = 1e-10;
// Of the speeds that enter: surfaces that are slower than this do not count as approaching.
inline constexpr double approachThreshold = 1e-12;

// How exactly places are known, besides rounding: of a body that rests, the gap that its contacts
// leave. Depths up to it, times the smaller part's size, and approaches up to it, times the speeds
// that enter, count as none.
using Slack = double;

struct PartMotion {
    const Part* part = nullptr;
    MotionPiece piece;
    Vector pivot = Vector::Zero(); // in the shape's frame
    // Of the part from the pivot, surface included; of a half space, as far as what it meets.
    double reach = 0;

    [[nodiscard]] bool turns() const { return piece.attitude.size() > 1; }
    [[nodiscard]] Posed posedAt(double t, const Vector& origin) const;
};

[[nodiscard]] PartMotion partMotion(const MovingShape& moving, std::size_t part, double t);

struct PartPair {
    PartMotion first, second;
    Slack slack = 0;

    [[nodiscard]] double size() const { return first.part->radius + second.part->radius + cores; }
    double cores = 0; // reaches of the cores about themselves

    [[nodiscard]] bool hasPlane() const { return first.part->isPlane() || second.part->isPlane(); }
    // Each of which is everywhere: they are not looked at.
    [[nodiscard]] bool areHalfSpaces() const {
        return first.part->isPlane() && second.part->isPlane();
    }

    // World coordinates minus this are small and share no rounding with places far away.
    [[nodiscard]] Vector originAt(double t) const { return positionAt(second.piece, t); }
    [[nodiscard]] Separation separationAt(double t, WarmStart& warm) const;
    // The most that round-off of the poses can change a gap.
    [[nodiscard]] double roundOff(double t) const;
    // The speeds that enter: the scale against which an approach counts as none.
    [[nodiscard]] double speedScale(double t) const;
    // Slower than this surfaces do not count as approaching.
    [[nodiscard]] double leastApproach(double t) const;
    // Of the smaller part, about its first vertex; a half space is never that.
    [[nodiscard]] double smallerSize() const;
    // Shallower than this an overlap may have gone unnoticed.
    [[nodiscard]] double unnoticedDepth(double t) const;
    // No two points of the parts move faster against each other.
    [[nodiscard]] double relativeSpeed(double t) const;
};

[[nodiscard]] PartPair partPair(const MovingShape& first, std::size_t firstPart,
                                const MovingShape& second, std::size_t secondPart, double t,
                                Slack slack = 0);

} // namespace collision
