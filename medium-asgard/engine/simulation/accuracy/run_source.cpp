#include "accuracy/run_source.h"

#include "solution/workers.h"

#include <algorithm>
#include <utility>

namespace simulation {

void RunSource::expect(const Problem& problem, const std::vector<double>& tolerances) {
    const auto threads = static_cast<std::size_t>(std::max(problem.options.threads, 0));
    expected_.reset();
    isBeside_ = true;
    if (solution::Workers(threads).threads() > 1 && makesRuns())
        expected_ = std::make_unique<RunAhead>(problem, tolerances, use_);
}

void RunSource::beginExpected() {
    constexpr std::chrono::milliseconds worthwhile(50); // a short search needs no second thread
    if (expected_)
        expected_->begin(worthwhile);
}

std::unique_ptr<OpenRun> RunSource::open(const Problem& problem, const Wanted& wanted,
                                         const Observer& observer) {
    std::vector<bool> taken;
    if (wanted.base)
        taken = untouchedIn(problem, wanted.base->before, wanted.base->again);
    if (std::ranges::find(taken, true) == taken.end())
        taken.clear();
    const bool isNudged = wanted.kind == RunSource::Kind::nudged;
    const bool isBeside = std::exchange(isBeside_, false);
    if (expects(wanted.tolerances) && !isNudged && taken.empty()) {
        if (auto solved = std::exchange(expected_, nullptr)->take(observer))
            return solved;
    } else if (!isBeside && (wanted.kind == Kind::compared || wanted.kind == Kind::proving)) {
        expected_.reset(); // another one is wanted
    }
    return std::make_unique<OpenRun>(problem, wanted.tolerances,
                                     isNudged ? Rounding::nudged : Rounding::asItIs, use_,
                                     std::move(taken));
}

std::optional<Run> FreshRuns::next(const Problem& problem, const Wanted& wanted,
                                   const Observer& observer) {
    const Run* const before = wanted.base ? &wanted.base->before : nullptr;
    Run run = open(problem, wanted, observer)->upToFinish(observer, before);
    if (!run.isDisturbed)
        return run;
    const Wanted alone{.kind = wanted.kind, .tolerances = wanted.tolerances};
    return open(problem, alone, observer)->upToFinish(observer, nullptr);
}

} // namespace simulation
