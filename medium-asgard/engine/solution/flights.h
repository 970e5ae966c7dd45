// Bodies in flight: event_source.h says which those are.
//
// The six components of a body's flight, single unknowns in closed form, share one history from
// their first turn on: a step for each turn, with place, velocity and, where there is one, half the
// acceleration along each axis. The first event of another kind gives each of them its own again,
// from the last turn on. So a turn costs one step however many axes there are, and nothing else is
// looked at.
#pragma once

#include "solution/event_islands.h"
#include "solution/network.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class Flights {
public:
    // A body that flies along several axes meets itself: it is one island.
    Flights(Network& network, EventIslands& islands) : network_(network), islands_(islands) {}

    // All of them stay in the plane or on the line on which they were: what is 0 for ever stays so,
    // up to rounding, which this takes away.
    [[nodiscard]] bool stayInPlane(double time, std::span<Turn> turns);
    // False: it does not fly, and an event must turn it. Those before it are turned again by that.
    [[nodiscard]] bool turn(double time, std::span<Turn> turns);
    // These components go on by themselves.
    void land(std::span<const std::size_t> components);

private:
    struct Flight {
        struct Axis {                            // that is not 0 for ever
            std::size_t place = 0, velocity = 0; // components; a velocity may stay 0
            std::size_t coordinate = 0;
            double half = 0; // of the acceleration
        };
        std::vector<Axis> axes;
        std::array<bool, 3> moves{};      // by coordinate: its velocity is not 0 for ever
        std::shared_ptr<History> history; // a column for each axis, then the rates of these
        bool isBent = false;              // else accelerations are 0
        bool isOn = false;                // else the components go on by themselves
        [[nodiscard]] std::size_t terms() const { return isBent ? 3 : 2; }
        [[nodiscard]] std::size_t bytesOfTurn() const {
            return (1 + axes.size() * terms()) * sizeof(double);
        }
    };
    [[nodiscard]] Flight* flightOf(std::size_t unknown);
    [[nodiscard]] bool flyOn(std::span<const Turn> turns);
    [[nodiscard]] bool turn(double time, Turn& turn);
    [[nodiscard]] std::optional<std::vector<Flight::Axis>> axesOf(const Turn& turn) const;
    [[nodiscard]] Flight* takeOff(double time, Turn& turn);
    [[nodiscard]] Flight& openFlight(const Turn& turn);
    void follow(const Flight& flight, const Turn& turn, double time);
    void land(Flight& flight);

    Network& network_;
    EventIslands& islands_;
    std::vector<Flight> flights_;
    std::vector<std::uint32_t> flightOf_; // by unknown; 0: none, else one more than its place
};

} // namespace solution
