// Impacts of balls in flight, hit after hit: flight_impacts.h.
#include "events/flight_impacts.h"

#include "meetings/rally_gathering.h"

#include <algorithm>

namespace simulation {

using collision::FlightContact;

namespace {

solution::Turn turnOf(const Rally::Ball& ball, double time, const Vector& before,
                      const Vector& after) {
    solution::Turn turn = ball.turn;
    const Vector place = ball.flight.centreAt(time);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        turn.place[k] = place[axis];
        turn.jumps[k] = after[axis] != before[axis];
        turn.velocity[k] = after[axis];
    }
    return turn;
}

} // namespace

bool FlightImpacts::canRally() {
    bool isUnread = true;
    for (Rally::Ball& ball : rally_.balls) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t first = view_.world.records[ball.body].firstUnknown;
            ball.turn.places[k] = first + physics::x + k;
            ball.turn.velocities[k] = first + physics::dx + k;
        }
        isUnread = isUnread && !readers_.isRead(ball.body);
    }
    return isUnread;
}

FlightImpacts::Rallied FlightImpacts::rally(const Instant& at, const Pair& pair, double until,
                                            MeetingCounts& counts,
                                            const std::function<bool()>& cancelled) {
    if (!turns_ || !gather(search_, pair, rally_)) {
        rally_.tried(0);
        return {};
    }
    Step step = canRally() ? Step::goesOn : Step::isOver;
    std::size_t hits = 0;
    Rallied rallied;
    const Rally::Meeting* last = nullptr;
    while (step == Step::goesOn) {
        const Rally::Meeting* met = rally_.next();
        if (!met || met->time > until || (++hits % 64 == 0 && cancelled && cancelled()))
            break;
        last = met;
        rallied.time = met->time; // its own will be the next time
        step = meetInRally(at, *met, counts);
    }
    if (step == Step::isUnclear)
        rally_.forgetMeetings(*last);
    dissolve(rally_, search_);
    rally_.tried(hits);
    if (last)
        rallied.pair = last->pair;
    rallied.course = step == Step::isEndless   ? Course::endless
                     : step == Step::isRefused ? Course::refused
                     : step == Step::isUnclear ? Course::unclear
                                               : Course::over;
    return rallied;
}

// What is not told here at once is left to the search, which is asked again.
bool FlightImpacts::touchesMoreInRally(const Present& one, const Rally::Ball& ball,
                                       const Rally::Meeting& met, double time) const {
    for (const std::size_t m : ball.meetings) {
        const Rally::Meeting& meeting = rally_.meetings[m];
        if (&meeting == &met)
            continue;
        if (meeting.isStanding) {
            const Rally::Standing& standing = rally_.standing[meeting.other];
            const Present other = view_.presentAt(standing.body, time);
            const double tolerance = view_.toleranceOf(one, other, time);
            if (!FlightView::isBeyond(standing.box, one.ball.centre, one.ball.radius + tolerance) &&
                view_.contactOf(one, other, time).kind != FlightContact::Kind::none)
                return true;
            continue;
        }
        const Rally::Ball& first = rally_.balls[meeting.ball];
        const Rally::Ball& ballNear = first.body == one.body ? rally_.balls[meeting.other] : first;
        const Present other = FlightView::presentOf(ballNear.body, ballNear.flight, time);
        const double far =
            one.ball.radius + other.ball.radius + view_.toleranceOf(one, other, time);
        if (!((one.ball.centre - other.ball.centre).squaredNorm() > far * far))
            return true;
    }
    return false;
}

// As handle() of encounters.cpp, meet() and turn() do.
FlightImpacts::Step FlightImpacts::meetInRally(const Instant& at, const Rally::Meeting& met,
                                               MeetingCounts& counts) {
    const double time = met.time;
    const Rally::Ball* const one = &rally_.balls[met.ball];
    const Rally::Ball* const two = met.isStanding ? nullptr : &rally_.balls[met.other];
    const Present ball = FlightView::presentOf(one->body, one->flight, time);
    const Present other = two ? FlightView::presentOf(two->body, two->flight, time)
                              : view_.presentAt(rally_.standing[met.other].body, time);
    const bool isInOrder = ball.body < other.body;
    const Present &first = isInOrder ? ball : other, &second = isInOrder ? other : ball;
    const FlightContact contact = view_.contactOf(first, second, time);
    const bool mayGoAlongside = two && one->flight.half != two->flight.half;
    if (contact.kind != FlightContact::Kind::contact || mayGoAlongside || !rally_.areHome(time) ||
        touchesMoreInRally(ball, *one, met, time) ||
        (two && touchesMoreInRally(other, *two, met, time)))
        return Step::isOver;
    const auto push = view_.pushOf(first, second, contact.normal);
    if (!push)
        return Step::isOver;
    const Instant then{at.world, at.resting, at.search, at.histories, time};
    if (meetsWithoutEnd(then, {first.body, second.body}, counts))
        return Step::isEndless;
    if (!turnInRally(met, {ball.velocity, other.velocity},
                     {push->velocities[isInOrder ? 0 : 1], push->velocities[isInOrder ? 1 : 0]}))
        return Step::isRefused;
    record({first.body, second.body}, contact, push->impulse, time);
    record_.addEvent(time);
    const bool parted = two ? one->flight.half == two->flight.half
                            : one->isStraight && rally_.standing[met.other].parts.size() == 1;
    const bool forGood =
        parted && push->isClear && contact.gap > -resolution::deep * ball.ball.radius;
    return rally_.turned(met, time, forGood, search_.near().cells, resolution::searchedGap)
               ? Step::goesOn
               : Step::isUnclear;
}

// Velocities: of the ball, and of the other. False: the solver does not do so on the spot.
bool FlightImpacts::turnInRally(const Rally::Meeting& met, const std::array<Vector, 2>& before,
                                const std::array<Vector, 2>& then) {
    std::array<solution::Turn, 2> turns;
    const std::array<std::size_t, 2> balls{met.ball, met.other};
    const std::size_t count = met.isStanding ? 1 : 2;
    for (std::size_t i = 0; i < count; ++i)
        turns[i] = turnOf(rally_.balls[balls[i]], met.time, before[i], then[i]);
    if (!turns_->turn(met.time, std::span(turns).first(count)))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        rally_.balls[balls[i]].fly(turns[i], met.time);
    return true;
}

} // namespace simulation
