// How far the motion that is shown is known: what the status panel and the time scrollbar say.
#pragma once

#include "simulation/motion.h"

#include <cstddef>
#include <optional>

namespace views {

struct KnownSpan {
    double computed = 0;                 // s; of all bodies: to where the first of them stops
    std::optional<double> reliableUntil; // nothing: throughout
    std::size_t stopped = 0;             // bodies that stop before the end
};

[[nodiscard]] KnownSpan knownSpan(const simulation::Motion& motion);

} // namespace views
