// The forces and contacts of each body, in the words of the scene: at rest and in motion.
#pragma once

#include <string>
#include <vector>

namespace simulation {

struct Problem;
struct Run;

struct Acting { // on a body that is not fixed
    std::string body;
    std::vector<std::string> what; // "gravity {0 -9.81 0}", "a link to rod2 (tightness 100)"
};

// At the end of the motion, with the impacts on the way.
[[nodiscard]] std::vector<Acting> actingOn(const Problem& problem, const Run& run);

} // namespace simulation
