#include "events/collision_source.h"

#include "collision/separation.h"
#include "events/sentences.h"
#include "surfaces/posed_parts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace simulation {

CollisionSource::CollisionSource(const Collision& of, double start, double finish,
                                 std::vector<ContactResolution> resolution,
                                 std::function<bool()> cancelled)
    : world_(of.scene, of.equations, of.shapes, start, std::move(resolution)), finish_(finish),
      cancelled_(std::move(cancelled)), readers_(of.equations, world_.records, start),
      contacts_(world_), mobility_(world_, contacts_, finish),
      search_(world_, contacts_, mobility_), releases_(of.scene, of.equations, start),
      flights_(world_, search_, readers_, record_), counts_(world_.records.size(), start),
      walls_(world_) {}

CollisionSource::~CollisionSource() = default;

std::optional<solution::Event> CollisionSource::next(const Histories& histories, double known) {
    world_.read(histories);
    const double until = std::min(known, finish_);
    bool wasImpact = false; // the last look, which may have taken long
    for (std::size_t looks = 1;; ++looks) {
        if ((wasImpact || looks % 64 == 0) && cancelled_ && cancelled_())
            return std::nullopt;
        wasImpact = false;
        const EncounterSearch::Next next = search_.next();
        if (const auto released = releases_.first(histories, std::min(next.time, until))) {
            search_.release(releases_.take(histories, *released), *released);
            continue;
        }
        // A contact that holds to the finish holds at the finish.
        std::optional<ContactSet::Change> ended;
        if (!contacts_.empty())
            ended = contacts_.firstChange(histories, std::min(next.time, until));
        const double horizon = std::min({next.time, until, ended ? ended->time : until});
        if (auto event = crossWall(histories, horizon))
            return announced(std::move(*event));
        if (ended && ended->time < finish_ && !(next.isHit && next.time <= ended->time))
            return announced(renewContacts(at(histories, ended->time), ended->bodies));
        if (next.isHit ? next.time > until : next.time >= until)
            return std::nullopt;
        if (!next.isHit) {
            if (auto event = renew(histories))
                return announced(std::move(*event));
            continue;
        }
        const Found hit = search_.takeHit();
        if (isOffConditions(histories, hit))
            return std::nullopt;
        Handled handled = handle(histories, hit);
        wasImpact = true;
        if (handled.event)
            return announced(std::move(*handled.event));
        if (!handled.isDone)
            search_.searchOn(hit.pair, hit.time);
    }
}

// The body stands where its motion has ended.
void CollisionSource::stand(const Histories& histories, std::size_t body, double time) {
    contacts_.forget(body);
    const double end = search_.endOf(histories, body).value_or(time);
    const BodyState last = stateOf(world_.records[body], histories, end);
    world_.moving[body].standAt({last.position, last.attitude});
    search_.stand(body, time);
}

std::optional<solution::Event> CollisionSource::renew(const Histories& histories) {
    const Instant now = at(histories, search_.next().time);
    if (const auto renewed = search_.renew(histories); renewed.ended)
        stand(histories, renewed.body, now.time);
    std::optional<Event> lost;
    for (const auto& [pair, depth] : search_.takeOverlaps()) {
        if (const auto sentence = unmodelledOf(now, pair); sentence && !lost)
            lost = end(now, pair, *sentence);
        else if (hasMet(now, pair) && !lost)
            lost = search_.hasAnyEnded(pair) ? meetEnded(now, pair).event
                                             : end(now, pair, sentences::missed(world_, pair));
        else if (now.time <= world_.start)
            record_.addOverlap(pair, depth);
        else if (!search_.hasAnyEnded(pair))
            record_.addNote(pair, now.time, sentences::overlap(world_, pair));
    }
    return lost;
}

// Since either was last taken hold of or let go: in an impact, or in a contact that lasted.
bool CollisionSource::hasMet(const Instant& now, const Pair& pair) const {
    const double since = std::max(mobility_.lastPhase(pair.first, now.time),
                                  mobility_.lastPhase(pair.second, now.time));
    return (now.givesWay(pair.first) || now.givesWay(pair.second)) &&
           (record_.haveMet(pair, since) || contactLog().hasHad(pair, since));
}

void CollisionSource::lengthen(double finish) {
    finish_ = finish;
    mobility_.lengthen(finish);
}

// A body that is in contact with a hollow one comes to lie across its wall.
std::optional<solution::Event> CollisionSource::crossWall(const Histories& histories,
                                                          double until) {
    const auto crossing = walls_.first(contacts_, until, [&](std::size_t body, double time) {
        return at(histories, time).placed(body);
    });
    if (!crossing)
        return std::nullopt;
    return end(at(histories, crossing->time), crossing->bodies,
               sentences::throughWall(world_, crossing->bodies));
}

// An event cuts the bodies that it touches and all that read them: what was found beyond it for
// them no longer holds.
void CollisionSource::cut(const Event& event) {
    std::vector<std::size_t> cut = readers_.cutBy(event);
    if (!contacts_.empty()) {
        const auto together = contacts_.island({cut.begin(), cut.end()});
        cut.assign(together.begin(), together.end());
    }
    walls_.cut(event.time);
    releases_.cut(event.time);
    for (const std::size_t body : cut)
        search_.cut(body, event.time);
}

solution::Event CollisionSource::announced(Event event) {
    cut(event);
    record_.addEvent(event.time);
    return event;
}

// LIMIT: a hollow body counts as apart from all others.
bool CollisionSource::areApart(const Instant& at, const Pair& pair, const ChangedStates& states,
                               double tolerance) const {
    if (world_.isHollow(pair.first) || world_.isHollow(pair.second))
        return true;
    const Placed one = at.placed(pair.first, states), other = at.placed(pair.second, states);
    const Vector origin = one.state.position;
    for (std::size_t i = 0; i < one.shape->parts.size(); ++i)
        for (std::size_t j = 0; j < other.shape->parts.size(); ++j) {
            collision::WarmStart cold;
            if (!contacts_.areIn(pair.first, i, pair.second, j) &&
                collision::separate(posed(one, i, origin), posed(other, j, origin), cold).gap <
                    -tolerance)
                return false;
        }
    return true;
}

// A blow reads which contacts hold, and how near and how fast all is, from places and velocities.
bool CollisionSource::isOffConditions(const Histories& histories, const Found& hit) {
    const auto isBound = [&](std::size_t body) {
        return contacts_.isIn(body) || world_.joints.isJoined(body);
    };
    if (!turns_ || !(isBound(hit.pair.first) || isBound(hit.pair.second)))
        return false;
    constexpr double ofSize = 1e-9; // an overlap that is none
    const Instant now = at(histories, hit.time);
    const std::vector<std::size_t> unknowns = now.unknownsOf(hit.pair);
    const double tolerance =
        std::max(now.contactTolerance(hit.pair), ofSize * world_.smallerRadius(hit.pair));
    const auto isBefore = [&](double time, const solution::Turns::Values& valueOf) {
        ChangedStates states;
        for (const std::size_t body : {hit.pair.first, hit.pair.second})
            if (now.canGiveWay(body)) {
                std::array<double, physics::bodyUnknowns> values;
                for (std::size_t i = 0; i < values.size(); ++i)
                    values[i] = valueOf(world_.records[body].firstUnknown + i);
                states[body] = stateOf(world_.records[body], values);
            }
        return areApart(at(histories, time), hit.pair, states, tolerance);
    };
    const auto end = turns_->approach(hit.time, unknowns, isBefore);
    if (end)
        cut({.time = *end, .touched = unknowns, .tag = 0});
    return end.has_value();
}

void CollisionSource::apply(const Histories& /*histories*/, const Event& event,
                            solution::EquationsInForce& equations, solution::Changes& changes) {
    changes.jumps = outcome_.jumps;
    changes.ends = outcome_.ends;
    if (outcome_.isContactsNew)
        contacts_.write(event.time, equations, changes);
}

} // namespace simulation
