// Could errors have changed the order in which a body is hit?
//
// A comparison of runs shows the effect of errors on a motion that varies little with them. A body
// that meets two others at nearly one instant goes one way when it meets the one first, and another
// when it meets the other: two runs whose errors exceed the time between the two hits may take the
// same wrong way, and then agree to all digits. So near hits are worth another run.
#pragma once

#include "run/run.h"

#include <vector>

namespace simulation {

// By body: in its island somebody that is integrated is hit by two others, or at two places, within
// a time in which it goes no farther than a few of the errors, and hard enough for the accuracy to
// depend on it. `sizes`: what errors are scaled by. Hits of rallies on a line are left out: nothing
// there is integrated.
[[nodiscard]] std::vector<bool> hasCloseImpacts(const Problem& problem, const Run& run,
                                                const std::vector<BodyError>& errors,
                                                const std::vector<double>& sizes);

} // namespace simulation
