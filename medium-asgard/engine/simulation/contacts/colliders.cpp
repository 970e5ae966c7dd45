#include "contacts/colliders.h"

#include <cmath>

namespace simulation {

Colliders::Colliders(const scene::Scene& ofScene, const physics::EquationsOfMotion& ofEquations,
                     const std::vector<geometry::Shape>& shapes, double from,
                     std::vector<ContactResolution> resolved)
    : scene(ofScene), equations(ofEquations), start(from), records(recordsOf(ofEquations)),
      resolution(std::move(resolved)), joints(ofEquations) {
    for (std::size_t body = 0; body < records.size(); ++body)
        moving.emplace_back(records[body], shapes[body]);
}

physics::ContactFriction Colliders::frictionOf(std::size_t body, std::size_t support) const {
    const scene::Body &a = scene.bodies[body], &b = scene.bodies[support];
    const auto mean = [](double one, double other) {
        return one == other ? one : std::sqrt(one * other);
    };
    return {.sticking =
                mean(a.staticFriction.value_or(a.friction), b.staticFriction.value_or(b.friction)),
            .sliding = mean(a.friction, b.friction),
            .rolling = std::max(a.rollingFriction, b.rollingFriction),
            .reach = 0,
            .bodySurface = a.surfaceVelocity,
            .supportSurface = b.surfaceVelocity};
}

void Colliders::read(const solution::Histories& histories) {
    if (std::exchange(read_, &histories) != &histories)
        for (MovingBody& body : moving)
            body.read(histories);
}

} // namespace simulation
