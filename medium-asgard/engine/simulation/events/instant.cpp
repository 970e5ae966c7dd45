#include "events/instant.h"

#include "collision/contact.h"

#include <algorithm>
#include <set>

namespace simulation {

physics::ImpactBody Instant::impactBody(std::size_t body) const {
    BodyState state = stateOf(body);
    if (world.isBall(body) && !state.angularVelocity.allFinite())
        state.angularVelocity.setZero(); // its blows go through its centre
    return mobility.impactBody(body, time, state);
}

bool Instant::areFreeBalls(const Pair& pair) const {
    const auto isFree = [&](std::size_t body) {
        return search.isFollowed(body) || mobility.isFree(body, time);
    };
    return world.isBall(pair.first) && world.isBall(pair.second) && isFree(pair.first) &&
           isFree(pair.second);
}

namespace {

// It is 0 and stays so (solution/zero_states.h).
bool sleeps(const solution::Histories& histories, std::size_t unknown, double time) {
    const auto place = histories.place(unknown, time);
    const auto isZero = [](double coefficient) { return coefficient == 0; };
    return place.history->until() == solution::infinity &&
           place.history->from() <= histories.start() &&
           std::ranges::all_of(histories.piece(unknown, time).coefficients, isZero);
}

double speedOf(const BodyState& state, double radius) {
    return state.velocity.norm() + radius * state.angularVelocity.norm();
}

// By more than `rounding`.
bool leaves(const BodyState& state, int axis, double radius, double rounding) {
    Vector turn = radius * state.angularVelocity;
    turn[axis] = 0;
    return std::abs(state.velocity[axis]) + turn.norm() > rounding;
}

// Its surface runs along that axis, by more than rounding.
bool runsAlong(const Colliders& world, std::size_t body, int axis) {
    constexpr double rounding = 1e-12;
    const Vector& surface = world.scene.bodies[body].surfaceVelocity;
    return std::abs((world.records[body].start.attitude * surface)[axis]) >
           rounding * surface.norm();
}

} // namespace

std::optional<MotionPlane> Instant::planeOf(std::span<const std::size_t> bodies,
                                            const ChangedStates& changed) const {
    for (const int axis : {2, 1, 0}) {
        const auto staysIn = [&](std::size_t body) {
            return world.isFixed(body) || (!isDrivenAlong(body, axis) && sleepsAcross(body, axis));
        };
        if (!std::ranges::all_of(bodies, staysIn))
            continue;
        if (const auto at = placeAlong(bodies, axis);
            at && !isAnyChangedAcross(bodies, changed, axis))
            return MotionPlane{.axis = axis, .at = *at};
    }
    return std::nullopt;
}

// Its motion out of the plane across that axis is 0, and stays so.
bool Instant::sleepsAcross(std::size_t body, int axis) const {
    using namespace physics;
    const std::size_t first = world.records[body].firstUnknown;
    const auto sleepsAt = [&](std::size_t unknown) {
        return sleeps(histories, first + unknown, time);
    };
    bool isAsleep = sleepsAt(dx + static_cast<std::size_t>(axis));
    for (std::size_t k = 0; k < 3 && isAsleep; ++k)
        isAsleep = static_cast<int>(k) == axis || (sleepsAt(qx + k) && sleepsAt(w1 + k));
    return isAsleep;
}

// None: of bodies at several places, or of fixed bodies alone.
std::optional<double> Instant::placeAlong(std::span<const std::size_t> bodies, int axis) const {
    std::optional<double> at;
    for (const std::size_t body : bodies) {
        if (world.isFixed(body))
            continue;
        const double place = stateOf(body).position[axis];
        if (at && *at != place)
            return std::nullopt;
        at = place;
    }
    return at;
}

bool Instant::isAnyChangedAcross(std::span<const std::size_t> bodies, const ChangedStates& changed,
                                 int axis) const {
    constexpr double ofSpeeds = 1e-9; // that enter a blow
    double rounding = 0;
    for (const auto& [body, after] : changed)
        for (const BodyState& state : {stateOf(body), after})
            rounding = std::max(rounding,
                                ofSpeeds * simulation::speedOf(state, world.records[body].radius));
    return std::ranges::any_of(bodies, [&](std::size_t body) {
        const auto after = changed.find(body);
        return !world.isFixed(body) && after != changed.end() &&
               leaves(after->second, axis, world.records[body].radius, rounding);
    });
}

// A belt near by drives what comes to lie on it, or it drives itself so. LIMIT: no belt turns out
// of a plane.
bool Instant::isDrivenAlong(std::size_t body, int axis) const {
    return std::ranges::any_of(search.partners(body), [&](std::size_t other) {
        return (runsAlong(world, body, axis) || runsAlong(world, other, axis)) &&
               world.frictionOf(body, other).sticking > 0;
    });
}

double Instant::speedOf(const Pair& pair) const {
    double speed = 0;
    for (const std::size_t body : {pair.first, pair.second}) {
        if (const collision::BallFlight* flight = search.flight(body)) {
            speed += flight->velocityAt(time).norm();
        } else if (!world.isFixed(body)) {
            const auto velocity = collision::velocityAt(world.moving[body].pieceAt(time), time);
            speed += velocity.linear.norm() + velocity.angular.norm() * world.records[body].radius;
        }
    }
    return speed;
}

double Instant::contactTolerance(const Pair& pair) const {
    double reach = 0, coordinates = 0;
    for (const std::size_t body : {pair.first, pair.second}) {
        reach += world.records[body].radius;
        if (const collision::BallFlight* flight = search.flight(body))
            coordinates += flight->centreAt(time).cwiseAbs().maxCoeff();
        else if (world.isFixed(body))
            coordinates += world.records[body].start.position.cwiseAbs().maxCoeff();
        else
            coordinates +=
                collision::positionAt(world.moving[body].pieceAt(time), time).cwiseAbs().maxCoeff();
    }
    const double depth = search.depth(pair);
    return (depth > 0 ? depth : collision::touchingGap * reach) +
           resolution::ofPlaces * (coordinates + std::abs(time) * speedOf(pair));
}

std::vector<std::size_t> Instant::unknownsOf(const Pair& pair) const {
    std::vector<std::size_t> unknowns;
    for (const std::size_t body : std::set<std::size_t>{pair.first, pair.second})
        if (canGiveWay(body))
            for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
                unknowns.push_back(world.records[body].firstUnknown + i);
    return unknowns;
}

} // namespace simulation
