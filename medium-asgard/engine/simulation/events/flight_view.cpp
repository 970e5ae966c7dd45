#include "events/flight_view.h"

#include "collision/contact.h"
#include "events/last_hops.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using collision::approachThreshold;
using collision::FlightContact;

double farthestOf(const Vector& point) {
    return std::max(std::max(std::abs(point[0]), std::abs(point[1])), std::abs(point[2]));
}

} // namespace

Present FlightView::presentOf(std::size_t body, const collision::BallFlight& flight, double time) {
    const collision::PlacedBall ball = flight.placedAt(time);
    const Vector velocity = flight.velocityAt(time);
    return {.body = body,
            .flight = &flight,
            .ball = ball,
            .velocity = velocity,
            .speed = velocity.norm(),
            .farthest = farthestOf(ball.centre)};
}

Present FlightView::presentAt(std::size_t body, double time) const {
    if (const collision::BallFlight* flight = search.flight(body))
        return presentOf(body, *flight, time);
    return {.body = body,
            .farthest =
                world.records[body].isFixed ? farthestOf(world.records[body].start.position) : 0};
}

double FlightView::toleranceOf(const Present& a, const Present& b, double time) const {
    return collision::touchingGap * (world.records[a.body].radius + world.records[b.body].radius) +
           resolution::ofPlaces * (a.farthest + b.farthest + std::abs(time) * (a.speed + b.speed));
}

FlightContact FlightView::contactOf(const Present& first, const Present& second,
                                    double time) const {
    const double tolerance = toleranceOf(first, second, time);
    if (first.flight && second.flight)
        return collision::contactOf(first.ball, second.ball, tolerance);
    const auto parts = search.standing(first.flight ? second.body : first.body);
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

bool FlightView::isBeyond(const geometry::Box& box, const Vector& point, double by) {
    bool beyond = false;
    for (Eigen::Index i = 0; i < 3; ++i)
        beyond = beyond || point[i] > box.max()[i] + by || point[i] < box.min()[i] - by;
    return beyond;
}

// softenLastHops() would end the bouncing here, or is near to it.
bool FlightView::isLastHop(const Present& first, const Present& second, const Vector& normal,
                           double speed) const {
    const double push = (first.flight ? 2 * normal.dot(first.flight->half) : 0) -
                        (second.flight ? 2 * normal.dot(second.flight->half) : 0);
    if (!(push < 0))
        return false;
    double reach = 0;
    for (const Present* one : {&first, &second})
        reach += world.records[one->body].radius + (one->flight ? one->ball.centre.norm() : 0);
    const Pair pair(first.body, second.body);
    return speed * speed / (-2 * push) <
           2 * lastHopHeight(hopHeightOf(world, pair), world.smallerRadius(pair), reach);
}

std::optional<Push> FlightView::pushOf(const Present& first, const Present& second,
                                       const Vector& normal) const {
    const double restitution = world.restitutionOf({first.body, second.body});
    const double speed = normal.dot(first.velocity - second.velocity);
    if (world.frictionOf(first.body, second.body).sliding > 0 || restitution == 0 ||
        !(speed < -approachThreshold * (first.speed + second.speed)) ||
        isLastHop(first, second, normal, restitution * speed))
        return std::nullopt;
    const double one = 1 / world.records[first.body].mass,
                 other = 1 / world.records[second.body].mass;
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

} // namespace simulation
