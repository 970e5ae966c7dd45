#include "simulation/restarts.h"

#include "simulation/tightening.h"

#include <algorithm>

namespace simulation {
namespace {

constexpr double leastDoubted = 0.02; // of the accuracy

} // namespace

std::vector<bool> restartsOften(const Problem& problem, const Run& run,
                                const std::vector<BodyError>& errors) {
    const std::size_t bodies = errors.size();
    const std::vector<std::size_t> owners = ownersOf(problem);
    std::vector<std::size_t> restarts(bodies), steps(bodies);
    for (std::size_t unknown = 0; unknown < owners.size(); ++unknown)
        if (const std::size_t body = owners[unknown]; run.isIntegrated[body]) {
            const auto before = std::ranges::count_if(
                run.histories->restarts(unknown), [&](double t) { return t < problem.finish(); });
            restarts[body] = std::max(restarts[body], static_cast<std::size_t>(before));
            steps[body] = std::max(steps[body], run.histories->steps(unknown, problem.finish()));
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
