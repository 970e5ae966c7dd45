#include "solution/rounds.h"

#include "batches/alike_steps.h"
#include "solution/side_by_side.h"

#include <algorithm>
#include <vector>

namespace solution {

void Rounds::advanceGroup(std::size_t group, const Leg& leg) {
    Schedule& schedule = network_.schedule;
    if (schedule.components(group).size() == 1)
        return advanceAlone(schedule.components(group)[0], leg);
    const bool isCaller = interruption_.isCaller();
    std::size_t added = 0;
    for (bool any = true; !interruption_.isCancelled() && added <= leg.share; any = false) {
        if (isCaller)
            interruption_.poll(network_.components[schedule.components(group)[0]]->time());
        const auto behind = schedule.next(group, leg.until, any, !network_.options.eventDriven);
        if (!behind || interruption_.isCancelled())
            return;
        Component& component = network_.readyFor(*network_.components[*behind]);
        const std::size_t before = component.history()->bytes(), switches = component.switches();
        component.step();
        added += component.history()->bytes() - std::min(before, component.history()->bytes());
        schedule.stepped(network_.componentOf[component.unknowns()[0]]);
        if (component.ended()) { // its readers must be told first
            network_.areStopsNew = true;
            return;
        }
        if (haveEvents_ && component.switches() != switches)
            return;
    }
}

// It reads no other: nobody need be asked whose turn it is.
void Rounds::advanceAlone(std::size_t place, const Leg& leg) {
    const bool isCaller = interruption_.isCaller();
    Component& component = *network_.components[place];
    const History& history = *component.history();
    const std::size_t most = history.bytes() + leg.share, switches = component.switches();
    for (bool any = network_.options.eventDriven; !interruption_.isCancelled(); any = false) {
        if (isCaller)
            interruption_.poll(component.time());
        if (interruption_.isCancelled() || component.ended() ||
            !(any || component.time() < leg.until) || history.bytes() > most)
            break;
        (void)network_.readyFor(component);
        component.step();
        if (component.ended())
            network_.areStopsNew = true;
        if (haveEvents_ && component.switches() != switches)
            break;
    }
    network_.schedule.stepped(place);
}

// Those that are by themselves go side by side.
void Rounds::advanceGroups(std::span<const std::size_t> groups, const Leg& leg) {
    std::vector<std::size_t> single;
    for (const std::size_t group : groups) {
        const std::vector<std::size_t>& places = network_.schedule.components(group);
        const bool maySo = groups.size() > 1 && places.size() == 1 &&
                           network_.options.eventDriven &&
                           network_.components[places[0]]->integration().mayGoSideBySide();
        if (maySo)
            single.push_back(places[0]);
        else
            advanceGroup(group, leg);
    }
    if (!single.empty())
        advanceSideBySide(single, leg);
}

void Rounds::advanceSideBySide(std::span<const std::size_t> places, const Leg& leg) {
    constexpr std::size_t seldom = 64; // steps, each time that all are counted
    const bool isCaller = interruption_.isCaller();
    std::vector<Component*> components;
    for (const std::size_t place : places)
        components.push_back(network_.components[place].get());
    const auto bytes = [&components] {
        std::size_t sum = 0;
        for (const Component* component : components)
            sum += component->history()->bytes();
        return sum;
    };
    const std::size_t before = bytes(), share = leg.share * places.size();
    std::size_t asked = 0;
    solution::advanceSideBySide(components, leg.until, [&, this](double time) {
        if (isCaller)
            interruption_.poll(time);
        const bool isFull = ++asked % (seldom * places.size()) == 0 && bytes() > before + share;
        return !interruption_.isCancelled() && !isFull;
    });
    for (const std::size_t place : places) {
        if (network_.components[place]->ended())
            network_.areStopsNew = true;
        network_.schedule.stepped(place);
    }
}

// That a thread takes: few, so that none waits long for the last, but enough to go side by side.
static std::size_t groupsAtOnce(std::size_t groups, std::size_t threads) {
    constexpr std::size_t parts = 16, side = AlikeSteps::lanes;
    if (threads == 1)
        return std::max<std::size_t>(1, groups);
    return std::max(1 + groups / (parts * threads), std::min(side, groups / (2 * threads)));
}

// Starting threads costs more than a few small steps do.
void Rounds::doOne(double until) {
    constexpr std::size_t enough = 64; // unknowns
    const bool unbroken = !haveEvents_ || !network_.options.eventDriven;
    const Schedule::Round round = network_.schedule.nextRound(until, unbroken);
    const std::size_t count = round.groups.size();
    const std::size_t atOnce = groupsAtOnce(count, workers_.threads());
    const Leg leg{.until = round.until, .share = network_.kept.share(count)};
    const auto advance = [&](std::size_t piece) {
        const std::size_t first = atOnce * piece;
        advanceGroups(std::span(round.groups).subspan(first, std::min(atOnce, count - first)), leg);
    };
    const std::size_t pieces = (count + atOnce - 1) / atOnce;
    ++done_;
    if (round.work < enough)
        for (std::size_t piece = 0; piece < pieces; ++piece)
            advance(piece);
    else
        workers_.forEach(pieces, advance,
                         [this] { interruption_.poll(network_.histories.known()); });
    for (const std::size_t group : round.groups) {
        network_.schedule.settle(group);
        for (const std::size_t component : network_.schedule.components(group))
            network_.noteKept(component);
    }
    network_.noteStops();
}

} // namespace solution
