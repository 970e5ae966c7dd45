// How fast do the surfaces of a contact slip along each other?
#pragma once

#include "motion/computed_motion.h"

#include <cstddef>

namespace simulation {

// At the fastest of the points that press then. `body` and `support`: those of the contact, as the
// motion has them.
[[nodiscard]] double slipSpeedAt(const ComputedMotion& motion, const solution::Histories& histories,
                                 const ContactLog::Contact& contact, std::size_t body,
                                 std::size_t support, double time);

} // namespace simulation
