// The quantity that one looks at first, of those that a new plot may show.
//
// Of a joint it is its coordinate. A body that a joint of one coordinate holds to the ground moves
// by that alone. Any other body moves farthest along one of the axes of the world, as far as its
// motion is known. Forces, constraints, shapes and gears stand for what they act on.
#pragma once

#include "commands/quantities.h"
#include "motion/motion.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace commands {

struct Proposal {
    std::size_t measured = 0, quantity = 0; // of those that are offered
};

// `about`: what is selected; none, and what has no quantities: the first body that can move.
// `motion`: null while there is none. None: nothing is offered.
[[nodiscard]] std::optional<Proposal> proposalOf(const scene::Scene& scene,
                                                 const simulation::Motion* motion,
                                                 const std::vector<Measured>& offered,
                                                 const std::optional<editing::Element>& about);

} // namespace commands
