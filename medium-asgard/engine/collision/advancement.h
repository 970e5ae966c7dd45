// Conservative advancement of two convex parts along one piece of each one's motion.
#pragma once

#include "collision/encounter.h"
#include "collision/part_motion.h"

namespace collision {

[[nodiscard]] Encounter advance(const PartPair& pair, Interval during);

} // namespace collision
