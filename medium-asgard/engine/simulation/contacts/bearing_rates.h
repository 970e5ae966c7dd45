// An active contact has a gap of 0 and no speed along its normal.
//
// In exact motion its constraint keeps both; errors of the integration leave a gap that opens or
// closes by next to nothing. An impact elsewhere on the body asks which of its contacts approach
// at that instant (physics/impact.h), and after it an edge that bore lands again on both of its
// ends at once, or on one and then the other: another answer is another motion. So the error is
// taken out of places and velocities before, by the least change in the sense of kinetic energy.
#pragma once

#include "motion/body_motion.h"

#include "physics/resting.h"

#include <span>

namespace simulation {

struct BearingRow {
    physics::GapRow rates; // J and g' (physics/resting.h)
    double gap = 0;        // of a tilt: the angle
};

// Of a contact that bears, from the states of both.
[[nodiscard]] BearingRow bearingRow(const physics::GapConstraint& constraint,
                                    const BodyRecord& record, const BodyState& body,
                                    const BodyState& support);

// The body's state with these gaps and rates 0.
[[nodiscard]] BodyState bearingExactly(const BodyState& state, const physics::BodyMotion& motion,
                                       const physics::Held& held, std::span<const BearingRow> rows);

// A vector without what is rounding beside its largest component: in a plane nothing is to leave it
// (solution/zero_states.h).
[[nodiscard]] Vector withoutRounding(const Vector& v);

// By a rotation vector next to nothing, about the world's axes.
[[nodiscard]] Quaternion turnedBy(const Quaternion& attitude, const Vector& turn);

} // namespace simulation
