// How balls leave the search for a rally, and come back: encounter_search.h.
#include "meetings/encounter_search.h"

#include <algorithm>

namespace simulation {

using solution::infinity;

bool EncounterSearch::isRallying(std::size_t body) const {
    const Window& window = windows_[body];
    return window.isFlight && window.isFollowed && window.growth == 0 && cells_.contains(body) &&
           unclear_[body].empty() && !ended_[body];
}

// False: it cannot be followed in a rally, or there is no room for it.
bool EncounterSearch::join(std::size_t body, Rally& rally) const {
    if (Rally::indexOf(rally.balls, body) < rally.balls.size())
        return true;
    if (rally.balls.size() == Rally::mostBalls || !isRallying(body))
        return false;
    const Window& window = windows_[body];
    rally.balls.push_back({.body = body,
                           .flight = window.flight,
                           .cell = cells_.cell(body),
                           .until = window.until,
                           .isStraight = window.flight.half.isZero(0),
                           .meetings = {}});
    return true;
}

// The balls that may come near one of the rally's, each a ball of it from now on.
bool EncounterSearch::gatherBalls(std::size_t body, Rally& rally) {
    for (const std::uint32_t near : cells_.near(body)) {
        if (!mayMeet(body, near))
            continue;
        if (!join(near, rally))
            return false;
        const Pair both = std::minmax(body, std::size_t{near});
        if (std::ranges::find(rally.meetings, both, &Rally::Meeting::pair) == rally.meetings.end())
            rally.meetings.push_back({.pair = both, .time = infinity});
    }
    return true;
}

// Who stands where a ball of the rally may come to.
bool EncounterSearch::gatherStanding(std::size_t ball, Rally& rally) const {
    const std::size_t body = rally.balls[ball].body;
    for (const std::size_t partner : partners_[body]) {
        if (!records_[partner].isFixed || standing_[partner].empty())
            return false;
        const std::size_t s = Rally::indexOf(rally.standing, partner);
        if (s == Rally::mostStanding)
            return false;
        if (s == rally.standing.size())
            rally.standing.push_back(
                {.body = partner, .parts = standing_[partner], .box = windows_[partner].box});
        rally.meetings.push_back({.pair = std::minmax(body, partner),
                                  .ball = ball,
                                  .other = s,
                                  .isStanding = true,
                                  .time = infinity});
    }
    return true;
}

// The balls, and who stands where they may come to; false: somebody else may.
bool EncounterSearch::gatherBodies(const Pair& pair, Rally& rally) {
    for (const std::size_t body : {pair.first, pair.second})
        if (!records_[body].isFixed && !join(body, rally))
            return false;
    for (std::size_t b = 0; b < rally.balls.size(); ++b) // they become more meanwhile
        if (!gatherBalls(rally.balls[b].body, rally) || !gatherStanding(b, rally))
            return false;
    rally.shareMeetings();
    return true;
}

bool EncounterSearch::gather(const Pair& pair, Rally& rally) {
    rally.clear();
    if (!passing_.empty() || resting_.isAnyResting() || !gatherBodies(pair, rally))
        return false;
    const auto isIn = [&](std::size_t body) {
        return std::ranges::find(rally.balls, body, &Rally::Ball::body) != rally.balls.end();
    };
    for (const Hit& hit : queue_) {
        if (isOutdated(hit) || (!isIn(hit.first) && !isIn(hit.second)))
            continue;
        const auto meeting =
            std::ranges::find(rally.meetings, Pair(hit.first, hit.second), &Rally::Meeting::pair);
        if (meeting == rally.meetings.end() || hit.pressing || hit.isLost)
            return false;
        meeting->time = std::min(meeting->time, hit.time);
    }
    for (const Rally::Ball& ball : rally.balls) {
        ++version_[ball.body];
        ends_.set(ball.body, infinity);
    }
    rally.others = next().time;
    return true;
}

void EncounterSearch::dissolve(const Rally& rally) {
    pairTests_ += rally.tests;
    for (const Rally::Ball& ball : rally.balls) {
        Window& window = windows_[ball.body];
        if (ball.hasTurned) {
            bodies_[ball.body].forget();
            window.flight = ball.flight;
            window.from = ball.flight.from;
            window.number = 0;
            window.exit = cells_.exitOf(ball.body, ball.flight, window.from);
            window.until = std::min(window.from + firstSpan, window.exit.time);
            if (!partners_[ball.body].empty())
                boxFlight(ball.body);
        }
        ends_.set(ball.body, window.until);
    }
    for (const Rally::Meeting& meeting : rally.meetings) {
        if (meeting.isNear)
            remember(meeting.pair);
        const double until =
            meeting.isStanding ? windows_[rally.balls[meeting.ball].body].until : infinity;
        if (meeting.time < infinity && meeting.time <= until)
            keep(meeting.pair, meeting.time, false, false);
    }
}

} // namespace simulation
