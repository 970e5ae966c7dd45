// One part of a moving shape during one piece of its motion, and what counts as nothing between
// two.
#pragma once

#include "collision/contact.h"
#include "collision/moving_shape.h"
#include "collision/separation.h"

#include <optional>

namespace collision {

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

// The contact of two parts that touch at t along (or all but along) the separation's normal, as if
// they hit.
[[nodiscard]] Contact contactOf(const PartPair& pair, double t, const Separation& separation);

// Their contact along that axis along which they approach least, if they do not approach there.
[[nodiscard]] std::optional<Contact> passing(const PartPair& pair, double t);

} // namespace collision
