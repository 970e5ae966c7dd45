// Meetings of balls in flight by formulas (collision/ball_flight.h), as the search for encounters
// asks for them.
#pragma once

#include "collision/ball_flight.h"
#include "collision/time_of_impact.h"

#include <span>

namespace simulation {

// A flight is looked at for so long after a cut at most, in s.
inline constexpr double firstSpan = 16;

// They pass so far from each other that it is no encounter.
[[nodiscard]] inline bool passApart(const collision::Approach& approach,
                                    const collision::BallFlight& a,
                                    const collision::BallFlight& b) {
    return approach.passesBeyond(2 * (a.radius + b.radius));
}

// The first with any of these parts; `unclear` where a formula does not tell.
[[nodiscard]] collision::FlightMeeting
meetingWithStanding(const collision::BallFlight& ball,
                    std::span<const collision::StandingPart> parts, collision::Interval during);

} // namespace simulation
