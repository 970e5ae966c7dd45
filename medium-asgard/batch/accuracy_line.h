// The accuracy of a motion, in one line (docs/command-line.md).
#pragma once

#include "simulation/simulation.h"

#include <string>

namespace batch {

struct ToldMotion {
    double start = 0, reached = 0; // all bodies are known up to then
    double accuracy = 0;           // that was asked for, relative to the size of what moves
    std::string method = "auto";   // or the one that was asked for
    double fixedStep = 0;          // 0: none
};

// One sentence without its end; empty where nothing is known of a motion by "auto".
[[nodiscard]] std::string accuracyLine(const ToldMotion& motion,
                                       const simulation::Statistics& statistics);

} // namespace batch
