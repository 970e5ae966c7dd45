#include "resimulation/kept_runs.h"

#include <algorithm>
#include <utility>

namespace simulation {

void KeptRuns::begin(std::size_t bodies) {
    isRepeated_ = !runs_[static_cast<std::size_t>(Kind::compared)].empty();
    asked_.fill(0);
    marked_.assign(bodies, false);
}

bool KeptRuns::saysNothing(const Problem& problem) const {
    for (std::size_t b = 0; b < marked_.size(); ++b)
        if (!marked_[b] && !(*problem.bodies)[b].isFixed)
            return false;
    return std::ranges::find(marked_, true) != marked_.end();
}

// A search that is repeated says nothing without them.
void KeptRuns::forget() {
    areForgotten_ = true;
    expectNothing();
    for (auto& runs : runs_)
        for (auto& run : runs)
            run.reset();
    if (isRepeated_)
        marked_.assign(marked_.size(), true);
}

void KeptRuns::markOthers(const OpenRun& open, const Wanted& wanted) {
    for (std::size_t b = 0; b < wanted.tolerances.size(); ++b)
        if (open.tolerances()[b] != wanted.tolerances[b] ||
            (wanted.base && open.takes(b) && wanted.base->again[b]))
            marked_[b] = true;
}

std::optional<Run> KeptRuns::next(const Problem& problem, const Wanted& wanted,
                                  const Observer& observer) {
    if (areForgotten_ && !isRepeated_)
        return FreshRuns().next(problem, wanted, observer);
    std::optional<Run> run = keptRun(problem, wanted, observer);
    for (std::size_t b = 0; b < wanted.concerned.size() && !run; ++b)
        if (wanted.concerned[b])
            marked_[b] = true;
    return run;
}

std::optional<Run> KeptRuns::keptRun(const Problem& problem, const Wanted& wanted,
                                     const Observer& observer) {
    const Run* const before = wanted.base ? &wanted.base->before : nullptr;
    auto& runs = runs_[static_cast<std::size_t>(wanted.kind)];
    const std::size_t index = asked_[static_cast<std::size_t>(wanted.kind)]++;
    if (isRepeated_ && (areForgotten_ || index >= runs.size()))
        return std::nullopt;
    const bool isNew = index >= runs.size();
    if (isNew) {
        runs.resize(index + 1);
        runs[index] = open(problem, wanted, observer);
    }
    std::unique_ptr<OpenRun>& kept = runs[index];
    markOthers(*kept, wanted);
    if (saysNothing(problem))
        return std::nullopt;
    const std::vector<double> own = kept->tolerances();
    const Wanted alone{.kind = wanted.kind, .tolerances = own};
    if (!isNew && !kept->canGoOn(before))
        kept = open(problem, alone, observer);
    std::optional<Run> run = kept->upToFinish(observer, before);
    if (run->isDisturbed) {
        kept = open(problem, alone, observer);
        run = kept->upToFinish(observer, nullptr);
    }
    if (bytes() > most_)
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
