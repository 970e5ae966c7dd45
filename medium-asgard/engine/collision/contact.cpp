#include "collision/contact.h"

#include "collision/part_motion.h"
#include "collision/patch.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

constexpr double flatLanding = 1e-9; // of the size: less tilt than this is none

// The normal of the touching face, or of two crossing edges, that lies along `normal` up to the
// rounding with which closest points give it; else `normal`.
Vector snapped(const Posed& first, const Posed& second, const Vector& normal, double size) {
    const double tolerance = 3 * flatLanding * size;
    const auto ofFirst = furthestFeature(first, -normal, tolerance);
    const auto ofSecond = furthestFeature(second, normal, tolerance);
    const auto faceOf = [&](const Posed& owner, double sign) -> const geometry::Face* {
        const geometry::Face* best = nullptr;
        double most = 1 - 1e-8;
        for (const geometry::Face& f : owner.part->core.faces)
            if (const double d = sign * (owner.rotation * f.normal).dot(normal); d > most) {
                most = d;
                best = &f;
            }
        return best;
    };
    if (ofFirst.size() > 2)
        if (const geometry::Face* f = faceOf(first, -1))
            return -(first.rotation * f->normal);
    if (ofSecond.size() > 2)
        if (const geometry::Face* f = faceOf(second, 1))
            return second.rotation * f->normal;
    if (ofFirst.size() == 2 && ofSecond.size() == 2) {
        const Vector u = ofFirst[1] - ofFirst[0], v = ofSecond[1] - ofSecond[0];
        const Vector across = u.cross(v);
        if (across.norm() > 1e-6 * u.norm() * v.norm()) {
            const Vector n = across.normalized();
            const Vector along = n.dot(normal) > 0 ? n : Vector(-n);
            return along.dot(normal) > 1 - 1e-8 ? along : normal;
        }
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
    Vector normal = separation.normal;
    if (!isRound(pair)) {
        // At the contact itself the line between closest points is lost; a little before, it is
        // not.
        const double speed = pair.relativeSpeed(t);
        const double before = speed > 0 ? t - 1e-6 * size / speed : t;
        WarmStart cold;
        const Separation earlier = pair.separationAt(before, cold);
        if (earlier.gap > separation.gap && earlier.gap > 0)
            normal = earlier.normal;
    }
    const Vector origin = pair.originAt(t);
    const Posed first = pair.first.posedAt(t, origin), second = pair.second.posedAt(t, origin);
    normal = snapped(first, second, normal, size);

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
