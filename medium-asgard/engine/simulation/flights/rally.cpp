#include "flights/rally.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using collision::FlightMeeting;
using solution::infinity;

namespace {

// A straight flight that begins now and goes away from its box, or along it.
bool staysBeyond(const Rally::Ball& ball, const Rally::Standing& standing, double room) {
    const double reach = ball.flight.radius * (1 + room);
    for (Eigen::Index i = 0; ball.isStraight && i < 3; ++i) {
        const double from = ball.flight.place[i], v = ball.flight.velocity[i];
        if ((v >= 0 && from - reach > standing.box.max()[i]) ||
            (v <= 0 && from + reach < standing.box.min()[i]))
            return true;
    }
    return false;
}

} // namespace

void Rally::clear() {
    balls.clear();
    standing.clear();
    meetings.clear();
    tests = 0;
}

void Rally::tried(std::size_t hits) {
    waited_ = 0;
    wait_ = hits > wait_ ? shortWait : std::min(2 * wait_, longWait);
}

void Rally::shareMeetings() {
    std::ranges::sort(meetings, {}, &Meeting::pair);
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        Meeting& meeting = meetings[m];
        if (!meeting.isStanding) {
            meeting.ball = indexOf(balls, meeting.pair.first);
            meeting.other = indexOf(balls, meeting.pair.second);
            balls[meeting.other].meetings.push_back(m);
        }
        balls[meeting.ball].meetings.push_back(m);
    }
}

void Rally::Ball::fly(const solution::Turn& turned, double from) {
    flight.from = from;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        flight.place[axis] = turned.place[i];
        flight.velocity[axis] = turned.velocity[i];
    }
}

void Rally::forgetMeetings(const Meeting& met) {
    for (const std::size_t m : balls[met.ball].meetings)
        meetings[m].time = infinity;
    for (std::size_t i = 0; !met.isStanding && i < balls[met.other].meetings.size(); ++i)
        meetings[balls[met.other].meetings[i]].time = infinity;
}

const Rally::Meeting* Rally::next() const { return nextMeeting(balls, meetings, others); }

bool Rally::areHome(double time) const {
    return std::ranges::all_of(balls, [time](const Ball& ball) {
        if (!ball.hasTurned || !ball.isStraight)
            return true;
        const geometry::Vector centre = ball.flight.centreAt(time);
        bool is = true;
        for (Eigen::Index i = 0; i < 3; ++i)
            is = is && centre[i] >= ball.cell.min()[i] && centre[i] <= ball.cell.max()[i];
        return is;
    });
}

bool Rally::turned(const Meeting& met, double time, bool parted, const collision::BallCells& cells,
                   double room) {
    const auto renew = [&](Ball& ball) {
        ball.hasTurned = true;
        ball.until = time + firstSpan;
        if (!ball.isStraight)
            ball.until = std::min(ball.until, cells.exitOf(ball.body, ball.flight, time).time);
    };
    renew(balls[met.ball]);
    if (!met.isStanding)
        renew(balls[met.other]);
    bool tells = true;
    for (const std::size_t m : balls[met.ball].meetings) {
        if (&meetings[m] == &met && parted)
            meetings[m].time = infinity;
        else
            tells = tells && predict(meetings[m], time, room);
    }
    for (std::size_t i = 0; !met.isStanding && i < balls[met.other].meetings.size(); ++i)
        if (Meeting& meeting = meetings[balls[met.other].meetings[i]]; &meeting != &met)
            tells = tells && predict(meeting, time, room);
    return tells;
}

bool Rally::predict(Meeting& meeting, double time, double room) {
    const Ball& ball = balls[meeting.ball];
    meeting.time = infinity;
    FlightMeeting met;
    if (meeting.isStanding) {
        const Standing& face = standing[meeting.other];
        if (staysBeyond(ball, face, room))
            return true;
        met = meetingWithStanding(ball.flight, face.parts, {time, ball.until});
    } else {
        const Ball& other = balls[meeting.other];
        const collision::Approach approach(ball.flight, other.flight);
        if (passApart(approach, ball.flight, other.flight))
            return true;
        met = collision::meetingOf(approach, ball.flight, other.flight, {time, infinity});
    }
    meeting.isNear = true;
    ++tests;
    if (met.kind == FlightMeeting::Kind::hit)
        meeting.time = met.time;
    return met.kind != FlightMeeting::Kind::unclear;
}

} // namespace simulation
