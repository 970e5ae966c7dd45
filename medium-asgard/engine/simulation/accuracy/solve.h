// A scene solved to its accuracy, with what simulate() knows and does not tell: for who keeps parts
// of it (resimulation.h).
#pragma once

#include "accuracy/result.h"
#include "accuracy/run_source.h"

#include <utility>
#include <vector>

namespace simulation {

struct Solved {
    Result result;
    Run run; // that the result's motion shows
    bool isEstimated = false;
    std::vector<BodyError> errors; // by body, when estimated
    // Pairs of bodies that came near each other in any of the runs. Who is not joined by these, and
    // reads nothing of each other, did not change each other's numbers.
    std::vector<std::pair<std::size_t, std::size_t>> near;
    // The most that a run kept; one had to end for it.
    std::size_t keptBytes = 0;
    bool isFull = false;
};

// Solves the problem by the runs of this source, and estimates the errors by comparing them.
[[nodiscard]] Solved solve(const Problem& problem, const Observer& observer, RunSource& runs);

} // namespace simulation
