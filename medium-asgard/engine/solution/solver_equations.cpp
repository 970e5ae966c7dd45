// What an event's new equations make of the components; see solver.h.
#include "solution/solver_implementation.h"

#include <cmath>
#include <map>

namespace solution {

namespace {

// Of a velocity that jumps beside larger ones: as good as none.
constexpr double rounding = 1e-14;

} // namespace

void Solver::Implementation::retire(Component& component) {
    const ComponentStatistics s = component.statistics();
    past_.steps += s.steps;
    past_.integratedSteps += s.integratedSteps;
    if (s.integratedSteps > 0)
        past_.integrated.insert(past_.integrated.end(), s.unknowns.begin(), s.unknowns.end());
    past_.rejectedSteps += s.rejectedSteps;
    past_.unconvergedSteps += s.unconvergedSteps;
    past_.discardedSteps += s.discardedSteps;
    past_.evaluations += s.evaluations;
    past_.equationEvaluations += s.evaluations * s.unknowns.size();
    past_.factorisations += s.factorisations;
    past_.switches += s.switches;
}

// Equations from the event on.
void Solver::Implementation::change(const Event& event, const Changes& changes) {
    for (const auto& change : changes.equations) {
        auto& phases = set_.changing().unknowns[change.unknown].phases;
        std::erase_if(phases, [&](const expression::Phase& p) { return p.from >= event.time; });
        phases.push_back(change.phase);
        phases.back().from = event.time;
        phases.insert(phases.end(), change.later.begin(), change.later.end());
    }
}

// How fast a jump moves points: comparable between velocities and spins. Infinite: a position.
double Solver::Implementation::magnitude(std::size_t unknown, double value) const {
    const expression::Unknown& u = set_->unknowns[unknown];
    if (u.lengthPerUnit > 0)
        return value == 0 ? 0 : infinity;
    const bool turns = !u.integralOf && !options_.extents.empty();
    return std::abs(value) * (turns ? options_.extents[unknown] : 1);
}

// What no longer stays 0, since the event moves it or its new equations do. An impact is computed
// in three dimensions; what its rounding leaves out of the plane moves nothing.
std::vector<std::size_t> Solver::Implementation::roused(const Event& event,
                                                        const Changes& changes) const {
    std::vector<std::size_t> roused;
    if (zero_.empty())
        return roused;
    double largest = 0;
    for (const auto& jump : changes.jumps)
        if (set_->unknowns[jump.unknown].lengthPerUnit == 0)
            largest =
                std::max({largest, magnitude(jump.unknown, jump.value),
                          magnitude(jump.unknown, histories_.value(jump.unknown, event.time))});
    for (const auto& jump : changes.jumps)
        if (zero_.contains(jump.unknown) && jump.value != 0 &&
            !(magnitude(jump.unknown, jump.value) <= rounding * largest))
            roused.push_back(jump.unknown);
    return roused;
}

std::vector<std::size_t> Solver::Implementation::woken(const Event& event, const Changes& changes) {
    const std::vector<std::size_t> roused = this->roused(event, changes);
    if (roused.empty() && changes.equations.empty())
        return {};
    return zero_.wake(*set_, event.time, roused);
}

// Components that keep their unknowns and equations stay as they are; others are made anew from the
// values at the event. Answers with what must restart.
std::vector<std::size_t> Solver::Implementation::replace(const Event& event, const Changes& changes,
                                                         const std::vector<std::size_t>& woken) {
    std::set<std::size_t> changed;
    for (const auto& change : changes.equations)
        changed.insert(change.unknown);
    if (!woken.empty()) { // who reads them had a 0 in their place
        const Reads all = readsOf(*set_, prepared_->index, event.time);
        for (std::size_t u = 0; u < all.size(); ++u)
            if (std::ranges::any_of(
                    woken, [&](std::size_t w) { return std::ranges::binary_search(all[u], w); }))
                changed.insert(u);
    }
    const Partition partition = this->partition(event.time);
    std::vector<std::unique_ptr<Component>> old = std::move(components_);
    const std::vector<std::size_t> oldOf = componentOf_;
    components_.clear();
    connect(partition);

    const auto stays = [&](const std::vector<std::size_t>& unknowns) {
        const std::size_t c = oldOf[unknowns[0]];
        const Component* was = c == noComponent ? nullptr : old[c].get();
        return was && was->unknowns() == unknowns &&
               std::none_of(unknowns.begin(), unknowns.end(),
                            [&](std::size_t u) { return changed.contains(u); });
    };
    std::vector<std::size_t> isNew;
    std::map<std::size_t, Stop> ended; // made of unknowns whose motion ended before
    std::vector<std::vector<double>> values(partition.components.size());
    for (std::size_t c = 0; c < partition.components.size(); ++c) {
        const auto& unknowns = partition.components[c];
        if (stays(unknowns)) {
            components_.push_back(nullptr);
            continue;
        }
        isNew.push_back(c);
        for (const std::size_t u : unknowns) {
            if (oldOf[u] == noComponent) {
                values[c].push_back(0);
                continue;
            }
            Component& was = *old[oldOf[u]];
            was.backTo(event.time);
            const auto& own = was.unknowns();
            const auto column = std::lower_bound(own.begin(), own.end(), u) - own.begin();
            values[c].push_back(was.values()[static_cast<std::size_t>(column)]);
        }
        components_.push_back(madeOf(unknowns));
    }
    for (std::size_t c = 0; c < components_.size(); ++c)
        if (!components_[c])
            components_[c] = std::move(old[oldOf[partition.components[c][0]]]);
    for (const auto& component : old)
        if (component)
            retire(*component);
    for (const auto& jump : changes.jumps) {
        const std::size_t c = componentOf_[jump.unknown];
        if (c == noComponent)
            continue;
        const auto& own = partition.components[c];
        const auto column = std::lower_bound(own.begin(), own.end(), jump.unknown) - own.begin();
        if (!values[c].empty())
            values[c][static_cast<std::size_t>(column)] = jump.value;
    }
    for (const std::size_t c : isNew)
        addTracks(*components_[c], event.time);
    for (const std::size_t c : isNew)
        components_[c]->startAt(event.time, values[c]);
    for (const auto& [c, stop] : ended)
        components_[c]->end(stop.reason, {}, stop.sentence);
    live_.clear();
    for (std::size_t c = 0; c < components_.size(); ++c)
        if (!components_[c]->ended())
            live_.emplace(components_[c]->time(), c);

    Event again = event;
    for (const std::size_t c : isNew)
        again.touched.insert(again.touched.end(), partition.components[c].begin(),
                             partition.components[c].end());
    std::vector<std::size_t> touched = touchedBy(again, changes);
    goBack(touched, event.time);
    return touched;
}

} // namespace solution
