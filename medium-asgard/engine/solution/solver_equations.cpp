// What an event's new equations make of the components; see solver.h.
#include "solution/solver_implementation.h"

#include <cmath>
#include <map>
#include <set>

namespace solution {

namespace {

// Of a velocity that jumps beside larger ones: as good as none.
constexpr double rounding = 1e-14;

} // namespace

void Solver::Implementation::retire(Component& component) {
    const ComponentStatistics s = component.statistics();
    past_.steps += s.steps;
    past_.integratedSteps += s.integratedSteps;
    past_.addIntegrated(s);
    past_.rejectedSteps += s.rejectedSteps;
    past_.unconvergedSteps += s.unconvergedSteps;
    past_.discardedSteps += s.discardedSteps;
    past_.evaluations += s.evaluations;
    past_.equationEvaluations += s.evaluations * s.unknowns.size();
    past_.factorisations += s.factorisations;
    past_.switches += s.switches;
    retiredBeyond_ = std::min(retiredBeyond_, component.hopelessBeyond());
}

// Equations from the event on.
void Solver::Implementation::change(const Event& event, const Changes& changes) {
    for (const auto& change : changes.equations) {
        expression::Phase phase = change.phase;
        phase.from = event.time;
        set_.replace(change.unknown, phase, change.later);
    }
    for (const Changes::Reading& reading : changes.readings)
        set_.replace(reading.reading, event.time, reading.node);
}

// Unknowns that an event adds: asleep, until it gives them equations.
void Solver::Implementation::add(const Changes& changes) {
    for (const Changes::Addition& added : changes.additions) {
        set_.add(added.unknown);
        zero_.add(*set_);
        Histories::Track track;
        auto history = std::make_shared<History>(1);
        constexpr double none = 0;
        history->append({options_.start, infinity, 1, true, 1}, std::span(&none, 1));
        track.spans.push_back({options_.start, std::move(history), 0});
        histories_.tracks_.push_back(std::move(track));
        componentOf_.push_back(noComponent);
        if (!options_.tolerances.empty()) {
            options_.tolerances.push_back(options_.tolerances[added.like]);
            options_.extents.push_back(options_.extents[added.like]);
        }
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

// A row that ends, and that was 0 all the time.
bool Solver::Implementation::sleepsOn(const Changes::Equation& change) const {
    const auto& given = change.phase.given;
    return zero_.contains(change.unknown) && given &&
           set_->graph.op(*given) == expression::Op::constant && set_->graph.value(*given) == 0;
}

// What no longer stays 0, since the event moves it or its new equations do. An impact is computed
// in three dimensions; what its rounding leaves out of the plane moves nothing.
std::vector<std::size_t>
Solver::Implementation::roused(double time, std::span<const Changes::Jump> jumps) const {
    std::vector<std::size_t> roused;
    if (std::ranges::none_of(jumps, [this](const Changes::Jump& jump) {
            return zero_.contains(jump.unknown) && jump.value != 0;
        }))
        return roused;
    double largest = 0;
    for (const auto& jump : jumps)
        if (set_->unknowns[jump.unknown].lengthPerUnit == 0)
            largest = std::max({largest, magnitude(jump.unknown, jump.value),
                                magnitude(jump.unknown, histories_.value(jump.unknown, time))});
    for (const auto& jump : jumps)
        if (zero_.contains(jump.unknown) && jump.value != 0 &&
            !(magnitude(jump.unknown, jump.value) <= rounding * largest))
            roused.push_back(jump.unknown);
    return roused;
}

std::vector<std::size_t> Solver::Implementation::woken(const Event& event, const Changes& changes) {
    const std::vector<std::size_t> roused = this->roused(event.time, changes.jumps);
    if (roused.empty() && changes.equations.empty())
        return {};
    std::vector<std::size_t> changed;
    for (const auto& change : changes.equations)
        if (!sleepsOn(change))
            changed.push_back(change.unknown);
    std::vector<std::size_t> woken = zero_.wake(*set_, event.time, roused, changed);
    std::erase_if(woken, [this](std::size_t u) { return isUnread(u); });
    return woken;
}

// Whose equation is another from the event on: those that are given, and those that read what woke,
// which had a 0 in its place.
std::set<std::size_t> Solver::Implementation::changedBy(const Event& event, const Changes& changes,
                                                        const std::vector<std::size_t>& woken) {
    std::set<std::size_t> changed;
    for (const auto& change : changes.equations)
        if (!isUnread(change.unknown) && !sleepsOn(change))
            changed.insert(change.unknown);
    std::vector<std::size_t> candidates = zero_.readersOf(*set_, woken);
    for (const std::size_t w : woken)
        if (const auto four = set_.index().quaternionOf(w))
            candidates.insert(candidates.end(), set_->quaternions[*four].begin(),
                              set_->quaternions[*four].end());
    const auto isWoken = [&](std::size_t u) { return std::ranges::binary_search(woken, u); };
    for (const std::size_t u : candidates)
        if (!isUnread(u) &&
            std::ranges::any_of(readsOf(*set_, set_.index(), u, event.time, {}), isWoken))
            changed.insert(u);
    return changed;
}

// Groups of which an equation changed, and groups that these equations read now: no other can be
// cut otherwise than before.
Solver::Implementation::Region
Solver::Implementation::regionOf(const Event& event, const std::set<std::size_t>& changed,
                                 const std::vector<std::size_t>& woken) const {
    std::set<std::size_t> groups;
    const auto include = [&](std::size_t unknown) {
        if (componentOf_[unknown] != noComponent)
            groups.insert(schedule_.groupOf(componentOf_[unknown]));
    };
    for (const std::size_t u : changed) {
        include(u);
        if (!zero_.contains(u))
            for (const std::size_t read : readsOf(*set_, set_.index(), u, event.time, zero_))
                include(read);
    }
    Region region{.groups = {groups.begin(), groups.end()},
                  .components = {},
                  .unknowns = woken,
                  .partition = {},
                  .isTaken = false};
    for (const std::size_t u : changed) // new ones
        if (componentOf_[u] == noComponent && !zero_.contains(u) &&
            !std::ranges::binary_search(woken, u))
            region.unknowns.push_back(u);
    for (const std::size_t group : groups)
        for (const std::size_t c : schedule_.components(group)) {
            region.isTaken = region.isTaken || !components_[c];
            if (region.isTaken)
                return region;
            region.components.push_back(c);
            const auto& own = components_[c]->unknowns();
            region.unknowns.insert(region.unknowns.end(), own.begin(), own.end());
        }
    std::ranges::sort(region.unknowns);
    Reads reads;
    for (const std::size_t u : region.unknowns) {
        auto& places = reads.emplace_back(readsOf(*set_, set_.index(), u, event.time, zero_));
        for (std::size_t& read : places)
            read = static_cast<std::size_t>(std::ranges::lower_bound(region.unknowns, read) -
                                            region.unknowns.begin());
    }
    addSharedSwitches(*set_, set_.index(), region.unknowns, event.time, zero_, reads);
    region.partition = options_.whole ? wholePartition(reads) : partitionOf(reads);
    for (auto& component : region.partition.components)
        for (std::size_t& u : component)
            u = region.unknowns[u];
    return region;
}

// Just after the event. Cuts the components that had these unknowns.
std::vector<double> Solver::Implementation::valuesAt(const Event& event, const Changes& changes,
                                                     std::span<const std::size_t> unknowns) {
    std::vector<double> values;
    for (const std::size_t u : unknowns) {
        double value = 0;
        if (componentOf_[u] != noComponent) {
            Component& was = *components_[componentOf_[u]];
            was.backTo(event.time);
            const auto column =
                std::ranges::lower_bound(was.unknowns(), u) - was.unknowns().begin();
            value = was.values()[static_cast<std::size_t>(column)];
        }
        for (const auto& jump : changes.jumps)
            if (jump.unknown == u)
                value = jump.value;
        values.push_back(value);
    }
    return values;
}

// Components that keep their unknowns and equations stay as they are; others are made anew from the
// values at the event. Answers with what must restart.
std::vector<std::size_t> Solver::Implementation::replace(const Event& event, const Changes& changes,
                                                         const std::vector<std::size_t>& woken) {
    const std::set<std::size_t> changed = changedBy(event, changes, woken);
    const Region region = regionOf(event, changed, woken);
    disturbed_ = region.isTaken; // what rests on a body reads it from now on
    if (disturbed_)
        return {};
    const auto stays = [&](const std::vector<std::size_t>& unknowns) {
        const std::size_t c = componentOf_[unknowns[0]];
        return c != noComponent && components_[c]->unknowns() == unknowns &&
               std::ranges::none_of(unknowns, [&](std::size_t u) { return changed.contains(u); });
    };
    std::vector<std::size_t> places, isNew;
    std::vector<std::vector<double>> values;
    std::set<std::size_t> old(region.components.begin(), region.components.end());
    land(region.components);
    for (const std::size_t group : region.groups)
        schedule_.disband(group);
    for (const auto& unknowns : region.partition.components) {
        if (stays(unknowns)) {
            places.push_back(componentOf_[unknowns[0]]);
            old.erase(places.back());
            continue;
        }
        values.push_back(valuesAt(event, changes, unknowns));
        places.push_back(components_.size());
        isNew.push_back(places.back());
        components_.push_back(madeOf(unknowns));
    }
    for (const std::size_t c : old) {
        retire(*components_[c]);
        noteKept(c);
        components_[c].reset();
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const std::size_t u : region.partition.components[i])
            componentOf_[u] = places[i];
    connect(region.partition, places);
    for (const std::size_t c : isNew)
        addTracks(*components_[c], event.time);
    for (std::size_t i = 0; i < isNew.size(); ++i)
        components_[isNew[i]]->startAt(event.time, values[i]);
    stopsChanged_ = true;
    schedule_.arrange(region.partition, places);

    Event again = event;
    for (const std::size_t c : isNew) {
        const auto& own = components_[c]->unknowns();
        again.touched.insert(again.touched.end(), own.begin(), own.end());
    }
    std::vector<std::size_t> touched = touchedBy(again, changes);
    goBack(touched, event.time);
    return touched;
}

} // namespace solution
