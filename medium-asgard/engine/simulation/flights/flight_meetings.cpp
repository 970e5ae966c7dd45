#include "flights/flight_meetings.h"

namespace simulation {

using collision::FlightMeeting;

FlightMeeting meetingWithStanding(const collision::BallFlight& ball,
                                  std::span<const collision::StandingPart> parts,
                                  collision::Interval during) {
    FlightMeeting first;
    for (const collision::StandingPart& part : parts) {
        const FlightMeeting met = collision::meetingOf(ball, part, during);
        if (met.kind == FlightMeeting::Kind::unclear)
            return met;
        if (met.kind == FlightMeeting::Kind::hit &&
            (first.kind == FlightMeeting::Kind::none || met.time < first.time))
            first = met;
    }
    return first;
}

} // namespace simulation
