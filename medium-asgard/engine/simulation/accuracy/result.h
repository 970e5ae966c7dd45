// The answer of a simulation: its motion, the work done for it, or why there is none.
#pragma once

#include "motion/motion.h"
#include "reports/explanation.h"

#include <optional>
#include <string>
#include <vector>

namespace simulation {

// Work done, for tests and --stats. Counts are portable; seconds are not.
struct ComponentStatistics {
    std::size_t unknowns = 0;
    std::string model;  // "closed-form" | "quadrature" | "linear" | "explicit" | "implicit"
    std::string method; // "dop853", "radau5", ...
    std::size_t steps = 0, evaluations = 0;
};

// Counts of what was done; those of several solutions add up.
struct WorkCounts {
    std::size_t steps = 0, rejectedSteps = 0, discardedSteps = 0;
    std::size_t unconvergedSteps = 0; // of the rejected: the implicit equations were not solved
    std::size_t evaluations = 0, equationEvaluations = 0, factorisations = 0;
    std::size_t pairTests = 0;

    WorkCounts& operator+=(const WorkCounts& more);
    WorkCounts& operator-=(const WorkCounts& less);
};

struct Seconds {               // CPU
    double seconds = 0;        // of the motion
    double secondsSolving = 0; // of these, without making the equations
    // Of the seconds: equations, partition and code of all runs; and the run that is delivered,
    // alone. What is left is the estimate of its error: other runs, and comparing them. Of runs
    // that are solved side by side each counts the other's, too.
    double secondsSettingUp = 0, secondsMoving = 0;
};

// Of a motion that was computed further than it is wanted now, what was done beyond its finish
// counts: in the list of components, and in the bytes.
struct Statistics : WorkCounts, Seconds {
    std::size_t collisions = 0;
    std::size_t components = 0, largestComponent = 0, historyBytes = 0;
    double reached = 0;
    std::optional<double> errorEstimate, predictableUntil;
    // The size, in m, of the island with the largest estimate; none: no runs were compared there.
    std::optional<double> movingSize;
    std::vector<ComponentStatistics> componentList;
};

struct Result {
    // Null when `refusal` says why nothing could be computed, or when it was cancelled before.
    MotionPointer motion;
    Statistics statistics;
    std::vector<std::string> refusal; // faults that make the scene unusable; then motion is null
    bool cancelled = false;
    std::optional<Explanation> explanation; // when asked for, and not cancelled
};

} // namespace simulation
