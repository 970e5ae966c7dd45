#include "events/collision_source.h"

#include "events/sentences.h"
#include "placing/placing.h"

#include <algorithm>
#include <utility>

namespace simulation {

CollisionSource::CollisionSource(const Collision& of, double start, double finish,
                                 std::vector<ContactResolution> resolution,
                                 std::function<bool()> cancelled)
    : world_(of.scene, of.equations, of.shapes, start, std::move(resolution)), finish_(finish),
      cancelled_(std::move(cancelled)), readers_(of.equations, world_.records, start),
      resting_(world_, finish), search_(world_, resting_), releases_(of.scene, of.equations, start),
      flights_(world_, search_, readers_, record_), counts_(world_.records.size(), start),
      walls_(world_) {}

CollisionSource::~CollisionSource() = default;

std::optional<solution::Event> CollisionSource::next(const Histories& histories, double known) {
    world_.read(histories);
    const double until = std::min(known, finish_);
    for (std::size_t looks = 1;; ++looks) {
        if (looks % 64 == 0 && cancelled_ && cancelled_())
            return std::nullopt;
        const EncounterSearch::Next next = search_.next();
        if (const auto released = releases_.first(histories, std::min(next.time, until))) {
            search_.release(releases_.take(histories, *released), *released);
            continue;
        }
        std::optional<RestingBodies::Change> change;
        if (resting_.isAnyResting())
            change = resting_.firstChange(histories, std::min(next.time, until), until, search_);
        // A contact that holds to the finish holds at the finish.
        std::optional<ContactSet::Change> ended;
        if (!resting_.contacts().empty())
            ended = resting_.contacts().firstChange(histories, std::min(next.time, until));
        const double horizon = std::min(
            {next.time, until, ended ? ended->time : until, change ? change->time : until});
        if (auto event = crossWall(histories, horizon))
            return announced(std::move(*event));
        if (ended && ended->time < finish_ && !(change && change->time < ended->time) &&
            !(next.isHit && next.time <= ended->time))
            return announced(renewContacts(at(histories, ended->time), ended->bodies));
        const bool changes = change && change->time < finish_;
        if (changes && !(next.isHit && next.time <= change->time))
            return announced(stir(at(histories, change->time), change->body));
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
        if (handled.event)
            return announced(std::move(*handled.event));
        if (!handled.isDone)
            search_.searchOn(hit.pair, hit.time);
    }
}

// The body stands where its motion has ended.
void CollisionSource::stand(const Histories& histories, std::size_t body, double time) {
    resting_.forget(body);
    resting_.contacts().forget(body);
    const double end = search_.endOf(histories, body).value_or(time);
    const BodyState last = stateOf(world_.records[body], histories, end);
    world_.moving[body].standAt({last.position, last.attitude});
    search_.stand(body, time, renewal_);
}

std::optional<solution::Event> CollisionSource::renew(const Histories& histories) {
    const Instant now = at(histories, search_.next().time);
    search_.renew(histories, renewal_);
    if (renewal_.ended)
        stand(histories, renewal_.body, now.time);
    lookAtJoined(now.time);
    std::optional<Event> lost;
    for (const auto& [pair, depth] : search_.takeOverlaps()) {
        if (const auto sentence = unmodelledOf(now, pair); sentence && !lost)
            lost = end(now, pair, *sentence);
        else if (hasMet(now, pair) && !lost)
            lost = search_.hasAnyEnded(pair) ? meetEnded(now, pair).event
                                             : end(now, pair, sentences::missed(world_, pair));
        else
            record_.addNote(pair, now.time,
                            now.time <= world_.start ? overlapSentence(world_.scene, pair, depth,
                                                                       Begin::throughEachOther)
                                                     : sentences::overlap(world_, pair));
    }
    return lost;
}

// Since either was last taken hold of or let go: in an impact, or in a contact that lasted.
bool CollisionSource::hasMet(const Instant& now, const Pair& pair) const {
    const double since = std::max(resting_.lastPhase(pair.first, now.time),
                                  resting_.lastPhase(pair.second, now.time));
    return (now.givesWay(pair.first) || now.givesWay(pair.second)) &&
           (record_.haveMet(pair, since) || contactLog().hasHad(pair, since));
}

// Resting bodies look at who came near them.
void CollisionSource::lookAtJoined(double time) {
    for (const std::size_t joined : renewal_.joined)
        for (const std::size_t body : {renewal_.body, joined})
            if (resting_.isResting(body))
                resting_.lookAgain(std::span(&body, 1), time);
}

void CollisionSource::lengthen(double finish) {
    finish_ = finish;
    resting_.lengthen(finish);
}

// A body that is in contact with a hollow one comes to lie across its wall.
std::optional<solution::Event> CollisionSource::crossWall(const Histories& histories,
                                                          double until) {
    const auto crossing =
        walls_.first(resting_.contacts(), until, [&](std::size_t body, double time) {
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
    if (!resting_.contacts().empty()) {
        const auto together = resting_.contacts().island({cut.begin(), cut.end()});
        cut.assign(together.begin(), together.end());
    }
    resting_.lookAgain(cut, event.time);
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

// A blow reads which contacts hold, and how near and how fast all is, from places and velocities.
bool CollisionSource::isOffConditions(const Histories& histories, const Found& hit) {
    if (!turns_ ||
        !(resting_.contacts().isIn(hit.pair.first) || resting_.contacts().isIn(hit.pair.second)))
        return false;
    const std::vector<std::size_t> unknowns = at(histories, hit.time).unknownsOf(hit.pair);
    const auto end = turns_->approach(hit.time, unknowns);
    if (end)
        cut({.time = *end, .touched = unknowns, .tag = 0});
    return end.has_value();
}

void CollisionSource::apply(const Histories& histories, const Event& event,
                            solution::EquationsInForce& equations, solution::Changes& changes) {
    changes.jumps = outcome_.jumps;
    changes.ends = outcome_.ends;
    for (const Outcome::Resting& resting : outcome_.rests)
        resting_.write(histories, resting.body, event.time, resting.state, resting.rest,
                       equations.changing(), changes);
    if (outcome_.isContactsNew)
        resting_.contacts().write(event.time, equations, changes);
}

} // namespace simulation
