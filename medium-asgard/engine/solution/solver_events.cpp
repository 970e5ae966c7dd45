// What an event cuts, and how all goes on from it: solution/event_source.h says what one is.
#include "solution/solver_implementation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace solution {

// True when there was one; the schedule then goes on from it.
bool Solver::Implementation::handleEvents(double finish) {
    const double until = std::min(known(), finish);
    if (until < asked_)
        return false;
    const auto event = source_->next(histories_, until);
    if (!event) {
        asked_ = until;
        return false;
    }
    const double time = std::clamp(event->time, std::max(lastEvent_, options_.start), until);
    lastEvent_ = asked_ = time;
    ++past_.events;
    Event placed = *event;
    placed.time = time;
    apply(placed);
    if (disturbed_)
        return true;
    if (paces_.hopelessFrom(time, placed.touched) < options_.finish)
        stopIsland(placed, "events follow each other so fast that the finish is more than a "
                           "billion of them away");
    paces_.note(time, placed.touched);
    if (!goesOnAfter(placed))
        return false;
    histories_.known_ = std::min(known(), finish);
    return true;
}

// Of what meets what, however many events there are elsewhere at that instant. False: no event is
// asked for any more.
bool Solver::Implementation::goesOnAfter(const Event& event) {
    const std::size_t atOnce = paces_.atOnce(event.time, event.touched);
    if (atOnce < options_.maximumEventsAtOnce)
        return true;
    const std::string tooMany =
        "more than " + std::to_string(options_.maximumEventsAtOnce) + " events at one instant";
    if (atOnce > 2 * options_.maximumEventsAtOnce) { // at what moves no more
        stopAll(event.time, tooMany + " would hide what happens to others");
        return false;
    }
    stopFor(event, Stop::Reason::tooManyEvents, tooMany);
    return true;
}

void Solver::Implementation::apply(const Event& event) {
    Changes changes;
    source_->apply(histories_, event, set_, changes);
    add(changes);
    std::vector<std::size_t> touched = touchedBy(event, changes);
    disturbed_ = std::ranges::any_of(touched, [this](std::size_t c) { return !components_[c]; });
    if (disturbed_)
        return;
    land(touched);
    resume(event, changes, touched);
    // What stays 0 has no component that could be touched, and may be woken.
    if (touched.empty() && roused(event.time, changes.jumps).empty())
        return;
    goBack(touched, event.time);
    change(event, changes);
    const std::vector<std::size_t> awake = woken(event, changes);
    if (!changes.equations.empty() || !awake.empty())
        touched = replace(event, changes, awake);
    if (disturbed_)
        return;
    restart(touched, changes);
    endThose(changes);
    noteStops();
}

// Components of what the event touches, and transitively those that read them, in order.
std::vector<std::size_t> Solver::Implementation::touchedBy(const Event& event,
                                                           const Changes& changes) const {
    std::vector<std::size_t> touched;
    isTouched_.resize(components_.size(), 0);
    const auto touch = [&](std::size_t component) {
        if (component != noComponent && !isTouched_[component]) {
            isTouched_[component] = 1;
            touched.push_back(component);
        }
    };
    for (const std::size_t u : event.touched)
        touch(componentOf_[u]);
    for (const auto& jump : changes.jumps)
        touch(componentOf_[jump.unknown]);
    for (const auto& equation : changes.equations)
        touch(componentOf_[equation.unknown]);
    for (const auto& end : changes.ends)
        for (const std::size_t u : end.unknowns)
            touch(componentOf_[u]);
    for (std::size_t next = 0; next < touched.size(); ++next)
        for (const std::size_t reader : readers_[touched[next]])
            touch(reader);
    for (const std::size_t c : touched)
        isTouched_[c] = 0;
    std::ranges::sort(touched,
                      [this](std::size_t a, std::size_t b) { return schedule_.comesBefore(a, b); });
    return touched;
}

// Those that go on in closed form are done with at once; the others are left, and all after them,
// which may read them.
void Solver::Implementation::resume(const Event& event, const Changes& changes,
                                    std::vector<std::size_t>& touched) {
    if (!changes.equations.empty() || !changes.ends.empty() ||
        !roused(event.time, changes.jumps).empty())
        return;
    std::size_t done = 0;
    for (; done < touched.size(); ++done) {
        Component& component = *components_[touched[done]];
        std::optional<double> value;
        for (const auto& jump : changes.jumps)
            if (jump.unknown == component.unknowns()[0])
                value = jump.value;
        if (!component.resume(event.time, value))
            break;
        noteKept(touched[done]);
    }
    touched.erase(touched.begin(), touched.begin() + static_cast<std::ptrdiff_t>(done));
}

void Solver::Implementation::goBack(const std::vector<std::size_t>& components, double t) {
    for (const std::size_t c : components) {
        Component& component = *components_[c];
        const bool had = component.ended();
        component.backTo(t);
        if (had || component.ended())
            stopsChanged_ = true;
        schedule_.changed(c);
    }
}

void Solver::Implementation::restart(const std::vector<std::size_t>& components,
                                     const Changes& changes) {
    std::map<std::size_t, std::vector<Component::Jump>> jumps;
    for (const auto& jump : changes.jumps) {
        const std::size_t c = componentOf_[jump.unknown];
        if (c == noComponent) // it stays 0
            continue;
        const auto& own = components_[c]->unknowns();
        const auto column = std::lower_bound(own.begin(), own.end(), jump.unknown) - own.begin();
        jumps[c].push_back({static_cast<std::size_t>(column), jump.value});
    }
    for (const std::size_t c : components) {
        components_[c]->restart(jumps[c]);
        noteKept(c);
        if (components_[c]->ended())
            stopsChanged_ = true;
        schedule_.changed(c);
    }
}

void Solver::Implementation::endThose(const Changes& changes) {
    for (const auto& end : changes.ends)
        for (const std::size_t u : end.unknowns) {
            const std::size_t c = componentOf_[u];
            if (c == noComponent || components_[c]->ended())
                continue;
            components_[c]->end(Stop::Reason::source, {}, end.sentence);
            stopsChanged_ = true;
            schedule_.changed(c);
        }
}

void Solver::Implementation::stopFor(const Event& event, Stop::Reason reason,
                                     const std::string& sentence) {
    for (const std::size_t u : event.touched) {
        const std::size_t c = componentOf_[u];
        if (c == noComponent || components_[c]->ended())
            continue;
        components_[c]->end(reason, {}, sentence);
        stopsChanged_ = true;
        schedule_.changed(c);
    }
    noteStops();
}

// No event is asked for any more: what goes on without them would be wrong.
void Solver::Implementation::stopAll(double time, const std::string& sentence) {
    Event all{.time = time, .touched = {}, .tag = 0};
    for (std::size_t u = 0; u < componentOf_.size(); ++u)
        all.touched.push_back(u);
    std::vector<std::size_t> moving = touchedBy(all, {});
    std::erase_if(moving,
                  [this](std::size_t c) { return !components_[c] || components_[c]->ended(); });
    goBack(moving, time);
    stopFor(all, Stop::Reason::tooManyEvents, sentence);
}

void Solver::Implementation::noteStops() {
    if (!stopsChanged_.exchange(false))
        return;
    if (histories_.stops_.empty() &&
        std::ranges::none_of(components_, [](const auto& c) { return c && c->ended(); }))
        return;
    histories_.stops_.clear();
    for (auto& track : histories_.tracks_)
        track.stop.reset();
    for (const auto& component : components_) {
        if (!component || !component->stop() || isAdded(component->unknowns()[0]))
            continue;
        for (const std::size_t u : component->unknowns())
            histories_.tracks_[u].stop = histories_.stops_.size();
        Stop stop = *component->stop();
        for (std::vector<std::size_t>* list : {&stop.unknowns, &stop.culprits})
            std::erase_if(*list, [this](std::size_t u) { return isAdded(u); });
        histories_.stops_.push_back(std::move(stop));
    }
}

// What takes part in the event, and all that it met by then; others go on. What reads those ends
// with them.
void Solver::Implementation::stopIsland(const Event& event, const std::string& sentence) {
    Event island{.time = event.time, .touched = paces_.islandOf(event.touched[0]), .tag = 0};
    std::erase_if(island.touched, [this](std::size_t u) { return componentOf_[u] == noComponent; });
    const std::vector<std::size_t> all = touchedBy(island, {});
    land(all);
    goBack(all, event.time);
    restart(all, {});
    stopFor(island, Stop::Reason::tooLong, sentence);
}

} // namespace solution
