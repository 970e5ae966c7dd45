// The instants at which contacts jam. The friction of a slip presses a body in faster than any
// force pushes it away (Painleve's rod): no forces keep the laws, and there is an impact without a
// collision. The solver marks it in the histories of friction (solution/modes/active_set.h).
#pragma once

#include "dense/histories.h"
#include "motion/contact_log.h"

#include <utility>
#include <vector>

namespace simulation {

struct Jam {
    double time = 0;
    std::pair<std::size_t, std::size_t> bodies; // of the part, the lesser first
};

// Up to a time, in order of what the log has.
[[nodiscard]] std::vector<Jam> jamsOf(const solution::Histories& histories,
                                      const ContactLog& contacts, double until);

} // namespace simulation
