#include "equations/prepared_equations.h"

namespace solution {

namespace {

ZeroStates zeroAtStart(const expression::EquationSet& set, const Preparation& how) {
    if (how.everyState)
        return {};
    std::vector<double> initial;
    for (const expression::Unknown& unknown : set.unknowns)
        initial.push_back(unknown.initial);
    return ZeroStates(set, how.start, initial);
}

// What an event wakes may be read too: nothing is taken as 0 here.
std::vector<bool> unreadAtStart(const expression::EquationSet& set, const UnknownIndex& index,
                                const Preparation& how) {
    if (how.everyState || !how.asked)
        return {};
    return unreadBy(*how.asked, readsOf(set, index, how.start));
}

Partition partitionAtStart(const expression::EquationSet& set, const UnknownIndex& index,
                           const ZeroStates& zero, const std::vector<bool>& unread,
                           const Preparation& how) {
    const Reads reads = readsOf(set, index, how.start, zero);
    if (how.whole)
        return wholePartition(reads);
    std::vector<bool> leftOut(reads.size());
    for (std::size_t u = 0; u < leftOut.size(); ++u)
        leftOut[u] = zero.contains(u) || (!unread.empty() && unread[u]);
    return partitionOf(reads, leftOut);
}

Preparation withModels(Preparation how) {
    if (!how.models)
        how.models = std::make_shared<ComponentModels>();
    return how;
}

} // namespace

std::size_t phaseAt(const expression::Unknown& unknown, double time) {
    std::size_t phase = 0;
    while (phase + 1 < unknown.phases.size() && unknown.phases[phase + 1].from <= time)
        ++phase;
    return phase;
}

PreparedEquations::PreparedEquations(std::shared_ptr<const expression::EquationSet> equations,
                                     Preparation preparation,
                                     const std::function<void()>& meanwhile)
    : set(std::move(equations)), how(withModels(std::move(preparation))), index(*set),
      zero(zeroAtStart(*set, how)), unread(unreadAtStart(*set, index, how)),
      partition(partitionAtStart(*set, index, zero, unread, how)) {
    for (const auto& unknowns : partition.components) {
        if (components.size() % 256 == 255 && meanwhile)
            meanwhile();
        Component component;
        for (const std::size_t u : unknowns)
            component.phases.push_back(phaseAt(set->unknowns[u], how.start));
        component.bound = std::make_shared<const BoundModel>(
            boundModel(*set, index, zero, unknowns, component.phases, *how.models));
        components.push_back(std::move(component));
    }
}

} // namespace solution
