// Does a motion restart so often that its errors follow no tolerance?
//
// Impacts and switches end steps where no tolerance would: of a phase with a handful of steps the
// first is a guess and the last is cut, and a run at an eighth of the tolerance may take all but
// the same ones. Then two runs err alike, phase after phase, and agree where both are off.
//
// Told from the motion up to the finish alone, so that it is the same however the run came about.
#pragma once

#include "run/run.h"

#include <vector>

namespace simulation {

// By body: in its island somebody that is integrated makes few steps from one impact or switch to
// the next, and what runs differ by is not so small against the accuracy that no chance could hide
// more than that.
[[nodiscard]] std::vector<bool> restartsOften(const Problem& problem, const Run& run,
                                              const std::vector<BodyError>& errors);

} // namespace simulation
