// The work that a motion took, as the JSON of `simulate --stats` (docs/command-line.md).
#pragma once

#include "simulation/simulation.h"

#include <string>

namespace batch {

[[nodiscard]] std::string statisticsJson(const scene::Scene& scene,
                                         const simulation::Motion& motion,
                                         const simulation::Statistics& statistics,
                                         double secondsReading);

} // namespace batch
