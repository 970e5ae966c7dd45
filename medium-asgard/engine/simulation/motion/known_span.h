// The span over which a motion is known, for all that tell it: statistics, the status panel, the
// time scrollbar.
#pragma once

#include "motion/motion.h"

#include <cstddef>
#include <optional>

namespace simulation {

struct KnownSpan {
    double computed = 0;                 // s; of all bodies: to where the first of them stops
    std::optional<double> reliableUntil; // nothing: throughout
    std::size_t stopped = 0;             // bodies that stop before the end
};

[[nodiscard]] KnownSpan knownSpan(const Motion& motion);

} // namespace simulation
