#include "events/impact_cluster.h"

#include "collision/contact.h"
#include "contacts/contact_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace simulation {
namespace {

using solution::infinity;

double ballRadius(const MovingBody& body) {
    return body.isBall() ? body.shape().parts[0].radius : 0;
}

struct NearCorner { // that bears, or lands on what bears it already
    Vector point, normal;
    double gap = 0;
    bool bears = false;
};

// Of a body that gives way and its support.
std::vector<NearCorner> cornersNear(const Instant& at, const Pair& pair) {
    const auto& [body, support] = pair;
    const double gap = at.world.resolution[body].gap;
    const double speed = at.speedOf(pair), tolerance = at.contactTolerance(pair);
    std::vector<NearCorner> corners;
    for (const Touch& touch : touchesOf(at.placed(body), at.placed(support), 2 * gap))
        for (const Corner& corner : touch.corners)
            corners.push_back({.point = corner.point,
                               .normal = touch.normal,
                               .gap = corner.gap,
                               .bears = std::abs(corner.gap) <= tolerance &&
                                        std::abs(corner.rate) <= gap * speed});
    return corners;
}

// Contact points that hit at this instant. A point that is near and approaches hits
// by itself a little later: that is another motion. Points as near as that which hits, such as both
// ends of an edge that lands, hit with it. One that has sunk in by an error of the integration
// counts.
std::vector<NearCorner> cornersAt(const Instant& at, const Pair& pair) {
    const double tolerance = at.contactTolerance(pair);
    std::vector<NearCorner> corners = cornersNear(at, pair);
    double nearest = infinity; // of what hits
    bool isAnyTouching = false;
    for (const NearCorner& corner : corners)
        if (std::abs(corner.gap) <= tolerance)
            isAnyTouching = true;
        else
            nearest = std::min(nearest, corner.gap);
    const bool isReached = nearest <= 2 * tolerance || !isAnyTouching;
    const double farthest = isReached ? std::max(tolerance, nearest + tolerance) : tolerance;
    std::erase_if(corners, [&](const NearCorner& corner) { return corner.gap > farthest; });
    return corners;
}

class Gathering { // of contacts of one pair
public:
    Gathering(const Instant& at, const Pair& pair, ImpactCluster& cluster,
              const std::optional<MotionPlane>& plane)
        : at_(at), a_(pair.first), b_(pair.second), cluster_(cluster),
          friction_(at.world.frictionOf(a_, b_)) {
        const ContactSet& lasting = at.contacts;
        if (friction_.sliding > 0 || (at.canGiveWay(a_) && at.canGiveWay(b_)) || lasting.isIn(a_) ||
            lasting.isIn(b_))
            arePoints_ = true;
        if (arePoints_)
            plane_ = plane;
        if (!friction_.bodySurface.isZero(0) || !friction_.supportSurface.isZero(0))
            surface_ = at.stateOf(a_).attitude * friction_.bodySurface -
                       at.stateOf(b_).attitude * friction_.supportSurface;
    }

    // isHit: the search found that these two hit each other.
    void add(bool isHit) {
        const auto contacts =
            collision::contactsAt(at_.world.moving[a_], at_.world.moving[b_], at_.time,
                                  toleranceOf(isHit), at_.mobility.slack(a_, b_, at_.time));
        // Each corner counts if gaps have errors of the integration, which are more than rounding.
        const bool isUnsure = contacts.empty() && isHit && !at_.contacts.areIn(a_, b_);
        if (isUnsure && freedom(a_) != freedom(b_))
            return addCorners();
        const ContactSet& lasting = at_.contacts;
        if (arePoints_ && (!contacts.empty() || lasting.areIn(a_, b_)))
            findPoints();
        if (lasting.areIn(a_, b_))
            addLasting(lasting);
        for (const collision::Contact& contact : contacts)
            if (!lasting.areIn(a_, contact.firstPart, b_, contact.secondPart))
                addPatch(contact);
    }

private:
    // The end of a step moves balls on joints onto these, and deeper into each other than they
    // were: those that hit or go side by side touch however deep.
    [[nodiscard]] double toleranceOf(bool isHit) const {
        const double tolerance = at_.contactTolerance({a_, b_});
        const double known = at_.search.depth({a_, b_});
        if (!at_.areFreeBalls({a_, b_}) || !(isHit || known > 0))
            return tolerance;
        return tolerance + std::max(0.0, -at_.search.gapOfBalls({a_, b_}, at_.time) - known);
    }
    // How freely it moves; the freer one may rest on the other.
    [[nodiscard]] int freedom(std::size_t body) const {
        return at_.mobility.isFree(body, at_.time) ? 2 : at_.canGiveWay(body) ? 1 : 0;
    }
    std::size_t indexOf(std::size_t body) {
        const auto place = std::ranges::find(cluster_.bodies, body);
        const auto index = static_cast<std::size_t>(place - cluster_.bodies.begin());
        if (place == cluster_.bodies.end())
            cluster_.bodies.push_back(body);
        return index;
    }
    void add(const Vector& point, const Vector& normal, const std::array<double, 2>& radii) {
        cluster_.radii.push_back(radii);
        cluster_.contacts.push_back({.first = indexOf(a_),
                                     .second = indexOf(b_),
                                     .point = point,
                                     .normal = normal,
                                     .restitution = at_.world.restitutionOf({a_, b_}),
                                     .isBeside = at_.search.depth({a_, b_}) > 0,
                                     .friction = friction_.sliding,
                                     .surface = surface_});
    }
    // As rows have them, which then hold what the blow leaves.
    void findPoints() {
        const auto [body, support] = at_.world.bodyAndSupport({a_, b_});
        points_ = pointsInTouch(at_.placed(body), at_.placed(support), landing, plane_);
        if (body == a_)
            return;
        for (PointInTouch& point : points_) {
            std::swap(point.bodyPart, point.supportPart);
            point.normal = -point.normal;
        }
    }
    // Of parts in a contact that lasts each corner that touches: those of the contact, and others
    // that land.
    void addLasting(const ContactSet& lasting) {
        std::optional<std::size_t> last;
        for (const PointInTouch& point : points_)
            if (lasting.areIn(a_, point.bodyPart, b_, point.supportPart)) {
                if (last != point.patch)
                    ++cluster_.patches;
                last = point.patch;
                add(point.point, flat(point.normal),
                    {at_.world.moving[a_].shape().parts[point.bodyPart].radius,
                     at_.world.moving[b_].shape().parts[point.supportPart].radius});
                cluster_.contacts.back().patch = cluster_.patches;
            }
    }
    void addCorners() {
        const bool isFirst = freedom(a_) > freedom(b_);
        const Pair ordered = isFirst ? Pair{a_, b_} : Pair{b_, a_};
        for (const NearCorner& corner : cornersAt(at_, ordered)) {
            add(corner.point, isFirst ? corner.normal : Vector(-corner.normal),
                {ballRadius(at_.world.moving[a_]), ballRadius(at_.world.moving[b_])});
            cluster_.contacts.back().isResting = corner.bears;
        }
    }
    void addPatch(const collision::Contact& contact) {
        add(contact.point, contact.normal,
            {at_.world.moving[a_].shape().parts[contact.firstPart].radius,
             at_.world.moving[b_].shape().parts[contact.secondPart].radius});
        const double size = at_.world.smallerRadius({a_, b_});
        const std::vector<Vector> corners = inPlane(contact.patch, plane_, size);
        if (corners.size() < contact.patch.size()) {
            cluster_.contacts.back().normal = flat(contact.normal);
            cluster_.contacts.back().point[plane_->axis] = plane_->at;
        }
        if (contact.patch.size() == 1)
            return asRow(contact, size, cluster_.contacts.back());
        ++cluster_.patches;
        for (const Vector& corner : corners) {
            cluster_.corners.push_back(cluster_.contacts.back());
            cluster_.corners.back().point = corner;
            cluster_.corners.back().patch = cluster_.patches;
            asRow(contact, size, cluster_.corners.back());
            cluster_.contactOf.push_back(cluster_.contacts.size() - 1);
        }
    }
    void asRow(const collision::Contact& contact, double size,
               physics::ImpactContact& corner) const {
        constexpr double same = 1e-6;
        for (const PointInTouch& point : points_)
            if (point.bodyPart == contact.firstPart && point.supportPart == contact.secondPart &&
                (point.point - corner.point).norm() <= same * size &&
                isOneNormal(point.normal, corner.normal)) {
                corner.point = point.point;
                corner.normal = flat(point.normal);
                return;
            }
    }

    // Without what is rounding beside the plane of motion.
    [[nodiscard]] Vector flat(Vector normal) const {
        if (plane_ && std::abs(normal[plane_->axis]) <= landing) {
            normal[plane_->axis] = 0;
            normal.normalize();
        }
        return normal;
    }

    const Instant& at_;
    std::size_t a_, b_;
    ImpactCluster& cluster_;
    bool arePoints_ = false;           // their contacts last as rows
    std::vector<PointInTouch> points_; // then
    std::optional<MotionPlane> plane_;
    physics::ContactFriction friction_;
    Vector surface_ = Vector::Zero();
};

} // namespace

namespace {

ImpactCluster gathered(const Instant& instant, const Pair& hit,
                       const std::optional<MotionPlane>& plane) {
    ImpactCluster cluster;
    cluster.bodies = {hit.first, hit.second};
    cluster.plane = plane;
    std::set<Pair> seen;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (!instant.canGiveWay(body))
            continue;
        for (const std::size_t other : instant.search.partners(body))
            if (const Pair pair = std::minmax(body, other);
                !instant.search.hasEnded(other) && seen.insert(pair).second)
                Gathering(instant, pair, cluster, plane).add(pair == hit);
        for (const std::size_t joined : instant.world.joints.neighbours(body))
            if (std::ranges::find(cluster.bodies, joined) == cluster.bodies.end())
                cluster.bodies.push_back(joined);
    }
    return cluster;
}

} // namespace

// Points are in a plane where all bodies move in it.
ImpactCluster clusterAt(const Instant& instant, const Pair& hit) {
    const auto plane = instant.planeOf(std::array{hit.first, hit.second});
    ImpactCluster cluster = gathered(instant, hit, plane);
    if (const auto ofAll = plane ? instant.planeOf(cluster.bodies) : plane; ofAll != plane)
        cluster = gathered(instant, hit, ofAll);
    using State = physics::JointRows::State;
    const auto valueOf = [&](std::size_t unknown) {
        return instant.histories.value(unknown, instant.time);
    };
    const physics::JointRows::Motion motion{
        .stateOf =
            [&](std::size_t body) {
                const BodyState state = instant.stateOf(body);
                return physics::BodyValues{state.position, state.velocity, state.attitude,
                                           state.angularVelocity};
            },
        .valueOf = valueOf,
        .multiplierOf =
            [&](std::size_t multiplier) {
                const double mode = valueOf(multiplier);
                return mode == solution::releasedMode ? State::gone
                       : mode == solution::heldMode   ? State::held
                                                      : State::open;
            }};
    cluster.joints = instant.world.joints.rowsAt(cluster.bodies, instant.time, motion);
    return cluster;
}

std::vector<physics::ImpactBody> bodiesOf(const Instant& instant, const ImpactCluster& cluster) {
    std::vector<physics::ImpactBody> bodies;
    for (const std::size_t body : cluster.bodies)
        bodies.push_back(instant.impactBody(body));
    return bodies;
}

bool touch(const Instant& instant, const Pair& pair) {
    ImpactCluster cluster;
    Gathering(instant, pair, cluster, instant.planeOf(std::array{pair.first, pair.second}))
        .add(true);
    return !cluster.contacts.empty();
}

} // namespace simulation
