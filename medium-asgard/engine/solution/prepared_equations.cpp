#include "solution/prepared_equations.h"

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

Partition partitionAtStart(const expression::EquationSet& set, const UnknownIndex& index,
                           const ZeroStates& zero, const Preparation& how) {
    const Reads reads = readsOf(set, index, how.start, zero);
    return how.whole ? wholePartition(reads) : partitionOf(reads, zero);
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
      zero(zeroAtStart(*set, how)), partition(partitionAtStart(*set, index, zero, how)) {
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
