// The work that a solver did.
#pragma once

#include "stepping/options.h"

#include <cstddef>
#include <vector>

namespace solution {

struct Statistics : Work {
    std::size_t equationEvaluations = 0; // of single unknowns' right-hand sides
    std::size_t events = 0;
    std::size_t integratedSteps = 0; // 0: all is exact but for rounding
    std::size_t components = 0, largestComponent = 0, historyBytes = 0;
    std::size_t keptBytes = 0; // of histories and beside them, as Options::mostBytes counts
    std::size_t groups = 0;    // of components that read each other: what moves side by side
    std::size_t rounds = 0;
    // Those in force, also those that were taken, which are not in the sums; ended ones are.
    std::vector<ComponentStatistics> componentList;
    std::vector<std::size_t> zeroStates; // unknowns that stayed 0 all the time
    struct Integrated {
        std::size_t unknown = 0;
        double from = 0; // the first time at which a method stepped it
    };
    std::vector<Integrated> integrated; // of components that a method stepped

    void addWork(const ComponentStatistics& component);
    void addIntegrated(const ComponentStatistics& component);
};

} // namespace solution
