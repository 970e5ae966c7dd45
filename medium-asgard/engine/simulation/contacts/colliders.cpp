#include "contacts/colliders.h"

namespace simulation {

Colliders::Colliders(const scene::Scene& ofScene, const physics::EquationsOfMotion& ofEquations,
                     const std::vector<geometry::Shape>& shapes, double from,
                     std::vector<ContactResolution> resolved)
    : scene(ofScene), equations(ofEquations), start(from), records(recordsOf(ofEquations)),
      resolution(std::move(resolved)), joints(ofEquations) {
    for (std::size_t body = 0; body < records.size(); ++body)
        moving.emplace_back(records[body], shapes[body]);
}

void Colliders::read(const solution::Histories& histories) {
    if (std::exchange(read_, &histories) != &histories)
        for (MovingBody& body : moving)
            body.read(histories);
}

} // namespace simulation
