#include "motion/known_span.h"

#include <algorithm>

namespace simulation {

KnownSpan knownSpan(const Motion& motion) {
    KnownSpan known{motion.computed(), motion.predictableUntil(), 0};
    for (std::size_t body = 0; body < motion.bodies(); ++body)
        if (const auto stop = motion.stop(body)) {
            ++known.stopped;
            known.computed = std::min(known.computed, stop->time);
            known.reliableUntil = std::min(known.reliableUntil.value_or(stop->time), stop->time);
        }
    return known;
}

} // namespace simulation
