// Impacts of balls in flight, where nothing else touches: collision_source.h in closed form.
#include "events/collision_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace simulation {
namespace {

using namespace flight_hits;

using collision::approachThreshold;
using collision::FlightContact;
using solution::Event;
using solution::Histories;

double farthestOf(const Vector& point) {
    return std::max(std::max(std::abs(point[0]), std::abs(point[1])), std::abs(point[2]));
}

// By how much of an axis something lies beyond a box.
bool isBeyond(const geometry::Box& box, const Vector& point, double by) {
    bool beyond = false;
    for (Eigen::Index i = 0; i < 3; ++i)
        beyond = beyond || point[i] > box.max()[i] + by || point[i] < box.min()[i] - by;
    return beyond;
}

} // namespace

CollisionSource::Present
CollisionSource::presentOf(std::size_t body, const collision::BallFlight& flight, double time) {
    const collision::PlacedBall ball = flight.placedAt(time);
    const Vector velocity = flight.velocityAt(time);
    return {.body = body,
            .flight = &flight,
            .ball = ball,
            .velocity = velocity,
            .speed = velocity.norm(),
            .farthest = farthestOf(ball.centre)};
}

// Of what is neither in flight nor fixed only who it is.
CollisionSource::Present CollisionSource::presentAt(std::size_t body, double time) const {
    if (const collision::BallFlight* flight = search_.flight(body))
        return presentOf(body, *flight, time);
    return {.body = body,
            .farthest = records_[body].isFixed ? farthestOf(records_[body].start.position) : 0};
}

// As contactTolerance().
double CollisionSource::toleranceOf(const Present& a, const Present& b, double time) const {
    return collision::touchingGap * (records_[a.body].radius + records_[b.body].radius) +
           timeResolution * (a.farthest + b.farthest + std::abs(time) * (a.speed + b.speed));
}

FlightContact CollisionSource::flightContact(const Present& first, const Present& second,
                                             double time) const {
    const double tolerance = toleranceOf(first, second, time);
    if (first.flight && second.flight)
        return collision::contactOf(first.ball, second.ball, tolerance);
    const auto parts = search_.standing(first.flight ? second.body : first.body);
    if ((!first.flight && !second.flight) || parts.empty())
        return {FlightContact::Kind::unclear, {}, {}};
    FlightContact found;
    for (const collision::StandingPart& part : parts) {
        const FlightContact contact =
            collision::contactOf(first.flight ? first.ball : second.ball, part, tolerance);
        if (contact.kind == FlightContact::Kind::none)
            continue;
        if (contact.kind == FlightContact::Kind::unclear ||
            found.kind == FlightContact::Kind::contact)
            return {FlightContact::Kind::unclear, {}, {}};
        found = contact;
    }
    if (!first.flight)
        found.normal = -found.normal;
    return found;
}

// Something but `met` touches it, or that is not clear.
bool CollisionSource::touchesMore(const Histories& histories, const Present& one,
                                  const Present& met, double time) {
    bool touches = false;
    search_.forEachPartner(one.body, [&](std::size_t partner) {
        if (touches || partner == met.body)
            return;
        const Present other = presentAt(partner, time);
        const double tolerance = toleranceOf(one, other, time);
        if (one.flight && other.flight) {
            const double far = one.ball.radius + other.ball.radius + tolerance;
            if ((one.ball.centre - other.ball.centre).squaredNorm() > far * far)
                return;
        } else if (one.flight && records_[partner].isFixed) {
            if (isBeyond(search_.box(partner), one.ball.centre, one.ball.radius + tolerance))
                return;
        }
        const bool isFirst = one.body < partner;
        const FlightContact contact =
            flightContact(isFirst ? one : other, isFirst ? other : one, time);
        touches = contact.kind == FlightContact::Kind::contact ||
                  (contact.kind == FlightContact::Kind::unclear &&
                   touchesClosely(histories, std::minmax(one.body, partner), partner, time));
    });
    return touches;
}

// Whoever is near without touching leaves no trace in the result.
bool CollisionSource::touchesClosely(const Histories& histories, const Pair& pair,
                                     std::size_t other, double time) {
    Cluster cluster;
    if (!search_.hasEnded(other))
        addContacts(histories, cluster, pair.first, pair.second, time, true);
    return !cluster.contacts.empty();
}

// softenLastHops() would end the bouncing here, or is near to it.
bool CollisionSource::isLastHop(const Present& first, const Present& second, const Vector& normal,
                                double speed) const {
    const double push = (first.flight ? 2 * normal.dot(first.flight->half) : 0) -
                        (second.flight ? 2 * normal.dot(second.flight->half) : 0);
    if (!(push < 0))
        return false;
    double radius = solution::infinity, reach = 0, lowest = solution::infinity;
    for (const Present* one : {&first, &second}) {
        if (!records_[one->body].isFixed)
            lowest = std::min(lowest, limits_[one->body].hopHeight);
        radius = std::min(radius, records_[one->body].radius);
        reach += records_[one->body].radius + (one->flight ? one->ball.centre.norm() : 0);
    }
    lowest = std::max({lowest * radius, 2e-9 * radius, 1e-13 * reach});
    return speed * speed / (-2 * push) < 2 * lowest;
}

// Of a flight that the search does not follow.
void CollisionSource::readVelocity(const Histories& histories, Present& present,
                                   double time) const {
    if (!present.flight || search_.isFollowed(present.body))
        return;
    const std::size_t first = records_[present.body].firstUnknown + physics::dx;
    present.velocity = {histories.value(first, time), histories.value(first + 1, time),
                        histories.value(first + 2, time)};
}

// On the spot, where the solver agrees and nobody reads them.
bool CollisionSource::turn(const Pair& pair, double time, const std::array<Vector, 2>& before,
                           const std::array<Vector, 2>& after) {
    std::array<solution::Turn, 2> turns;
    std::array<std::size_t, 2> turned{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        if (records_[body].isFixed)
            continue;
        if (!turns_ || !search_.isFollowed(body) || !dependents_[body].empty())
            return false;
        turned[count] = body;
        solution::Turn& turn = turns[count++];
        const Vector place = search_.flight(body)->centreAt(time);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            turn.place[k] = place[axis]; // for who nudges (nudge.h)
            turn.places[k] = records_[body].firstUnknown + physics::x + k;
            turn.velocities[k] = records_[body].firstUnknown + physics::dx + k;
            turn.jumps[k] = after[i][axis] != before[i][axis];
            turn.velocity[k] = after[i][axis];
        }
    }
    if (!turns_->turn(time, std::span(turns).first(count)))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        search_.turn(turned[i], turns[i], time);
    search_.goOn(pair, time, renewal_);
    lookAtJoined(time);
    noteEvent(time);
    return true;
}

std::optional<CollisionSource::Push>
CollisionSource::pushOf(const Present& first, const Present& second, const Vector& normal) const {
    const double restitution =
        std::min(scene_.bodies[first.body].restitution, scene_.bodies[second.body].restitution);
    const double speed = normal.dot(first.velocity - second.velocity);
    if (restitution == 0 || !(speed < -approachThreshold * (first.speed + second.speed)) ||
        isLastHop(first, second, normal, restitution * speed))
        return std::nullopt;
    const double one = 1 / records_[first.body].mass, other = 1 / records_[second.body].mass;
    const double impulse = physics::centralImpulse(speed, restitution, one + other);
    const Push push{.impulse = impulse,
                    .velocities = {first.velocity + (impulse * one) * normal,
                                   second.velocity + (-impulse * other) * normal},
                    .isClear = restitution * -speed >
                               2 * approachThreshold * (first.speed + second.speed - 2 * speed)};
    if (push.velocities[0] == first.velocity && push.velocities[1] == second.velocity)
        return std::nullopt;
    return push;
}

void CollisionSource::record(const Pair& pair, const FlightContact& contact, double impulse,
                             double time) {
    impacts_.add({.time = time,
                  .first = pair.first,
                  .second = pair.second,
                  .point = contact.point,
                  .normal = contact.normal,
                  .impulse = impulse},
                 time);
}

std::optional<CollisionSource::Handled>
CollisionSource::meetInFlight(const Histories& histories, const Pair& pair, double time) {
    Present first = presentAt(pair.first, time), second = presentAt(pair.second, time);
    const FlightContact contact = flightContact(first, second, time);
    if (contact.kind != FlightContact::Kind::contact ||
        touchesMore(histories, first, second, time) || touchesMore(histories, second, first, time))
        return std::nullopt;
    readVelocity(histories, first, time);
    readVelocity(histories, second, time);
    const auto push = pushOf(first, second, contact.normal);
    if (!push)
        return std::nullopt;
    const std::array<Vector, 2> velocities{first.velocity, second.velocity};
    const std::array<Vector, 2>& then = push->velocities;
    record(pair, contact, push->impulse, time);
    if (turn(pair, time, velocities, then))
        return Handled{.event = {}, .isDone = true};
    // All axes of what could be turned restart, as they do in a turn: whether somebody reads a body
    // changes no bit of it.
    Event event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        for (std::size_t k = 0; k < 3 && !records_[body].isFixed; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const bool jumps = then[i][axis] != velocities[i][axis];
            const std::size_t unknown = records_[body].firstUnknown + physics::dx + k;
            if (jumps || search_.isFollowed(body))
                event.touched.push_back(unknown);
            if (jumps)
                outcome_.jumps.push_back({unknown, then[i][axis]});
        }
    }
    return Handled{.event = std::move(event), .isDone = false};
}

// --- in a rally -------------------------------------------------------------------------------

std::optional<Event> CollisionSource::rally(const Histories& histories, const Pair& pair,
                                            double until) {
    Course course;
    if (!turns_ || !search_.gather(pair, rally_)) {
        rally_.tried(course.hits);
        return std::nullopt;
    }
    for (Rally::Ball& ball : rally_.balls)
        for (std::size_t k = 0; k < 3; ++k) {
            ball.turn.places[k] = records_[ball.body].firstUnknown + physics::x + k;
            ball.turn.velocities[k] = records_[ball.body].firstUnknown + physics::dx + k;
        }
    const bool isUnread = std::ranges::all_of(
        rally_.balls, [this](const Rally::Ball& ball) { return dependents_[ball.body].empty(); });
    auto& [state, hits, last, time] = course;
    while (isUnread && state == Rallied::goesOn) {
        const Rally::Meeting* met = rally_.next();
        if (!met || met->time > until || (++hits % 64 == 0 && cancelled_ && cancelled_()))
            break;
        last = met;
        time = met->time; // its own will be the next time
        state = meetInRally(*met);
    }
    if (state == Rallied::isUnclear)
        rally_.forgetMeetings(*last);
    search_.dissolve(rally_);
    rally_.tried(hits);
    if (state == Rallied::isEndless)
        return endWithoutEnd(histories, last->pair, time);
    if (state == Rallied::isUnclear)
        search_.goOn(last->pair, time, renewal_);
    if (state == Rallied::isRefused)
        if (auto handled = meetInFlight(histories, last->pair, time))
            return std::move(handled->event);
    return std::nullopt;
}

// What is not told here at once is left to the search, which is asked again.
bool CollisionSource::touchesMoreInRally(const Present& one, const Rally::Ball& ball,
                                         const Rally::Meeting& met, double time) const {
    for (const std::size_t m : ball.meetings) {
        const Rally::Meeting& meeting = rally_.meetings[m];
        if (&meeting == &met)
            continue;
        if (meeting.isStanding) {
            const Rally::Standing& standing = rally_.standing[meeting.other];
            const Present other = presentAt(standing.body, time);
            const double tolerance = toleranceOf(one, other, time);
            if (!isBeyond(standing.box, one.ball.centre, one.ball.radius + tolerance) &&
                flightContact(one, other, time).kind != FlightContact::Kind::none)
                return true;
            continue;
        }
        const Rally::Ball& first = rally_.balls[meeting.ball];
        const Rally::Ball& ballNear = first.body == one.body ? rally_.balls[meeting.other] : first;
        const Present other = presentOf(ballNear.body, ballNear.flight, time);
        const double far = one.ball.radius + other.ball.radius + toleranceOf(one, other, time);
        if (!((one.ball.centre - other.ball.centre).squaredNorm() > far * far))
            return true;
    }
    return false;
}

static solution::Turn turnOf(const Rally::Ball& ball, double time, const Vector& before,
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

// As handle(), meetInFlight() and turn() do.
CollisionSource::Rallied CollisionSource::meetInRally(const Rally::Meeting& met) {
    const double time = met.time;
    const Rally::Ball* const one = &rally_.balls[met.ball];
    const Rally::Ball* const two = met.isStanding ? nullptr : &rally_.balls[met.other];
    const Present ball = presentOf(one->body, one->flight, time);
    const Present other = two ? presentOf(two->body, two->flight, time)
                              : presentAt(rally_.standing[met.other].body, time);
    const bool isInOrder = ball.body < other.body;
    const Present &first = isInOrder ? ball : other, &second = isInOrder ? other : ball;
    const FlightContact contact = flightContact(first, second, time);
    const bool mayGoAlongside = two && one->flight.half != two->flight.half;
    if (contact.kind != FlightContact::Kind::contact || mayGoAlongside || !rally_.areHome(time) ||
        touchesMoreInRally(ball, *one, met, time) ||
        (two && touchesMoreInRally(other, *two, met, time)))
        return Rallied::isOver;
    const auto push = pushOf(first, second, contact.normal);
    if (!push)
        return Rallied::isOver;
    if (isWithoutEnd(first.body, second.body, time) || isWithoutEnd(second.body, first.body, time))
        return Rallied::isEndless;
    if (!turnInRally(met, {ball.velocity, other.velocity},
                     {push->velocities[isInOrder ? 0 : 1], push->velocities[isInOrder ? 1 : 0]}))
        return Rallied::isRefused;
    record({first.body, second.body}, contact, push->impulse, time);
    noteEvent(time);
    const bool parted = two ? one->flight.half == two->flight.half
                            : one->isStraight && rally_.standing[met.other].parts.size() == 1;
    const bool forGood = parted && push->isClear && contact.gap > -deep * ball.ball.radius;
    return search_.turned(rally_, met, time, forGood) ? Rallied::goesOn : Rallied::isUnclear;
}

// Velocities: of the ball, and of the other. False: the solver does not do so on the spot.
bool CollisionSource::turnInRally(const Rally::Meeting& met, const std::array<Vector, 2>& before,
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
