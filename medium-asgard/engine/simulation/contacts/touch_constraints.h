// Which constraints keep the gaps of a touch, once it is known which of its corners bear?
#pragma once

#include "contacts/touching.h"

#include <vector>

namespace simulation {

// The constraints that keep these corners' gaps: of a face that bears whole, one distance and two
// turns; of the two corners of an edge, the points of whichever edge it is, on the other's plane;
// of one corner where edges cross, these edges.
[[nodiscard]] std::vector<physics::GapConstraint>
constraintsOf(const Touch& touch, const std::vector<std::size_t>& bearing, const Placed& body,
              const Placed& support);

} // namespace simulation
