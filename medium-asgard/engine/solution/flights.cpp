#include "solution/flights.h"

#include "solution/awakening.h"

#include <algorithm>
#include <utility>

namespace solution {

// None: it has none, or has landed. An unknown that an event added has none.
Flights::Flight* Flights::flightOf(std::size_t unknown) {
    const std::uint32_t known = unknown < flightOf_.size() ? flightOf_[unknown] : 0;
    return known != 0 && flights_[known - 1].isOn ? &flights_[known - 1] : nullptr;
}

// All of them do, in the plane or on the line on which they were.
bool Flights::flyOn(std::span<const Turn> turns) {
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

bool Flights::stayInPlane(double time, std::span<Turn> turns) {
    if (flyOn(turns))
        return true;
    bool leaves = false;
    for (const Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            leaves =
                leaves || (turn.velocity[k] != 0 && network_.zero.contains(turn.velocities[k]));
    if (!leaves)
        return true;
    std::vector<Changes::Jump> jumps;
    for (const Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            jumps.push_back({turn.velocities[k], turn.velocity[k]});
    if (!roused(network_, time, jumps).empty())
        return false;
    for (Turn& turn : turns)
        for (std::size_t k = 0; k < 3; ++k)
            if (network_.zero.contains(turn.velocities[k]))
                turn.velocity[k] = 0;
    return true;
}

bool Flights::turn(double time, std::span<Turn> turns) {
    return std::ranges::all_of(turns, [&](Turn& one) { return turn(time, one); });
}

bool Flights::turn(double time, Turn& turn) {
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
    network_.kept.add(flight->bytesOfTurn());
    double* c = flight->history->turn(time).data();
    for (const Flight::Axis& axis : flight->axes) {
        const std::array<double, 3> row{turn.place[axis.coordinate], turn.velocity[axis.coordinate],
                                        axis.half};
        c = std::copy_n(row.begin(), flight->terms(), c);
    }
    return true;
}

// None: it does not fly.
std::optional<std::vector<Flights::Flight::Axis>> Flights::axesOf(const Turn& turn) const {
    std::vector<Flight::Axis> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = network_.componentOf[turn.places[k]],
                          v = network_.componentOf[turn.velocities[k]];
        if (x == noComponent && v == noComponent)
            continue;
        if (x == noComponent || !network_.components[x] || !network_.readers[x].empty())
            return std::nullopt;
        const PlainRate* rate = network_.components[x]->plainRate();
        if (!rate)
            return std::nullopt;
        if (v == noComponent) { // a place that stays
            if (rate->unknown || rate->constant != 0)
                return std::nullopt;
        } else {
            const PlainRate* bend =
                network_.components[v] ? network_.components[v]->plainRate() : nullptr;
            if (rate->unknown != turn.velocities[k] || !bend || bend->unknown ||
                network_.readers[v] != std::vector<std::size_t>{x})
                return std::nullopt;
        }
        const double half =
            v == noComponent ? 0 : network_.components[v]->plainRate()->constant / 2;
        axes.push_back({.place = x, .velocity = v, .coordinate = k, .half = half});
    }
    return axes;
}

// Takes the components' motion over; null: they do not fly.
Flights::Flight* Flights::takeOff(double time, Turn& turn) {
    auto axes = axesOf(turn);
    if (!axes || axes->empty())
        return nullptr;
    turn.place = {};
    for (const Flight::Axis& axis : *axes) {
        const History& history = *network_.components[axis.place]->history();
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
    islands_.join(turn.places);
    islands_.join(turn.velocities);
    islands_.join(std::array{turn.places[0], turn.velocities[0]});
    follow(flight, turn, time);
    return &flight;
}

// The one of these unknowns, new or old.
Flights::Flight& Flights::openFlight(const Turn& turn) {
    flightOf_.resize(network_.set->unknowns.size(), 0);
    if (flightOf_[turn.places[0]] == 0) {
        flights_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            flightOf_[turn.places[k]] = flightOf_[turn.velocities[k]] =
                static_cast<std::uint32_t>(flights_.size());
    }
    return flights_[flightOf_[turn.places[0]] - 1];
}

// From now on the unknowns are read from the flight, and their components wait.
void Flights::follow(const Flight& flight, const Turn& turn, double time) {
    for (std::size_t i = 0; i < flight.axes.size(); ++i) {
        const Flight::Axis& axis = flight.axes[i];
        network_.components[axis.place]->leave(time);
        network_.readFrom(time, turn.places[axis.coordinate], flight.history, i);
        if (axis.velocity == noComponent)
            continue;
        network_.components[axis.velocity]->leave(time);
        network_.readFrom(time, turn.velocities[axis.coordinate], flight.history,
                          flight.axes.size() + i);
    }
}

void Flights::land(std::span<const std::size_t> components) {
    if (flights_.empty())
        return;
    for (const std::size_t c : components)
        if (network_.components[c])
            if (Flight* const flight = flightOf(network_.components[c]->unknowns()[0]))
                land(*flight);
}

void Flights::land(Flight& flight) {
    flight.isOn = false;
    const std::size_t last = flight.history->size() - 1;
    const double origin = flight.history->origin(last);
    for (std::size_t i = 0; i < flight.axes.size(); ++i) {
        const Piece place = flight.history->piece(last, i);
        const std::array<double, 2> rate{place.coefficients[1], 2 * flight.axes[i].half};
        network_.components[flight.axes[i].place]->goOn(origin, place.coefficients);
        network_.addTracks(*network_.components[flight.axes[i].place], origin);
        if (flight.axes[i].velocity == noComponent)
            continue;
        network_.components[flight.axes[i].velocity]->goOn(origin, rate);
        network_.addTracks(*network_.components[flight.axes[i].velocity], origin);
    }
    (void)flight.history->cut(origin);
}

} // namespace solution
