#include "solution/events.h"

#include "solution/awakening.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace solution {

Events::Events(Network& network, Interruption& interruption, EventSource* source)
    : network_(network), interruption_(interruption), source_(source) {
    if (source_)
        source_->use(*this);
}

bool Events::handleAll(double finish) {
    if (!source_)
        return false;
    bool any = false;
    while (!interruption_.isCancelled() && !network_.isDisturbed && !memory_.isFull() &&
           handleNext(finish)) {
        any = true;
        interruption_.poll(lastEvent_);
    }
    // A source that was interrupted has not said that nothing happens.
    interruption_.poll(network_.histories.known());
    return std::exchange(hasGoneBack_, false) || any;
}

Statistics Events::statistics() const {
    Statistics sum = replacement_.retired();
    sum.events = events_;
    return sum;
}

// True when there was one; the schedule then goes on from it.
bool Events::handleNext(double finish) {
    const double until = std::min(network_.known(), finish);
    if (until < asked_)
        return false;
    auto event = source_->next(network_.histories, until);
    if (!event) {
        asked_ = until;
        network_.setKnown(std::min(network_.known(), finish)); // it may have gone back
        return false;
    }
    event->time = std::clamp(event->time, std::max(lastEvent_, network_.options.start), until);
    lastEvent_ = asked_ = event->time;
    ++events_;
    apply(*event);
    if (network_.isDisturbed)
        return true;
    islands_.note(event->time, event->touched);
    if (!goesOnAfter(*event))
        return false;
    network_.setKnown(std::min(network_.known(), finish));
    return true;
}

// The count is that of the bodies that meet, whatever happens elsewhere at that instant. False: no
// event is asked for any more.
bool Events::goesOnAfter(const Event& event) {
    const std::size_t most = network_.options.maximumEventsAtOnce;
    const std::size_t atOnce = islands_.atOnce(event.time, event.touched);
    if (atOnce < most)
        return true;
    const std::string tooMany = "more than " + std::to_string(most) + " events at one instant";
    if (atOnce > 2 * most) { // at what moves no more
        stopAll(event.time, tooMany + " would hide what happens to others");
        return false;
    }
    network_.end(event.touched, Stop::Reason::tooManyEvents, tooMany);
    network_.noteStops();
    return true;
}

void Events::apply(const Event& event) {
    Changes changes;
    source_->apply(network_.histories, event, network_.set, changes);
    for (const Changes::Addition& added : changes.additions)
        network_.addUnknown(added);
    std::vector<std::size_t> touched = network_.touchedBy(event, changes);
    network_.isDisturbed =
        std::ranges::any_of(touched, [this](std::size_t c) { return !network_.components[c]; });
    if (network_.isDisturbed)
        return;
    flights_.land(touched);
    resume(event, changes, touched);
    // An unknown that stays 0 has no component that could be touched, and may be woken.
    if (touched.empty() && roused(network_, event.time, changes.jumps).empty())
        return;
    network_.goBack(touched, event.time);
    replacement_.change(event, changes);
    const std::vector<std::size_t> woken = wake(network_, event, changes);
    if (!changes.equations.empty() || !woken.empty())
        touched = replacement_.replace(event, changes, woken);
    if (network_.isDisturbed)
        return;
    network_.restart(touched, changes);
    network_.endThose(changes);
    network_.noteStops();
}

// The same as handleNext() does of such an event.
bool Events::turn(double time, std::span<Turn> turns) {
    turning_.clear();
    for (const Turn& one : turns)
        turning_.push_back(one.places[0]);
    if (!(time >= lastEvent_ && time >= network_.options.start) || memory_.isFull() ||
        islands_.atOnce(time, turning_) + 1 >= network_.options.maximumEventsAtOnce ||
        !flights_.stayInPlane(time, turns) || !flights_.turn(time, turns))
        return false;
    lastEvent_ = asked_ = time;
    ++events_;
    islands_.note(time, turning_);
    interruption_.poll(time);
    return true;
}

// Nothing goes back to before the last event, which is done.
std::optional<double> Events::approach(double time, std::span<const std::size_t> unknowns,
                                       const IsBefore& isBefore) {
    constexpr int doublings = 6; // of a hundredth of a step
    const Event event{.time = time, .touched = {unknowns.begin(), unknowns.end()}, .tag = 0};
    const std::vector<std::size_t> touched = network_.touchedBy(event, {});
    if (std::ranges::any_of(touched, [this](std::size_t c) { return !network_.components[c]; }))
        return std::nullopt;
    double end = time;
    for (const std::size_t c : touched)
        end = std::min(end, network_.components[c]->endBefore(time).value_or(time));
    const double earliest = std::max(lastEvent_, network_.options.start);
    end = std::max(end, earliest);
    if (!(end < time))
        return std::nullopt;
    flights_.land(touched);
    const auto goBack = [&] {
        network_.goBack(touched, end);
        network_.restart(touched, {});
    };
    const Values values = [&](std::size_t unknown) {
        const std::size_t c = network_.componentOf[unknown];
        return std::ranges::find(touched, c) != touched.end()
                   ? network_.components[c]->valueOf(unknown)
                   : network_.histories.value(unknown, end);
    };
    goBack();
    for (int i = 0; i < doublings && end > earliest && !isBefore(end, values); ++i) {
        end = std::max(time - 2 * (time - end), earliest);
        goBack();
    }
    network_.noteStops();
    hasGoneBack_ = true;
    return end;
}

// Those that go on in closed form are done with at once; the others are left, and all after them,
// which may read them.
void Events::resume(const Event& event, const Changes& changes, std::vector<std::size_t>& touched) {
    if (!changes.equations.empty() || !changes.ends.empty() ||
        !roused(network_, event.time, changes.jumps).empty())
        return;
    std::size_t done = 0;
    for (; done < touched.size(); ++done) {
        Component& component = *network_.components[touched[done]];
        std::optional<double> value;
        for (const auto& jump : changes.jumps)
            if (jump.unknown == component.unknowns()[0])
                value = jump.value;
        if (!component.resume(event.time, value))
            break;
        network_.noteKept(touched[done]);
    }
    touched.erase(touched.begin(), touched.begin() + static_cast<std::ptrdiff_t>(done));
}

// No event is asked for any more: what goes on without them would be wrong.
void Events::stopAll(double time, const std::string& sentence) {
    Event all{.time = time, .touched = {}, .tag = 0};
    for (std::size_t u = 0; u < network_.componentOf.size(); ++u)
        all.touched.push_back(u);
    std::vector<std::size_t> moving = network_.touchedBy(all, {});
    std::erase_if(moving, [this](std::size_t c) {
        return !network_.components[c] || network_.components[c]->ended();
    });
    network_.goBack(moving, time);
    network_.end(all.touched, Stop::Reason::tooManyEvents, sentence);
    network_.noteStops();
}

} // namespace solution
