#include "meetings/encounter_search.h"

#include "scene/connections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using collision::FlightMeeting;
using collision::Interval;
using geometry::Vector;
using solution::infinity;

constexpr std::size_t recentPairs = 4096;
constexpr std::size_t shortQueue = 16;

std::vector<collision::StandingPart> standingOf(const MovingBody& body, const BodyRecord& record) {
    std::vector<collision::StandingPart> parts;
    const geometry::Pose pose{record.start.position - record.start.attitude * record.centroid,
                              record.start.attitude};
    for (const geometry::Part& part : body.shape().parts) {
        if (part.isSphere())
            return {};
        parts.push_back(collision::standingPart(part, pose));
    }
    return parts;
}

} // namespace

EncounterSearch::EncounterSearch(const scene::Scene& scene,
                                 const physics::EquationsOfMotion& equations,
                                 const std::vector<BodyRecord>& records,
                                 const std::vector<MovingBody>& bodies,
                                 const RestingBodies& resting, double start, double slack)
    : records_(records), bodies_(bodies), resting_(resting), slack_(slack),
      joined_(scene::joinedBodies(scene)), tree_(records.size()), cells_(records.size()),
      windows_(records.size()), version_(records.size(), 0), ends_(records.size()),
      partners_(records.size()), unclear_(records.size()), ended_(records.size(), false),
      recentPairs_(recentPairs, 0) {
    for (std::size_t b = 0; b < records.size(); ++b) {
        const bool isFixed = records[b].isFixed;
        const auto& held = equations.bodies[b].held;
        groups_.push_back(scene.bodies[b].collisionGroup);
        isFreeBall_.push_back(!isFixed && bodies[b].isBall() && held.size() == 1 &&
                              !std::ranges::count(held[0].position, true));
        standing_.push_back(isFixed ? standingOf(bodies[b], records[b])
                                    : std::vector<collision::StandingPart>{});
        if (isFixed) {
            windows_[b].from = -infinity;
            windows_[b].until = windows_[b].pieceEnd = infinity;
            windows_[b].box = collision::boundsDuring(bodies_[b], start, start);
            const double more = slack * records[b].radius;
            windows_[b].box.min().array() -= more;
            windows_[b].box.max().array() += more;
            tree_.put(b, windows_[b].box);
        } else {
            windows_[b].from = windows_[b].until = start;
            ends_.set(b, start);
        }
    }
    for (std::size_t b = 0; b < records.size(); ++b)
        isChoosy_.push_back(groups_[b].has_value() || !joined_[b].empty());
}

bool EncounterSearch::mayChoosyMeet(std::size_t a, std::size_t b) const {
    if (groups_[a] && groups_[b] && *groups_[a] == *groups_[b])
        return false;
    return std::ranges::find(joined_[a], b) == joined_[a].end();
}

// --- the queue ------------------------------------------------------------------------------

bool EncounterSearch::Later::operator()(const Hit& a, const Hit& b) const {
    if (a.time != b.time)
        return a.time > b.time;
    return std::pair(a.first, a.second) > std::pair(b.first, b.second);
}

// What is outdated lies in the queue until its time comes, or until it is most of the queue.
void EncounterSearch::push(const Hit& hit) {
    if (queue_.size() > queueLimit_) {
        std::erase_if(queue_, [this](const Hit& h) { return isOutdated(h); });
        std::ranges::make_heap(queue_, Later{});
        queueLimit_ = 2 * queue_.size() + shortQueue;
    }
    queue_.push_back(hit);
    std::ranges::push_heap(queue_, Later{});
}

void EncounterSearch::drop() {
    std::ranges::pop_heap(queue_, Later{});
    queue_.pop_back();
}

bool EncounterSearch::isOutdated(const Hit& hit) const {
    return version_[hit.first] != hit.versionFirst || version_[hit.second] != hit.versionSecond;
}

EncounterSearch::Next EncounterSearch::next() {
    while (!queue_.empty() && isOutdated(queue_.front()))
        drop();
    if (!queue_.empty() && queue_.front().time <= ends_.time())
        return {queue_.front().time, true};
    return {ends_.time(), false};
}

EncounterSearch::Found EncounterSearch::takeHit() {
    const Hit hit = queue_.front();
    drop();
    return {hit.time, {hit.first, hit.second}, hit.pressing, hit.isLost};
}

void EncounterSearch::cut(std::size_t body, double time) {
    if (records_[body].isFixed || ended_[body])
        return;
    ++version_[body];
    windows_[body].number = -1;
    windows_[body].until = time;
    windows_[body].isFlight = windows_[body].isFollowed = false;
    bodies_[body].forget();
    ends_.set(body, time);
}

// --- hits -----------------------------------------------------------------------------------

void EncounterSearch::remember(const Pair& pair) {
    const std::uint64_t key = (static_cast<std::uint64_t>(pair.first) << 32) + pair.second;
    std::uint64_t& recent = recentPairs_[(pair.first * 613 + pair.second) % recentPairs];
    if (recent == key)
        return;
    recent = key;
    pairs_.push_back(key);
    if (pairs_.size() > 2 * pairsKept_ + recentPairs)
        pairsKept_ = sortPairs();
}

std::size_t EncounterSearch::sortPairs() {
    std::ranges::sort(pairs_);
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    return pairs_.size();
}

std::vector<EncounterSearch::Pair> EncounterSearch::pairs() {
    pairsKept_ = sortPairs();
    std::vector<Pair> pairs;
    pairs.reserve(pairs_.size());
    for (const std::uint64_t key : pairs_)
        pairs.emplace_back(key >> 32, key & 0xffffffff);
    return pairs;
}

bool EncounterSearch::isPassing(const Pair& pair, double time) const {
    return std::ranges::any_of(passing_,
                               [&](const Passing& p) { return p.pair == pair && p.until > time; });
}

void EncounterSearch::keep(const Pair& pair, double time, bool pressing, bool isLost) {
    push({.time = time,
          .first = static_cast<std::uint32_t>(pair.first),
          .second = static_cast<std::uint32_t>(pair.second),
          .versionFirst = version_[pair.first],
          .versionSecond = version_[pair.second],
          .pressing = pressing,
          .isLost = isLost});
}

void EncounterSearch::searchOn(const Pair& pair, double time) {
    if (cells_.contains(pair.first) && cells_.contains(pair.second))
        searchFlight(pair.first, pair.second, time);
    else
        search(pair, time);
}

// False: formulas do not tell.
bool EncounterSearch::keep(const Pair& pair, const FlightMeeting& met) {
    if (met.kind == FlightMeeting::Kind::hit)
        keep(pair, met.time, false, false);
    return met.kind != FlightMeeting::Kind::unclear;
}

void EncounterSearch::search(const Pair& pair, double from) {
    const Window &a = windows_[pair.first], &b = windows_[pair.second];
    const Interval during{std::max({from, a.from, b.from}), std::min(a.until, b.until)};
    // A window that is about to be renewed has nothing to say.
    if (!(during.from < during.to) || !a.box.intersects(b.box) || isPassing(pair, during.from))
        return;
    ++pairTests_;
    remember(pair);
    const std::size_t standing = a.isFlight ? pair.second : pair.first;
    FlightMeeting met{FlightMeeting::Kind::unclear, 0};
    if (a.isFlight && b.isFlight)
        met = collision::meetingOf(a.flight, b.flight, during);
    else if ((a.isFlight || b.isFlight) && !standing_[standing].empty())
        met = meetingWithStanding(a.isFlight ? a.flight : b.flight, standing_[standing], during);
    if (!keep(pair, met))
        searchGenerally(pair, during);
}

// Two balls in cells, for as long as they fly.
void EncounterSearch::searchFlight(std::size_t body, std::size_t other, double time) {
    const Pair pair = std::minmax(body, other);
    const Window &a = windows_[pair.first], &b = windows_[pair.second];
    // One that was cut is searched when its next window begins.
    if (!a.isFlight || !b.isFlight || !mayMeet(body, other))
        return;
    const collision::Approach approach(a.flight, b.flight);
    if (passApart(approach, a.flight, b.flight))
        return;
    ++pairTests_;
    remember(pair);
    const Interval during{time, std::min(a.pieceEnd, b.pieceEnd)};
    if (keep(pair, collision::meetingOf(approach, a.flight, b.flight, during)))
        return;
    for (const auto& [one, two] : {pair, Pair(pair.second, pair.first)})
        if (std::ranges::find(unclear_[one], two) == unclear_[one].end())
            unclear_[one].push_back(two);
    if (const double until = std::min(a.until, b.until); time < until)
        searchGenerally(pair, {time, until});
}

double EncounterSearch::gapOfBalls(const Pair& pair, double time) const {
    const Vector apart = collision::positionAt(bodies_[pair.first].pieceAt(time), time) -
                         collision::positionAt(bodies_[pair.second].pieceAt(time), time);
    return apart.norm() - records_[pair.first].radius - records_[pair.second].radius;
}

void EncounterSearch::searchGenerally(const Pair& pair, Interval during) {
    collision::PartFilter footing;
    if (resting_.hasFooting(pair.first, pair.second))
        footing = [&](std::size_t i, std::size_t j) {
            return resting_.isFooting(pair.first, i, pair.second, j);
        };
    if (depth(pair) > 0)
        sideBySide_.look(pair, gapOfBalls(pair, during.from));
    const collision::Encounter encounter =
        collision::timeOfImpact(bodies_[pair.first], bodies_[pair.second], during, footing,
                                resting_.slack(pair.first, pair.second), depth(pair));
    if (encounter.overlap > 0)
        overlaps_.push_back(pair);
    if (encounter.hit)
        keep(pair, encounter.hit->time, encounter.hit->pressing, encounter.hit->isLost);
}

} // namespace simulation
