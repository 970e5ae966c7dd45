// What bears has no speed along the normal of its contact.
//
// Its constraint says so of the exact motion; the integration errs, and leaves the gap opening or
// closing by next to nothing. An impact elsewhere on the body asks which of its contacts approach
// at that instant (physics/impact.h), and another answer is another motion: what bears is at rest,
// and takes part once the blow has reached it. So the error is taken out of the velocities before,
// by the least change in the sense of kinetic energy.
#pragma once

#include "simulation/body_motion.h"

#include "physics/resting.h"

namespace simulation {

// J and g' of a contact that bears (physics/resting.h), from the states of both.
[[nodiscard]] physics::GapRow bearingRow(const physics::GapConstraint& constraint,
                                         const BodyRecord& record, const BodyState& body,
                                         const BodyState& support);

// The body's state with these rates 0.
[[nodiscard]] BodyState withoutRates(const BodyState& state, const physics::BodyMotion& motion,
                                     bool attitudeIsHeld, std::span<const physics::GapRow> rows);

} // namespace simulation
