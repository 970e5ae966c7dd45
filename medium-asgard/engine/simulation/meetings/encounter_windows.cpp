// Windows and partners: encounter_search.h.
#include "meetings/encounter_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace simulation {
namespace {

using solution::Histories;
using solution::infinity;

constexpr double firstWay = 3;     // of the body's radius, in the first window after a cut
constexpr int mostDoublings = 400; // of both: nothing is farther away; cells go on to grow
constexpr double roomAround = 0.5; // of the radius, about boxes of short windows
constexpr double mostRoom = 4;     // a box in the tree is at most so much larger than needed
constexpr double rounding = 1e-12; // of coordinates, in boxes
constexpr int smallWindows = 16;   // that nothing cut; from then on a ball takes larger cells

double doublings(int number) {
    return number < 63 ? static_cast<double>(std::uint64_t{1} << std::max(number, 0))
                       : std::ldexp(1, std::min(number, mostDoublings));
}

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

// With `more` about it.
geometry::Box boxOf(const collision::BallFlight& flight, double from, double to, double more) {
    const geometry::Vector a = flight.centreAt(from), b = flight.centreAt(to);
    double reach = 0;
    for (const double coordinate : {a[0], a[1], a[2], b[0], b[1], b[2]})
        reach = std::max(reach, std::abs(coordinate));
    reach = flight.radius + more + 2 * rounding * reach;
    geometry::Box box;
    for (Eigen::Index i = 0; i < 3; ++i) {
        // A parabola leaves the box of its ends by at most |h| (to - from)^2 / 4.
        const double room = reach + std::abs(flight.half[i]) * ((to - from) * (to - from) / 4);
        box.min()[i] = std::min(a[i], b[i]) - room;
        box.max()[i] = std::max(a[i], b[i]) + room;
    }
    return box;
}

} // namespace

// --- windows --------------------------------------------------------------------------------

bool EncounterSearch::isOver(const Histories& histories, std::size_t body, double time) const {
    if (histories.stops().empty())
        return false;
    const auto end = endOf(histories, body);
    return end && *end <= time;
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
    window.isFollowed = end == infinity;
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

// Without one the flight is looked at no further than cells and boxes say.
void EncounterSearch::openFlightWindow(std::size_t body, double time) {
    Window& window = windows_[body];
    window.until = std::min(window.pieceEnd, time + firstSpan * doublings(window.number));
    if (cells_.contains(body)) {
        window.exit = cells_.exitOf(body, window.flight, time);
        window.until = std::min(window.until, window.exit.time);
    } else {
        const double way = firstWay * records_[body].radius * doublings(window.number);
        const std::array<geometry::Vector, 3> path{
            geometry::Vector::Zero(), window.flight.velocityAt(time), window.flight.half};
        const std::size_t terms = window.flight.half.isZero(0) ? 2 : 3;
        window.until =
            std::min(window.until, time + timeForWay(std::span(path).first(terms), 1, way));
    }
    if (!cells_.contains(body) || !partners_[body].empty())
        boxFlight(body);
}

// Only partners need the box of a flight.
void EncounterSearch::boxFlight(std::size_t body) {
    Window& window = windows_[body];
    window.box = boxOf(window.flight, window.from, window.until, slack_ * records_[body].radius);
}

void EncounterSearch::openWindow(const Histories& histories, std::size_t body, double time,
                                 Renewal& renewal) {
    Window& window = windows_[body];
    ++window.number;
    window.from = time;
    bodies_[body].forget();
    const bool isNew = !window.isFlight || time >= window.pieceEnd;
    if (isNew)
        window.isFlight = openFlight(histories, body, window);
    around_ = Around::all;
    const Crossing crossing = window.isFlight ? enterCell(body, time, isNew) : Crossing::nowhere;
    if (crossing != Crossing::nowhere) {
        if (crossing == Crossing::toOtherBlock)
            findPartners(body, leafOfBlock(body), renewal);
        openFlightWindow(body, time);
        ends_.set(body, windows_[body].until);
        return;
    }
    if (cells_.contains(body))
        cells_.remove(body);
    if (window.isFlight) {
        openFlightWindow(body, time);
    } else {
        const double way = firstWay * records_[body].radius * doublings(window.number);
        const collision::MotionPiece& piece = bodies_[body].pieceAt(time);
        const double latest = time + firstSpan * doublings(window.number);
        const double end = piece.until > time ? std::min(piece.until, latest) : latest;
        const double longest = timeForWay(
            shifted(piece.position, (time - piece.from) / piece.scale), piece.scale, way);
        window.until = std::min(time + longest, end);
        window.box = collision::boundsDuring(bodies_[body], time, window.until);
        grow(window.box, slack_ * records_[body].radius);
    }
    ends_.set(body, windows_[body].until);
    enterTree(body, renewal);
}

EncounterSearch::Crossing EncounterSearch::enterCell(std::size_t body, double time, bool isNew) {
    Window& window = windows_[body];
    const int growth = std::max(0, (window.number - smallWindows + 2) / 2);
    if (!isNew && cells_.contains(body) && growth == window.growth && time == window.exit.time) {
        around_ = Around::beyond;
        window.crossed = window.exit;
        return cells_.cross(body, window.exit);
    }
    if (!cells_.put(body, window.flight.centreAt(time), window.flight.radius, growth))
        return Crossing::nowhere;
    window.growth = growth;
    if (tree_.contains(body))
        tree_.remove(body);
    return Crossing::toOtherBlock;
}

geometry::Box EncounterSearch::leafOfBlock(std::size_t body) const {
    geometry::Box leaf = cells_.block(body);
    grow(leaf, (1 + slack_) * records_[body].radius +
                   rounding * (leaf.min().cwiseAbs() + leaf.max().cwiseAbs()).maxCoeff());
    return leaf;
}

void EncounterSearch::leave(std::size_t body) {
    ended_[body] = true;
    ++version_[body];
    ends_.set(body, infinity);
    if (tree_.contains(body))
        tree_.remove(body);
    if (cells_.contains(body))
        cells_.remove(body);
    for (const std::size_t other : partners_[body])
        std::erase(partners_[other], body);
    partners_[body].clear();
    windows_[body].isFlight = windows_[body].isFollowed = false;
    for (const std::size_t other : unclear_[body])
        std::erase(unclear_[other], body);
    unclear_[body].clear();
}

void EncounterSearch::renew(const Histories& histories, Renewal& renewal) {
    const std::size_t body = ends_.first();
    const double time = ends_.time();
    renewal = {.body = body, .ended = false, .joined = {}};
    if (isOver(histories, body, time)) {
        leave(body);
        renewal.ended = true;
        return;
    }
    openWindow(histories, body, time, renewal);
    searchAround(body, time);
}

void EncounterSearch::stand(std::size_t body, double time, Renewal& renewal) {
    Window& window = windows_[body];
    window.from = time;
    window.until = window.pieceEnd = infinity;
    window.box = collision::boundsDuring(bodies_[body], time, time);
    grow(window.box, slack_ * records_[body].radius);
    tree_.put(body, window.box);
    findPartners(body, window.box, renewal);
    renewal.joined.clear(); // nobody rests on it
    for (const std::size_t other : partners_[body])
        search(std::minmax(body, other), time);
}

void EncounterSearch::searchAround(std::size_t body, double time, std::size_t but) {
    for (const std::size_t other : partners_[body])
        if (other != but)
            search(std::minmax(body, other), time);
    if (!cells_.contains(body))
        return;
    const auto look = [&](std::size_t other) {
        if (other != but)
            searchFlight(body, other, time);
    };
    if (around_ == Around::all) {
        // Who searched it just now has put itself there.
        if (!unclear_[body].empty())
            std::erase_if(unclear_[body], [&](std::size_t other) { return other != but; });
        std::ranges::for_each(cells_.near(body), look);
        return;
    }
    const std::vector<std::size_t> unclear = std::exchange(unclear_[body], {});
    cells_.forEachBeyond(body, windows_[body].crossed, look);
    std::ranges::for_each(unclear, look);
}

std::vector<std::size_t> EncounterSearch::partners(std::size_t body) const {
    std::vector<std::size_t> partners;
    std::ranges::copy_if(partners_[body], std::back_inserter(partners),
                         [this](std::size_t other) { return !ended_[other]; });
    if (cells_.contains(body))
        cells_.forEachNear(body, [&](std::size_t other) {
            if (mayMeet(body, other))
                partners.push_back(other);
        });
    std::ranges::sort(partners);
    return partners;
}

void EncounterSearch::turn(std::size_t body, const solution::Turn& turn, double time) {
    collision::BallFlight& flight = windows_[body].flight;
    flight.from = time;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        flight.place[axis] = turn.place[i];
        flight.velocity[axis] = turn.velocity[i];
    }
}

void EncounterSearch::goOn(const Pair& turned, double time, Renewal& renewal) {
    renewal.body = turned.first;
    renewal.ended = false;
    renewal.joined.clear();
    const std::array<std::size_t, 2> two{turned.first, turned.second};
    for (const std::size_t body : two) {
        if (records_[body].isFixed)
            continue;
        Window& window = windows_[body];
        ++version_[body];
        bodies_[body].forget();
        window.number = 0;
        window.from = time;
        const bool isInCell = cells_.contains(body);
        const bool stays = isInCell && window.growth == 0;
        const bool entered =
            stays || (isInCell && enterCell(body, time, true) != Crossing::nowhere);
        if (entered && !stays)
            findPartners(body, leafOfBlock(body), renewal);
        openFlightWindow(body, time);
        ends_.set(body, windows_[body].until);
        if (!entered)
            enterTree(body, renewal);
    }
    around_ = Around::all;
    const bool areTwo = !records_[turned.first].isFixed && !records_[turned.second].isFixed;
    for (const std::size_t body : two)
        if (!records_[body].isFixed)
            searchAround(body, time, areTwo && body == turned.second ? turned.first : nobody);
}

// The box in the tree may be larger than the window's, so that short windows seldom change it.
void EncounterSearch::enterTree(std::size_t body, Renewal& renewal) {
    const geometry::Box& box = windows_[body].box;
    const double room = roomAround * records_[body].radius;
    const bool isShort = box.diagonal().norm() < 4 * records_[body].radius;
    if (tree_.contains(body) && tree_.box(body).contains(box) &&
        tree_.box(body).diagonal().norm() < box.diagonal().norm() + mostRoom * room)
        return;
    geometry::Box leaf = box;
    if (isShort && !windows_[body].isFlight)
        grow(leaf, room);
    tree_.put(body, leaf);
    findPartners(body, leaf, renewal);
}

// A ball in a cell has partners in the tree only; whoever is in the tree has them everywhere.
void EncounterSearch::findPartners(std::size_t body, const geometry::Box& leaf, Renewal& renewal) {
    before_ = partners_[body];
    for (const std::size_t other : before_)
        if (!records_[other].isFixed)
            std::erase(partners_[other], body);
    found_.clear();
    tree_.overlapping(leaf, found_);
    if (!cells_.contains(body))
        cells_.forEachIn(leaf, [&](std::size_t ball) {
            if (!leafOfBlock(ball).intersects(leaf))
                return;
            found_.push_back(ball);
            if (partners_[ball].empty() && windows_[ball].isFlight)
                boxFlight(ball);
        });
    std::erase_if(found_, [&](std::size_t other) {
        const bool bothStand = ended_[body] && (ended_[other] || records_[other].isFixed);
        return bothStand || !mayMeet(body, other);
    });
    std::ranges::sort(found_);
    partners_[body] = found_;
    for (const std::size_t other : found_) {
        if (!records_[other].isFixed)
            partners_[other].insert(std::ranges::lower_bound(partners_[other], body), body);
        if (resting_.isAnyResting() && !std::ranges::binary_search(before_, other))
            renewal.joined.push_back(other);
    }
}

} // namespace simulation
