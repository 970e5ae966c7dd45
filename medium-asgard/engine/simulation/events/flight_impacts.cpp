#include "events/flight_impacts.h"

#include "events/impact_cluster.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using collision::FlightContact;
using solution::Event;

namespace {

// Whoever is near without touching leaves no trace in the result.
bool touchesClosely(const Instant& instant, const Pair& pair, std::size_t other) {
    return !instant.search.hasEnded(other) && touch(instant, pair);
}

} // namespace

// Something but `met` touches it, or that is not clear.
bool FlightImpacts::touchesMore(const Instant& at, const Present& one, const Present& met) {
    bool touches = false;
    search_.forEachPartner(one.body, [&](std::size_t partner) {
        if (touches || partner == met.body)
            return;
        const Present other = view_.presentAt(partner, at.time);
        const double tolerance = view_.toleranceOf(one, other, at.time);
        if (one.flight && other.flight) {
            const double far = one.ball.radius + other.ball.radius + tolerance;
            if ((one.ball.centre - other.ball.centre).squaredNorm() > far * far)
                return;
        } else if (one.flight && view_.world.records[partner].isFixed) {
            if (FlightView::isBeyond(view_.search.box(partner), one.ball.centre,
                                     one.ball.radius + tolerance))
                return;
        }
        const bool isFirst = one.body < partner;
        const FlightContact contact =
            view_.contactOf(isFirst ? one : other, isFirst ? other : one, at.time);
        touches = contact.kind == FlightContact::Kind::contact ||
                  (contact.kind == FlightContact::Kind::unclear &&
                   touchesClosely(at, std::minmax(one.body, partner), partner));
    });
    return touches;
}

// Of a flight that the search does not follow.
void FlightImpacts::readVelocity(const Instant& at, Present& present) const {
    if (!present.flight || search_.isFollowed(present.body))
        return;
    const std::size_t first = view_.world.records[present.body].firstUnknown + physics::dx;
    present.velocity = {at.histories.value(first, at.time), at.histories.value(first + 1, at.time),
                        at.histories.value(first + 2, at.time)};
}

// On the spot, where the solver agrees and nobody reads them.
bool FlightImpacts::turn(const Pair& pair, double time, const std::array<Vector, 2>& before,
                         const std::array<Vector, 2>& after) {
    std::array<solution::Turn, 2> turns;
    std::array<std::size_t, 2> turned{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        if (view_.world.records[body].isFixed)
            continue;
        if (!turns_ || !search_.isFollowed(body) || readers_.isRead(body))
            return false;
        turned[count] = body;
        solution::Turn& turn = turns[count++];
        const Vector place = search_.flight(body)->centreAt(time);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            turn.place[k] = place[axis]; // for who nudges (nudge.h)
            turn.places[k] = view_.world.records[body].firstUnknown + physics::x + k;
            turn.velocities[k] = view_.world.records[body].firstUnknown + physics::dx + k;
            turn.jumps[k] = after[i][axis] != before[i][axis];
            turn.velocity[k] = after[i][axis];
        }
    }
    if (!turns_->turn(time, std::span(turns).first(count)))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        search_.turn(turned[i], turns[i], time);
    record_.addEvent(time);
    return true;
}

void FlightImpacts::record(const Pair& pair, const FlightContact& contact, double impulse,
                           double time) {
    record_.addImpact({.time = time,
                       .first = pair.first,
                       .second = pair.second,
                       .point = contact.point,
                       .normal = contact.normal,
                       .impulse = impulse},
                      time);
}

// All axes of what could be turned restart, as they do in a turn: whether somebody reads a body
// changes no bit of it.
void FlightImpacts::announce(const Pair& pair, const std::array<Vector, 2>& before,
                             const std::array<Vector, 2>& after, Event& event, Outcome& outcome) {
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        for (std::size_t k = 0; k < 3 && !view_.world.isFixed(body); ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const bool jumps = after[i][axis] != before[i][axis];
            const std::size_t unknown = view_.world.records[body].firstUnknown + physics::dx + k;
            if (jumps || search_.isFollowed(body))
                event.touched.push_back(unknown);
            if (jumps)
                outcome.jumps.push_back({unknown, after[i][axis]});
        }
    }
}

std::optional<FlightImpacts::Hit> FlightImpacts::meet(const Instant& at, const Pair& pair,
                                                      Outcome& outcome) {
    Present first = view_.presentAt(pair.first, at.time);
    Present second = view_.presentAt(pair.second, at.time);
    const FlightContact contact = view_.contactOf(first, second, at.time);
    if (contact.kind != FlightContact::Kind::contact || touchesMore(at, first, second) ||
        touchesMore(at, second, first))
        return std::nullopt;
    readVelocity(at, first);
    readVelocity(at, second);
    const auto push = view_.pushOf(first, second, contact.normal);
    if (!push)
        return std::nullopt;
    const std::array<Vector, 2> velocities{first.velocity, second.velocity};
    record(pair, contact, push->impulse, at.time);
    if (turn(pair, at.time, velocities, push->velocities))
        return Hit{};
    Event event{.time = at.time, .touched = {}, .tag = 0};
    outcome = {};
    announce(pair, velocities, push->velocities, event, outcome);
    return Hit{std::move(event)};
}

} // namespace simulation
