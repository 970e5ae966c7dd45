#include "simulation/restarts.h"

#include "simulation/tightening.h"

#include <algorithm>
#include <set>

namespace simulation {
namespace {

constexpr double leastDoubted = 0.02; // of the accuracy

} // namespace

std::vector<bool> restartsOften(const Problem& problem, const Run& run,
                                const std::vector<BodyError>& errors) {
    const std::size_t bodies = errors.size();
    const std::vector<std::size_t> owners = ownersOf(problem);
    std::vector<std::size_t> restarts(bodies), steps(bodies);
    run.impacts.forEachPair([&](std::size_t first, std::size_t second, std::size_t times) {
        restarts[first] += times;
        restarts[second] += times;
    });
    for (const solution::ComponentStatistics& c : run.statistics.componentList) {
        std::set<std::size_t> own;
        for (const std::size_t unknown : c.unknowns)
            own.insert(owners[unknown]);
        for (const std::size_t body : own) {
            restarts[body] += c.switches;
            steps[body] = std::max(steps[body], c.integratedSteps);
        }
    }
    std::vector<bool> islands(bodies), often(bodies);
    for (std::size_t b = 0; b < bodies; ++b)
        if (run.isIntegrated[b] && restarts[b] > 0 &&
            steps[b] <= Tightening::fewSteps * (restarts[b] + 1) &&
            errors[b].estimate > leastDoubted * problem.accuracy())
            islands[run.island[b]] = true;
    for (std::size_t b = 0; b < bodies; ++b)
        often[b] = islands[run.island[b]];
    return often;
}

} // namespace simulation
