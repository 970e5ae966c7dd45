// What touches at one instant, and which impulses it gets.
#include "events/collision_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace simulation {
namespace {

using physics::ImpactBody;
using physics::ImpactContact;
using solution::Histories;
using solution::infinity;

struct Closing {
    double rate = 0; // of the gap; negative: they approach
    double speeds = 0;
};

Closing closingAt(const ImpactContact& corner, const std::vector<ImpactBody>& bodies) {
    const ImpactBody &a = bodies[corner.first], &b = bodies[corner.second];
    const Vector va = a.velocity + a.angularVelocity.cross(corner.point - a.centre);
    const Vector vb = b.velocity + b.angularVelocity.cross(corner.point - b.centre);
    return {.rate = corner.normal.dot(va - vb), .speeds = va.norm() + vb.norm()};
}

bool sinksIn(const ImpactContact& corner, const std::vector<ImpactBody>& bodies) {
    const Closing closing = closingAt(corner, bodies);
    return closing.rate < -1e-9 * closing.speeds;
}

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
        const bool isAtRest = std::abs(closing.rate) <= 1e-9 * closing.speeds;
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

double ballRadius(const MovingBody& body) {
    return body.isBall() ? body.shape().parts[0].radius : 0;
}

} // namespace

ImpactBody CollisionSource::impactBody(const Histories& histories, std::size_t body,
                                       double time) const {
    BodyState state = resting_.bearingState(histories, body, time);
    if (bodies_[body].isBall() && !state.angularVelocity.allFinite())
        state.angularVelocity.setZero(); // its blows go through its centre
    return resting_.impactBody(body, time, state);
}

// The speeds that enter.
double CollisionSource::speedOf(const Pair& pair, double time) const {
    double speed = 0;
    for (const std::size_t body : {pair.first, pair.second}) {
        if (const collision::BallFlight* flight = search_.flight(body)) {
            speed += flight->velocityAt(time).norm();
        } else if (!records_[body].isFixed) {
            const auto velocity = collision::velocityAt(bodies_[body].pieceAt(time), time);
            speed += velocity.linear.norm() + velocity.angular.norm() * records_[body].radius;
        }
    }
    return speed;
}

double CollisionSource::contactTolerance(const Pair& pair, double time) const {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    double reach = 0, coordinates = 0;
    for (const std::size_t body : {pair.first, pair.second}) {
        reach += records_[body].radius;
        if (const collision::BallFlight* flight = search_.flight(body))
            coordinates += flight->centreAt(time).cwiseAbs().maxCoeff();
        else if (records_[body].isFixed)
            coordinates += records_[body].start.position.cwiseAbs().maxCoeff();
        else
            coordinates +=
                collision::positionAt(bodies_[body].pieceAt(time), time).cwiseAbs().maxCoeff();
    }
    const double depth = search_.depth(pair);
    return (depth > 0 ? depth : collision::touchingGap * reach) +
           8 * epsilon * (coordinates + std::abs(time) * speedOf(pair, time));
}

// Of a body that gives way and its support.
std::vector<CollisionSource::Standing> CollisionSource::cornersNear(const Histories& histories,
                                                                    const Pair& pair, double time,
                                                                    bool isHit) {
    const auto& [body, support] = pair;
    const BodyState solved = stateOf(records_[body], histories, time);
    const BodyState bearing = resting_.bearingState(histories, body, time);
    const double speed = speedOf(pair, time), tolerance = contactTolerance(pair, time);
    std::vector<Standing> corners;
    for (const Touch& touch :
         touchesOf(resting_.placed(histories, body, time, {{body, bearing}}),
                   resting_.placed(histories, support, time), 2 * limits_[body].gap))
        for (const Corner& corner : touch.corners) {
            if (!isHit && touch.passes(collision::approachThreshold * speed))
                continue;
            const Vector arm =
                bearing.attitude.conjugate() * Vector(corner.point - bearing.position);
            const Vector there = solved.position + solved.attitude * arm;
            corners.push_back({.point = corner.point,
                               .normal = touch.normal,
                               .gap = corner.gap,
                               .solved = corner.gap + touch.normal.dot(there - corner.point),
                               .bears = std::abs(corner.gap) <= tolerance &&
                                        std::abs(corner.rate) <= limits_[body].gap * speed});
        }
    return corners;
}

// Contact points that are active, or hit at this instant. A point that is near and approaches hits
// by itself a little later: that is another motion. The search found the hit at the solved places;
// other points as near, such as both ends of an edge that lands, are compared with active contacts
// put back to a gap of 0. A point that has sunk in by an error of the integration counts.
std::vector<CollisionSource::Standing>
CollisionSource::cornersAt(const Histories& histories, const Pair& pair, double time, bool isHit) {
    const double tolerance = contactTolerance(pair, time);
    std::vector<Standing> corners = cornersNear(histories, pair, time, isHit);
    double nearest = infinity, level = infinity; // of what hits: as solved, and exactly
    bool isAnyTouching = false;
    for (const Standing& corner : corners)
        if (std::abs(corner.gap) <= tolerance) {
            isAnyTouching = true;
        } else if (corner.solved < nearest) {
            nearest = corner.solved;
            level = corner.gap;
        }
    const bool isReached = nearest <= 2 * tolerance || (isHit && !isAnyTouching);
    const double farthest = isReached ? std::max(tolerance, level + tolerance) : tolerance;
    std::erase_if(corners, [&](const Standing& corner) { return corner.gap > farthest; });
    return corners;
}

void CollisionSource::addContacts(const Histories& histories, Cluster& cluster, std::size_t a,
                                  std::size_t b, double time, bool isHit) {
    const auto indexIn = [&](std::size_t body) {
        const auto place = std::ranges::find(cluster.bodies, body);
        const auto index = static_cast<std::size_t>(place - cluster.bodies.begin());
        if (place == cluster.bodies.end())
            cluster.bodies.push_back(body);
        return index;
    };
    const auto add = [&](const Vector& point, const Vector& normal,
                         const std::array<double, 2>& radii) {
        cluster.radii.push_back(radii);
        cluster.contacts.push_back({.first = indexIn(a),
                                    .second = indexIn(b),
                                    .point = point,
                                    .normal = normal,
                                    .restitution = restitutionOf({a, b}),
                                    .isBeside = search_.depth({a, b}) > 0});
    };
    const double tolerance = contactTolerance({a, b}, time);
    const auto contacts =
        collision::contactsAt(bodies_[a], bodies_[b], time, tolerance, resting_.slack(a, b));
    // A body that rests turns about what it rests on: each corner counts. So it does where gaps
    // have the integration's errors, not rounding's.
    const bool isFooting = resting_.hasFooting(a, b);
    const bool isUnsure = isFooting || (contacts.empty() && isHit);
    // How freely it moves; the freer one may rest on the other.
    const auto freedom = [&](std::size_t body) {
        return resting_.isFree(body, time) ? 2 : resting_.canGiveWay(body, time) ? 1 : 0;
    };
    if (isUnsure && freedom(a) != freedom(b)) {
        const bool isFirst = freedom(a) > freedom(b);
        const Pair ordered = isFirst ? Pair{a, b} : Pair{b, a};
        for (const Standing& corner : cornersAt(histories, ordered, time, isHit)) {
            add(corner.point, isFirst ? corner.normal : Vector(-corner.normal),
                {ballRadius(bodies_[a]), ballRadius(bodies_[b])});
            cluster.contacts.back().isResting = corner.bears;
        }
        return;
    }
    for (const collision::Contact& contact : contacts) {
        add(contact.point, contact.normal,
            {bodies_[a].shape().parts[contact.firstPart].radius,
             bodies_[b].shape().parts[contact.secondPart].radius});
        for (const Vector& corner : contact.patch)
            if (contact.patch.size() > 1) {
                cluster.corners.push_back(cluster.contacts.back());
                cluster.corners.back().point = corner;
                cluster.contactOf.push_back(cluster.contacts.size() - 1);
            }
    }
}

CollisionSource::Cluster CollisionSource::clusterAt(const Histories& histories, const Pair& pair,
                                                    double time) {
    Cluster cluster{.bodies = {pair.first, pair.second},
                    .contacts = {},
                    .radii = {},
                    .corners = {},
                    .contactOf = {},
                    .joints = {}};
    std::set<Pair> seen;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (!resting_.canGiveWay(body, time))
            continue;
        for (const std::size_t other : search_.partners(body))
            if (!search_.hasEnded(other) && seen.insert(std::minmax(body, other)).second) {
                const Pair ordered = std::minmax(body, other);
                addContacts(histories, cluster, ordered.first, ordered.second, time,
                            ordered == pair);
            }
        for (const std::size_t joined : joints_.neighbours(body))
            if (std::ranges::find(cluster.bodies, joined) == cluster.bodies.end())
                cluster.bodies.push_back(joined);
    }
    cluster.joints = joints_.rowsAt(cluster.bodies, time, [&](std::size_t body) {
        const BodyState state = resting_.bearingState(histories, body, time);
        return physics::BodyValues{state.position, state.velocity, state.attitude,
                                   state.angularVelocity};
    });
    return cluster;
}

// As a bar on a held centre that is driven flat against a wall: nothing about it can turn.
bool CollisionSource::cannotPart(const Histories& histories, const Pair& pair, double time) {
    if (resting_.isFree(pair.first, time) || resting_.isFree(pair.second, time))
        return false;
    const Cluster cluster = clusterAt(histories, pair, time);
    std::vector<ImpactBody> bodies;
    for (const std::size_t body : cluster.bodies)
        bodies.push_back(impactBody(histories, body, time));
    return std::ranges::any_of(cluster.contacts, [&](const ImpactContact& contact) {
        const Pair met = std::minmax(cluster.bodies[contact.first], cluster.bodies[contact.second]);
        return met == pair && sinksIn(contact, bodies);
    });
}

// How the gap accelerates: of flat parts as their points that touch, of spheres as their centres.
double CollisionSource::pushAt(const Histories& histories, const Cluster& cluster,
                               const ImpactContact& c, const std::array<double, 2>& radii,
                               std::span<const ImpactBody> bodies, double time) const {
    double push = 0;
    Vector speed = Vector::Zero();
    for (const auto& [index, sign, radius] :
         {std::tuple{c.first, 1.0, radii[0]}, std::tuple{c.second, -1.0, radii[1]}}) {
        const Vector arm = c.point + sign * radius * c.normal - bodies[index].centre;
        const Vector& w = bodies[index].angularVelocity;
        const Acceleration a = accelerationOf(records_[cluster.bodies[index]], histories, time);
        speed += sign * (bodies[index].velocity + w.cross(arm));
        push += sign * c.normal.dot(a.linear + a.angular.cross(arm) + w.cross(w.cross(arm)));
    }
    // Two spheres that pass each other part.
    if (radii[0] > 0 && radii[1] > 0)
        push += (speed - c.normal * c.normal.dot(speed)).squaredNorm() / (radii[0] + radii[1]);
    return push;
}

// A hop lower than the rest height is the last: its contact gets a plastic impact, and all the hops
// that would have followed are over after 2 u / a (1 - e), where u is the first one's speed and a
// what pushes the bodies together.
// Where a patch touches, that holds of all its corners: an edge that rocks hops at its ends, and
// its middle need not approach at all.
double CollisionSource::softenLastHops(const Histories& histories, Cluster& cluster,
                                       std::span<const ImpactBody> bodies, double time) {
    double longest = -1;
    for (std::size_t c = 0; c < cluster.contacts.size(); ++c) {
        const Pair pair(cluster.bodies[cluster.contacts[c].first],
                        cluster.bodies[cluster.contacts[c].second]);
        if (cluster.contacts[c].restitution == 1 && areFreeBalls(pair, time))
            continue; // they hop on (side_by_side.h)
        Hop hop = hopOf(histories, cluster, cluster.contacts[c], cluster.radii[c], bodies, time);
        for (std::size_t i = 0; i < cluster.corners.size(); ++i) {
            if (cluster.contactOf[i] != c)
                continue;
            const Hop other =
                hopOf(histories, cluster, cluster.corners[i], cluster.radii[c], bodies, time);
            hop.approaches = hop.approaches || other.approaches;
            hop.isLow = hop.isLow && other.isLow;
            hop.settling = std::max(hop.settling, other.settling);
            hop.height = std::max(hop.height, other.height);
        }
        if (hop.approaches && hop.isLow) {
            loseHop(pair, time, hop.height);
            longest = std::max(longest, hop.settling);
            cluster.contacts[c].restitution = 0;
        }
    }
    return longest;
}

CollisionSource::Hop CollisionSource::hopOf(const Histories& histories, const Cluster& cluster,
                                            const ImpactContact& contact,
                                            const std::array<double, 2>& radii,
                                            std::span<const ImpactBody> bodies, double time) const {
    const double push = pushAt(histories, cluster, contact, radii, bodies, time);
    double approach = 0, speed = 0, radius = infinity, reach = 0, lowest = infinity;
    for (const auto& [index, sign] :
         {std::pair{contact.first, 1.0}, std::pair{contact.second, -1.0}}) {
        const std::size_t body = cluster.bodies[index];
        const Vector arm = contact.point - bodies[index].centre;
        const Vector velocity = bodies[index].velocity + bodies[index].angularVelocity.cross(arm);
        approach += sign * contact.normal.dot(velocity);
        speed += bodies[index].velocity.norm() + bodies[index].angularVelocity.norm() * arm.norm();
        radius = std::min(radius, records_[body].radius);
        if (!records_[body].isFixed)
            lowest = std::min(lowest, limits_[body].hopHeight);
        reach += records_[body].radius + bodies[index].centre.norm();
    }
    if (contact.isResting || !(approach < -collision::approachThreshold * speed))
        return {};
    // Hops that the search may pass over (time_of_impact.h) are lower still; where a body rests,
    // what sinks in unnoticed would hop again by that much without end.
    const double slack =
        resting_.slack(cluster.bodies[contact.first], cluster.bodies[contact.second]);
    lowest = std::max({lowest * radius, 2e-9 * radius, 2 * slack * radius, 1e-13 * reach});
    const double parting = -contact.restitution * approach;
    Hop hop{.approaches = true, .isLow = push < 0 && parting * parting / (-2 * push) < lowest};
    if (hop.isLow)
        hop.height = parting * parting / (-2 * push);
    if (hop.isLow && contact.restitution < 1)
        hop.settling = 2 * parting / (-push * (1 - contact.restitution));
    return hop;
}

void CollisionSource::loseHop(const Pair& pair, double time, double height) {
    for (const std::size_t body : {pair.first, pair.second})
        if (resting_.canGiveWay(body, time))
            lostHops_.add({.time = time, .height = height, .body = body});
}

// side_by_side.h. Where something hits that comes faster, all is an impact as any other.
void CollisionSource::pressTogether(const Histories& histories, Cluster& cluster,
                                    const std::vector<ImpactBody>& bodies, double time) const {
    constexpr double more = 1.5; // than what the push gives
    std::vector<ImpactContact*> contacts;
    double fastest = 0, ofPush = 0;
    for (std::size_t c = 0; c < cluster.contacts.size(); ++c) {
        ImpactContact& contact = cluster.contacts[c];
        const Pair pair =
            std::minmax(cluster.bodies[contact.first], cluster.bodies[contact.second]);
        const double rate = closingAt(contact, bodies).rate;
        fastest = std::max(fastest, -rate);
        if (!areFreeBalls(pair, time))
            continue;
        contacts.push_back(&contact);
        if (!contact.isBeside)
            continue;
        const double push = -pushAt(histories, cluster, contact, cluster.radii[c], bodies, time);
        ofPush = std::max(ofPush, search_.sideBySide().speedOfPush(
                                      pair, {.time = time, .rate = rate, .push = push}));
    }
    if (!(fastest < more * ofPush))
        return;
    for (ImpactContact* const contact : contacts) {
        contact->restitution = 0;
        contact->isPressed = true;
    }
}

// Of a patch one end of which hits much faster than the other, as where what rattles itself flat
// hits with its ends in turn, the blow is at that end.
void CollisionSource::aimAtFastest(Cluster& cluster, const std::vector<ImpactBody>& bodies) {
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

// A patch gets one impulse at its centre. Where it then sinks in at a corner, corners take part:
// of plastic contacts from the start, since nothing of them parts at one corner because another
// was hit; what was pushed at a face and rests against it does not turn. Of others after the
// impulse at the centre.
physics::ImpactResult CollisionSource::resolve(Cluster& cluster,
                                               const std::vector<ImpactBody>& before) const {
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

} // namespace simulation
