#include "events/cluster_impulses.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {

using physics::ImpactBody;
using physics::ImpactContact;

Closing closingAt(const ImpactContact& corner, std::span<const ImpactBody> bodies) {
    const ImpactBody &a = bodies[corner.first], &b = bodies[corner.second];
    const Vector va = a.velocity + a.angularVelocity.cross(corner.point - a.centre);
    const Vector vb = b.velocity + b.angularVelocity.cross(corner.point - b.centre);
    return {.rate = corner.normal.dot(va - vb), .speeds = va.norm() + vb.norm()};
}

bool sinksIn(const ImpactContact& corner, std::span<const ImpactBody> bodies) {
    const Closing closing = closingAt(corner, bodies);
    return closing.rate < -resolution::atRest * closing.speeds;
}

namespace {

// Contacts, of some the corners instead of the centres, and whose each is.
struct Corners {
    std::vector<ImpactContact> contacts;
    std::vector<std::size_t> of;
};

Corners cornersOf(const std::vector<ImpactContact>& contacts,
                  const std::vector<ImpactContact>& corners,
                  const std::vector<std::size_t>& contactOf, bool arePlasticOnly) {
    Corners all;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const bool isMeant = !arePlasticOnly || contacts[c].restitution == 0;
        for (std::size_t i = 0; i < corners.size() && isMeant; ++i)
            if (contactOf[i] == c) {
                all.contacts.push_back(corners[i]);
                all.contacts.back().restitution = contacts[c].restitution;
                all.contacts.back().isPressed = contacts[c].isPressed;
            }
        if (all.contacts.size() == all.of.size())
            all.contacts.push_back(contacts[c]);
        all.of.resize(all.contacts.size(), c);
    }
    return all;
}

// What is held in place can only turn. Where it stands on something that cannot give way, as a cart
// that is led along the floor, that keeps it from turning while a blow lasts: it does not rattle.
void standStill(std::vector<ImpactContact>& contacts, const std::vector<ImpactBody>& bodies) {
    const auto onlyTurns = [](const ImpactBody& body) {
        return body.moves.isZero(0) && !body.inverseInertia.isZero(0);
    };
    const auto isFirm = [](const ImpactBody& body) {
        return body.inverseMass == 0 && body.inverseInertia.isZero(0);
    };
    for (ImpactContact& contact : contacts) {
        const ImpactBody &a = bodies[contact.first], &b = bodies[contact.second];
        const Closing closing = closingAt(contact, bodies);
        const bool isAtRest = std::abs(closing.rate) <= resolution::atRest * closing.speeds;
        if (isAtRest && ((onlyTurns(a) && isFirm(b)) || (isFirm(a) && onlyTurns(b)))) {
            contact.restitution = 0;
            contact.isPressed = true;
        }
    }
}

// The impulses are told by contact, each where those of its corners have the same effect.
physics::ImpactResult resolveByCorners(std::vector<ImpactContact>& contacts, const Corners& corners,
                                       const std::vector<ImpactBody>& before,
                                       std::span<const physics::ImpactRow> joints) {
    physics::ImpactResult result = physics::resolveImpact(before, corners.contacts, joints);
    std::vector<double> sums(contacts.size(), 0);
    std::vector<Vector> moments(contacts.size(), Vector::Zero());
    for (const physics::ImpulseGiven& given : result.impulses) {
        sums[corners.of[given.contact]] += given.impulse;
        moments[corners.of[given.contact]] += given.impulse * corners.contacts[given.contact].point;
    }
    result.impulses.clear();
    for (std::size_t c = 0; c < contacts.size(); ++c)
        if (sums[c] > 0) {
            contacts[c].point = moments[c] / sums[c];
            result.impulses.push_back({c, sums[c]});
        }
    return result;
}

// After the impulses at the centres; what else is touched takes part here, too. Corners are then
// contacts of their own.
void addByCorners(std::vector<ImpactContact>& contacts, const Corners& corners,
                  std::span<const physics::ImpactRow> joints, physics::ImpactResult& result) {
    physics::ImpactResult then = physics::resolveImpact(result.bodies, corners.contacts, joints);
    result.bodies = std::move(then.bodies);
    result.jammed = result.jammed || then.jammed;
    for (const physics::ImpulseGiven& given : then.impulses)
        result.impulses.push_back({contacts.size() + given.contact, given.impulse});
    contacts.insert(contacts.end(), corners.contacts.begin(), corners.contacts.end());
}

} // namespace

void aimAtFastest(ImpactCluster& cluster, std::span<const ImpactBody> bodies) {
    constexpr double together = 0.25; // of the fastest
    for (std::size_t c = 0; c < cluster.contacts.size(); ++c) {
        double fastest = 0;
        std::vector<std::pair<double, Vector>> corners;
        for (std::size_t i = 0; i < cluster.corners.size(); ++i)
            if (cluster.contactOf[i] == c) {
                const double rate = closingAt(cluster.corners[i], bodies).rate;
                corners.emplace_back(rate, cluster.corners[i].point);
                fastest = std::min(fastest, rate);
            }
        std::erase_if(corners,
                      [&](const auto& corner) { return !(corner.first <= together * fastest); });
        const auto all = static_cast<std::size_t>(std::ranges::count(cluster.contactOf, c));
        if (!(fastest < 0) || corners.size() == all)
            continue;
        Vector sum = Vector::Zero();
        for (const auto& [rate, point] : corners)
            sum += point;
        cluster.contacts[c].point = sum / static_cast<double>(corners.size());
    }
}

physics::ImpactResult resolve(ImpactCluster& cluster, const std::vector<ImpactBody>& before) {
    standStill(cluster.contacts, before);
    physics::ImpactResult result = physics::resolveImpact(before, cluster.contacts, cluster.joints);
    bool isSunk = false, isPlastic = false;
    for (std::size_t i = 0; i < cluster.corners.size(); ++i)
        if (sinksIn(cluster.corners[i], result.bodies)) {
            isSunk = true;
            isPlastic = isPlastic || cluster.contacts[cluster.contactOf[i]].restitution == 0;
        }
    if (isPlastic)
        return resolveByCorners(
            cluster.contacts, cornersOf(cluster.contacts, cluster.corners, cluster.contactOf, true),
            before, cluster.joints);
    if (isSunk)
        addByCorners(cluster.contacts,
                     cornersOf(cluster.contacts, cluster.corners, cluster.contactOf, false),
                     cluster.joints, result);
    return result;
}

bool cannotPart(const Instant& instant, const Pair& pair) {
    if (instant.mobility.isFree(pair.first, instant.time) ||
        instant.mobility.isFree(pair.second, instant.time))
        return false;
    const ImpactCluster cluster = clusterAt(instant, pair);
    const auto bodies = bodiesOf(instant, cluster);
    return std::ranges::any_of(cluster.contacts, [&](const physics::ImpactContact& contact) {
        const auto [a, b] = cluster.pairOf(contact);
        return Pair(std::minmax(a, b)) == pair && sinksIn(contact, bodies);
    });
}

} // namespace simulation
