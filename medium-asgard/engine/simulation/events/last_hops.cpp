#include "events/last_hops.h"

#include "collision/contact.h"
#include "contacts/contact_places.h"
#include "events/cluster_impulses.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace simulation {

using physics::ImpactBody;
using physics::ImpactContact;
using solution::infinity;

double hopHeightOf(const Colliders& world, const Pair& pair) {
    double least = infinity;
    for (const std::size_t body : {pair.first, pair.second})
        if (!world.isFixed(body))
            least = std::min(least, world.resolution[body].hopHeight);
    return least;
}

// Hops that the search may pass over (time_of_impact.h) are lower still; where a body rests, what
// sinks in unnoticed would hop again by that much without end.
double lastHopHeight(double hopHeight, double radius, double reach, double slack) {
    return std::max({hopHeight * radius, resolution::leastHop * radius, 2 * slack * radius,
                     resolution::ofMotion * reach});
}

namespace {

struct Hop { // that an impact would lead to
    bool approaches = false, isLow = true;
    double settling = 0; // the time that it and all hops after it take
    double height = 0;
};

// How the gap accelerates: of flat parts as their points that touch, of spheres as their centres.
double pushAt(const Instant& at, const ImpactCluster& cluster, const ImpactContact& c,
              const std::array<double, 2>& radii, std::span<const ImpactBody> bodies) {
    double push = 0;
    Vector speed = Vector::Zero();
    for (const auto& [index, sign, radius] :
         {std::tuple{c.first, 1.0, radii[0]}, std::tuple{c.second, -1.0, radii[1]}}) {
        const Vector arm = c.point + sign * radius * c.normal - bodies[index].centre;
        const Vector& w = bodies[index].angularVelocity;
        const Acceleration a = at.accelerationOf(cluster.bodies[index]);
        speed += sign * (bodies[index].velocity + w.cross(arm));
        push += sign * c.normal.dot(a.linear + a.angular.cross(arm) + w.cross(w.cross(arm)));
    }
    // Two spheres that pass each other part.
    if (radii[0] > 0 && radii[1] > 0)
        push += (speed - c.normal * c.normal.dot(speed)).squaredNorm() / (radii[0] + radii[1]);
    return push;
}

physics::SurfaceMotion motionOf(const Instant& at, std::size_t body, const ImpactBody& before,
                                const Vector& origin) {
    const Placed placed = at.placed(body);
    const Acceleration a = at.accelerationOf(body);
    return {.pose = {placed.state.position - origin, placed.state.attitude.toRotationMatrix()},
            .velocity = before.velocity,
            .spin = before.angularVelocity,
            .acceleration = a.linear,
            .spinRate = a.angular};
}

// The same of the pieces of surfaces that touch there: edges and rims that slide along each other
// bend the gap, too.
std::optional<double> pushOfPieces(const Instant& at, const ImpactCluster& cluster,
                                   const ImpactContact& c, std::span<const ImpactBody> bodies) {
    constexpr double near = 1e-6; // of the parts' size
    const Pair pair = cluster.pairOf(c);
    const auto [body, support] = at.world.bodyAndSupport(pair);
    const bool isFirst = body == pair.first;
    const double size = at.world.smallerRadius(pair);
    const Placed of = at.placed(body);
    for (const PointInTouch& point :
         pointsInTouch(of, at.placed(support), landing, cluster.plane)) {
        const Vector normal = isFirst ? c.normal : Vector(-c.normal);
        if (!point.gap || !((point.point - c.point).norm() <= near * size) ||
            !isOneNormal(point.normal, normal))
            continue;
        const Vector& origin = of.state.position;
        return physics::accelerationOf(
            *point.gap, motionOf(at, body, bodies[isFirst ? c.first : c.second], origin),
            motionOf(at, support, bodies[isFirst ? c.second : c.first], origin));
    }
    return std::nullopt;
}

Hop hopOf(const Instant& at, const ImpactCluster& cluster, const ImpactContact& contact,
          const std::array<double, 2>& radii, std::span<const ImpactBody> bodies) {
    double push = pushAt(at, cluster, contact, radii, bodies);
    double approach = 0, speed = 0, reach = 0;
    for (const auto& [index, sign] :
         {std::pair{contact.first, 1.0}, std::pair{contact.second, -1.0}}) {
        const std::size_t body = cluster.bodies[index];
        const Vector arm = contact.point - bodies[index].centre;
        const Vector velocity = bodies[index].velocity + bodies[index].angularVelocity.cross(arm);
        approach += sign * contact.normal.dot(velocity);
        speed += bodies[index].velocity.norm() + bodies[index].angularVelocity.norm() * arm.norm();
        reach += at.world.records[body].radius + bodies[index].centre.norm();
    }
    if (contact.isResting || !(approach < -collision::approachThreshold * speed))
        return {};
    const double radius = at.world.smallerRadius(cluster.pairOf(contact));
    const double slack =
        at.mobility.slack(cluster.bodies[contact.first], cluster.bodies[contact.second], at.time);
    const double least = hopHeightOf(at.world, cluster.pairOf(contact));
    const double lowest = lastHopHeight(least, radius, reach, slack);
    const double parting = -contact.restitution * approach;
    // However closely they bend around each other there, it may be low.
    constexpr double closely = 10;
    const double most = std::abs(push) + closely * speed * speed / radius;
    if (parting * parting / (2 * most) < lowest)
        push = pushOfPieces(at, cluster, contact, bodies).value_or(push);
    Hop hop{.approaches = true, .isLow = push < 0 && parting * parting / (-2 * push) < lowest};
    if (hop.isLow)
        hop.height = parting * parting / (-2 * push);
    if (hop.isLow && contact.restitution < 1)
        hop.settling = 2 * parting / (-push * (1 - contact.restitution));
    return hop;
}

} // namespace

LastHops softenLastHops(const Instant& at, ImpactCluster& cluster,
                        std::span<const ImpactBody> bodies) {
    LastHops last;
    std::vector<std::size_t> low;
    bool isAnyHigh = false;
    for (std::size_t c = 0; c < cluster.contacts.size(); ++c) {
        const Pair pair = cluster.pairOf(cluster.contacts[c]);
        if (cluster.contacts[c].restitution == 1 && at.areFreeBalls(pair)) {
            isAnyHigh = true; // they hop on (side_by_side.h)
            continue;
        }
        Hop hop;
        if (std::ranges::find(cluster.contactOf, c) == cluster.contactOf.end()) // it is a point
            hop = hopOf(at, cluster, cluster.contacts[c], cluster.radii[c], bodies);
        for (std::size_t i = 0; i < cluster.corners.size(); ++i) {
            if (cluster.contactOf[i] != c)
                continue;
            const Hop other = hopOf(at, cluster, cluster.corners[i], cluster.radii[c], bodies);
            hop.approaches = hop.approaches || other.approaches;
            hop.isLow = hop.isLow && other.isLow;
            hop.settling = std::max(hop.settling, other.settling);
            hop.height = std::max(hop.height, other.height);
        }
        isAnyHigh =
            isAnyHigh || (hop.approaches && !hop.isLow && sinksIn(cluster.contacts[c], bodies));
        if (!hop.approaches || !hop.isLow)
            continue;
        low.push_back(c);
        last.settling = std::max(last.settling, hop.settling);
        for (const std::size_t body : {pair.first, pair.second})
            if (at.canGiveWay(body))
                last.lost.push_back({.time = at.time, .height = hop.height, .body = body});
    }
    if (isAnyHigh)
        return {};
    for (const std::size_t c : low)
        cluster.contacts[c].restitution = 0;
    if (!low.empty())
        for (ImpactContact& contact : cluster.contacts)
            if (contact.restitution > 0 && contact.restitution < 1) {
                contact.restitution = 0;
                contact.isPressed = true;
            }
    return last;
}

void pressTogether(const Instant& at, ImpactCluster& cluster, std::span<const ImpactBody> bodies) {
    constexpr double more = 1.5; // than what the push gives
    std::vector<ImpactContact*> contacts;
    double fastest = 0, ofPush = 0;
    for (std::size_t c = 0; c < cluster.contacts.size(); ++c) {
        ImpactContact& contact = cluster.contacts[c];
        const Pair pair =
            std::minmax(cluster.bodies[contact.first], cluster.bodies[contact.second]);
        const double rate = closingAt(contact, bodies).rate;
        fastest = std::max(fastest, -rate);
        if (!at.areFreeBalls(pair))
            continue;
        contacts.push_back(&contact);
        if (!contact.isBeside)
            continue;
        const double push = -pushAt(at, cluster, contact, cluster.radii[c], bodies);
        ofPush = std::max(ofPush, at.search.sideBySide().speedOfPush(
                                      pair, {.time = at.time, .rate = rate, .push = push}));
    }
    if (!(fastest < more * ofPush))
        return;
    for (ImpactContact* const contact : contacts) {
        contact->restitution = 0;
        contact->isPressed = true;
    }
}

} // namespace simulation
