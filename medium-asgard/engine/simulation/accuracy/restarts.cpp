#include "accuracy/restarts.h"

#include "accuracy/tightening.h"

#include <algorithm>
#include <utility>

namespace simulation {
namespace {

constexpr double leastError = 0.02; // of the accuracy

} // namespace

std::vector<bool> restartsOften(const Problem& problem, const Run& run,
                                const std::vector<BodyError>& errors) {
    const std::size_t bodies = errors.size();
    const std::vector<std::size_t> owners = ownersOf(problem);
    std::vector<std::size_t> restarts(bodies), steps(bodies);
    const solution::History* last = nullptr;
    for (std::size_t unknown = 0; unknown < owners.size(); ++unknown) {
        const std::size_t body = owners[unknown];
        if (!run.isIntegrated[body])
            continue;
        const solution::History* history =
            run.histories->isInOnePlace(unknown)
                ? run.histories->place(unknown, problem.start()).history
                : nullptr;
        if (history && history == std::exchange(last, history) && unknown > 0 &&
            owners[unknown - 1] == body)
            continue; // as the unknown before
        const auto course = run.histories->course(unknown, problem.finish());
        restarts[body] = std::max(restarts[body], course.restarts);
        steps[body] = std::max(steps[body], course.steps);
    }
    std::vector<bool> islands(bodies), often(bodies);
    for (std::size_t b = 0; b < bodies; ++b)
        if (run.isIntegrated[b] && restarts[b] > 0 &&
            steps[b] <= Tightening::fewSteps * (restarts[b] + 1) &&
            errors[b].estimate > leastError * problem.accuracy())
            islands[run.island[b]] = true;
    for (std::size_t b = 0; b < bodies; ++b)
        often[b] = islands[run.island[b]];
    return often;
}

} // namespace simulation
