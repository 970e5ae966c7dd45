// Does a motion restart so often that its errors follow no tolerance?
//
// Impacts and switches end steps where no tolerance would: of a phase with a handful of steps the
// first is a guess and the last is cut, and a run at an eighth of the tolerance may take all but
// the same ones. Then two runs err alike, phase after phase, and agree where both are off.
//
// LIMIT: steps and switches are those of the components that there are at the end, impacts are all:
// of a body that came to rest, or to slide, only what it did since counts in steps and switches.
#pragma once

#include "simulation/solved.h"

#include <vector>

namespace simulation {

// By body: in its island somebody that is integrated makes few steps from one impact or switch to
// the next, and what runs differ by is not so small against the accuracy that no chance could hide
// more than that.
[[nodiscard]] std::vector<bool> restartsOften(const Problem& problem, const Run& run,
                                              const std::vector<BodyError>& errors);

} // namespace simulation
