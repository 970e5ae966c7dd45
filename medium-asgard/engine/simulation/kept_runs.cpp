#include "simulation/kept_runs.h"

#include <algorithm>
#include <utility>

namespace simulation {

void KeptRuns::begin(std::size_t bodies) {
    isRepeated_ = !runs_[static_cast<std::size_t>(Kind::compared)].empty();
    asked_.fill(0);
    marked_.assign(bodies, false);
}

std::unique_ptr<OpenRun> KeptRuns::made(const Problem& problem, Kind kind,
                                        const std::vector<double>& tolerances,
                                        const std::optional<Base>& base) const {
    std::vector<bool> taken;
    if (base)
        taken = untouchedIn(problem, base->before, base->again);
    if (std::ranges::find(taken, true) == taken.end())
        taken.clear();
    return std::make_unique<OpenRun>(
        problem, tolerances, kind == Kind::nudged ? Rounding::nudged : Rounding::asItIs,
        keep_ == Keep::no ? OpenRun::Use::once : OpenRun::Use::again, std::move(taken));
}

bool KeptRuns::saysNothing(const Problem& problem) const {
    for (std::size_t b = 0; b < marked_.size(); ++b)
        if (!marked_[b] && !(*problem.bodies)[b].isFixed)
            return false;
    return std::ranges::find(marked_, true) != marked_.end();
}

// A search that is repeated says nothing without them.
void KeptRuns::forget() {
    keep_ = Keep::no;
    areForgotten_ = true;
    for (auto& runs : runs_)
        for (auto& run : runs)
            run.reset();
    if (isRepeated_)
        marked_.assign(marked_.size(), true);
}

std::optional<Run> KeptRuns::next(const Problem& problem, Kind kind,
                                  const std::vector<double>& tolerances, const Observer& observer,
                                  const std::optional<Base>& base) {
    const Run* const before = base ? &base->before : nullptr;
    auto& runs = runs_[static_cast<std::size_t>(kind)];
    const std::size_t index = asked_[static_cast<std::size_t>(kind)]++;
    if (isRepeated_ && (areForgotten_ || index >= runs.size()))
        return std::nullopt;
    if (index >= runs.size()) {
        runs.resize(index + 1);
        runs[index] = made(problem, kind, tolerances, base);
    }
    std::unique_ptr<OpenRun>& open = runs[index];
    for (std::size_t b = 0; b < tolerances.size(); ++b)
        if (open->tolerances()[b] != tolerances[b] || (base && open->takes(b) && base->again[b]))
            mark(b);
    if (saysNothing(problem))
        return std::nullopt;
    const std::vector<double> own = open->tolerances();
    if (!open->canGoOn(before))
        open = made(problem, kind, own, {});
    std::optional<Run> run = open->upToFinish(observer, before);
    if (run->isDisturbed) {
        open = made(problem, kind, own, {});
        run = open->upToFinish(observer, nullptr);
    }
    if (keep_ == Keep::no)
        open.reset();
    else if (bytes() > most_)
        forget();
    return run;
}

std::size_t KeptRuns::bytes() const {
    std::size_t sum = 0;
    for (const auto& runs : runs_)
        for (const auto& run : runs)
            sum += run ? run->bytes() : 0;
    return sum;
}

} // namespace simulation
