#include "meetings/encounter_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using collision::FlightMeeting;
using collision::Interval;
using geometry::Vector;
using solution::infinity;

std::vector<collision::StandingPart> standingOf(const MovingBody& body, const BodyRecord& record) {
    std::vector<collision::StandingPart> parts;
    const geometry::Pose pose{record.start.position - record.start.attitude * record.centroid,
                              record.start.attitude};
    for (const geometry::Part& part : body.shape().parts) {
        if (!part.isPolyhedron() && !part.isPlane())
            return {};
        parts.push_back(collision::standingPart(part, pose));
    }
    return parts;
}

} // namespace

EncounterSearch::EncounterSearch(const Colliders& world, const ContactSet& contacts,
                                 const Mobility& mobility)
    : world_(world), contacts_(contacts), mobility_(mobility), standing_(world.records.size()),
      near_(world.scene, world.records, resolution::searchedGap), windows_(world.records.size()),
      ends_(world.records.size()), unclear_(world.records.size()), hits_(world.records.size()) {
    for (std::size_t b = 0; b < world.records.size(); ++b) {
        const auto& held = world.equations.bodies[b].held;
        isFreeBall_.push_back(!world.isFixed(b) && world.isBall(b) && held.size() == 1 &&
                              !std::ranges::count(held[0].position, true));
        if (world.isFixed(b)) {
            addFixed(b);
        } else {
            windows_[b].from = windows_[b].until = world.start;
            ends_.set(b, world.start);
        }
    }
}

void EncounterSearch::addFixed(std::size_t body) {
    standing_[body] = standingOf(world_.moving[body], world_.records[body]);
    Window& window = windows_[body];
    window.from = -infinity;
    window.until = window.pieceEnd = infinity;
    window.box = collision::boundsDuring(world_.moving[body], world_.start, world_.start);
    grow(window.box, near_.slackOf(body));
    near_.tree.put(body, window.box);
}

EncounterSearch::Next EncounterSearch::next() {
    const Found* const hit = hits_.first();
    if (hit && hit->time < ends_.time()) // who is near is known before they meet
        return {hit->time, true};
    return {ends_.time(), false};
}

void EncounterSearch::cut(std::size_t body, double time) {
    if (world_.isFixed(body) || hasEnded(body))
        return;
    hits_.cut(body);
    windows_[body].number = -1;
    windows_[body].until = time;
    windows_[body].isFlight = windows_[body].isFollowed = false;
    world_.moving[body].forget();
    ends_.set(body, time);
}

// Who has been passed over is found when the body enters the tree again.
void EncounterSearch::release(const scene::Released& released, double time) {
    for (const std::size_t body : near_.mayMeet.release(world_.scene, released)) {
        if (world_.isFixed(body) || hasEnded(body))
            continue;
        cut(body, time);
        if (near_.tree.contains(body))
            near_.tree.remove(body);
    }
}

// --- hits -----------------------------------------------------------------------------------

void EncounterSearch::searchOn(const Pair& pair, double time) {
    if (near_.cells.contains(pair.first) && near_.cells.contains(pair.second))
        searchFlight(pair.first, pair.second, time);
    else
        search(pair, time);
}

// False: formulas do not tell.
bool EncounterSearch::keep(const Pair& pair, const FlightMeeting& met) {
    if (met.kind == FlightMeeting::Kind::hit)
        hits_.push({.time = met.time, .pair = pair});
    return met.kind != FlightMeeting::Kind::unclear;
}

void EncounterSearch::search(const Pair& pair, double from) {
    const Window &a = windows_[pair.first], &b = windows_[pair.second];
    const Interval during{std::max({from, a.from, b.from}), std::min(a.until, b.until)};
    // A window that is about to be renewed has nothing to say.
    if (!(during.from < during.to) || !a.box.intersects(b.box) ||
        near_.mayMeet.isPassing(pair, during.from))
        return;
    tested_.test(pair);
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
    if (!a.isFlight || !b.isFlight || !near_.mayMeet(body, other))
        return;
    const collision::Approach approach(a.flight, b.flight);
    if (passApart(approach, a.flight, b.flight))
        return;
    tested_.test(pair);
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
    const Vector apart = collision::positionAt(world_.moving[pair.first].pieceAt(time), time) -
                         collision::positionAt(world_.moving[pair.second].pieceAt(time), time);
    return apart.norm() - world_.records[pair.first].radius - world_.records[pair.second].radius;
}

void EncounterSearch::searchGenerally(const Pair& pair, Interval during) {
    collision::PartFilter footing;
    if (contacts_.areIn(pair.first, pair.second))
        footing = [&](std::size_t i, std::size_t j) {
            return contacts_.areIn(pair.first, i, pair.second, j);
        };
    if (depth(pair) > 0)
        sideBySide_.look(pair, gapOfBalls(pair, during.from));
    const collision::Encounter encounter = collision::timeOfImpact(
        world_.moving[pair.first], world_.moving[pair.second], during, footing,
        mobility_.slack(pair.first, pair.second, during.from), depth(pair));
    if (encounter.overlap > 0)
        overlaps_.push_back({pair, encounter.overlap});
    if (encounter.hit)
        hits_.push({.time = encounter.hit->time,
                    .pair = pair,
                    .pressing = encounter.hit->pressing,
                    .isLost = encounter.hit->isLost});
}

} // namespace simulation
