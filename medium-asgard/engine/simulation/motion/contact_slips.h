// How fast do the surfaces of a contact slip along each other?
#pragma once

#include "motion/computed_motion.h"

#include <cstddef>

namespace simulation {

// The multiplier of a contact's row keeps its condition then, also where the contact jams.
[[nodiscard]] bool holdsAt(const solution::Histories& histories, std::size_t row, double time);

// At the fastest of the points that press then. `body` and `support`: those of the contact, as the
// motion has them.
[[nodiscard]] double slipSpeedAt(const ComputedMotion& motion, const solution::Histories& histories,
                                 const ContactLog::Contact& contact, std::size_t body,
                                 std::size_t support, double time);

} // namespace simulation
