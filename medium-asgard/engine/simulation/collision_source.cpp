#include "simulation/collision_source.h"

#include "solution/partition.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using collision::Hit;
using solution::Event;
using solution::Histories;
using solution::infinity;

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

} // namespace

CollisionSource::CollisionSource(const scene::Scene& scene,
                                 const physics::EquationsOfMotion& equations,
                                 std::vector<geometry::Shape> shapes, double start, double finish,
                                 const RestLimits& limits)
    : scene_(scene), equations_(equations), records_(recordsOf(equations)), start_(start),
      finish_(finish), limits_(limits), front_(start),
      resting_(equations, records_, bodies_, start, finish, limits) {
    for (std::size_t i = 0; i < records_.size(); ++i)
        bodies_.emplace_back(records_[i], std::move(shapes[i]));
    const std::size_t n = records_.size();
    ended_.assign(n, false);
    boxUntil_.assign(n, -infinity);
    boxes_.resize(n);
    partners_.resize(n);
    version_.assign(n, 1);
    cutAt_.assign(n, start);
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
            found_[{a, b}].testedUntil = found_[{a, b}].since = time;
            if (auto event = handle(histories, {a, b}, hit))
                return announced(std::move(*event));
        }
        const auto change = resting_.firstChange(histories, front_, partners_);
        if (change)
            return announced(stir(histories, change->body, change->time));
        if (front_ >= until)
            return std::nullopt;
        const double window = std::min(until, front_ + windowLength(histories));
        lookAtWindow(histories, window);
        const auto next = resting_.firstChange(histories, window, partners_);
        front_ = hits_.empty() ? window : std::min(window, std::get<0>(*hits_.begin()));
        if (next)
            front_ = std::min(front_, next->time);
    }
}

std::optional<Event> CollisionSource::announced(Event event) {
    forgetAfterEvent(event);
    return event;
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
    resting_.lookAgain(cut, event.time);
    for (const std::size_t b : cut) {
        boxUntil_[b] = -infinity;
        ++version_[b];
        cutAt_[b] = event.time;
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
        if (stopped)
            resting_.forget(b);
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
        if (boxUntil_[b] >= until || ended_[b]) // what comes after an end is no motion
            continue;
        boxes_[b] = collision::boundsDuring(bodies_[b], front_, until);
        boxes_[b].min() -= Vector::Constant(slackOf(b));
        boxes_[b].max() += Vector::Constant(slackOf(b));
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

// What touches at an instant is found among those whose boxes overlap, however short their windows.
double CollisionSource::slackOf(std::size_t body) const {
    return 4 * limits_.gap * records_[body].radius;
}

// The part of both bodies' present pieces that holds t, on a grid whose spacing is about the time
// in which they cross their own size.
collision::Interval CollisionSource::cellAt(const Pair& pair, double since, double t) const {
    double from = std::max(start_, since), to = finish_, size = 0, speed = 0;
    for (const std::size_t body : {pair.first, pair.second}) {
        if (records_[body].isFixed)
            continue;
        const collision::MotionPiece& piece = bodies_[body].pieceAt(t);
        from = std::max({from, cutAt_[body], piece.from});
        to = std::min(to, piece.until);
        size += records_[body].radius;
        speed += collision::velocityAt(piece, piece.from).linear.norm();
    }
    const double span = finish_ - start_;
    const double wanted = speed > 0 ? std::clamp(4 * size / speed, span / 1000, span) : span;
    const double spacing = std::exp2(std::ceil(std::log2(wanted)));
    double first = start_ + std::floor((t - start_) / spacing) * spacing;
    if (first + spacing <= t)
        first += spacing;
    return {std::max(from, first), std::min(to, first + spacing)};
}

void CollisionSource::testPair(const Pair& pair, double until) {
    Found& found = found_[pair];
    const auto passing = passingUntil_.find(pair);
    if (passing != passingUntil_.end() && passing->second > front_) {
        found.since = passing->second;
        return;
    }
    const std::pair versions{version_[pair.first], version_[pair.second]};
    if (std::exchange(found.versions, versions) != versions)
        found.testedUntil = front_;
    for (double from = std::max(found.testedUntil, front_); !found.hit && from < until;
         from = found.testedUntil)
        if (!testCell(pair, found, cellAt(pair, found.since, from)))
            return;
}

// False: there is nothing after it.
bool CollisionSource::testCell(const Pair& pair, Found& found, collision::Interval cell) {
    ++pairTests_;
    collision::PartFilter footing;
    if (resting_.hasFooting(pair.first, pair.second))
        footing = [&](std::size_t i, std::size_t j) {
            return resting_.isFooting(pair.first, i, pair.second, j);
        };
    const collision::Encounter encounter =
        collision::timeOfImpact(bodies_[pair.first], bodies_[pair.second], cell, footing);
    const bool advances = cell.to > found.testedUntil;
    found.testedUntil = std::max(found.testedUntil, cell.to);
    if (encounter.overlap > 0)
        noteOnce(pair, "Bodies " + quoted(scene_.bodies[pair.first].name) + " and " +
                           quoted(scene_.bodies[pair.second].name) +
                           " overlap without having met; they can collide once they are apart.");
    if (encounter.hit)
        keepHit(pair, found, encounter.hit);
    return advances;
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
    for (std::size_t b = 0; b < records_.size(); ++b) {
        if (records_[b].isFixed || ended_[b])
            continue;
        size += records_[b].radius;
        speed += stateOf(records_[b], histories, front_).velocity.norm();
    }
    const double span = finish_ - start_;
    return speed > 0 ? std::clamp(4 * size / speed, span / 1000, span) : span;
}

} // namespace simulation
