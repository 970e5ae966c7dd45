#include "collision/contact.h"

#include "collision/part_motion.h"
#include "collision/patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace collision {

namespace {

constexpr double flatLanding = 1e-9; // of the size: less tilt than this is none

// The two posed parts at one time and the line between them.
struct Touching {
    Posed first, second;
    Vector normal;
};

// Vertices of the part within `tolerance` of its furthest extent along a direction.
std::vector<std::size_t> furthest(const Posed& posed, const Vector& direction, double tolerance) {
    const double most = direction.dot(posed.world(posed.support(direction)));
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < posed.part->core.vertices.size(); ++i)
        if (direction.dot(posed.world(i)) >= most - tolerance)
            result.push_back(i);
    return result;
}

const geometry::Face* faceAlong(const Posed& owner, const Vector& direction) {
    const geometry::Face* best = nullptr;
    double most = 1 - 1e-8;
    for (const geometry::Face& f : owner.part->core.faces)
        if (const double d = (owner.rotation * f.normal).dot(direction); d > most) {
            most = d;
            best = &f;
        }
    return best;
}

Vector edgeOf(const Posed& posed, const std::vector<std::size_t>& ends) {
    return (posed.world(ends[1]) - posed.world(ends[0])).normalized();
}

// Which features touch is seen `before`; where they are, and so the normal, is that of `now`.
Vector normalOf(const Touching& before, const Touching& now, double tolerance) {
    const auto ofFirst = furthest(before.first, -before.normal, tolerance);
    const auto ofSecond = furthest(before.second, before.normal, tolerance);
    if (ofFirst.size() > 2)
        if (const geometry::Face* f = faceAlong(before.first, -before.normal))
            return -(now.first.rotation * f->normal);
    if (ofSecond.size() > 2)
        if (const geometry::Face* f = faceAlong(before.second, before.normal))
            return now.second.rotation * f->normal;
    Vector normal = before.normal;
    if (ofFirst.size() == 2 && ofSecond.size() == 2) {
        const Vector across = edgeOf(now.first, ofFirst).cross(edgeOf(now.second, ofSecond));
        if (across.norm() > 1e-6)
            return (across.dot(normal) > 0 ? across : Vector(-across)).normalized();
    }
    // Across the one edge, or the parallel ones.
    for (const auto& [posed, ends] : {std::pair(&now.first, &ofFirst), {&now.second, &ofSecond}})
        if (ends->size() == 2) {
            const Vector along = edgeOf(*posed, *ends);
            normal = (normal - along * along.dot(normal)).normalized();
        }
    return normal;
}

bool isRound(const PartPair& pair) {
    return pair.first.part->isSphere() || pair.second.part->isSphere();
}

} // namespace

double closingSpeed(const Velocity& first, const Vector& firstPivot, const Velocity& second,
                    const Vector& secondPivot, const Vector& point, const Vector& normal) {
    const Vector a = first.linear + first.angular.cross(point - firstPivot);
    const Vector b = second.linear + second.angular.cross(point - secondPivot);
    return normal.dot(b - a);
}

Contact contactOf(const PartPair& pair, double t, const Separation& separation) {
    const double size = pair.size();
    const Vector origin = pair.originAt(t);
    const Posed first = pair.first.posedAt(t, origin), second = pair.second.posedAt(t, origin);
    const Touching now{first, second, separation.normal};
    Touching before = now;
    if (!isRound(pair)) {
        // At the contact itself the line between closest points is lost; a little before, it is
        // not.
        const double speed = pair.relativeSpeed(t);
        const double earlier = speed > 0 ? t - 1e-6 * size / speed : t;
        WarmStart cold;
        const Separation then = pair.separationAt(earlier, cold);
        const Vector there = pair.originAt(earlier);
        if (then.gap > separation.gap && then.gap > 0)
            before = {pair.first.posedAt(earlier, there), pair.second.posedAt(earlier, there),
                      then.normal};
    }
    const Vector normal = normalOf(before, now, 3 * flatLanding * size);

    const Patch patch = patchOf(first, second, normal, flatLanding * size);
    const Velocity va = velocityAt(pair.first.piece, t), vb = velocityAt(pair.second.piece, t);
    const Vector pivotA = positionAt(pair.first.piece, t) - origin;
    Contact contact;
    contact.normal = normal;
    contact.point = patch.centre + origin;
    contact.gap = separation.gap;
    contact.closingSpeed = -HUGE_VAL;
    for (const Vector& corner : patch.corners) {
        contact.patch.push_back(corner + origin);
        contact.closingSpeed = std::max(
            contact.closingSpeed, closingSpeed(va, pivotA, vb, Vector::Zero(), corner, normal));
    }
    return contact;
}

std::vector<Contact> contactsAt(const MovingShape& first, const MovingShape& second, double t,
                                double tolerance) {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < first.shape().parts.size(); ++i)
        for (std::size_t j = 0; j < second.shape().parts.size(); ++j) {
            const PartPair pair = partPair(first, i, second, j, t);
            const double apart =
                (positionAt(pair.first.piece, t) - positionAt(pair.second.piece, t)).norm();
            if (apart > pair.first.reach + pair.second.reach + tolerance)
                continue;
            WarmStart cold;
            const Separation separation = pair.separationAt(t, cold);
            if (std::abs(separation.gap) > tolerance)
                continue;
            contacts.push_back(contactOf(pair, t, separation));
            contacts.back().firstPart = i;
            contacts.back().secondPart = j;
        }
    return contacts;
}

} // namespace collision
