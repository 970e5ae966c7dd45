// What happens where bodies meet: the second half of collision_source.h. What touches there, and
// which impulses it gets: impact_clusters.cpp.
#include "events/collision_source.h"

#include "events/quoted.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace simulation {
namespace {

using physics::ImpactBody;
using physics::ImpactContact;
using solution::Event;
using solution::Histories;
using solution::infinity;

// Meetings of one body without end: so many of them within so little of the motion's length.
constexpr std::size_t manyMeetings = 1000;
constexpr double shortWhile = 1e-5;
constexpr double shorterWhile = 1e-9;  // with bodies that give way
constexpr double restlessWhile = 1e-3; // as many changes of what bears
constexpr double restlessPause = 1e-9; // or fewer of them, each so soon after the one before
constexpr std::size_t manyCloseChanges = 30;
constexpr std::size_t manyAtOnce = 200; // at one instant

bool isHeldInPlace(const RestingBodies& resting, std::size_t body, double time) {
    return std::ranges::count(resting.heldOf(body, time).position, true) == 3;
}

} // namespace

bool CollisionSource::givesWay(std::size_t body, double time) const {
    return search_.isFollowed(body) || resting_.canGiveWay(body, time);
}

double CollisionSource::nextPhase(const Pair& pair, double time) const {
    return std::min(resting_.nextPhase(pair.first, time), resting_.nextPhase(pair.second, time));
}

// What is held goes on, whatever stands there.
CollisionSource::Handled CollisionSource::meetEnded(const Histories& histories, const Pair& pair,
                                                    double time) {
    const bool isFirst = !search_.hasEnded(pair.first);
    const std::size_t body = isFirst ? pair.first : pair.second;
    const std::size_t ended = isFirst ? pair.second : pair.first;
    if (!givesWay(body, time)) {
        search_.letPass(pair, nextPhase(pair, time));
        return {};
    }
    char when[40];
    std::snprintf(when, sizeof when, "%.6g", search_.endOf(histories, ended).value_or(time));
    blocked_.push_back({pair, time});
    return {.event = end({body, body}, time,
                         "body " + quoted(scene_.bodies[body].name) + " meets " +
                             quoted(scene_.bodies[ended].name) + ", whose motion stopped at t = " +
                             when + "; what happens then is not known"),
            .isDone = false};
}

CollisionSource::Handled CollisionSource::handle(const Histories& histories,
                                                 const EncounterSearch::Found& hit) {
    const Pair& pair = hit.pair;
    if (search_.hasAnyEnded(pair))
        return meetEnded(histories, pair, hit.time);
    if (!givesWay(pair.first, hit.time) && !givesWay(pair.second, hit.time)) {
        passThrough(pair, hit.time);
        return {};
    }
    if (hit.isLost)
        return {end(pair, hit.time, lost(pair, hit.time))};
    const Alongside alongside = goAlongside(histories, hit);
    if (alongside == Alongside::yes)
        return {};
    if (alongside == Alongside::tooOften)
        return {end(pair, hit.time, leaning(pair.first, pair.second))};
    if (isWithoutEnd(pair.first, pair.second, hit.time) ||
        isWithoutEnd(pair.second, pair.first, hit.time))
        return {endWithoutEnd(histories, pair, hit.time)};
    if (hit.pressing)
        if (auto event = press(histories, pair, hit.time))
            return {std::move(event)};
    if (auto handled = meetInFlight(histories, pair, hit.time))
        return std::move(*handled);
    if (auto event = meet(histories, pair, hit.time))
        return {std::move(event)};
    if (auto event = press(histories, pair, hit.time))
        return {std::move(event)};
    if (cannotPart(histories, pair, hit.time))
        passThrough(pair, hit.time);
    return {};
}

void CollisionSource::passThrough(const Pair& pair, double time) {
    noteOnce(pair, time,
             "Bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
                 quoted(scene_.bodies[pair.second].name) +
                 " are both held where they meet, so they pass through each other.");
    search_.letPass(pair, nextPhase(pair, time));
}

bool CollisionSource::areFreeBalls(const Pair& pair, double time) const {
    const auto isFree = [&](std::size_t body) {
        return search_.isFollowed(body) || resting_.isFree(body, time);
    };
    return bodies_[pair.first].isBall() && bodies_[pair.second].isBall() && isFree(pair.first) &&
           isFree(pair.second);
}

double CollisionSource::restitutionOf(const Pair& pair) const {
    return std::min(scene_.bodies[pair.first].restitution, scene_.bodies[pair.second].restitution);
}

// side_by_side.h. They are slow where the forces on them give such a speed on a way of that depth.
// What loses speed in each hop comes to rest where it is pressed, but for what rounding presses.
CollisionSource::Alongside CollisionSource::goAlongside(const Histories& histories,
                                                        const EncounterSearch::Found& hit) {
    const auto [a, b] = hit.pair;
    const auto *flight = search_.flight(a), *other = search_.flight(b);
    // What flies alike nothing pushes together: it parts for ever.
    if (!areFreeBalls(hit.pair, hit.time) || (flight && other && flight->half == other->half))
        return Alongside::no;
    const Closeness near = closenessOf(histories, hit.pair, hit.time);
    const double least = std::min(limits_[a].depth, limits_[b].depth) * near.radius + near.rounding;
    const double known = search_.depth(hit.pair), square = near.rate * near.rate;
    constexpr double passing = 1e-3; // of the accelerations: what opens the gap where they graze
    const bool isPassing = known == 0 && near.turning > passing * near.accelerations;
    const double floor = RestLimits::leastPush * near.radius;
    const bool isSlow = square < 4 * std::max(near.accelerations, floor) * std::max(known, least);
    if (!hit.pressing && (isPassing || !isSlow))
        return Alongside::no;
    const double weak = std::max(RestLimits::weakPush * near.accelerations, floor);
    const bool isPressed = near.push < -weak;
    if (restitutionOf(hit.pair) < 1 && isPressed)
        return Alongside::no;
    constexpr double low = 1.0 / 16; // of that depth: a hop is none
    if (known > 0 && !hit.pressing && !(square < -2 * near.push * low * least))
        return search_.sideBySide().hop(hit.pair) ? Alongside::no : Alongside::tooOften;
    const SideBySide::Now now{.time = hit.time, .rate = near.rate, .push = -near.push};
    return search_.sideBySide().sink(hit.pair, least, now) ? Alongside::yes : Alongside::tooOften;
}

CollisionSource::Closeness CollisionSource::closenessOf(const Histories& histories,
                                                        const Pair& pair, double time) const {
    const BodyRecord &a = records_[pair.first], &b = records_[pair.second];
    const BodyState one = stateOf(a, histories, time), other = stateOf(b, histories, time);
    const Vector first = accelerationOf(a, histories, time).linear;
    const Vector second = accelerationOf(b, histories, time).linear;
    const Vector normal = (one.position - other.position).normalized();
    const Vector speed = one.velocity - other.velocity;
    const double rate = normal.dot(speed);
    const double turning = (speed - rate * normal).squaredNorm() / (a.radius + b.radius);
    return {.radius = std::min(a.radius, b.radius),
            .rounding = 1e-13 * (one.position.norm() + other.position.norm()),
            .rate = rate,
            .push = normal.dot(first - second) + turning,
            .turning = turning,
            .accelerations = first.norm() + second.norm()};
}

std::string CollisionSource::bodiesQuoted(const Pair& pair) const {
    return "bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
           quoted(scene_.bodies[pair.second].name);
}

std::string CollisionSource::leaning(std::size_t a, std::size_t b) const {
    return bodiesQuoted({a, b}) +
           " come to rest on each other, which is modelled only where one of them is fixed or held";
}

std::string CollisionSource::lost(const Pair& pair, double time) const {
    const bool bothGiveWay =
        resting_.canGiveWay(pair.first, time) && resting_.canGiveWay(pair.second, time);
    return bodiesQuoted(pair) +
           (bothGiveWay ? " go on touching while they turn, which is modelled only where one of "
                          "them is fixed or held and the other is pushed onto it"
                        : " go on touching while they turn, and no force presses them together; "
                          "the time of their next impact cannot be told. Leave a little room "
                          "between them, or add a force that presses them together");
}

// Why the meetings of one of the two have no end, as far as that shows.
Event CollisionSource::endWithoutEnd(const Histories& histories, const Pair& pair, double time) {
    for (const std::size_t body : {pair.first, pair.second})
        for (const std::size_t other : search_.partners(body))
            if (resting_.canGiveWay(body, time) && resting_.canGiveWay(other, time) &&
                !touchesOf(resting_.placed(histories, body, time),
                           resting_.placed(histories, other, time), limits_[body].gap)
                     .empty())
                return end(std::minmax(body, other), time, leaning(body, other));
    const bool isBetweenSeveral =
        meetings_[pair.first].isWithSeveral || meetings_[pair.second].isWithSeveral;
    return end(pair, time,
               bodiesQuoted(pair) + " meet again and again in ever shorter time; " +
                   (isBetweenSeveral ? "leave more room between them"
                                     : "they meet no other body in between, and their motion in "
                                       "contact is not modelled"));
}

// With itself: its rest changes.
bool CollisionSource::isWithoutEnd(std::size_t body, std::size_t other, double time) {
    if (!givesWay(body, time))
        return false;
    Meetings& met = meetings_[body];
    if (other == body)
        met.add(met.partner, false, time);
    else // who only turns does not turn back
        met.add(other, givesWay(other, time) && !isHeldInPlace(resting_, other, time), time);
    if (met.count % manyMeetings == 0) {
        const double since = std::exchange(met.markedAt, time);
        const double least = std::exchange(met.isGivenWay, false) ? shorterWhile : shortWhile;
        if (time - since < least * (time - start_))
            return true;
        met.isWithSeveral = false;
    }
    return met.atOnce > manyAtOnce;
}

bool CollisionSource::isRestless(std::size_t body, double time) {
    Meetings& changes = changes_[body];
    const bool isClose = time - changes.last < restlessPause * (time - start_);
    changes.atOnce = isClose ? changes.atOnce + 1 : 0;
    changes.last = time;
    if (changes.atOnce > manyCloseChanges)
        return true;
    if (++changes.count % manyMeetings != 0)
        return false;
    return time - std::exchange(changes.markedAt, time) < restlessWhile * (time - start_);
}

Event CollisionSource::end(const Pair& pair, double time, const std::string& sentence) {
    outcome_ = {};
    outcome_.ends.push_back({unknownsOf(pair, time), sentence});
    for (const std::size_t body : {pair.first, pair.second})
        if (resting_.canGiveWay(body, time)) // nothing changes any more in how it bears
            resting_.forget(body);
    return {.time = time, .touched = outcome_.ends[0].unknowns, .tag = 0};
}

// Of those of the two that can give way.
std::vector<std::size_t> CollisionSource::unknownsOf(const Pair& pair, double time) const {
    std::vector<std::size_t> unknowns;
    for (const std::size_t body : std::set<std::size_t>{pair.first, pair.second})
        if (resting_.canGiveWay(body, time))
            for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
                unknowns.push_back(records_[body].firstUnknown + i);
    return unknowns;
}

std::optional<Event> CollisionSource::meet(const Histories& histories, const Pair& pair,
                                           double time) {
    Cluster cluster = clusterAt(histories, pair, time);
    std::vector<ImpactBody> before;
    for (const std::size_t body : cluster.bodies)
        before.push_back(impactBody(histories, body, time));
    aimAtFastest(cluster, before);
    const double settling = softenLastHops(histories, cluster, before, time);
    pressTogether(histories, cluster, before, time);
    const physics::ImpactResult result = resolve(cluster, before);
    if (result.jammed)
        noteJam(cluster, result, time);
    record(cluster, result, time, settling);
    Event event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    RestingBodies::States after;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (records_[body].isFixed)
            continue;
        after[body] = resting_.bearingState(histories, body, time);
        after[body].velocity = result.bodies[i].velocity;
        after[body].angularVelocity = result.bodies[i].angularVelocity;
        if (before[i].velocity != result.bodies[i].velocity ||
            before[i].angularVelocity != result.bodies[i].angularVelocity)
            jump(body, stateOf(records_[body], histories, time), after[body], event);
    }
    if (event.touched.empty())
        return std::nullopt;
    const bool isPlastic = std::ranges::any_of(cluster.contacts, [](const auto& contact) {
        return contact.restitution == 0 && !contact.isPressed;
    });
    for (const auto& [body, state] : after)
        if (resting_.canGiveWay(body, time) && (isPlastic || resting_.isResting(body)))
            settle(histories, body, time, after, event);
    return event;
}

// Of the body's unknowns those that are not the same; of the attitude all or none, since what was
// solved is of length 1 only to its error.
void CollisionSource::jump(std::size_t body, const BodyState& from, const BodyState& to,
                           Event& event) {
    const physics::BodyMotion& motion = equations_.bodies[body];
    const auto first =
        motion.unknownsOf({from.position, from.velocity, from.attitude, from.angularVelocity});
    const auto then =
        motion.unknownsOf({to.position, to.velocity, to.attitude, to.angularVelocity});
    const bool turns = !std::equal(first.begin() + physics::qw, first.begin() + physics::w1,
                                   then.begin() + physics::qw);
    for (std::size_t k = 0; k < physics::bodyUnknowns; ++k)
        if (k >= physics::qw && k < physics::w1 ? turns : first[k] != then[k]) {
            outcome_.jumps.push_back({records_[body].firstUnknown + k, then[k]});
            event.touched.push_back(records_[body].firstUnknown + k);
        }
}

// Whatever the body touches now and does not part from, it rests on.
void CollisionSource::settle(const Histories& histories, std::size_t body, double time,
                             const RestingBodies::States& states, Event& event) {
    const Rest rest = resting_.restAt(histories, body, time, search_.partners(body), states);
    const auto refuse = [&](std::size_t partner, const std::string& sentence) {
        for (const std::size_t unknown : unknownsOf({body, partner}, time))
            event.touched.push_back(unknown);
        outcome_.ends.push_back({unknownsOf({body, partner}, time), sentence});
        resting_.forget(body);
        resting_.forget(partner);
    };
    if (rest.state == Rest::State::unmodelled)
        return refuse(rest.partner, rest.sentence);
    if (!rest.footings.empty() && joints_.isJoined(body))
        return refuse(rest.footings[0].support,
                      "body " + quoted(scene_.bodies[body].name) +
                          ", which a joint holds, comes to "
                          "rest on body " +
                          quoted(scene_.bodies[rest.footings[0].support].name) +
                          ", which is not computed yet");
    const bool isNothingNew = rest.footings.empty() && !resting_.isResting(body);
    if (isNothingNew || rest.state == Rest::State::approaching)
        return;
    for (const Footing& footing : rest.footings)
        noteUnturned(footing.support, time);
    resting_.set(body, time, rest);
    const auto state = states.find(body);
    outcome_.rests.push_back(
        {body, state != states.end() ? state->second : stateOf(records_[body], histories, time),
         rest});
    for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
        event.touched.push_back(records_[body].firstUnknown + i);
}

// Pushed together without approaching.
std::optional<Event> CollisionSource::press(const Histories& histories, const Pair& pair,
                                            double time) {
    Event event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    for (const std::size_t body : {pair.first, pair.second})
        if (resting_.canGiveWay(body, time) && outcome_.ends.empty())
            settle(histories, body, time, {}, event);
    return event.touched.empty() ? std::nullopt : std::optional(event);
}

// What a body rests on is no longer what it was.
Event CollisionSource::stir(const Histories& histories, std::size_t body, double time) {
    Event event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    const Rest rest = resting_.restAt(histories, body, time, search_.partners(body));
    if (isWithoutEnd(body, body, time))
        return end({body, body}, time,
                   "body " + quoted(scene_.bodies[body].name) +
                       " comes to rest and opens again and again in ever shorter time");
    if (isRestless(body, time))
        return end({body, body}, time,
                   "body " + quoted(scene_.bodies[body].name) +
                       " lifts off its support and comes back again and again within next to no "
                       "time: no position is found in which it rests there; turn or move it a "
                       "little, or hold it there (constrain, link)");
    if (rest.state == Rest::State::approaching)
        if (auto met = meet(histories, std::minmax(body, rest.partner), time))
            return *met;
    settle(histories, body, time, leaving(histories, body, time, rest), event);
    return event;
}

// A ball that lets go has no speed along the normals of what bore it, but for what the integration
// errs in it; with that it might hit what it leaves.
RestingBodies::States CollisionSource::leaving(const Histories& histories, std::size_t body,
                                               double time, const Rest& rest) const {
    if (!rest.footings.empty() || !bodies_[body].isBall())
        return {};
    const BodyState now = stateOf(records_[body], histories, time);
    const BodyState bearing = resting_.bearingState(histories, body, time);
    const double radius = records_[body].radius;
    const double change = (bearing.velocity - now.velocity).norm() +
                          (bearing.angularVelocity - now.angularVelocity).norm() * radius;
    const double speed = now.velocity.norm() + now.angularVelocity.norm() * radius;
    if (change > limits_[body].gap * speed)
        return {};
    return {{body, bearing}};
}

void CollisionSource::record(const Cluster& cluster, const physics::ImpactResult& result,
                             double time, double settling) {
    for (const physics::ImpulseGiven& given : result.impulses) {
        const physics::ImpactContact& contact = cluster.contacts[given.contact];
        const std::size_t first = cluster.bodies[contact.first];
        const std::size_t second = cluster.bodies[contact.second];
        noteUnturned(first, time);
        noteUnturned(second, time);
        Impact impact{.time = time,
                      .first = first,
                      .second = second,
                      .point = contact.point,
                      .normal = contact.normal,
                      .impulse = given.impulse};
        // The last of the hops stands for all that would have followed, at the time of their end.
        if (settling > 0 && contact.restitution == 0) {
            const double e =
                std::min(scene_.bodies[first].restitution, scene_.bodies[second].restitution);
            impact.time = time + settling;
            impact.impulse *= (1 + e) / (1 - e);
        }
        impacts_.add(impact, time);
    }
}

// Told of the body that was hit last: it is between others.
void CollisionSource::noteJam(const Cluster& cluster, const physics::ImpactResult& result,
                              double time) {
    std::map<std::size_t, std::set<std::size_t>> met; // by body that can give way
    for (const physics::ImpulseGiven& given : result.impulses) {
        const physics::ImpactContact& contact = cluster.contacts[given.contact];
        const std::size_t a = cluster.bodies[contact.first], b = cluster.bodies[contact.second];
        for (const auto& [body, other] : {std::pair(a, b), std::pair(b, a)})
            if (resting_.canGiveWay(body, time))
                met[body].insert(other);
    }
    const auto most =
        std::ranges::max_element(met, {}, [](const auto& entry) { return entry.second.size(); });
    if (most == met.end())
        return;
    std::string others;
    for (const std::size_t other : most->second)
        others += (others.empty() ? "" : " and ") + quoted(scene_.bodies[other].name);
    noteOnce({most->first, most->first}, time,
             "Body " + quoted(scene_.bodies[most->first].name) + " has no room between " + others +
                 ": it would bounce between them without end at one instant, and loses its speed "
                 "there.");
}

// What would turn if its hold were a hinge.
void CollisionSource::noteUnturned(std::size_t body, double time) {
    if (!records_[body].isFixed && resting_.turnsFreely(body, time) &&
        resting_.heldOf(body, time).attitude)
        noteOnce({body, body}, time,
                 "Body " + quoted(scene_.bodies[body].name) +
                     " is held at a place beside its centre of mass, which makes no hinge: what "
                     "hits it or rests on it does not turn it. A stiff link makes a hinge.");
}

void CollisionSource::noteOnce(const Pair& pair, double time, const std::string& sentence) {
    if (noted_.insert(pair).second)
        notes_.push_back({time, sentence});
}

void CollisionSource::apply(const Histories& histories, const Event& event,
                            solution::EquationsInForce& equations, solution::Changes& changes) {
    changes.jumps = outcome_.jumps;
    changes.ends = outcome_.ends;
    for (const Outcome::Resting& resting : outcome_.rests)
        resting_.write(histories, resting.body, event.time, resting.state, resting.rest,
                       equations.changing(), changes);
}

} // namespace simulation
