#include "simulation/simulation.h"

#include "accuracy/solve.h"
#include "run/cpu_seconds.h"

#include <utility>
#include <variant>

namespace simulation {

Result simulate(const scene::Scene& scene, const Options& options, const Observer& observer) {
    const double begin = cpuSeconds();
    auto problem = problemOf(scene, options, observer);
    if (auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        Result result;
        result.cancelled = refusal->empty();
        result.refusal = std::move(*refusal);
        return result;
    }
    const double posing = cpuSeconds() - begin;
    FreshRuns runs;
    Result result = solve(*std::get<std::shared_ptr<Problem>>(problem), observer, runs).result;
    result.statistics.seconds = posing + result.statistics.secondsSolving;
    result.statistics.secondsSettingUp += posing;
    return result;
}

} // namespace simulation
