#include "contacts/hollow_faults.h"

#include "collision/hollow_separation.h"
#include "collision/patch.h"
#include "surfaces/posed_parts.h"

#include <algorithm>
#include <cmath>

namespace simulation {
namespace {

using collision::Posed;
using geometry::Part;

double radiusOf(const Part& part) {
    return geometry::radiusAbout(part, part.core.vertices[0]) + part.radius;
}

Vector turnedInto(const Posed& owner, const Vector& place) {
    return owner.rotation.transpose() * (place - owner.offset);
}

bool isWideBall(const Posed& ball, const Posed& wall, double tolerance) {
    const geometry::Curved& curved = *wall.part->curved;
    if (!ball.part->isSphere() || ball.part->radius < curved.inner)
        return false;
    const auto nearest = geometry::nearestOf(curved, turnedInto(wall, ball.world(0)));
    return nearest.piece == geometry::HollowNearest::Piece::rim &&
           nearest.distance - ball.part->radius <= tolerance * radiusOf(*ball.part);
}

// Something of a round part touches the lid where there is none.
bool isAtMouth(const Posed& other, const Posed& wall, double tolerance) {
    const geometry::Curved& curved = *wall.part->curved;
    if (!other.part->curved || other.part->isPlane())
        return false;
    const double beside = tolerance * std::min(radiusOf(*other.part), radiusOf(*wall.part));
    collision::WarmStart cold;
    const collision::Separation hull = collision::separate(other, wall, cold);
    if (std::abs(hull.gap) > beside)
        return false;
    const Vector axis = wall.rotation * curved.axis();
    const double along = axis.dot(hull.normal);
    const bool isTube = curved.kind == geometry::Curved::Kind::tube;
    constexpr double parallel = 1e-6;
    if ((isTube ? std::abs(along) : along) < 1 - parallel)
        return false;
    const Vector middle = wall.rotation * curved.center + wall.offset;
    const collision::Patch patch = collision::patchOf(other, wall, hull.normal, beside, beside);
    return std::ranges::any_of(patch.corners, [&](const Vector& corner) {
        return axis.cross(corner - middle).norm() < (1 - parallel) * curved.inner;
    });
}

} // namespace

std::optional<HollowFault> hollowFaultOf(const Placed& first, const Placed& second,
                                         double tolerance) {
    const Vector origin = first.state.position;
    for (std::size_t i = 0; i < first.shape->parts.size(); ++i)
        for (std::size_t j = 0; j < second.shape->parts.size(); ++j) {
            const Posed a = posed(first, i, origin), b = posed(second, j, origin);
            for (const auto& [other, wall] : {std::pair(&a, &b), std::pair(&b, &a)}) {
                if (!wall->part->isHollow())
                    continue;
                if (isWideBall(*other, *wall, tolerance))
                    return HollowFault::wideBall;
                if (isAtMouth(*other, *wall, tolerance))
                    return HollowFault::closedMouth;
            }
        }
    return std::nullopt;
}

WallWatch::WallWatch(const Colliders& world) : world_(world), looked_(world.start) {
    for (std::size_t body = 0; body < world.moving.size(); ++body)
        hasHollow_ = hasHollow_ || world.isHollow(body);
}

std::optional<WallWatch::Crossing> WallWatch::first(const ContactSet& contacts, double until,
                                                    const PlacedAt& placedAt) {
    constexpr int looks = 4; // in the time since the last
    // Of the size: so far the polynomial of a step may leave the wall; what counts as touching.
    constexpr double deep = 1e-3, touching = 1e-6;
    std::optional<Crossing> found;
    if (!hasHollow_)
        return found;
    for (const ContactSet::Parts& parts : contacts.parts()) {
        const auto isDeeper = [&](double time, double part) {
            const Placed body = placedAt(parts.body, time), support = placedAt(parts.support, time);
            const Vector& origin = body.state.position;
            const Posed a = posed(body, parts.bodyPart, origin),
                        b = posed(support, parts.supportPart, origin);
            // A ball has but one place that touches, and that is a condition.
            if (!collision::isHollowPair(*a.part, *b.part) || a.part->isSphere() ||
                b.part->isSphere())
                return false;
            return collision::separateHollow(a, b).gap <
                   -part * std::min(radiusOf(*a.part), radiusOf(*b.part));
        };
        double from = std::max(looked_, parts.from);
        const double stretch = (until - from) / looks;
        for (int i = 1; i <= looks && stretch > 0; ++i) {
            const double to = i == looks ? until : from + stretch;
            if (!isDeeper(to, deep)) {
                from = to;
                continue;
            }
            double low = from, high = to;
            for (double middle = (low + high) / 2; low < middle && middle < high;
                 middle = (low + high) / 2)
                (isDeeper(middle, touching) ? high : low) = middle;
            if (!found || high < found->time)
                found = {.time = high, .bodies = std::minmax(parts.body, parts.support)};
            break;
        }
    }
    looked_ = std::max(looked_, until);
    return found;
}

} // namespace simulation
