// What flies: solution/event_source.h says what that is.
//
// The six components of a body's flight, single unknowns in closed form, share one history from
// their first turn on: a step for each turn, with place, velocity and, where there is one, half the
// acceleration along each axis. The first event of another kind gives each of them its own again,
// from the last turn on. So a turn costs one step however many axes there are, and nothing else is
// looked at.
#include "solution/solver_implementation.h"

#include <cmath>

namespace solution {

// The same as handleEvents() does of such an event.
bool Solver::Implementation::turn(double time, std::span<Turn> turns) {
    turning_.clear();
    for (const Turn& one : turns)
        turning_.push_back(one.places[0]);
    if (!(time >= lastEvent_ && time >= options_.start) || isFull())
        return false;
    const bool flies = fliesOn(turns); // then nobody takes off, and islands stay as they are
    EventPaces::Island* const plain = flies ? paces_.plainIsland(turning_) : nullptr;
    const std::size_t atOnce = plain ? plain->eventsAt(time) : paces_.atOnce(time, turning_);
    if (atOnce + 1 >= options_.maximumEventsAtOnce ||
        (!plain && paces_.hopelessFrom(time, turning_) < options_.finish) ||
        (!flies && !staysInPlane(time, turns)))
        return false;
    for (Turn& one : turns) // those before one that cannot are turned again by the event
        if (!turn(time, one))
            return false;
    lastEvent_ = asked_ = time;
    ++past_.events;
    if (plain)
        plain->note(time);
    else
        paces_.note(time, turning_);
    poll(time);
    return true;
}

// None: it has none, or has landed. An unknown that an event added has none.
Solver::Implementation::Flight* Solver::Implementation::flightOf(std::size_t unknown) {
    const std::uint32_t known = unknown < flightOf_.size() ? flightOf_[unknown] : 0;
    return known != 0 && flights_[known - 1].isOn ? &flights_[known - 1] : nullptr;
}

// All of them do, in the plane or on the line on which they were.
bool Solver::Implementation::fliesOn(std::span<const Turn> turns) {
    for (const Turn& turn : turns) {
        const Flight* flight = flightOf(turn.places[0]);
        if (!flight)
            return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (turn.velocity[k] != 0 && !flight->moves[k])
                return false;
    }
    return true;
}

// What is 0 for ever stays so, up to rounding.
bool Solver::Implementation::staysInPlane(double time, std::span<Turn> turns) const {
    bool leaves = false;
    for (const Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            leaves = leaves || (turn.velocity[k] != 0 && zero_.contains(turn.velocities[k]));
    if (!leaves)
        return true;
    std::vector<Changes::Jump> jumps;
    for (const Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            jumps.push_back({turn.velocities[k], turn.velocity[k]});
    if (!roused(time, jumps).empty())
        return false;
    for (Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            if (zero_.contains(turn.velocities[k]))
                turn.velocity[k] = 0;
    return true;
}

bool Solver::Implementation::turn(double time, Turn& turn) {
    Flight* flight = flightOf(turn.places[0]);
    if (flight) {
        const std::size_t last = flight->history->size() - 1;
        const double origin = flight->history->origin(last);
        if (origin > time)
            return false;
        turn.place = {};
        const double* c = flight->history->row(last).data();
        for (const Flight::Axis& axis : flight->axes) {
            turn.place[axis.coordinate] = evaluate({c, flight->terms()}, time - origin);
            c += flight->terms();
        }
    } else {
        flight = takeOff(time, turn);
        if (!flight)
            return false;
    }
    kept_.add(flight->bytesOfTurn());
    double* c = flight->history->turn(time).data();
    for (const Flight::Axis& axis : flight->axes) {
        const std::array<double, 3> row{turn.place[axis.coordinate], turn.velocity[axis.coordinate],
                                        axis.half};
        c = std::copy_n(row.begin(), flight->terms(), c);
    }
    return true;
}

// None: it does not fly.
std::optional<std::vector<Solver::Implementation::Flight::Axis>>
Solver::Implementation::axesOf(const Turn& turn) const {
    std::vector<Flight::Axis> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = componentOf_[turn.places[k]], v = componentOf_[turn.velocities[k]];
        if (x == noComponent && v == noComponent)
            continue;
        if (x == noComponent || !components_[x] || !readers_[x].empty())
            return std::nullopt;
        const PlainRate* rate = components_[x]->plainRate();
        if (!rate)
            return std::nullopt;
        if (v == noComponent) { // a place that stays
            if (rate->unknown || rate->constant != 0)
                return std::nullopt;
        } else {
            const PlainRate* bend = components_[v] ? components_[v]->plainRate() : nullptr;
            if (rate->unknown != turn.velocities[k] || !bend || bend->unknown ||
                readers_[v] != std::vector<std::size_t>{x})
                return std::nullopt;
        }
        const double half = v == noComponent ? 0 : components_[v]->plainRate()->constant / 2;
        axes.push_back({.place = x, .velocity = v, .coordinate = k, .half = half});
    }
    return axes;
}

// Takes the components' motion over; null: they do not fly.
Solver::Implementation::Flight* Solver::Implementation::takeOff(double time, Turn& turn) {
    auto axes = axesOf(turn);
    if (!axes || axes->empty())
        return nullptr;
    turn.place = {};
    for (const Flight::Axis& axis : *axes) {
        const History& history = *components_[axis.place]->history();
        const Piece piece = history.piece(history.size() - 1, 0);
        if (piece.origin > time)
            return nullptr;
        turn.place[axis.coordinate] = piece.value(time);
    }
    Flight& flight = openFlight(turn);
    flight.axes = std::move(*axes);
    flight.isBent =
        std::ranges::any_of(flight.axes, [](const auto& axis) { return axis.half != 0; });
    flight.history =
        History::ofFlight(flight.axes.size(), static_cast<std::uint8_t>(flight.terms()));
    flight.moves = {};
    for (const Flight::Axis& axis : flight.axes)
        flight.moves[axis.coordinate] = axis.velocity != noComponent;
    flight.isOn = true;
    paces_.join(turn.places);
    paces_.join(turn.velocities);
    paces_.join(std::array{turn.places[0], turn.velocities[0]});
    follow(flight, turn, time);
    return &flight;
}

// The one of these unknowns, new or old.
Solver::Implementation::Flight& Solver::Implementation::openFlight(const Turn& turn) {
    flightOf_.resize(set_->unknowns.size(), 0);
    if (flightOf_[turn.places[0]] == 0) {
        flights_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            flightOf_[turn.places[k]] = flightOf_[turn.velocities[k]] =
                static_cast<std::uint32_t>(flights_.size());
    }
    return flights_[flightOf_[turn.places[0]] - 1];
}

// From now on the unknowns are read from the flight, and their components wait.
void Solver::Implementation::follow(const Flight& flight, const Turn& turn, double time) {
    const auto read = [&](std::size_t unknown, std::size_t column) {
        auto& spans = histories_.tracks_[unknown].spans;
        while (!spans.empty() && spans.back().from >= time)
            spans.pop_back();
        spans.push_back({time, flight.history, column});
    };
    for (std::size_t i = 0; i < flight.axes.size(); ++i) {
        const Flight::Axis& axis = flight.axes[i];
        components_[axis.place]->leave(time);
        read(turn.places[axis.coordinate], i);
        if (axis.velocity == noComponent)
            continue;
        components_[axis.velocity]->leave(time);
        read(turn.velocities[axis.coordinate], flight.axes.size() + i);
    }
}

void Solver::Implementation::land(std::span<const std::size_t> components) {
    if (flights_.empty())
        return;
    for (const std::size_t c : components)
        if (components_[c])
            if (Flight* const flight = flightOf(components_[c]->unknowns()[0]))
                land(*flight);
}

void Solver::Implementation::land(Flight& flight) {
    flight.isOn = false;
    const std::size_t last = flight.history->size() - 1;
    const double origin = flight.history->origin(last);
    for (std::size_t i = 0; i < flight.axes.size(); ++i) {
        const Piece place = flight.history->piece(last, i);
        const std::array<double, 2> rate{place.coefficients[1], 2 * flight.axes[i].half};
        components_[flight.axes[i].place]->goOn(origin, place.coefficients);
        addTracks(*components_[flight.axes[i].place], origin);
        if (flight.axes[i].velocity == noComponent)
            continue;
        components_[flight.axes[i].velocity]->goOn(origin, rate);
        addTracks(*components_[flight.axes[i].velocity], origin);
    }
    (void)flight.history->cut(origin);
}

} // namespace solution
