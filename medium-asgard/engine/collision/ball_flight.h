// Balls in flight: when they meet each other or the faces of what stands still, in closed form.
//
//     centre of a ball   p + v s + h s^2,    s = t - from
//     ball, ball         |p + v s| = R for the difference of two flights with the same h: with m
//                        the part of p across v,   v^2 s = -p.v - |v| sqrt(R^2 - m^2)
//     ball, face         n.(p + v s + h s^2) = offset + R, and the centre is over the face
//
// Both are refined by one step of Newton's method on the gap itself. What these formulas do not
// answer (edges and vertices, balls pressed onto each other, hops too low to tell) is `unclear`:
// time_of_impact.h answers everything. Where both answer, they agree to rounding.
#pragma once

#include "collision/contact.h"
#include "collision/time_of_impact.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace collision {

// A ball where it is at an instant.
struct PlacedBall {
    Vector centre;
    double radius = 0;
};

struct BallFlight {
    double from = 0;
    Vector place = Vector::Zero(), velocity = Vector::Zero(), half = Vector::Zero();
    double radius = 0;

    [[nodiscard, gnu::always_inline]] Vector centreAt(double t) const {
        const double s = t - from;
        return place + s * (velocity + s * half);
    }
    [[nodiscard, gnu::always_inline]] Vector velocityAt(double t) const {
        return velocity + 2 * (t - from) * half;
    }
    [[nodiscard]] BallFlight startingAt(double t) const {
        return {t, centreAt(t), velocityAt(t), half, radius};
    }
    [[nodiscard]] PlacedBall placedAt(double t) const { return {centreAt(t), radius}; }
};

// A face of something that stands still: its plane and those through its edges, inwards.
struct StandingFace {
    struct Plane {
        Vector normal;
        double offset = 0;
        [[nodiscard]] double above(const Vector& p) const { return normal.dot(p) - offset; }
    };
    Plane plane;
    std::vector<Plane> sides;
};

struct StandingPart {
    std::vector<StandingFace> faces;
    double extent = 0; // largest coordinate, for rounding
    // The face that the point is furthest above.
    [[nodiscard]] const StandingFace& facing(const Vector& point) const;
};
[[nodiscard]] StandingPart standingPart(const geometry::Part& part, const Pose& pose);

// A flight as another sees it, from the later of their starts on: place + velocity s, if both are
// bent alike.
struct Approach {
    Approach(const BallFlight& first, const BallFlight& second)
        : from(std::max(first.from, second.from)), isStraight(first.half == second.half),
          firstPlace(first.centreAt(from)), secondPlace(second.centreAt(from)),
          place(firstPlace - secondPlace),
          velocity(first.velocityAt(from) - second.velocityAt(from)), along(place.dot(velocity)),
          distanceSquare(place.squaredNorm()), speedSquare(velocity.squaredNorm()) {}

    // They never come so near to each other; told by a formula that rounding blurs where they are
    // millions of times as far apart.
    [[nodiscard]] bool passesBeyond(double distance) const {
        constexpr double farthest = 1e12; // of the square
        const double square = distance * distance;
        if (!isStraight || !(distanceSquare > square) || distanceSquare > farthest * square)
            return false;
        return along >= 0 || (distanceSquare - square) * speedSquare > along * along;
    }

    double from;
    bool isStraight;
    Vector firstPlace, secondPlace, place, velocity;
    double along, distanceSquare, speedSquare;
};

struct FlightMeeting {
    enum class Kind { none, hit, unclear };
    Kind kind = Kind::none;
    double time = 0; // of the hit
};
// `approach` is that of these two.
[[nodiscard]] FlightMeeting meetingOf(const Approach& approach, const BallFlight& first,
                                      const BallFlight& second, Interval during);
[[nodiscard]] inline FlightMeeting meetingOf(const BallFlight& first, const BallFlight& second,
                                             Interval during) {
    return meetingOf(Approach(first, second), first, second, during);
}
[[nodiscard]] FlightMeeting meetingOf(const BallFlight& ball, const StandingPart& part,
                                      Interval during);

// Whether they are in contact, up to `tolerance`: point and normal (from the second to the first).
struct FlightContact {
    enum class Kind { none, contact, unclear };
    Kind kind = Kind::none;
    Vector point = Vector::Zero(), normal = Vector::UnitX();
    double gap = 0;
};
[[nodiscard]] FlightContact contactOf(const PlacedBall& first, const PlacedBall& second,
                                      double tolerance);
[[nodiscard]] FlightContact contactOf(const PlacedBall& ball, const StandingPart& part,
                                      double tolerance);

} // namespace collision
