// Balls in flight and faces that stand still, as their impacts in closed form see them.
#pragma once

#include "collision/ball_flight.h"
#include "contacts/colliders.h"
#include "meetings/encounter_search.h"

#include <array>
#include <optional>

namespace simulation {

struct Present { // of two that meet, or one beside them, at an instant
    std::size_t body = 0;
    const collision::BallFlight* flight = nullptr; // none: not in flight
    collision::PlacedBall ball = {};
    Vector velocity = Vector::Zero();
    double speed = 0, farthest = 0; // coordinate
};

struct Push { // what two do to each other
    double impulse = 0;
    std::array<Vector, 2> velocities; // then
    bool isClear = false;             // they part faster than rounding tells
};

struct FlightView {
    const Colliders& world;
    const EncounterSearch& search;

    [[nodiscard]] static Present presentOf(std::size_t body, const collision::BallFlight& flight,
                                           double time);
    // Of what is neither in flight nor fixed only who it is.
    [[nodiscard]] Present presentAt(std::size_t body, double time) const;
    // As Instant::contactTolerance().
    [[nodiscard]] double toleranceOf(const Present& a, const Present& b, double time) const;
    [[nodiscard]] collision::FlightContact contactOf(const Present& first, const Present& second,
                                                     double time) const;
    // Farther than that beyond the box along an axis.
    [[nodiscard]] static bool isBeyond(const geometry::Box& box, const Vector& point, double by);
    // None: they do not, or it is their last hop.
    [[nodiscard]] std::optional<Push> pushOf(const Present& first, const Present& second,
                                             const Vector& normal) const;

private:
    [[nodiscard]] bool isLastHop(const Present& first, const Present& second, const Vector& normal,
                                 double speed) const;
};

} // namespace simulation
