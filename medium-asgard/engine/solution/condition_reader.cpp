#include "solution/condition_reader.h"

#include "modes/component_equations.h"

#include <algorithm>
#include <limits>
#include <set>

namespace solution {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

bool isMultiplier(const expression::Unknown& unknown) {
    return unknown.phases.front().condition.has_value();
}

} // namespace

ConditionGroups::ConditionGroups(const PreparedEquations& prepared) {
    const expression::EquationSet& set = *prepared.set;
    groupOf_.assign(set.unknowns.size(), none);
    if (std::ranges::none_of(set.unknowns, isMultiplier))
        return;
    const Partition partition = partitionOf(readsOf(set, prepared.index, prepared.how.start), {});
    for (const std::vector<std::size_t>& unknowns : partition.components) {
        if (std::ranges::none_of(unknowns,
                                 [&](std::size_t u) { return isMultiplier(set.unknowns[u]); }))
            continue;
        std::set<double> times{prepared.how.start};
        for (const std::size_t u : unknowns) {
            groupOf_[u] = groups_.size();
            for (const expression::Phase& phase : set.unknowns[u].phases)
                if (phase.from > prepared.how.start)
                    times.insert(phase.from);
        }
        Group group{.unknowns = unknowns, .models = {}};
        for (const double time : times) {
            std::vector<std::size_t> phases;
            for (const std::size_t u : unknowns)
                phases.push_back(phaseAt(set.unknowns[u], time));
            group.models.emplace_back(
                time, std::make_shared<const BoundModel>(boundModel(
                          set, prepared.index, {}, unknowns, phases, *prepared.how.models)));
        }
        groups_.push_back(std::move(group));
    }
}

ConditionReader::ConditionReader(std::shared_ptr<const ConditionGroups> groups,
                                 std::shared_ptr<const Histories> histories)
    : groups_(std::move(groups)), histories_(std::move(histories)),
      places_(groups_->groups_.size()) {}

ConditionReader::~ConditionReader() = default;

// With mutex_ locked.
void ConditionReader::find(std::size_t group, double time) const {
    const ConditionGroups::Group& of = groups_->groups_[group];
    Place& place = places_[group];
    if (place.equations && place.time == time)
        return;
    const auto after = std::ranges::upper_bound(of.models, time, {},
                                                [](const auto& model) { return model.first; });
    const auto model =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - of.models.begin() - 1, 0));
    if (!place.equations || place.model != model)
        place.equations =
            std::make_unique<ComponentEquations>(of.models[model].second, *histories_);
    place.model = model;
    place.time = time;
    ComponentEquations& equations = *place.equations;
    equations.inputs().window(infinity);
    place.values.resize(of.unknowns.size());
    for (std::size_t i = 0; i < of.unknowns.size(); ++i)
        place.values[i] = histories_->value(of.unknowns[i], time);
    std::vector<double> y, rates(equations.states().size());
    for (const std::size_t i : equations.states())
        y.push_back(place.values[i]);
    if (!equations.model().surfaces().empty()) {
        std::vector<double> decided = y;
        equations.solver().decide(time, decided);
    }
    std::vector<double> kept;
    for (const std::size_t i : equations.multipliers())
        kept.push_back(place.values[i]);
    equations.takeKept(kept);
    equations.project(time, y);
    (void)equations.rates(time, y, rates);
    for (std::size_t k = 0; k < y.size(); ++k)
        place.values[equations.states()[k]] = y[k];
    for (std::size_t k = 0; k < equations.multipliers().size(); ++k)
        place.values[equations.multipliers()[k]] = equations.multiplierValues()[k];
    std::vector<double> held(equations.held().size());
    if (equations.heldValues(time, y, held))
        for (std::size_t k = 0; k < held.size(); ++k)
            place.values[equations.held()[k]] = held[k];
}

bool ConditionReader::values(std::size_t unknown, double time, std::span<double> out) const {
    const std::size_t group = groups_->groupOf_[unknown];
    if (group == none)
        return false;
    const std::scoped_lock lock(mutex_);
    find(group, time);
    const std::vector<std::size_t>& unknowns = groups_->groups_[group].unknowns;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const auto at = std::ranges::lower_bound(unknowns, unknown + i);
        out[i] = at != unknowns.end() && *at == unknown + i
                     ? places_[group].values[static_cast<std::size_t>(at - unknowns.begin())]
                     : histories_->value(unknown + i, time);
    }
    return true;
}

} // namespace solution
