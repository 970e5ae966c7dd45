#include "simulation/encounter_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

namespace simulation {
namespace {

using collision::FlightMeeting;
using collision::Interval;
using solution::Histories;
using solution::infinity;

constexpr double firstWay = 3;     // of the body's radius, in the first window after a cut
constexpr double firstSpan = 16;   // s, of that window at most
constexpr int mostDoublings = 40;  // of both
constexpr double roomAround = 0.5; // of the radius, about boxes of short windows
constexpr double mostRoom = 4;     // a box in the tree is at most so much larger than needed
constexpr double rounding = 1e-12; // of coordinates, in boxes
constexpr std::size_t recentPairs = 4096;
constexpr std::size_t shortQueue = 64;

void grow(geometry::Box& box, double by) {
    box.min() -= geometry::Vector::Constant(by);
    box.max() += geometry::Vector::Constant(by);
}

// The time in which c1 s + c2 s^2 + ... goes `way` at most, s = time / scale.
double timeForWay(std::span<const geometry::Vector> coefficients, double scale, double way) {
    const double terms = static_cast<double>(coefficients.size()) - 1;
    double least = infinity;
    for (std::size_t k = 1; k < coefficients.size(); ++k)
        if (const double size = coefficients[k].norm(); size > 0) {
            const double power = way / (terms * size);
            least = std::min(least, k == 1   ? power
                                    : k == 2 ? std::sqrt(power)
                                             : std::pow(power, 1 / static_cast<double>(k)));
        }
    return least * scale;
}

// About s0 instead of 0.
std::vector<geometry::Vector> shifted(std::vector<geometry::Vector> c, double s0) {
    for (std::size_t i = 0; s0 != 0 && i + 1 < c.size(); ++i)
        for (std::size_t k = c.size() - 1; k-- > i;)
            c[k] += s0 * c[k + 1];
    return c;
}

geometry::Box boxOf(const collision::BallFlight& flight, double from, double to) {
    const geometry::Vector a = flight.centreAt(from), b = flight.centreAt(to);
    geometry::Box box(a.cwiseMin(b), a.cwiseMax(b));
    // A parabola leaves the box of its ends by at most |h| (to - from)^2 / 4.
    const geometry::Vector bulge = flight.half.cwiseAbs() * ((to - from) * (to - from) / 4);
    const double reach =
        flight.radius + rounding * (a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
    box.min() -= bulge + geometry::Vector::Constant(reach);
    box.max() += bulge + geometry::Vector::Constant(reach);
    return box;
}

bool isBall(const geometry::Shape& shape, const geometry::Vector& centroid) {
    return shape.parts.size() == 1 && shape.parts[0].isSphere() &&
           shape.parts[0].center() == centroid;
}

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
    : records_(records), bodies_(bodies), resting_(resting), slack_(slack), tree_(records.size()),
      windows_(records.size()), version_(records.size(), 0), schedule_(records.size(), 0),
      partners_(records.size()), ended_(records.size(), false), recentPairs_(recentPairs, 0) {
    std::map<std::string, std::size_t> indices;
    for (std::size_t b = 0; b < records.size(); ++b) {
        const bool isFixed = records[b].isFixed;
        const auto& held = equations.bodies[b].held;
        indices.emplace(scene.bodies[b].name, b);
        groups_.push_back(scene.bodies[b].collisionGroup);
        isFreeBall_.push_back(!isFixed && isBall(bodies[b].shape(), records[b].centroid) &&
                              held.size() == 1 && !std::ranges::count(held[0].position, true));
        standing_.push_back(isFixed ? standingOf(bodies[b], records[b])
                                    : std::vector<collision::StandingPart>{});
        if (isFixed) {
            windows_[b] = {.from = -infinity,
                           .until = infinity,
                           .number = 0,
                           .box = collision::boundsDuring(bodies[b], start, start),
                           .isFlight = false,
                           .flight = {},
                           .pieceEnd = infinity};
            grow(windows_[b].box, slack * records[b].radius);
            tree_.put(b, windows_[b].box);
        } else {
            windows_[b].from = windows_[b].until = start;
            schedule(b, start);
        }
    }
    linked_.resize(records.size());
    for (const scene::Link& link : scene.links)
        if (const auto* second = std::get_if<scene::BodyEnd>(&link.second)) {
            const std::size_t a = indices.at(link.first.body), b = indices.at(second->body);
            linked_[a].push_back(b);
            linked_[b].push_back(a);
        }
}

bool EncounterSearch::mayMeet(std::size_t a, std::size_t b) const {
    if (a == b || (records_[a].isFixed && records_[b].isFixed))
        return false;
    if (groups_[a] && groups_[b] && *groups_[a] == *groups_[b])
        return false;
    return std::ranges::find(linked_[a], b) == linked_[a].end();
}

// --- the queue ------------------------------------------------------------------------------

bool EncounterSearch::Later::operator()(const Item& a, const Item& b) const {
    if (a.time != b.time)
        return a.time > b.time;
    return std::tuple(a.isWindow(), a.first, a.second) >
           std::tuple(b.isWindow(), b.first, b.second);
}

// What is outdated lies in the queue until its time comes, or until it is most of the queue.
void EncounterSearch::push(const Item& item) {
    if (queue_.size() > queueLimit_) {
        std::erase_if(queue_, [this](const Item& i) { return isOutdated(i); });
        std::ranges::make_heap(queue_, Later{});
        queueLimit_ = 2 * queue_.size() + shortQueue;
    }
    queue_.push_back(item);
    std::ranges::push_heap(queue_, Later{});
}

void EncounterSearch::drop() {
    std::ranges::pop_heap(queue_, Later{});
    queue_.pop_back();
}

bool EncounterSearch::isOutdated(const Item& item) const {
    if (item.isWindow())
        return schedule_[item.first] != item.versionFirst;
    return version_[item.first] != item.versionFirst || version_[item.second] != item.versionSecond;
}

void EncounterSearch::schedule(std::size_t body, double time) {
    const auto index = static_cast<std::uint32_t>(body);
    push({time, index, index, ++schedule_[body], 0});
}

EncounterSearch::Next EncounterSearch::next() {
    while (!queue_.empty() && isOutdated(queue_.front()))
        drop();
    if (queue_.empty())
        return {infinity, false};
    return {queue_.front().time, !queue_.front().isWindow()};
}

EncounterSearch::Found EncounterSearch::takeHit() {
    const Item item = queue_.front();
    drop();
    return {item.time, {item.first, item.second}, item.pressing, item.isLost};
}

void EncounterSearch::cut(std::size_t body, double time) {
    if (records_[body].isFixed || ended_[body])
        return;
    ++version_[body];
    windows_[body].number = -1;
    windows_[body].until = time;
    windows_[body].isFlight = false;
    bodies_[body].forget();
    schedule(body, time);
}

// --- windows --------------------------------------------------------------------------------

bool EncounterSearch::isOver(const Histories& histories, std::size_t body, double time) const {
    if (histories.stops().empty())
        return false;
    for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
        if (const auto* stop = histories.stop(records_[body].firstUnknown + i))
            if (stop->time <= time)
                return true;
    return false;
}

bool EncounterSearch::openFlight(const Histories& histories, std::size_t body,
                                 Window& window) const {
    if (!isFreeBall_[body] || resting_.isResting(body))
        return false;
    const std::size_t first = records_[body].firstUnknown;
    double origin = -infinity, end = infinity;
    std::array<solution::Piece, 6> pieces; // x y z dx dy dz
    for (std::size_t i = 0; i < 6; ++i) {
        pieces[i] = histories.piece(first + i, window.from);
        if (pieces[i].coefficients.size() > (i < 3 ? 3u : 2u))
            return false;
        origin = std::max(origin, pieces[i].origin);
        if (pieces[i].until > window.from)
            end = std::min(end, pieces[i].until);
    }
    collision::BallFlight& flight = window.flight;
    flight.from = origin;
    flight.radius = bodies_[body].shape().parts[0].radius;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const solution::Piece& speed = pieces[3 + i];
        flight.place[axis] = pieces[i].value(origin);
        flight.velocity[axis] = speed.value(origin);
        flight.half[axis] =
            speed.coefficients.size() > 1 ? speed.coefficients[1] / speed.scale / 2 : 0;
    }
    window.pieceEnd = end;
    return true;
}

void EncounterSearch::openWindow(const Histories& histories, std::size_t body, double time) {
    Window& window = windows_[body];
    window.number = std::min(window.number + 1, mostDoublings);
    window.from = time;
    const double way = firstWay * records_[body].radius * std::ldexp(1, window.number);
    const double latest = time + std::ldexp(firstSpan, window.number);
    bodies_[body].forget();
    window.isFlight = openFlight(histories, body, window);
    if (window.isFlight) {
        const std::array<geometry::Vector, 3> path{
            geometry::Vector::Zero(), window.flight.velocityAt(time), window.flight.half};
        const std::size_t terms = window.flight.half.isZero(0) ? 2 : 3;
        window.until = std::min(time + timeForWay(std::span(path).first(terms), 1, way),
                                std::min(window.pieceEnd, latest));
        window.box = boxOf(window.flight, time, window.until);
        return;
    }
    const collision::MotionPiece& piece = bodies_[body].pieceAt(time);
    const double end = piece.until > time ? std::min(piece.until, latest) : latest;
    const double longest =
        timeForWay(shifted(piece.position, (time - piece.from) / piece.scale), piece.scale, way);
    window.until = std::min(time + longest, end);
    window.box = collision::boundsDuring(bodies_[body], time, window.until);
}

void EncounterSearch::leave(std::size_t body) {
    ended_[body] = true;
    ++version_[body];
    ++schedule_[body];
    if (tree_.contains(body))
        tree_.remove(body);
    for (const std::size_t other : partners_[body])
        std::erase(partners_[other], body);
    partners_[body].clear();
}

void EncounterSearch::renew(const Histories& histories, Renewal& renewal) {
    const std::size_t body = queue_.front().first;
    const double time = queue_.front().time;
    drop();
    renewal = {.body = body, .ended = false, .joined = {}};
    if (isOver(histories, body, time)) {
        leave(body);
        renewal.ended = true;
        return;
    }
    openWindow(histories, body, time);
    grow(windows_[body].box, slack_ * records_[body].radius);
    schedule(body, windows_[body].until);
    findPartners(body, renewal);
    for (const std::size_t other : partners_[body])
        search(std::minmax(body, other), time);
}

// The box in the tree may be larger than the window's, so that short windows seldom change it.
void EncounterSearch::findPartners(std::size_t body, Renewal& renewal) {
    const geometry::Box& box = windows_[body].box;
    const double room = roomAround * records_[body].radius;
    const bool isShort = box.diagonal().norm() < 4 * records_[body].radius;
    if (tree_.contains(body) && tree_.box(body).contains(box) &&
        tree_.box(body).diagonal().norm() < box.diagonal().norm() + mostRoom * room)
        return;
    geometry::Box leaf = box;
    if (isShort && !windows_[body].isFlight)
        grow(leaf, room);
    before_ = partners_[body];
    for (const std::size_t other : before_)
        if (!records_[other].isFixed)
            std::erase(partners_[other], body);
    tree_.put(body, leaf);
    found_.clear();
    tree_.overlapping(leaf, found_);
    std::erase_if(found_, [&](std::size_t other) { return !mayMeet(body, other); });
    std::ranges::sort(found_);
    partners_[body] = found_;
    for (const std::size_t other : found_) {
        if (!records_[other].isFixed)
            partners_[other].insert(std::ranges::lower_bound(partners_[other], body), body);
        if (resting_.isAnyResting() && !std::ranges::binary_search(before_, other))
            renewal.joined.push_back(other);
    }
}

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

// --- hits -----------------------------------------------------------------------------------

bool EncounterSearch::isPassing(const Pair& pair, double time) const {
    return std::ranges::any_of(passing_,
                               [&](const Passing& p) { return p.pair == pair && p.until > time; });
}

void EncounterSearch::keep(const Pair& pair, double time, bool pressing, bool isLost) {
    push({time, static_cast<std::uint32_t>(pair.first), static_cast<std::uint32_t>(pair.second),
          version_[pair.first], version_[pair.second], pressing, isLost});
}

void EncounterSearch::searchOn(const Pair& pair, double time) { search(pair, time); }

FlightMeeting EncounterSearch::flightMeeting(const Pair& pair, Interval during) const {
    const collision::BallFlight *a = flight(pair.first), *b = flight(pair.second);
    if (a && b)
        return collision::meetingOf(*a, *b, during);
    const collision::BallFlight* ball = a ? a : b;
    const auto& faces = standing_[a ? pair.second : pair.first];
    if (!ball || faces.empty())
        return {FlightMeeting::Kind::unclear, 0};
    FlightMeeting first;
    for (const collision::StandingPart& part : faces) {
        const FlightMeeting met = collision::meetingOf(*ball, part, during);
        if (met.kind == FlightMeeting::Kind::unclear)
            return met;
        if (met.kind == FlightMeeting::Kind::hit &&
            (first.kind == FlightMeeting::Kind::none || met.time < first.time))
            first = met;
    }
    return first;
}

// False: formulas do not tell.
bool EncounterSearch::searchFlights(const Pair& pair, Interval during) {
    const FlightMeeting met = flightMeeting(pair, during);
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
    if (searchFlights(pair, during))
        return;
    collision::PartFilter footing;
    if (resting_.hasFooting(pair.first, pair.second))
        footing = [&](std::size_t i, std::size_t j) {
            return resting_.isFooting(pair.first, i, pair.second, j);
        };
    const collision::Encounter encounter =
        collision::timeOfImpact(bodies_[pair.first], bodies_[pair.second], during, footing);
    if (encounter.overlap > 0)
        overlaps_.push_back(pair);
    if (encounter.hit)
        keep(pair, encounter.hit->time, encounter.hit->pressing, encounter.hit->isLost);
}

} // namespace simulation
