// What happens where bodies meet: the second half of collision_source.h.
#include "events/collision_source.h"
#include "events/crushed.h"

#include "events/cluster_impulses.h"
#include "events/last_hops.h"
#include "events/sentences.h"
#include "events/side_by_side_balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace simulation {

using solution::Event;

namespace {

// Nothing approaches: rates at which a gap does not change are rounding.
bool isStill(const Instant& at, const ImpactCluster& cluster,
             std::span<const physics::ImpactBody> bodies) {
    const auto isNone = [&](const physics::ImpactContact& contact) {
        const double size = at.world.smallerRadius(cluster.pairOf(contact));
        return closingAt(contact, bodies).rate >= -resolution::noRate * size;
    };
    return std::ranges::all_of(cluster.contacts, isNone) &&
           std::ranges::all_of(cluster.corners, isNone);
}

// A body that moves in a plane does so behind a blow in it, too: joints answer a blow with rounding
// beside the plane, which would wake unknowns that are 0.
void keepInPlane(int axis, const physics::ImpactBody& before, double radius, BodyState& after) {
    constexpr double rounding = 1e-12; // of the speeds
    const double most =
        rounding * (before.velocity.norm() + before.angularVelocity.norm() * radius +
                    after.velocity.norm() + after.angularVelocity.norm() * radius);
    const auto keep = [](double& now, double was, double within) {
        if (std::abs(now - was) <= within)
            now = was;
    };
    keep(after.velocity[axis], before.velocity[axis], most);
    for (int other = 0; other < 3 && radius > 0; ++other)
        if (other != axis)
            keep(after.angularVelocity[other], before.angularVelocity[other], most / radius);
}

// Bodies that part slower are pressed back before the search for meetings sees a hop. The whole
// difference of accelerations bounds the part of it that presses, but for turning about a lever.
double lostHopSpeed(const Instant& at, const Pair& pair) {
    const Vector first = at.accelerationOf(pair.first).linear;
    const Vector second = at.accelerationOf(pair.second).linear;
    const double lost = resolution::leastHop * at.world.smallerRadius(pair);
    return std::sqrt(2 * (first - second).norm() * lost);
}

double speedOf(const Placed& body) {
    if (body.record->isFixed)
        return 0;
    return body.state.velocity.norm() + body.state.angularVelocity.norm() * body.record->radius;
}

} // namespace

// A held body goes on, whatever stands there.
CollisionSource::Handled CollisionSource::meetEnded(const Instant& at, const Pair& pair) {
    const bool isFirst = !search_.hasEnded(pair.first);
    const std::size_t body = isFirst ? pair.first : pair.second;
    const std::size_t ended = isFirst ? pair.second : pair.first;
    if (!at.givesWay(body)) {
        search_.letPass(pair, at.nextPhase(pair));
        return {};
    }
    record_.addBlocked(pair, at.time);
    const double stopped = search_.endOf(at.histories, ended).value_or(at.time);
    return {.event = end(at, {body, body}, sentences::meetsEnded(world_, body, ended, stopped)),
            .isDone = false};
}

CollisionSource::Handled CollisionSource::handle(const Histories& histories, const Found& hit) {
    const Instant now = at(histories, hit.time);
    const Pair& pair = hit.pair;
    if (search_.hasAnyEnded(pair))
        return meetEnded(now, pair);
    if (!now.givesWay(pair.first) && !now.givesWay(pair.second)) {
        passThrough(now, pair);
        return {};
    }
    if (const auto sentence = unmodelledOf(now, pair))
        return {end(now, pair, *sentence)};
    if (hit.isLost) { // they touch for long, whether anything presses them together or not
        if (auto event = press(now, pair, false))
            return {std::move(event)};
        const bool bothGiveWay = now.canGiveWay(pair.first) && now.canGiveWay(pair.second);
        return {end(now, pair, sentences::lost(world_, pair, bothGiveWay))};
    }
    const Alongside alongside = goAlongside(now, hit, search_.sideBySide());
    if (alongside == Alongside::yes)
        return {};
    if (alongside == Alongside::tooOften)
        return {end(now, pair, sentences::leaning(world_, pair))};
    if (meetsWithoutEnd(now, pair, counts_))
        return {endWithoutEnd(now, pair)};
    if (hit.pressing) {
        // Blows come first: of what touches at the start, some may approach.
        if (auto event = now.time <= world_.start ? meet(now, pair) : std::nullopt)
            return {std::move(event)};
        if (auto event = press(now, pair, true))
            return {std::move(event)};
    }
    if (auto handled = meetInFlight(now, pair))
        return std::move(*handled);
    if (auto event = meet(now, pair))
        return {std::move(event)};
    if (cannotPart(now, pair)) {
        passThrough(now, pair);
        return {};
    }
    if (auto event = press(now, pair, false))
        return {std::move(event)};
    return {partAnew(now, pair)};
}

// The polynomials of a step err by more than the gap, and bring two together that part by their
// velocities. Steps that begin here part them, too. MeetingCounts bounds how often.
std::optional<Event> CollisionSource::partAnew(const Instant& at, const Pair& pair) {
    const ImpactCluster cluster = clusterAt(at, pair);
    const std::vector<physics::ImpactBody> bodies = bodiesOf(at, cluster);
    bool doPart = false;
    for (const auto* contacts : {&cluster.contacts, &cluster.corners})
        for (const physics::ImpactContact& contact : *contacts) {
            if (Pair(std::minmax(cluster.bodies[contact.first], cluster.bodies[contact.second])) !=
                pair)
                continue;
            const Closing closing = closingAt(contact, bodies);
            if (!(closing.rate > resolution::atRest * closing.speeds))
                return std::nullopt;
            doPart = true;
        }
    if (!doPart)
        return std::nullopt;
    outcome_ = {};
    return Event{.time = at.time, .touched = at.unknownsOf(pair), .tag = 0};
}

std::optional<std::string> CollisionSource::unmodelledOf(const Instant& at,
                                                         const Pair& pair) const {
    if (!world_.isHollow(pair.first) && !world_.isHollow(pair.second))
        return std::nullopt;
    const double tolerance =
        std::min(world_.resolution[pair.first].gap, world_.resolution[pair.second].gap);
    const auto fault = hollowFaultOf(at.placed(pair.first), at.placed(pair.second), tolerance);
    if (!fault)
        return std::nullopt;
    return *fault == HollowFault::wideBall ? sentences::wideBall(world_, pair)
                                           : sentences::closedMouth(world_, pair);
}

std::optional<CollisionSource::Handled> CollisionSource::meetInFlight(const Instant& at,
                                                                      const Pair& pair) {
    auto hit = flights_.meet(at, pair, outcome_);
    if (!hit)
        return std::nullopt;
    if (hit->event)
        return Handled{.event = std::move(hit->event), .isDone = false};
    search_.goOn(pair, at.time);
    return Handled{.event = {}, .isDone = true};
}

void CollisionSource::passThrough(const Instant& at, const Pair& pair) {
    record_.addNote(pair, at.time, sentences::passThrough(world_, pair));
    search_.letPass(pair, at.nextPhase(pair));
}

// Why the meetings of one of the two have no end, as far as that shows.
Event CollisionSource::endWithoutEnd(const Instant& at, const Pair& pair) {
    for (const std::size_t body : {pair.first, pair.second})
        for (const std::size_t other : search_.partners(body))
            if (at.canGiveWay(body) && at.canGiveWay(other) &&
                !touchesOf(at.placed(body), at.placed(other), world_.resolution[body].gap).empty())
                return end(at, std::minmax(body, other), sentences::leaning(world_, {body, other}));
    const bool isBetweenSeveral =
        counts_.isWithSeveral(pair.first) || counts_.isWithSeveral(pair.second);
    return end(at, pair, sentences::withoutEnd(world_, pair, isBetweenSeveral));
}

Event CollisionSource::end(const Instant& at, const Pair& pair, const std::string& sentence) {
    outcome_ = {};
    outcome_.ends.push_back({at.unknownsOf(pair), sentence});
    forget(at, pair);
    return {.time = at.time, .touched = outcome_.ends[0].unknowns, .tag = 0};
}

// Their motion ends, with that of all in contact with them: nothing changes any more in how they
// bear.
void CollisionSource::forget(const Instant& at, const Pair& pair) {
    for (const std::size_t body : contacts_.island({pair.first, pair.second}))
        if (at.canGiveWay(body))
            contacts_.forget(body);
}

std::optional<Event> CollisionSource::meet(const Instant& at, const Pair& pair) {
    ImpactCluster cluster = clusterAt(at, pair);
    const std::vector<physics::ImpactBody> before = bodiesOf(at, cluster);
    if (isStill(at, cluster, before))
        return std::nullopt;
    aimAtFastest(cluster, before);
    const LastHops last = softenLastHops(at, cluster, before);
    for (const LostHop& hop : last.lost)
        record_.addLostHop(hop);
    pressTogether(at, cluster, before);
    const physics::ImpactResult result = resolve(cluster, before);
    const bool isStuck = !result.unyielding.empty() && !cannotPart(at, pair);
    if (isStuck || !result.settled)
        if (auto ended = endUnparted(at, cluster, before, pair, result.settled))
            return ended;
    if (result.jammed)
        noteJam(at, cluster, result);
    keepImpulses(at, cluster, result, last.settling);
    Event event{.time = at.time, .touched = {}, .tag = 0};
    outcome_ = {};
    ChangedStates after;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
        const std::size_t body = cluster.bodies[i];
        if (world_.isFixed(body))
            continue;
        after[body] = at.stateOf(body);
        after[body].velocity = result.bodies[i].velocity;
        after[body].angularVelocity = result.bodies[i].angularVelocity;
        if (cluster.plane)
            keepInPlane(cluster.plane->axis, before[i], world_.records[body].radius, after[body]);
        if (before[i].velocity != after[body].velocity ||
            before[i].angularVelocity != after[body].angularVelocity)
            outcome_.jump(world_.equations.bodies[body], at.stateOf(body), after[body], event);
    }
    if (event.touched.empty())
        return std::nullopt;
    const bool isPlastic = std::ranges::any_of(cluster.contacts, [](const auto& contact) {
        return contact.restitution == 0 && !contact.isPressed;
    });
    std::vector<std::size_t> settling;
    for (const auto& [body, state] : after) {
        const bool mayLeavePlane = !cluster.plane && contacts_.isAnyInPlane(std::array{body});
        if (at.canGiveWay(body) && (isPlastic || contacts_.isIn(body) || mayLeavePlane))
            settling.push_back(body);
    }
    settle(at, settling, after, event, true);
    return event;
}

std::optional<Event> CollisionSource::endUnparted(const Instant& at, const ImpactCluster& cluster,
                                                  std::span<const physics::ImpactBody> before,
                                                  const Pair& pair, bool isSettled) {
    using enum physics::Sides;
    auto crushed = crushedIn(at, cluster, cluster.contacts, before, slip);
    if (!crushed && isSettled)
        return std::nullopt;
    std::vector<physics::ImpactContact> all = cluster.contacts;
    all.insert(all.end(), cluster.corners.begin(), cluster.corners.end());
    for (const physics::Sides sides : {slip, grip}) // a flat blow turns nothing, and its corners do
        if (!crushed)
            crushed = crushedIn(at, cluster, all, before, sides);
    if (!crushed)
        return end(at, pair, sentences::unsolved(world_, pair));
    Event event = end(at, pair, crushed->sentence);
    for (const std::size_t body : crushed->bodies)
        if (body != pair.first && body != pair.second)
            refuse(at, {body, body}, crushed->sentence, event);
    return event;
}

void CollisionSource::refuse(const Instant& at, const Pair& pair, const std::string& sentence,
                             Event& event) {
    const auto unknowns = at.unknownsOf(pair);
    event.touched.insert(event.touched.end(), unknowns.begin(), unknowns.end());
    outcome_.ends.push_back({unknowns, sentence});
    forget(at, pair);
}

std::vector<LastingContact>
CollisionSource::contactsBetween(const Instant& at, const Pair& pair, const ChangedStates& states,
                                 double entering, const std::optional<MotionPlane>& plane,
                                 bool isPressed) const {
    const auto [first, second] = world_.bodyAndSupport(pair);
    const Placed a = at.placed(first, states), b = at.placed(second, states);
    const double hop = isPressed ? lostHopSpeed(at, pair) : 0;
    const TouchLimits limits{
        .gap = std::min(world_.resolution[first].gap, world_.resolution[second].gap),
        .beyond = std::min(world_.resolution[first].beyond, world_.resolution[second].beyond),
        .slow = std::max({resolution::rattled * std::max({entering, speedOf(a), speedOf(b)}),
                          resolution::noRate * world_.smallerRadius(pair), hop}),
        .wereInContact = contacts_.areIn(first, second),
        .isStart = at.time == world_.start,
        .stands = contacts_.standsOf(at.histories, first, second, at.time),
        .plane = plane};
    std::vector<LastingContact> found = lastingContacts(a, b, limits);
    for (LastingContact& contact : found) {
        const double reach = contact.place.friction.reach;
        contact.place.friction = world_.frictionOf(first, second);
        if (!contact.rolls) // edges and vertices do not
            contact.place.friction.rolling = 0;
        contact.place.friction.reach = reach;
        contact.place.hop = hopHeightOf(world_, pair) * world_.smallerRadius(pair);
        contact.isInPlane = plane.has_value();
    }
    return found;
}

// All that hangs together with the body by contacts that last or are to last.
std::vector<std::size_t> CollisionSource::together(std::set<std::size_t> bodies,
                                                   std::span<const LastingContact> found) const {
    for (std::size_t before = 0; before != bodies.size();) {
        bodies = contacts_.island(std::move(bodies));
        before = bodies.size();
        for (const LastingContact& contact : found)
            for (const auto& [one, other] : {std::pair(contact.place.body, contact.place.support),
                                             std::pair(contact.place.support, contact.place.body)})
                if (bodies.contains(one) && !world_.isFixed(other))
                    bodies.insert(other);
    }
    return {bodies.begin(), bodies.end()};
}

// Points are in a plane where all that hangs together moves in it.
std::vector<LastingContact> CollisionSource::contactsOf(const Instant& at,
                                                        std::span<const std::size_t> bodies,
                                                        const ChangedStates& states,
                                                        const std::optional<Pair>& pressed) const {
    double entering = 0; // what a blow leaves of it is rounding, also of bodies that it has stopped
    for (const auto& [body, after] : states)
        entering = std::max(entering, speedOf(at.placed(body)));
    std::vector<LastingContact> found;
    std::set<Pair> seen;
    std::map<Pair, std::optional<MotionPlane>> planes, ofOthers;
    const auto add = [&](std::vector<LastingContact> contacts) {
        std::ranges::move(contacts, std::back_inserter(found));
    };
    for (const std::size_t body : bodies)
        for (const std::size_t other : search_.partners(body)) {
            const Pair pair = std::minmax(body, other);
            if (!seen.insert(pair).second || mobility_.hopForEver(body, other, at.time))
                continue;
            planes[pair] = at.planeOf(std::array{pair.first, pair.second}, states);
            add(contactsBetween(at, pair, states, entering, planes[pair], pair == pressed));
        }
    for (const auto& [pair, plane] : planes)
        if (plane)
            if (const auto ofAll = at.planeOf(together({pair.first, pair.second}, found), states);
                ofAll != plane)
                ofOthers[pair] = ofAll;
    std::erase_if(found, [&](const LastingContact& contact) {
        return ofOthers.contains(std::minmax(contact.place.body, contact.place.support));
    });
    for (const auto& [pair, plane] : ofOthers)
        add(contactsBetween(at, pair, states, entering, plane, pair == pressed));
    return found;
}

void CollisionSource::settle(const Instant& at, std::span<const std::size_t> bodies,
                             const ChangedStates& states, Event& event, bool isForced,
                             const std::optional<Pair>& pressed) {
    std::vector<LastingContact> contacts = contactsOf(at, bodies, states, pressed);
    std::vector<std::size_t> together;
    for (const std::size_t body : bodies)
        if (contacts_.isIn(body) ||
            std::ranges::any_of(contacts, [&](const LastingContact& contact) {
                return contact.place.body == body || contact.place.support == body;
            }))
            together.push_back(body);
    if (together.empty())
        return;
    if (std::ranges::any_of(contacts, [](const auto& contact) { return !contact.isInPlane; }))
        if (const auto all = this->together({together.begin(), together.end()}, contacts);
            all.size() > together.size() && contacts_.isAnyInPlane(all)) {
            together = all; // contacts that were in a plane are no longer
            contacts = contactsOf(at, together, states, pressed);
        }
    for (const LastingContact& contact : contacts)
        if (!contact.isModelled) {
            const Pair pair{contact.place.body, contact.place.support};
            const bool isRim = world_.isHollow(pair.first) || world_.isHollow(pair.second);
            return refuse(
                at, pair,
                isRim ? sentences::onRim(world_, pair) : sentences::onlyEdges(world_, pair), event);
        }
    if (!isForced && contacts_.isLike(together, contacts))
        return;
    for (const LastingContact& contact : contacts)
        for (const std::size_t body : {contact.place.body, contact.place.support})
            noteUnturned(at, body);
    contacts_.set(together, std::move(contacts), at.time,
                  [&](std::size_t body) { return mobility_.nextPhase(body, at.time); });
    outcome_.isContactsNew = true;
    for (const std::size_t body : contacts_.concerned())
        for (std::size_t i = 0; i < physics::bodyUnknowns && !world_.isFixed(body); ++i)
            event.touched.push_back(world_.records[body].firstUnknown + i);
    const std::vector<std::size_t> readers = contacts_.concernedReaders();
    event.touched.insert(event.touched.end(), readers.begin(), readers.end());
}

// Contacts of these two have ended, or may be others.
Event CollisionSource::renewContacts(const Instant& at, const Pair& pair) {
    for (const std::size_t body : {pair.first, pair.second})
        if (at.canGiveWay(body) && counts_.isRestless(body, at.time))
            return end(at, pair, sentences::restless(world_, body));
    if (auto met = meet(at, pair))
        return *met;
    Event event{.time = at.time, .touched = {}, .tag = 0};
    outcome_ = {};
    std::vector<std::size_t> bodies;
    for (const std::size_t body : {pair.first, pair.second})
        if (!world_.isFixed(body))
            bodies.push_back(body);
    settle(at, bodies, {}, event, true);
    return event;
}

// Pushed together without approaching, with all that touches them: of a stack or of four wheels
// none is found to carry all before the others are known.
std::optional<Event> CollisionSource::press(const Instant& at, const Pair& pair, bool isPressed) {
    Event event{.time = at.time, .touched = {}, .tag = 0};
    outcome_ = {};
    std::vector<std::size_t> settling;
    for (const std::size_t body : clusterAt(at, pair).bodies)
        if (at.canGiveWay(body))
            settling.push_back(body);
    settle(at, settling, {}, event, false, isPressed ? std::optional(pair) : std::nullopt);
    return event.touched.empty() ? std::nullopt : std::optional(event);
}

void CollisionSource::keepImpulses(const Instant& at, const ImpactCluster& cluster,
                                   const physics::ImpactResult& result, double settling) {
    for (const physics::ImpulseGiven& given : result.impulses) {
        const physics::ImpactContact& contact = cluster.contacts[given.contact];
        const auto [first, second] = cluster.pairOf(contact);
        noteUnturned(at, first);
        noteUnturned(at, second);
        Impact impact{.time = at.time,
                      .first = first,
                      .second = second,
                      .point = contact.point,
                      .normal = contact.normal,
                      .impulse = given.impulse};
        // The last of the hops stands for all that would have followed, at the time of their end.
        if (settling > 0 && contact.restitution == 0) {
            const double e = world_.restitutionOf({first, second});
            impact.time = at.time + settling;
            impact.isEndOfHops = true;
            impact.impulse *= (1 + e) / (1 - e);
        }
        record_.addImpact(impact, at.time);
    }
}

// Told of the body that was hit last: it is between others.
void CollisionSource::noteJam(const Instant& at, const ImpactCluster& cluster,
                              const physics::ImpactResult& result) {
    std::map<std::size_t, std::set<std::size_t>> met; // by body that can give way
    for (const physics::ImpulseGiven& given : result.impulses) {
        const auto [a, b] = cluster.pairOf(cluster.contacts[given.contact]);
        for (const auto& [body, other] : {std::pair(a, b), std::pair(b, a)})
            if (at.canGiveWay(body))
                met[body].insert(other);
    }
    const auto most =
        std::ranges::max_element(met, {}, [](const auto& entry) { return entry.second.size(); });
    if (most != met.end())
        record_.addNote({most->first, most->first}, at.time,
                        sentences::noRoom(world_, most->first, most->second));
}

// A body that would turn if its hold were a hinge.
void CollisionSource::noteUnturned(const Instant& at, std::size_t body) {
    if (!world_.isFixed(body) && mobility_.turnsFreely(body, at.time) &&
        mobility_.heldOf(body, at.time).attitude)
        record_.addNote({body, body}, at.time, sentences::noHinge(world_, body));
}

} // namespace simulation
