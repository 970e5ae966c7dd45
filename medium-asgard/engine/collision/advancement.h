// Conservative advancement of two convex parts along one piece of each one's motion.
#pragma once

#include "collision/part_motion.h"
#include "collision/time_of_impact.h"

namespace collision {

// Slower than this times the speeds that enter, surfaces do not count as approaching.
inline constexpr double approachThreshold = 1e-12;

[[nodiscard]] Encounter advance(const PartPair& pair, Interval during);

} // namespace collision
