#include "resimulation/composition.h"

#include "motion/impact_order.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using Contents = ComputedMotion::Contents;

void putInOrder(const KnownMotion& known, std::vector<Impact> impacts, Contents& contents) {
    const auto& bodies = known.version->scene->bodies;
    contents.impacts = Impacts(std::move(impacts));
    putInOrder(contents.impacts, [&](std::size_t b) { return bodies[b].fixed; });
    std::ranges::sort(contents.notes);
}

void addUnit(const Unit& unit, Contents& contents) {
    for (const auto& [place, stop] : unit.stops)
        contents.stops.emplace(unit.bodyAt(place), stop);
    contents.notes.insert(contents.notes.end(), unit.notes.begin(), unit.notes.end());
}

std::vector<Impact> impactsOf(const KnownMotion& known) {
    std::vector<Impact> impacts;
    for (const UnitPointer& unit : known.units)
        for (Impact impact : unit->impacts) {
            impact.first = unit->bodyAt(impact.first);
            impact.second = unit->bodyAt(impact.second);
            impacts.push_back(impact);
        }
    return impacts;
}

// All but the impacts.
Contents contentsOf(const KnownMotion& known) {
    Contents contents;
    contents.start = known.version->scene->simulator.start;
    contents.finish = known.version->scene->simulator.finish;
    std::unordered_map<const SolvedPart*, std::size_t> index;
    for (const Home& home : known.homes) {
        if (!home.part) { // not known yet
            contents.places.emplace_back();
            continue;
        }
        const auto [part, isNew] = index.try_emplace(home.part.get(), contents.parts.size());
        if (isNew)
            contents.parts.push_back(home.part->motion);
        contents.places.push_back({part->second, home.place});
    }
    for (const UnitPointer& unit : known.units)
        addUnit(*unit, contents);
    return contents;
}

} // namespace

Result compose(const KnownMotion& known, Statistics work) {
    Contents contents = contentsOf(known);
    putInOrder(known, impactsOf(known), contents);
    bool isEstimated = known.isEstimated;
    BodyError error;
    work.components = work.largestComponent = 0;
    for (const UnitPointer& unit : known.units) {
        isEstimated = isEstimated && unit->error;
        if (unit->error)
            error = worse(error, *unit->error);
        work.components += unit->components;
        work.largestComponent = std::max(work.largestComponent, unit->largestComponent);
    }
    if (isEstimated)
        contents.errorEstimate = error.estimate;
    if (std::isfinite(error.predictableUntil))
        contents.predictableUntil = error.predictableUntil;
    const double accuracy = known.version->scene->simulator.accuracy;
    if (isEstimated && error.estimate > accuracy)
        contents.notes.push_back(shortfallOf(accuracy, error));
    work.historyBytes = 0;
    for (const ComputedMotion::Part& part : contents.parts)
        work.historyBytes += part.histories->bytes();
    work.collisions = contents.impacts.size();
    work.errorEstimate = contents.errorEstimate;
    work.predictableUntil = contents.predictableUntil;
    auto motion = std::make_shared<ComputedMotion>(std::move(contents));
    work.reached = motion->computed();
    Result result;
    result.motion = std::move(motion);
    result.statistics = std::move(work);
    return result;
}

MotionPointer composeDraft(const KnownMotion& kept, const ComputedMotion& draft,
                           const std::vector<std::size_t>& bodies) {
    Contents contents = contentsOf(kept);
    contents.draft = true;
    const Contents& grown = draft.contents();
    contents.parts.insert(contents.parts.end(), grown.parts.begin(), grown.parts.end());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i] != scene::noElement)
            contents.places[bodies[i]] = {contents.parts.size() - 1, grown.places[i].body};
    for (const auto& [place, stop] : grown.stops)
        if (bodies[place] != scene::noElement)
            contents.stops.emplace(bodies[place], stop);
    std::vector<Impact> impacts = impactsOf(kept);
    for (Impact impact : grown.impacts) {
        if (bodies[impact.first] == scene::noElement || bodies[impact.second] == scene::noElement)
            continue;
        impact.first = bodies[impact.first];
        impact.second = bodies[impact.second];
        impacts.push_back(impact);
    }
    contents.notes.insert(contents.notes.end(), grown.notes.begin(), grown.notes.end());
    putInOrder(kept, std::move(impacts), contents);
    return std::make_shared<ComputedMotion>(std::move(contents));
}

} // namespace simulation
