#include "solution/replacement.h"

#include "solution/awakening.h"

#include <algorithm>
#include <iterator>

namespace solution {

void Replacement::retire(Component& component) {
    const ComponentStatistics s = component.statistics();
    retired_.addWork(s);
    retired_.addIntegrated(s);
}

// Equations from the event on.
void Replacement::change(const Event& event, const Changes& changes) {
    for (const auto& change : changes.equations) {
        expression::Phase phase = change.phase;
        phase.from = event.time;
        network_.set.replace(change.unknown, phase, change.later);
    }
    for (const Changes::Reading& reading : changes.readings)
        network_.set.replace(reading.reading, event.time, reading.node);
}

// Whose equation is another from the event on: those that are given, and those that read what woke,
// which had a 0 in its place.
std::set<std::size_t> Replacement::changedBy(const Event& event, const Changes& changes,
                                             const std::vector<std::size_t>& woken) {
    std::set<std::size_t> changed;
    for (const auto& change : changes.equations)
        if (!network_.isUnread(change.unknown) && !sleepsOn(network_, change))
            changed.insert(change.unknown);
    std::vector<std::size_t> candidates = network_.zero.readersOf(*network_.set, woken);
    for (const std::size_t w : woken)
        if (const auto four = network_.set.index().quaternionOf(w))
            candidates.insert(candidates.end(), network_.set->quaternions[*four].begin(),
                              network_.set->quaternions[*four].end());
    const auto isWoken = [&](std::size_t u) { return std::ranges::binary_search(woken, u); };
    std::erase_if(candidates,
                  [&](std::size_t u) { return network_.isUnread(u) || changed.contains(u); });
    const Reads reads = readsOf(*network_.set, network_.set.index(), candidates, event.time, {});
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (std::ranges::any_of(reads[i], isWoken))
            changed.insert(candidates[i]);
    return changed;
}

// Groups of which an equation changed, and groups that these equations read now: no other can be
// cut otherwise than before.
Replacement::Region Replacement::regionOf(const Event& event, const std::set<std::size_t>& changed,
                                          const std::vector<std::size_t>& woken) const {
    std::set<std::size_t> groups;
    const auto include = [&](std::size_t unknown) {
        if (network_.componentOf[unknown] != noComponent)
            groups.insert(network_.schedule.groupOf(network_.componentOf[unknown]));
    };
    const auto readsNow = [&](std::span<const std::size_t> unknowns) {
        return readsOf(*network_.set, network_.set.index(), unknowns, event.time, network_.zero);
    };
    std::vector<std::size_t> awake;
    for (const std::size_t u : changed) {
        include(u);
        if (!network_.zero.contains(u))
            awake.push_back(u);
    }
    Reads readByAwake = readsNow(awake);
    for (const std::vector<std::size_t>& read : readByAwake)
        std::ranges::for_each(read, include);
    Region region{.groups = {groups.begin(), groups.end()},
                  .components = {},
                  .unknowns = woken,
                  .partition = {},
                  .isTaken = false};
    for (const std::size_t u : changed) // new ones
        if (network_.componentOf[u] == noComponent && !network_.zero.contains(u) &&
            !std::ranges::binary_search(woken, u))
            region.unknowns.push_back(u);
    for (const std::size_t group : groups)
        for (const std::size_t c : network_.schedule.components(group)) {
            region.isTaken = region.isTaken || !network_.components[c];
            if (region.isTaken)
                return region;
            region.components.push_back(c);
            const auto& own = network_.components[c]->unknowns();
            region.unknowns.insert(region.unknowns.end(), own.begin(), own.end());
        }
    std::ranges::sort(region.unknowns);
    std::vector<std::size_t> rest;
    std::ranges::set_difference(region.unknowns, awake, std::back_inserter(rest));
    Reads readByRest = readsNow(rest), reads;
    auto ofAwake = readByAwake.begin(), ofRest = readByRest.begin();
    for (const std::size_t u : region.unknowns)
        reads.push_back(std::move(std::ranges::binary_search(awake, u) ? *ofAwake++ : *ofRest++));
    for (std::vector<std::size_t>& places : reads)
        for (std::size_t& read : places)
            read = static_cast<std::size_t>(std::ranges::lower_bound(region.unknowns, read) -
                                            region.unknowns.begin());
    addSharedSwitches(*network_.set, network_.set.index(), region.unknowns, event.time,
                      network_.zero, reads);
    region.partition = network_.options.whole ? wholePartition(reads) : partitionOf(reads);
    for (auto& component : region.partition.components)
        for (std::size_t& u : component)
            u = region.unknowns[u];
    return region;
}

// Just after the event. Cuts the components that had these unknowns.
std::vector<double> Replacement::valuesAt(const Event& event, const Changes& changes,
                                          std::span<const std::size_t> unknowns) {
    std::vector<double> values;
    for (const std::size_t u : unknowns) {
        double value = 0;
        if (network_.componentOf[u] != noComponent) {
            Component& was = *network_.components[network_.componentOf[u]];
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
std::vector<std::size_t> Replacement::replace(const Event& event, const Changes& changes,
                                              const std::vector<std::size_t>& woken) {
    const std::set<std::size_t> changed = changedBy(event, changes, woken);
    const Region region = regionOf(event, changed, woken);
    network_.isDisturbed = region.isTaken; // what rests on a body reads it from now on
    if (network_.isDisturbed)
        return {};
    const auto stays = [&](const std::vector<std::size_t>& unknowns) {
        const std::size_t c = network_.componentOf[unknowns[0]];
        return c != noComponent && network_.components[c]->unknowns() == unknowns &&
               std::ranges::none_of(unknowns, [&](std::size_t u) { return changed.contains(u); });
    };
    std::vector<std::size_t> places, isNew;
    std::vector<std::vector<double>> values;
    std::set<std::size_t> old(region.components.begin(), region.components.end());
    flights_.land(region.components);
    for (const std::size_t group : region.groups)
        network_.schedule.disband(group);
    for (const auto& unknowns : region.partition.components) {
        if (stays(unknowns)) {
            places.push_back(network_.componentOf[unknowns[0]]);
            old.erase(places.back());
            continue;
        }
        values.push_back(valuesAt(event, changes, unknowns));
        places.push_back(network_.components.size());
        isNew.push_back(places.back());
        network_.components.push_back(network_.madeOf(unknowns));
    }
    for (const std::size_t c : old) {
        retire(*network_.components[c]);
        network_.noteKept(c);
        network_.components[c].reset();
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const std::size_t u : region.partition.components[i])
            network_.componentOf[u] = places[i];
    network_.connect(region.partition, places);
    for (const std::size_t c : isNew)
        network_.addTracks(*network_.components[c], event.time);
    for (std::size_t i = 0; i < isNew.size(); ++i)
        network_.components[isNew[i]]->startAt(event.time, values[i]);
    network_.areStopsNew = true;
    network_.schedule.arrange(region.partition, places);

    Event again = event;
    for (const std::size_t c : isNew) {
        const auto& own = network_.components[c]->unknowns();
        again.touched.insert(again.touched.end(), own.begin(), own.end());
    }
    std::vector<std::size_t> touched = network_.touchedBy(again, changes);
    network_.goBack(touched, event.time);
    return touched;
}

} // namespace solution
