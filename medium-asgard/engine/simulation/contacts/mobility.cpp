#include "contacts/mobility.h"

#include "physics/holds.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using solution::infinity;

physics::Held Mobility::heldOf(std::size_t body, double time) const {
    return physics::unyieldingAt(world_.equations, body,
                                 std::min(time, std::nextafter(finish_, world_.start)));
}

bool Mobility::canGiveWay(std::size_t body, double time) const {
    if (world_.records[body].isFixed)
        return false;
    const physics::Held held = heldOf(body, time);
    return std::ranges::count(held.position, true) < 3 ||
           (!held.attitude && !world_.moving[body].isBall());
}

bool Mobility::isFree(std::size_t body, double time) const {
    return !world_.records[body].isFixed &&
           std::ranges::count(heldOf(body, time).position, true) == 0;
}

bool Mobility::hopForEver(std::size_t a, std::size_t b, double time) const {
    return world_.restitutionOf({a, b}) == 1 && world_.moving[a].isBall() &&
           world_.moving[b].isBall() && isFree(a, time) && isFree(b, time);
}

double Mobility::nextPhase(std::size_t body, double time) const {
    double next = infinity;
    for (std::size_t i = 0; !world_.records[body].isFixed && i < physics::bodyUnknowns; ++i)
        for (const auto& phase :
             world_.equations.set.unknowns[world_.records[body].firstUnknown + i].phases)
            if (phase.from > time)
                next = std::min(next, phase.from);
    return next;
}

double Mobility::lastPhase(std::size_t body, double time) const {
    double last = world_.start;
    for (std::size_t i = 0; !world_.records[body].isFixed && i < physics::bodyUnknowns; ++i)
        for (const auto& phase :
             world_.equations.set.unknowns[world_.records[body].firstUnknown + i].phases)
            if (phase.from <= time)
                last = std::max(last, phase.from);
    return last;
}

collision::Slack Mobility::slack(std::size_t a, std::size_t b, double time) const {
    const auto of = [&](std::size_t body) {
        return contacts_.isIn(body) && canGiveWay(body, time) ? world_.resolution[body].gap : 0;
    };
    return std::max(of(a), of(b));
}

physics::ImpactBody Mobility::impactBody(std::size_t body, double time,
                                         const BodyState& state) const {
    physics::ImpactBody impact{.centre = state.position,
                               .velocity = state.velocity,
                               .angularVelocity = state.angularVelocity};
    if (!canGiveWay(body, time))
        return impact;
    const physics::BodyMotion& motion = world_.equations.bodies[body];
    const physics::Held held = heldOf(body, time);
    impact.inverseMass = 1 / motion.mass.mass;
    for (std::size_t i = 0; i < 3; ++i)
        impact.moves[static_cast<Eigen::Index>(i)] = held.position[i] ? 0 : 1;
    if (!held.attitude) {
        const geometry::Matrix r = state.attitude.toRotationMatrix();
        impact.inverseInertia = r * motion.mass.inertia.inverse() * r.transpose();
    }
    return impact;
}

Placed Mobility::placed(const solution::Histories& histories, std::size_t body, double time,
                        const ChangedStates& changed) const {
    const auto given = changed.find(body);
    Placed placed;
    placed.index = body;
    placed.record = &world_.records[body];
    placed.shape = &world_.moving[body].shape();
    placed.state =
        given != changed.end() ? given->second : stateOf(world_.records[body], histories, time);
    return placed;
}

} // namespace simulation
