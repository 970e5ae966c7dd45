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

    // The last moment worth playing: beyond a stop some bodies would stand while others move on. A
    // motion that is being computed still may go farther.
    [[nodiscard]] double playsTo(const Motion& motion, bool isBeingComputed) const {
        return isBeingComputed ? motion.finish() : computed;
    }
};

[[nodiscard]] KnownSpan knownSpan(const Motion& motion);

} // namespace simulation
