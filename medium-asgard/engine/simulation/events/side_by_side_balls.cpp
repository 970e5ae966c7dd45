#include "events/side_by_side_balls.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

struct Closeness {                   // of two balls
    double radius = 0, rounding = 0; // the smaller one; of places
    double gap = 0;
    double rate = 0, push = 0; // the first two derivatives of the gap
    double turning = 0;        // what of the push is their going past each other
    double accelerations = 0;  // that enter
};

Closeness closenessOf(const Instant& at, const Pair& pair) {
    const BodyRecord &a = at.world.records[pair.first], &b = at.world.records[pair.second];
    const BodyState one = at.stateOf(pair.first), other = at.stateOf(pair.second);
    const Vector first = at.accelerationOf(pair.first).linear;
    const Vector second = at.accelerationOf(pair.second).linear;
    const Vector normal = (one.position - other.position).normalized();
    const Vector speed = one.velocity - other.velocity;
    const double rate = normal.dot(speed);
    const double turning = (speed - rate * normal).squaredNorm() / (a.radius + b.radius);
    return {.radius = std::min(a.radius, b.radius),
            .rounding = resolution::ofMotion * (one.position.norm() + other.position.norm()),
            .gap = (one.position - other.position).norm() - a.radius - b.radius,
            .rate = rate,
            .push = normal.dot(first - second) + turning,
            .turning = turning,
            .accelerations = first.norm() + second.norm()};
}

} // namespace

Alongside goAlongside(const Instant& at, const Found& hit, SideBySide& balls) {
    const auto [a, b] = hit.pair;
    const auto *flight = at.search.flight(a), *other = at.search.flight(b);
    // What flies alike nothing pushes together: it parts for ever.
    if (!at.areFreeBalls(hit.pair) || (flight && other && flight->half == other->half))
        return Alongside::no;
    const Closeness near = closenessOf(at, hit.pair);
    const double least =
        std::min(at.world.resolution[a].depth, at.world.resolution[b].depth) * near.radius +
        near.rounding;
    const double known = balls.depth(hit.pair), square = near.rate * near.rate;
    constexpr double passing = 1e-3; // of the accelerations: what opens the gap where they graze
    const bool isPassing = known == 0 && near.turning > passing * near.accelerations;
    const double floor = resolution::leastPush * near.radius;
    const bool isSlow = square < 4 * std::max(near.accelerations, floor) * std::max(known, least);
    if (!hit.pressing && (isPassing || !isSlow))
        return Alongside::no;
    const double weak = std::max(resolution::weakPush * near.accelerations, floor);
    const bool isPressed = near.push < -weak;
    if (at.world.restitutionOf(hit.pair) < 1 && isPressed)
        return Alongside::no;
    constexpr double low = 1.0 / 16; // of that depth: a hop is none
    // The end of a step has moved them deeper, onto their joints as a rule: no way of theirs.
    const bool isMoved = known > 0 && -near.gap > at.contactTolerance(hit.pair);
    // No blow has anything to do at such a rate, and the next hit would be at once.
    const bool isStill = near.rate >= -resolution::noRate * near.radius;
    if (known > 0 && !isMoved && !isStill && !hit.pressing &&
        !(square < -2 * near.push * low * least))
        return balls.hop(hit.pair, at.time) ? Alongside::no : Alongside::tooOften;
    const SideBySide::Now now{.time = at.time, .rate = near.rate, .push = -near.push};
    const double deeper = isMoved ? least - near.gap - known : least;
    return balls.sink(hit.pair, deeper, least, now) ? Alongside::yes : Alongside::tooOften;
}

} // namespace simulation
