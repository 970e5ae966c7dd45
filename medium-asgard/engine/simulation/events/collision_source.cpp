#include "events/collision_source.h"

#include "equations/partition.h"
#include "events/quoted.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using solution::Event;
using solution::Histories;

std::vector<MovingBody> movingBodies(const std::vector<BodyRecord>& records,
                                     const std::vector<geometry::Shape>& shapes) {
    std::vector<MovingBody> bodies;
    for (std::size_t i = 0; i < records.size(); ++i)
        bodies.emplace_back(records[i], shapes[i]);
    return bodies;
}

std::vector<bool> elasticOf(const scene::Scene& scene) {
    std::vector<bool> elastic;
    for (const scene::Body& body : scene.bodies)
        elastic.push_back(body.restitution == 1);
    return elastic;
}

} // namespace

CollisionSource::CollisionSource(const scene::Scene& scene,
                                 const physics::EquationsOfMotion& equations,
                                 const std::vector<geometry::Shape>& shapes, double start,
                                 double finish, std::vector<RestLimits> limits,
                                 std::function<bool()> cancelled)
    : scene_(scene), equations_(equations), records_(recordsOf(equations)),
      bodies_(movingBodies(records_, shapes)), start_(start), finish_(finish),
      limits_(std::move(limits)), cancelled_(std::move(cancelled)), joints_(equations),
      resting_(equations, records_, bodies_, start, finish, limits_, elasticOf(scene)),
      search_(scene, equations, records_, bodies_, resting_, start, 4 * RestLimits::mostGap),
      meetings_(records_.size()), changes_(records_.size()) {
    findDependents();
}

CollisionSource::~CollisionSource() = default;

void CollisionSource::read(const Histories& histories) {
    if (std::exchange(read_, &histories) != &histories)
        for (MovingBody& body : bodies_)
            body.read(histories);
}

std::optional<Event> CollisionSource::next(const Histories& histories, double known) {
    read(histories);
    const double until = std::min(known, finish_);
    for (std::size_t looks = 1;; ++looks) {
        if (looks % 64 == 0 && cancelled_ && cancelled_())
            return std::nullopt;
        const EncounterSearch::Next next = search_.next();
        std::optional<RestingBodies::Change> change;
        if (resting_.isAnyResting())
            change = resting_.firstChange(histories, std::min(next.time, until), until, search_);
        // What holds to the finish holds at the finish.
        const bool changes = change && change->time < finish_;
        if (changes && !(next.isHit && next.time <= change->time))
            return announced(stir(histories, change->body, change->time));
        if (next.isHit ? next.time > until : next.time >= until)
            return std::nullopt;
        if (!next.isHit) {
            if (auto event = renew(histories))
                return announced(std::move(*event));
            continue;
        }
        const EncounterSearch::Found hit = search_.takeHit();
        Handled handled = handle(histories, hit);
        if (handled.event)
            return announced(std::move(*handled.event));
        if (!handled.isDone)
            search_.searchOn(hit.pair, hit.time);
        else if (rally_.isDue())
            if (auto event = rally(histories, hit.pair, until))
                return announced(std::move(*event));
    }
}

// Where its motion has ended.
void CollisionSource::stand(const Histories& histories, std::size_t body, double time) {
    resting_.forget(body);
    const double end = search_.endOf(histories, body).value_or(time);
    const BodyState last = stateOf(records_[body], histories, end);
    bodies_[body].standAt({last.position, last.attitude});
    search_.stand(body, time, renewal_);
}

std::optional<Event> CollisionSource::renew(const Histories& histories) {
    const double time = search_.next().time;
    search_.renew(histories, renewal_);
    if (renewal_.ended)
        stand(histories, renewal_.body, time);
    lookAtJoined(time);
    std::optional<Event> lost;
    for (const Pair& pair : search_.takeOverlaps()) {
        const std::string both = quoted(scene_.bodies[pair.first].name) + " and " +
                                 quoted(scene_.bodies[pair.second].name) + " overlap ";
        if (hasMet(pair, time) && !lost)
            lost = search_.hasAnyEnded(pair)
                       ? meetEnded(histories, pair, time).event
                       : end(pair, time,
                             "bodies " + both +
                                 "after they have met, since the search missed an impact; another "
                                 "accuracy may find it");
        else
            noteOnce(pair, time,
                     "Bodies " + both +
                         "without having met; they can collide once they are apart.");
    }
    return lost;
}

// Since either was last taken hold of or let go.
bool CollisionSource::hasMet(const Pair& pair, double time) const {
    const double since =
        std::max(resting_.lastPhase(pair.first, time), resting_.lastPhase(pair.second, time));
    return (givesWay(pair.first, time) || givesWay(pair.second, time)) &&
           impacts_.haveMet(pair, since);
}

// What rests looks at who came near it.
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

std::vector<collision::Pair> CollisionSource::blocked(double until) const {
    std::vector<Pair> pairs;
    for (const Blocked& blocked : blocked_)
        if (blocked.time <= until)
            pairs.push_back(blocked.pair);
    return pairs;
}

std::vector<std::string> CollisionSource::notes(double until) const {
    std::vector<std::string> sentences;
    for (const Note& note : notes_)
        if (note.time <= until)
            sentences.push_back(note.sentence);
    return sentences;
}

bool CollisionSource::hasEventAt(double time) const {
    return std::ranges::binary_search(events_, time);
}

std::optional<Event> CollisionSource::announced(Event event) {
    forgetAfterEvent(event);
    noteEvent(event.time);
    return event;
}

void CollisionSource::noteEvent(double time) {
    if (events_.empty() || events_.back() < time)
        events_.push_back(time);
}

// An event cuts the bodies that it touches and all that read them: what was found beyond it for
// them no longer holds.
void CollisionSource::forgetAfterEvent(const Event& event) {
    cut_.clear();
    for (const std::size_t unknown : event.touched) {
        const std::size_t body = bodyOf_[unknown];
        if (!cut_.empty() && cut_.back() == body)
            continue;
        cut_.push_back(body);
        cut_.insert(cut_.end(), dependents_[body].begin(), dependents_[body].end());
    }
    std::ranges::sort(cut_);
    cut_.erase(std::unique(cut_.begin(), cut_.end()), cut_.end());
    resting_.lookAgain(cut_, event.time);
    for (const std::size_t body : cut_)
        search_.cut(body, event.time);
}

void CollisionSource::findDependents() {
    bodyOf_.resize(equations_.set.unknowns.size());
    for (std::size_t b = 0; b < records_.size(); ++b)
        for (std::size_t i = 0; !records_[b].isFixed && i < physics::bodyUnknowns; ++i)
            bodyOf_[records_[b].firstUnknown + i] = b;
    const auto reads = solution::readsOf(equations_.set, start_);
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
                if (reader != b && dependents_[b].insert(reader).second)
                    open.push_back(reader);
        }
    }
}

} // namespace simulation
