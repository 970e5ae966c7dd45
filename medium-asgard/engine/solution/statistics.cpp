#include "solution/statistics.h"

namespace solution {

void Statistics::addWork(const ComponentStatistics& component) {
    Work::add(component);
    equationEvaluations += component.evaluations * component.unknowns.size();
}

void Statistics::addIntegrated(const ComponentStatistics& component) {
    integratedSteps += component.integratedSteps;
    if (component.integratedSteps > 0)
        for (const std::size_t unknown : component.unknowns)
            integrated.push_back({unknown, component.integratedFrom});
}

} // namespace solution
