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

#include <optional>
#include <vector>

namespace collision {

struct BallFlight {
    double from = 0;
    Vector place = Vector::Zero(), velocity = Vector::Zero(), half = Vector::Zero();
    double radius = 0;

    [[nodiscard]] Vector centreAt(double t) const {
        const double s = t - from;
        return place + s * (velocity + s * half);
    }
    [[nodiscard]] Vector velocityAt(double t) const { return velocity + 2 * (t - from) * half; }
    [[nodiscard]] BallFlight startingAt(double t) const {
        return {t, centreAt(t), velocityAt(t), half, radius};
    }
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

struct FlightMeeting {
    enum class Kind { none, hit, unclear };
    Kind kind = Kind::none;
    double time = 0; // of the hit
};
[[nodiscard]] FlightMeeting meetingOf(const BallFlight& first, const BallFlight& second,
                                      Interval during);
[[nodiscard]] FlightMeeting meetingOf(const BallFlight& ball, const StandingPart& part,
                                      Interval during);

// Whether they are in contact at t, up to `tolerance`: gap, point and normal (from the second to
// the first).
struct FlightContact {
    enum class Kind { none, contact, unclear };
    Kind kind = Kind::none;
    Vector point = Vector::Zero(), normal = Vector::UnitX();
};
[[nodiscard]] FlightContact contactOf(const BallFlight& first, const BallFlight& second, double t,
                                      double tolerance);
[[nodiscard]] FlightContact contactOf(const BallFlight& ball, const StandingPart& part, double t,
                                      double tolerance);

} // namespace collision
