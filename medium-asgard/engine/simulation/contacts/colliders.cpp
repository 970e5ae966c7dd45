#include "contacts/colliders.h"

#include <algorithm>

#include <tuple>
#include <utility>

namespace simulation {

Colliders::Colliders(const scene::Scene& ofScene, const physics::EquationsOfMotion& ofEquations,
                     const std::vector<geometry::Shape>& shapes, double from,
                     std::vector<ContactResolution> resolved)
    : scene(ofScene), equations(ofEquations), pairs(ofScene), start(from),
      records(recordsOf(ofEquations)), resolution(std::move(resolved)), joints(ofEquations) {
    for (std::size_t body = 0; body < records.size(); ++body)
        moving.emplace_back(records[body], shapes[body]);
}

double Colliders::smallerRadius(const Pair& pair) const {
    const double first = records[pair.first].radius, second = records[pair.second].radius;
    return first > 0 && second > 0 ? std::min(first, second) : std::max(first, second);
}

Pair Colliders::bodyAndSupport(const Pair& pair) const {
    const auto rank = [this](std::size_t body) {
        return std::tuple(isFixed(body), !isBall(body), records[body].radius, body);
    };
    return rank(pair.second) < rank(pair.first) ? Pair(pair.second, pair.first) : pair;
}

physics::ContactFriction Colliders::frictionOf(std::size_t body, std::size_t support) const {
    const scene::PairLaw law = pairs.lawOf(body, support);
    return {.sticking = law.sticking,
            .sliding = law.sliding,
            .rolling = law.rolling,
            .reach = 0,
            .bodySurface = scene.bodies[body].surfaceVelocity,
            .supportSurface = scene.bodies[support].surfaceVelocity};
}

void Colliders::read(const solution::Histories& histories) {
    if (std::exchange(read_, &histories) != &histories)
        for (MovingBody& body : moving)
            body.read(histories);
}

bool Colliders::isHollow(std::size_t body) const {
    return std::ranges::any_of(moving[body].shape().parts, &geometry::Part::isHollow);
}

} // namespace simulation
