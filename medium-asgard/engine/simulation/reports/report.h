// The faults and notes of a motion, at their places in the scene's text.
#pragma once

#include "motion/motion.h"
#include "scene/diagnostic.h"

#include <string>
#include <vector>

namespace simulation {

// Its warnings, then why bodies stopped, each reason once, with how many it stopped and how many
// stopped for these: at the force or link to blame, else at the first body that it names. A range
// is known where the text holds the element literally, a line where a command of the text made it.
[[nodiscard]] std::vector<scene::Diagnostic> reportOf(const scene::Scene& scene,
                                                      const Motion& motion);

// Why nothing could be computed: the sentence, at the simulator if it is about how long or exact
// the motion is to be, else at the first body that it names.
[[nodiscard]] scene::Diagnostic faultOf(const scene::Scene& scene, const std::string& sentence);

} // namespace simulation
