#include "simulation/collision_source.h"

#include "solution/partition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using collision::Hit;
using physics::ImpactBody;
using solution::Event;
using solution::Histories;
using solution::infinity;

constexpr double touchingGap = 1e-10; // of the two bodies' radii: in contact at an impact

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

} // namespace

CollisionSource::CollisionSource(const scene::Scene& scene,
                                 const physics::EquationsOfMotion& equations,
                                 std::vector<geometry::Shape> shapes, double start, double finish,
                                 double restHeight)
    : scene_(scene), equations_(equations), records_(recordsOf(equations)), finish_(finish),
      restHeight_(restHeight), front_(start) {
    for (std::size_t i = 0; i < records_.size(); ++i)
        bodies_.emplace_back(records_[i], std::move(shapes[i]));
    const std::size_t n = records_.size();
    ended_.assign(n, false);
    boxUntil_.assign(n, -infinity);
    boxes_.resize(n);
    partners_.resize(n);
    version_.assign(n, 1);
    const auto indexOf = [&](const std::string& name) {
        const auto body = std::ranges::find(scene.bodies, name, &scene::Body::name);
        return static_cast<std::size_t>(body - scene.bodies.begin());
    };
    for (const scene::Link& link : scene.links)
        if (const auto* second = std::get_if<scene::BodyEnd>(&link.second))
            linked_.insert(std::minmax(indexOf(link.first.body), indexOf(second->body)));
    findDependents();
}

CollisionSource::~CollisionSource() = default;

bool CollisionSource::mayMeet(std::size_t a, std::size_t b) const {
    if (records_[a].isFixed && records_[b].isFixed)
        return false;
    const auto& groupA = scene_.bodies[a].collisionGroup;
    const auto& groupB = scene_.bodies[b].collisionGroup;
    return !(groupA && groupB && *groupA == *groupB) && !linked_.contains(std::minmax(a, b));
}

bool CollisionSource::canGiveWay(std::size_t body, double time) const {
    if (records_[body].isFixed)
        return false;
    return std::ranges::count(equations_.bodies[body].heldAt(time).position, true) == 0;
}

// --- the search -----------------------------------------------------------------------------

std::optional<Event> CollisionSource::next(const Histories& histories, double known) {
    for (MovingBody& body : bodies_)
        body.read(histories);
    const double until = std::min(known, finish_);
    while (true) {
        while (!hits_.empty() && std::get<0>(*hits_.begin()) <= front_) {
            const auto [time, a, b] = *hits_.begin();
            const Hit hit = *found_[{a, b}].hit;
            dropHit({a, b});
            found_[{a, b}].testedUntil = time;
            if (auto event = handle(histories, {a, b}, hit)) {
                forgetAfterEvent(*event);
                return event;
            }
        }
        if (front_ >= until)
            return std::nullopt;
        const double window = std::min(until, front_ + windowLength(histories));
        lookAtWindow(histories, window);
        front_ = hits_.empty() ? window : std::min(window, std::get<0>(*hits_.begin()));
    }
}

// An event cuts the bodies that it touches and all that read them: what was found beyond it for
// them no longer holds.
void CollisionSource::forgetAfterEvent(const Event& event) {
    std::set<std::size_t> cut;
    for (const std::size_t unknown : event.touched) {
        const std::size_t body = bodyOf_[unknown];
        cut.insert(body);
        cut.insert(dependents_[body].begin(), dependents_[body].end());
    }
    for (const std::size_t b : cut) {
        boxUntil_[b] = -infinity;
        ++version_[b];
        for (const std::size_t other : partners_[b]) {
            const Pair pair = std::minmax(b, other);
            const auto found = found_.find(pair);
            if (found != found_.end() && found->second.hit && found->second.hit->time > event.time)
                dropHit(pair);
        }
    }
}

void CollisionSource::findDependents() {
    bodyOf_.resize(equations_.set.unknowns.size());
    for (std::size_t b = 0; b < records_.size(); ++b)
        for (std::size_t i = 0; !records_[b].isFixed && i < physics::bodyUnknowns; ++i)
            bodyOf_[records_[b].firstUnknown + i] = b;
    const auto reads = solution::readsOf(equations_.set, front_);
    std::vector<std::set<std::size_t>> readers(records_.size());
    for (std::size_t i = 0; i < reads.size(); ++i)
        for (const std::size_t read : reads[i])
            readers[bodyOf_[read]].insert(bodyOf_[i]);
    dependents_.resize(records_.size());
    for (std::size_t b = 0; b < records_.size(); ++b) {
        std::vector<std::size_t> open{b};
        while (!open.empty()) {
            const std::size_t next = open.back();
            open.pop_back();
            for (const std::size_t reader : readers[next])
                if (dependents_[b].insert(reader).second)
                    open.push_back(reader);
        }
    }
}

void CollisionSource::lookAtWindow(const Histories& histories, double until) {
    for (std::size_t b = 0; b < records_.size(); ++b) {
        bool stopped = false;
        for (std::size_t i = 0; !records_[b].isFixed && i < physics::bodyUnknowns; ++i)
            if (const auto* stop = histories.stop(records_[b].firstUnknown + i))
                stopped = stopped || stop->time <= until;
        ended_[b] = stopped;
    }
    updateCandidates(until);
    for (std::size_t a = 0; a < partners_.size(); ++a)
        for (const std::size_t b : partners_[a])
            if (a < b && !ended_[a] && !ended_[b])
                testPair({a, b}, until);
}

// Boxes of the bodies whose motion beyond the last box is needed, and whom they overlap now.
void CollisionSource::updateCandidates(double until) {
    std::vector<std::size_t> moved;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        if (boxUntil_[b] >= until)
            continue;
        boxes_[b] = collision::boundsDuring(bodies_[b], front_, until);
        boxUntil_[b] = records_[b].isFixed ? infinity : until;
        moved.push_back(b);
    }
    if (moved.size() * 4 > bodies_.size()) { // most moved: sweep all of them
        for (auto& partners : partners_)
            partners.clear();
        const auto all = collision::candidatePairs(
            boxes_, [this](std::size_t a, std::size_t b) { return mayMeet(a, b); });
        for (const auto& [a, b] : all.pairs) {
            partners_[a].insert(b);
            partners_[b].insert(a);
        }
        return;
    }
    for (const std::size_t b : moved) {
        for (const std::size_t other : partners_[b])
            partners_[other].erase(b);
        partners_[b].clear();
        for (std::size_t other = 0; other < bodies_.size(); ++other)
            if (other != b && boxes_[b].intersects(boxes_[other]) && mayMeet(b, other)) {
                partners_[b].insert(other);
                partners_[other].insert(b);
            }
    }
}

void CollisionSource::testPair(const Pair& pair, double until) {
    const auto passing = passingUntil_.find(pair);
    if (passing != passingUntil_.end() && passing->second > front_)
        return;
    Found& found = found_[pair];
    const std::pair versions{version_[pair.first], version_[pair.second]};
    const bool isNew = std::exchange(found.versions, versions) != versions;
    if (isNew)
        found.testedUntil = front_;
    if (found.hit)
        return;
    const double from = std::max(found.testedUntil, front_);
    if (from >= until && !isNew)
        return;
    ++pairTests_;
    const collision::Encounter encounter =
        collision::timeOfImpact(bodies_[pair.first], bodies_[pair.second], {from, until});
    found.testedUntil = until;
    if (encounter.overlap > 0)
        noteOnce(pair, "Bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
                           quoted(scene_.bodies[pair.second].name) +
                           " overlap without having met; they can collide once they are apart.");
    if (encounter.hit)
        keepHit(pair, found, encounter.hit);
}

void CollisionSource::keepHit(const Pair& pair, Found& found, std::optional<Hit> hit) {
    hits_.insert({hit->time, pair.first, pair.second});
    found.hit = std::move(hit);
}

void CollisionSource::dropHit(const Pair& pair) {
    Found& found = found_[pair];
    hits_.erase({found.hit->time, pair.first, pair.second});
    found.hit.reset();
}

// About the time in which the bodies that move cross their own size.
double CollisionSource::windowLength(const Histories& histories) const {
    double size = 0, speed = 0;
    for (const BodyRecord& body : records_) {
        if (body.isFixed)
            continue;
        size += body.radius;
        speed += stateOf(body, histories, front_).velocity.norm();
    }
    const double span = finish_ - front_;
    return speed > 0 ? std::clamp(4 * size / speed, span / 1000, span) : span;
}

// --- what happens ---------------------------------------------------------------------------

std::optional<Event> CollisionSource::handle(const Histories& histories, const Pair& pair,
                                             const Hit& hit) {
    if (!canGiveWay(pair.first, hit.time) && !canGiveWay(pair.second, hit.time)) {
        noteOnce(pair, "Bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
                           quoted(scene_.bodies[pair.second].name) +
                           " are both held where they meet, so they pass through each other.");
        double until = infinity;
        for (const double time : equations_.breakpoints)
            if (time > hit.time)
                until = std::min(until, time);
        passingUntil_[pair] = until;
        return std::nullopt;
    }
    return hit.pressing ? press(histories, pair, hit) : meet(histories, pair, hit.time);
}

ImpactBody CollisionSource::impactBody(const Histories& histories, std::size_t body,
                                       double time) const {
    const BodyState state = stateOf(records_[body], histories, time);
    ImpactBody impact{.centre = state.position,
                      .velocity = state.velocity,
                      .angularVelocity = state.angularVelocity};
    if (records_[body].isFixed)
        return impact;
    const physics::BodyMotion& motion = equations_.bodies[body];
    const physics::Held& held = motion.heldAt(time);
    // A held place leaves nothing to give way, not even by turning about it. LIMIT: a body that is
    // held along one axis counts as held along all of them in a collision.
    if (!canGiveWay(body, time))
        return impact;
    impact.inverseMass = 1 / motion.mass.mass;
    if (!held.attitude) {
        const geometry::Matrix r = state.attitude.toRotationMatrix();
        impact.inverseInertia = r * motion.mass.inertia.inverse() * r.transpose();
    }
    return impact;
}

void CollisionSource::addContacts(Cluster& cluster, std::size_t a, std::size_t b, double time) {
    const double tolerance = touchingGap * (records_[a].radius + records_[b].radius);
    const auto indexIn = [&](std::size_t body) {
        const auto place = std::ranges::find(cluster.bodies, body);
        const auto index = static_cast<std::size_t>(place - cluster.bodies.begin());
        if (place == cluster.bodies.end())
            cluster.bodies.push_back(body);
        return index;
    };
    for (const collision::Contact& contact :
         collision::contactsAt(bodies_[a], bodies_[b], time, tolerance))
        cluster.contacts.push_back(
            {.first = indexIn(a),
             .second = indexIn(b),
             .point = contact.point,
             .normal = contact.normal,
             .restitution = std::min(scene_.bodies[a].restitution, scene_.bodies[b].restitution)});
}

CollisionSource::Cluster CollisionSource::clusterAt(const Pair& pair, double time) {
    Cluster cluster{.bodies = {pair.first, pair.second}, .contacts = {}};
    std::set<Pair> seen;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (!canGiveWay(body, time))
            continue;
        for (const std::size_t other : partners_[body])
            if (!ended_[other] && seen.insert(std::minmax(body, other)).second) {
                const Pair ordered = std::minmax(body, other);
                addContacts(cluster, ordered.first, ordered.second, time);
            }
    }
    return cluster;
}

// A hop lower than restHeight_ radii is the last: its contact gets a plastic impact.
void CollisionSource::softenLastHops(const Histories& histories, Cluster& cluster,
                                     std::span<const ImpactBody> bodies, double time) const {
    for (physics::ImpactContact& contact : cluster.contacts) {
        if (contact.restitution >= 1)
            continue;
        double approach = 0, push = 0, radius = infinity;
        for (const auto& [index, sign] :
             {std::pair{contact.first, 1.0}, std::pair{contact.second, -1.0}}) {
            const std::size_t body = cluster.bodies[index];
            const Vector arm = contact.point - bodies[index].centre;
            const Vector& w = bodies[index].angularVelocity;
            const Acceleration a = accelerationOf(records_[body], histories, time);
            approach += sign * contact.normal.dot(bodies[index].velocity + w.cross(arm));
            push +=
                sign * contact.normal.dot(a.linear + a.angular.cross(arm) + w.cross(w.cross(arm)));
            if (!records_[body].isFixed)
                radius = std::min(radius, records_[body].radius);
        }
        const double speed = contact.restitution * approach;
        if (approach < 0 && push < 0 && speed * speed / (-2 * push) < restHeight_ * radius)
            contact.restitution = 0;
    }
}

std::optional<Event> CollisionSource::meet(const Histories& histories, const Pair& pair,
                                           double time) {
    Cluster cluster = clusterAt(pair, time);
    std::vector<ImpactBody> before;
    for (const std::size_t body : cluster.bodies)
        before.push_back(impactBody(histories, body, time));
    softenLastHops(histories, cluster, before, time);
    const physics::ImpactResult result = physics::resolveImpact(before, cluster.contacts);
    record(cluster, result, time);
    Event event{.time = time, .touched = {}, .tag = 0};
    jumps_.clear();
    ends_.clear();
    const auto jump = [&](std::size_t body, physics::BodyUnknown first, const Vector& from,
                          const Vector& to) {
        for (int i = 0; i < 3; ++i)
            if (from[i] != to[i]) {
                const std::size_t unknown =
                    equations_.bodies[body].unknown(first) + static_cast<std::size_t>(i);
                jumps_.push_back({unknown, to[i]});
                event.touched.push_back(unknown);
            }
    };
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (records_[body].isFixed)
            continue;
        jump(body, physics::dx, before[i].velocity, result.bodies[i].velocity);
        Vector from = before[i].angularVelocity, to = result.bodies[i].angularVelocity;
        if (from == to)
            continue;
        if (!records_[body].isSpinInWorldAxes) {
            const Quaternion q = stateOf(records_[body], histories, time).attitude.conjugate();
            from = q * from;
            to = q * to;
        }
        jump(body, physics::w1, from, to);
    }
    return event.touched.empty() ? std::nullopt : std::optional(event);
}

std::optional<Event> CollisionSource::press(const Histories& /*histories*/, const Pair& pair,
                                            const Hit& hit) {
    Event event{.time = hit.time, .touched = {}, .tag = 0};
    jumps_.clear();
    ends_.clear();
    for (const std::size_t body : {pair.first, pair.second})
        if (!records_[body].isFixed)
            for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
                event.touched.push_back(records_[body].firstUnknown + i);
    ends_.push_back({event.touched, "bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
                                        quoted(scene_.bodies[pair.second].name) +
                                        " come to rest on each other"});
    return event;
}

void CollisionSource::record(const Cluster& cluster, const physics::ImpactResult& result,
                             double time) {
    for (const physics::ImpulseGiven& given : result.impulses) {
        const physics::ImpactContact& contact = cluster.contacts[given.contact];
        impacts_.push_back({.time = time,
                            .first = cluster.bodies[contact.first],
                            .second = cluster.bodies[contact.second],
                            .point = contact.point,
                            .normal = contact.normal,
                            .impulse = given.impulse});
    }
}

void CollisionSource::noteOnce(const Pair& pair, const std::string& sentence) {
    if (noted_.insert(pair).second)
        notes_.push_back(sentence);
}

void CollisionSource::apply(const Histories& /*histories*/, const Event& /*event*/,
                            expression::EquationSet& /*equations*/, solution::Changes& changes) {
    changes.jumps = jumps_;
    changes.ends = ends_;
}

} // namespace simulation
