#include "accuracy/run_source.h"

#include <algorithm>
#include <utility>

namespace simulation {

std::unique_ptr<OpenRun> openRun(const Problem& problem, const RunSource::Wanted& wanted,
                                 OpenRun::Use use) {
    std::vector<bool> taken;
    if (wanted.base)
        taken = untouchedIn(problem, wanted.base->before, wanted.base->again);
    if (std::ranges::find(taken, true) == taken.end())
        taken.clear();
    const bool isNudged = wanted.kind == RunSource::Kind::nudged;
    return std::make_unique<OpenRun>(problem, wanted.tolerances,
                                     isNudged ? Rounding::nudged : Rounding::asItIs, use,
                                     std::move(taken));
}

std::optional<Run> FreshRuns::next(const Problem& problem, const Wanted& wanted,
                                   const Observer& observer) {
    const Run* const before = wanted.base ? &wanted.base->before : nullptr;
    Run run = openRun(problem, wanted, OpenRun::Use::once)->upToFinish(observer, before);
    if (!run.isDisturbed)
        return run;
    const Wanted alone{.kind = wanted.kind, .tolerances = wanted.tolerances};
    return openRun(problem, alone, OpenRun::Use::once)->upToFinish(observer, nullptr);
}

} // namespace simulation
