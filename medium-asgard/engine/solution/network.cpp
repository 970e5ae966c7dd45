#include "solution/network.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace solution {

namespace {

constexpr std::size_t ofUnknown = 128; // bytes that a component takes beside its steps, for each

} // namespace

// ---------------------------------------------------------------------------------------------
// Making components

Network::Network(std::shared_ptr<const PreparedEquations> equations, Options asked)
    : prepared(std::move(equations)), options(std::move(asked)),
      set(prepared->set, std::shared_ptr<const UnknownIndex>(prepared, &prepared->index)),
      zero(prepared->zero) {
    histories.start_ = histories.known_ = options.start;
    histories.tracks_.resize(set->unknowns.size());
    for (std::size_t u = 0; u < set->unknowns.size(); ++u)
        histories.tracks_[u].initial =
            options.initial.empty() ? set->unknowns[u].initial : options.initial[u];
    place();
    noteStops();
}

std::unique_ptr<Component> Network::madeOf(std::vector<std::size_t> unknowns) {
    return std::make_unique<Component>(
        Component::Surroundings{set, histories, options, zero, *prepared->how.models},
        std::move(unknowns));
}

void Network::place() {
    const double t = options.start;
    const Partition& parts = prepared->partition;
    for (std::size_t c = 0; c < parts.components.size(); ++c) {
        if (isTaken(parts.components[c])) {
            components.emplace_back();
            take(parts.components[c]);
            continue;
        }
        components.push_back(madeOf(parts.components[c]));
        components.back()->use(prepared->components[c]);
        addTracks(*components.back(), t);
    }
    addConstantTracks();
    componentOf = parts.componentOf;
    std::vector<std::size_t> places(components.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    connect(parts, places);
    for (std::size_t c = 0; c < components.size(); ++c) {
        if (!components[c])
            continue;
        std::vector<double> own;
        for (const std::size_t u : components[c]->unknowns())
            own.push_back(histories.tracks_[u].initial);
        components[c]->startAt(t, own);
    }
    schedule.arrange(parts, places);
}

void Network::readFrom(double t, std::size_t unknown, std::shared_ptr<const History> history,
                       std::size_t column) {
    auto& spans = histories.tracks_[unknown].spans;
    while (!spans.empty() && spans.back().from >= t)
        spans.pop_back();
    spans.push_back({t, std::move(history), column});
}

void Network::addTracks(const Component& component, double t) {
    for (std::size_t column = 0; column < component.unknowns().size(); ++column)
        readFrom(t, component.unknowns()[column], component.history(), column);
}

void Network::take(const std::vector<std::size_t>& unknowns) {
    for (const std::size_t u : unknowns)
        histories.tracks_[u] = options.taken->histories->tracks_[u];
}

void Network::takeLonger(std::shared_ptr<const TakenMotion> taken) {
    options.taken = std::move(taken);
    for (const std::vector<std::size_t>& unknowns : prepared->partition.components)
        if (isTaken(unknowns))
            take(unknowns);
}

// One piece from the start to the end of time.
std::shared_ptr<const History> Network::constant(double value) const {
    auto history = std::make_shared<History>(1);
    history->append({options.start, infinity, 1, true, 1}, std::span(&value, 1));
    return history;
}

// Unknowns that are not solved: one piece for all that stay 0, and one for all that nobody reads.
void Network::addConstantTracks() {
    const auto none = constant(0), unread = constant(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t u = 0; u < histories.tracks_.size(); ++u)
        if (zero.contains(u) || isUnread(u))
            histories.tracks_[u].spans.push_back(
                {options.start, zero.contains(u) ? none : unread, 0});
}

void Network::addUnknown(const Changes::Addition& added) {
    set.add(added.unknown);
    zero.add(*set);
    histories.tracks_.emplace_back().spans.push_back({options.start, constant(0), 0});
    componentOf.push_back(noComponent);
    if (!options.tolerances.empty()) {
        options.tolerances.push_back(options.tolerances[added.like]);
        options.extents.push_back(options.extents[added.like]);
    }
}

void Network::connect(const Partition& partition, std::span<const std::size_t> places) {
    readers.resize(components.size());
    for (const std::size_t place : places)
        readers[place].clear();
    for (std::size_t c = 0; c < places.size(); ++c)
        for (const std::size_t input : partition.reads[c])
            readers[places[input]].push_back(places[c]);
    for (const std::size_t place : places)
        if (components[place])
            components[place]->setRead(!readers[place].empty());
}

Component& Network::readyFor(Component& component) {
    Component* candidate = &component;
    while (const auto input = candidate->waitsFor())
        candidate = components[componentOf[*input]].get();
    return *candidate;
}

// ---------------------------------------------------------------------------------------------
// Events

std::vector<std::size_t> Network::touchedBy(const Event& event, const Changes& changes) const {
    std::vector<std::size_t> touched;
    isTouched_.resize(components.size(), 0);
    const auto touch = [&](std::size_t component) {
        if (component != noComponent && !isTouched_[component]) {
            isTouched_[component] = 1;
            touched.push_back(component);
        }
    };
    for (const std::size_t u : event.touched)
        touch(componentOf[u]);
    for (const auto& jump : changes.jumps)
        touch(componentOf[jump.unknown]);
    for (const auto& equation : changes.equations)
        touch(componentOf[equation.unknown]);
    for (const auto& end : changes.ends)
        for (const std::size_t u : end.unknowns)
            touch(componentOf[u]);
    for (std::size_t next = 0; next < touched.size(); ++next)
        for (const std::size_t reader : readers[touched[next]])
            touch(reader);
    for (const std::size_t c : touched)
        isTouched_[c] = 0;
    std::ranges::sort(touched,
                      [this](std::size_t a, std::size_t b) { return schedule.comesBefore(a, b); });
    return touched;
}

void Network::goBack(const std::vector<std::size_t>& touched, double t) {
    for (const std::size_t c : touched) {
        Component& component = *components[c];
        const bool had = component.ended();
        component.backTo(t);
        if (had || component.ended())
            areStopsNew = true;
        schedule.changed(c);
    }
}

void Network::restart(const std::vector<std::size_t>& touched, const Changes& changes) {
    std::map<std::size_t, std::vector<Component::Jump>> jumps;
    for (const auto& jump : changes.jumps) {
        const std::size_t c = componentOf[jump.unknown];
        if (c == noComponent) // it stays 0
            continue;
        const auto& own = components[c]->unknowns();
        const auto column = std::lower_bound(own.begin(), own.end(), jump.unknown) - own.begin();
        jumps[c].push_back({static_cast<std::size_t>(column), jump.value});
    }
    for (const std::size_t c : touched) {
        components[c]->restart(jumps[c]);
        noteKept(c);
        if (components[c]->ended())
            areStopsNew = true;
        schedule.changed(c);
    }
}

void Network::endThose(const Changes& changes) {
    for (const auto& last : changes.ends)
        end(last.unknowns, Stop::Reason::source, last.sentence);
}

void Network::end(std::span<const std::size_t> unknowns, Stop::Reason reason,
                  const std::string& sentence) {
    for (const std::size_t u : unknowns) {
        const std::size_t c = componentOf[u];
        if (c == noComponent || components[c]->ended())
            continue;
        components[c]->end(reason, {}, sentence);
        areStopsNew = true;
        schedule.changed(c);
    }
}

void Network::noteStops() {
    if (!areStopsNew.exchange(false))
        return;
    if (histories.stops_.empty() &&
        std::ranges::none_of(components, [](const auto& c) { return c && c->ended(); }))
        return;
    histories.stops_.clear();
    for (auto& track : histories.tracks_)
        track.stop.reset();
    for (const auto& component : components) {
        if (!component || !component->stop() || isAdded(component->unknowns()[0]))
            continue;
        for (const std::size_t u : component->unknowns())
            histories.tracks_[u].stop = histories.stops_.size();
        Stop stop = *component->stop();
        for (std::vector<std::size_t>* list : {&stop.unknowns, &stop.culprits})
            std::erase_if(*list, [this](std::size_t u) { return isAdded(u); });
        histories.stops_.push_back(std::move(stop));
    }
}

// ---------------------------------------------------------------------------------------------
// Memory

void Network::noteKept(std::size_t place) {
    if (const Component* component = components[place].get())
        kept.note(place, component->history()->bytes() + ofUnknown * component->unknowns().size() +
                             component->checkpointBytesBefore(infinity));
}

std::size_t Network::bytes() const {
    std::size_t sum = histories.bytes();
    for (const auto& component : components)
        sum += component ? component->bytes() : 0;
    return sum;
}

std::size_t Network::keptBefore(double t) const {
    std::size_t sum = histories.bytesBefore(t), tracks = 0;
    for (const Histories::Track& track : histories.tracks_)
        for (const Histories::Span& span : track.spans)
            tracks += span.from < t ? 1 : 0;
    for (const auto& component : components)
        sum += component ? component->checkpointBytesBefore(t) : 0;
    return sum + tracks * ofUnknown;
}

double Network::keptOf(std::size_t unknown, double t) const {
    double sum = 0;
    for (const Histories::Span& span : histories.tracks_[unknown].spans)
        sum += static_cast<double>(span.history->bytesBefore(t)) /
               static_cast<double>(span.history->columns());
    return sum;
}

std::shared_ptr<const Histories> Network::snapshot() const {
    auto copy = std::make_shared<Histories>(histories);
    for (auto& track : copy->tracks_)
        for (auto& span : track.spans)
            span.history = span.history->freeze(); // the same one for all that share it
    return copy;
}

} // namespace solution
