#include "surfaces/posed_parts.h"

namespace simulation {

using collision::Posed;
using geometry::Matrix;

Vector intoFrame(const Placed& placed, const Vector& point) {
    return placed.state.attitude.conjugate() * Vector(point - placed.state.position);
}

Vector turnedInto(const Placed& placed, const Vector& direction) {
    return placed.state.attitude.conjugate() * direction;
}

Posed posed(const Placed& placed, std::size_t part, const Vector& origin) {
    const Matrix rotation = placed.state.attitude.toRotationMatrix();
    return {.part = &placed.shape->parts[part],
            .rotation = rotation,
            .offset = placed.state.position - origin - rotation * placed.record->centroid};
}

Vector faceNormal(const Posed& owner, const Vector& direction) {
    Vector best = direction;
    double most = -1;
    if (owner.part->curved) { // of a cylinder the end that is meant; of a cone the base
        const Vector axis = owner.rotation * owner.part->curved->axis();
        using Curved = geometry::Curved::Kind;
        const Curved kind = owner.part->curved->kind;
        const bool hasTwo = kind == Curved::cylinder || kind == Curved::tube;
        const bool isUp =
            owner.part->isPlane() || kind == Curved::bowl || (hasTwo && axis.dot(direction) > 0);
        return isUp ? axis : Vector(-axis);
    }
    for (const geometry::Face& face : owner.part->core.faces) {
        const Vector normal = owner.rotation * face.normal;
        if (const double along = normal.dot(direction); along > most) {
            most = along;
            best = normal;
        }
    }
    return best;
}

} // namespace simulation
