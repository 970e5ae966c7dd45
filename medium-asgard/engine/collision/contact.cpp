#include "collision/contact.h"

#include "collision/curved_separation.h"
#include "collision/hollow_separation.h"
#include "collision/part_motion.h"
#include "collision/patch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace collision {

namespace {

constexpr double flatLanding = 2e-9; // of the smaller part's size: less tilt than this is none
constexpr double sameAxis = 1e-4;    // difference of normals: faces may yet land on each other

// The two posed parts at one time and the line between them.
struct Touching {
    Posed first, second;
    Vector normal;
};

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
    const auto ofFirst = furthestVertices(before.first, -before.normal, tolerance);
    const auto ofSecond = furthestVertices(before.second, before.normal, tolerance);
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

bool isCurved(const PartPair& pair) { return isCurvedPair(*pair.first.part, *pair.second.part); }

} // namespace

double closingSpeed(const Velocity& first, const Vector& firstPivot, const Velocity& second,
                    const Vector& secondPivot, const Vector& point, const Vector& normal) {
    const Vector a = first.linear + first.angular.cross(point - firstPivot);
    const Vector b = second.linear + second.angular.cross(point - secondPivot);
    return normal.dot(b - a);
}

namespace {

// Earlier by so much that the parts were some 1e-6 of their size elsewhere. Not by more: pieces of
// motion hold near the time for which they are asked, and a body that falls from rest was nowhere
// near before.
double shortlyBefore(const PartPair& pair, double t) {
    const double way = 1e-6 * pair.size(), speed = pair.relativeSpeed(t);
    if (!(speed > 0))
        return t;
    const auto relative = [&](double time) {
        return Vector(positionAt(pair.first.piece, time) - positionAt(pair.second.piece, time));
    };
    const auto turned = [t](const PartMotion& p, double time) {
        return p.reach *
               (attitudeAt(p.piece, time).coeffs() - attitudeAt(p.piece, t).coeffs()).norm();
    };
    double ago = way / speed;
    while ((relative(t - ago) - relative(t)).norm() > 2 * way ||
           turned(pair.first, t - ago) + turned(pair.second, t - ago) > 2 * way)
        ago /= 4;
    return t - ago;
}

// All axes along which they touch are those of two faces that lie on each other, or all but do.
bool isAlongOneAxis(const PartPair& pair, double t, const Touching& now) {
    return std::ranges::all_of(
        axesOfTouch(now.first, now.second, pair.unnoticedDepth(t)),
        [&](const Separation& axis) { return (axis.normal - now.normal).norm() < sameAxis; });
}

// Where faces land all but flat, the one of them is the normal that an edge or a vertex of the
// other lies on: along the other's own it may lie beside. Flat: that of the first.
Vector normalOfLanding(const Touching& now, double tolerance) {
    const bool isFlat = furthestVertices(now.first, -now.normal, tolerance).size() > 2 &&
                        furthestVertices(now.second, now.normal, tolerance).size() > 2;
    const geometry::Face* face = isFlat ? faceAlong(now.first, -now.normal) : nullptr;
    return face ? Vector(-(now.first.rotation * face->normal)) : now.normal;
}

// Two sharp points, or a point and a sharp edge, that are at one place: the line between them
// before.
Vector normalBefore(const PartPair& pair, double t, const Separation& separation) {
    WarmStart cold;
    const Separation then = pair.separationAt(shortlyBefore(pair, t), cold);
    return then.gap > separation.gap && then.gap > 0 ? then.normal : separation.normal;
}

// Which features touch along several axes is seen a little before: at the contact itself the line
// between closest points is lost. Along one they are those of now: a body that turns while it
// lands was tilted the other way a little before.
Vector normalOfHit(const PartPair& pair, double t, const Separation& separation) {
    if (isCurved(pair))
        return separation.isBlurred ? normalBefore(pair, t, separation) : separation.normal;
    if (isRound(pair)) // known from the sphere's centre (nearest_feature.h)
        return separation.normal;
    const Vector origin = pair.originAt(t);
    const Touching now{pair.first.posedAt(t, origin), pair.second.posedAt(t, origin),
                       separation.normal};
    if (isAlongOneAxis(pair, t, now))
        return normalOfLanding(now, flatLanding * pair.smallerSize());
    Touching before = now;
    const double earlier = shortlyBefore(pair, t);
    WarmStart cold;
    const Separation then = pair.separationAt(earlier, cold);
    const Vector there = pair.originAt(earlier);
    if (then.gap > separation.gap && then.gap > 0)
        before = {pair.first.posedAt(earlier, there), pair.second.posedAt(earlier, there),
                  then.normal};
    return normalOf(before, now, 3 * flatLanding * pair.smallerSize());
}

// The patch's places are from the pair's origin.
Contact contactIn(const PartPair& pair, double t, const Vector& normal, double gap,
                  const Patch& patch) {
    const Vector origin = pair.originAt(t);
    const Velocity va = velocityAt(pair.first.piece, t), vb = velocityAt(pair.second.piece, t);
    const Vector pivotA = positionAt(pair.first.piece, t) - origin;
    Contact contact;
    contact.normal = normal;
    contact.point = patch.centre + origin;
    contact.gap = gap;
    contact.closingSpeed = -HUGE_VAL;
    for (const Vector& corner : patch.corners) {
        contact.patch.push_back(corner + origin);
        contact.closingSpeed = std::max(
            contact.closingSpeed, closingSpeed(va, pivotA, vb, Vector::Zero(), corner, normal));
    }
    return contact;
}

Contact contactAlong(const PartPair& pair, double t, const Vector& normal, double gap) {
    const Vector origin = pair.originAt(t);
    const double tolerance = std::max(flatLanding * pair.smallerSize(), 2 * pair.roundOff(t));
    return contactIn(pair, t, normal, gap,
                     patchOf(pair.first.posedAt(t, origin), pair.second.posedAt(t, origin), normal,
                             tolerance, tolerance));
}

// Of those that are all but the same, the one along which they are farthest apart: along the others
// what touches may not be what is furthest.
std::vector<Separation> axesAt(const PartPair& pair, double t) {
    const Vector origin = pair.originAt(t);
    std::vector<Separation> axes;
    for (const Separation& axis :
         axesOfTouch(pair.first.posedAt(t, origin), pair.second.posedAt(t, origin),
                     pair.unnoticedDepth(t))) {
        const auto same = std::ranges::find_if(axes, [&](const Separation& other) {
            return (axis.normal - other.normal).norm() < sameAxis;
        });
        if (same == axes.end())
            axes.push_back(axis);
        else if (axis.gap > same->gap)
            *same = axis;
    }
    return axes;
}

// Of axes along which edges or vertices touch, the one along which they approach clearly less than
// along each other one. A little aside they would meet along one of the axes, and overlap along
// this one least. Where both have faces across it, one would slide past the other: there is none.
std::optional<Separation> leastApproach(const PartPair& pair, double t) {
    constexpr double clearly = 0.98;
    std::optional<Separation> axis;
    double least = HUGE_VAL, next = HUGE_VAL;
    for (const Separation& other : axesAt(pair, t)) {
        const double speed = contactAlong(pair, t, other.normal, other.gap).closingSpeed;
        if (speed < least)
            axis = other;
        next = std::min(next, std::max(least, speed));
        least = std::min(least, speed);
    }
    if (!axis || !(least < clearly * next))
        return std::nullopt;
    const Vector origin = pair.originAt(t);
    const auto [ofFirst, ofSecond] =
        facingFeatures(pair.first.posedAt(t, origin), pair.second.posedAt(t, origin), axis->normal,
                       flatLanding * pair.smallerSize());
    return ofFirst.size() > 2 && ofSecond.size() > 2 ? std::nullopt : axis;
}

Vector velocityOfPoint(const PartMotion& part, double t, const Vector& point) {
    const Velocity v = velocityAt(part.piece, t);
    return v.linear + v.angular.cross(point - positionAt(part.piece, t));
}

// A sphere at an edge or a vertex passes over it where it does not approach along another axis
// along which they touch, too: the normal of the face beside, or what of the line to the sphere's
// centre is across the way that it goes. Along that one it touches what it goes over or up to
// without a step.
std::vector<Separation> axesBesideRound(const PartPair& pair, double t, const Vector& normal) {
    const bool isFirst = pair.first.part->isSphere();
    const PartMotion& owner = isFirst ? pair.second : pair.first;
    if (owner.part->isSphere())
        return {};
    const Vector origin = pair.originAt(t);
    const Posed posed = owner.posedAt(t, origin);
    const Posed ball = (isFirst ? pair.first : pair.second).posedAt(t, origin);
    const Vector centre = ball.world(0);
    std::vector<Vector> directions; // outward
    double most = -HUGE_VAL;
    for (const geometry::Face& face : owner.part->core.faces)
        if (const double above =
                face.normal.dot(posed.rotation.transpose() * Vector(centre - posed.offset)) -
                face.offset;
            above > most) {
            most = above;
            directions = {posed.rotation * face.normal};
        }
    const Vector outward = isFirst ? normal : Vector(-normal);
    const Vector way = velocityOfPoint(isFirst ? pair.first : pair.second, t, centre + origin) -
                       velocityOfPoint(owner, t, centre + origin);
    if (const double square = way.squaredNorm(); square > 0)
        directions.push_back((outward - way * (outward.dot(way) / square)).normalized());
    std::vector<Separation> axes;
    for (const Vector& n : directions) {
        const double gap = n.dot(centre - posed.world(posed.support(n))) - ball.part->radius;
        if (gap >= -pair.unnoticedDepth(t))
            axes.push_back({.gap = gap, .normal = isFirst ? n : Vector(-n)});
    }
    return axes;
}

// They touch along several axes, and do not approach along each.
bool isPassing(const PartPair& pair, double t, const Contact& contact) {
    if (isCurved(pair))
        return false;
    if (isRound(pair))
        return contact.closingSpeed > pair.leastApproach(t) && passing(pair, t).has_value();
    if (contact.patch.size() > 2)
        return false;
    if (contact.closingSpeed > pair.leastApproach(t))
        return passing(pair, t).has_value();
    return std::ranges::any_of(axesAt(pair, t), [&](const Separation& axis) {
        return (axis.normal - contact.normal).norm() > sameAxis;
    });
}

} // namespace

Contact contactOf(const PartPair& pair, double t, const Separation& separation) {
    if (separation.touch)
        return contactIn(pair, t, separation.normal, separation.gap,
                         {{*separation.touch}, *separation.touch});
    Contact contact = contactAlong(pair, t, normalOfHit(pair, t, separation), separation.gap);
    if (!isCurved(pair) && !isRound(pair) && contact.patch.size() <= 2)
        if (const auto axis = leastApproach(pair, t);
            axis && (axis->normal - contact.normal).norm() > sameAxis)
            return contactAlong(pair, t, axis->normal, axis->gap);
    return contact;
}

std::optional<Contact> passing(const PartPair& pair, double t) {
    if (isCurved(pair))
        return std::nullopt;
    WarmStart cold;
    const std::vector<Separation> axes =
        isRound(pair) ? axesBesideRound(pair, t, pair.separationAt(t, cold).normal)
                      : axesAt(pair, t);
    std::optional<Contact> least;
    for (const Separation& axis : axes) {
        Contact along = contactAlong(pair, t, axis.normal, axis.gap);
        if (!least || along.closingSpeed < least->closingSpeed)
            least = std::move(along);
    }
    if (least && least->closingSpeed > pair.leastApproach(t))
        least.reset();
    return least;
}

std::vector<Contact> contactsAt(const MovingShape& first, const MovingShape& second, double t,
                                double tolerance, Slack slack) {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < first.shape().parts.size(); ++i)
        for (std::size_t j = 0; j < second.shape().parts.size(); ++j) {
            const PartPair pair = partPair(first, i, second, j, t, slack);
            const double apart =
                (positionAt(pair.first.piece, t) - positionAt(pair.second.piece, t)).norm();
            if (pair.areHalfSpaces() ||
                (!pair.hasPlane() && apart > pair.first.reach + pair.second.reach + tolerance))
                continue;
            WarmStart cold;
            const Separation separation = pair.separationAt(t, cold);
            if (std::abs(separation.gap) > tolerance)
                continue;
            if (separation.isInside) { // each ball has a normal of its own
                const Vector origin = pair.originAt(t);
                for (const BallAtWall& ball :
                     ballsAtWall(pair.first.posedAt(t, origin), pair.second.posedAt(t, origin),
                                 tolerance)) {
                    contacts.push_back(contactOf(pair, t, ball.separation));
                    contacts.back().firstPart = i;
                    contacts.back().secondPart = j;
                }
                continue;
            }
            Contact contact = contactOf(pair, t, separation);
            if (isPassing(pair, t, contact))
                continue;
            contacts.push_back(std::move(contact));
            contacts.back().firstPart = i;
            contacts.back().secondPart = j;
        }
    return contacts;
}

} // namespace collision
