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
constexpr int smallWindows = 16;   // that nothing cut; from then on a ball takes larger cells

double doublings(int number) {
    return number < 63 ? static_cast<double>(std::uint64_t{1} << std::max(number, 0))
                       : std::ldexp(1, std::min(number, mostDoublings));
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
    reach = flight.radius + more + 2 * boxRounding * reach;
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
    if (!isFreeBall_[body] || contacts_.isIn(body))
        return false;
    const std::size_t first = world_.records[body].firstUnknown;
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
    flight.radius = world_.moving[body].shape().parts[0].radius;
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
    if (near_.cells.contains(body)) {
        window.exit = near_.cells.exitOf(body, window.flight, time);
        window.until = std::min(window.until, window.exit.time);
    } else {
        const double way = firstWay * world_.records[body].radius * doublings(window.number);
        const std::array<geometry::Vector, 3> path{
            geometry::Vector::Zero(), window.flight.velocityAt(time), window.flight.half};
        const std::size_t terms = window.flight.half.isZero(0) ? 2 : 3;
        window.until =
            std::min(window.until, time + timeForWay(std::span(path).first(terms), 1, way));
    }
    if (!near_.cells.contains(body) || !near_.partners(body).empty())
        boxFlight(body);
}

// Only partners need the box of a flight.
void EncounterSearch::boxFlight(std::size_t body) {
    Window& window = windows_[body];
    window.box = boxOf(window.flight, window.from, window.until, near_.slackOf(body));
}

void EncounterSearch::openWindow(const Histories& histories, std::size_t body, double time) {
    Window& window = windows_[body];
    ++window.number;
    window.from = time;
    world_.moving[body].forget();
    const bool isNew = !window.isFlight || time >= window.pieceEnd;
    if (isNew)
        window.isFlight = openFlight(histories, body, window);
    around_ = Around::all;
    const Crossing crossing = window.isFlight ? enterCell(body, time, isNew) : Crossing::nowhere;
    if (crossing != Crossing::nowhere) {
        if (crossing == Crossing::toOtherBlock)
            findPartners(body, near_.leafOfBlock(body));
        openFlightWindow(body, time);
        ends_.set(body, windows_[body].until);
        return;
    }
    if (near_.cells.contains(body))
        near_.cells.remove(body);
    if (window.isFlight) {
        openFlightWindow(body, time);
    } else {
        openPieceWindow(body, time);
    }
    ends_.set(body, windows_[body].until);
    enterTree(body);
}

// Of what is no flight: along one piece of its motion.
void EncounterSearch::openPieceWindow(std::size_t body, double time) {
    Window& window = windows_[body];
    const double way = firstWay * world_.records[body].radius * doublings(window.number);
    const collision::MotionPiece& piece = world_.moving[body].pieceAt(time);
    const double latest = time + firstSpan * doublings(window.number);
    const double end = piece.until > time ? std::min(piece.until, latest) : latest;
    const double longest =
        timeForWay(shifted(piece.position, (time - piece.from) / piece.scale), piece.scale, way);
    window.until = std::min(time + longest, end);
    window.box = collision::boundsDuring(world_.moving[body], time, window.until);
    grow(window.box, near_.slackOf(body));
}

EncounterSearch::Crossing EncounterSearch::enterCell(std::size_t body, double time, bool isNew) {
    Window& window = windows_[body];
    const int growth = std::max(0, (window.number - smallWindows + 2) / 2);
    if (!isNew && near_.cells.contains(body) && growth == window.growth &&
        time == window.exit.time) {
        around_ = Around::beyond;
        window.crossed = window.exit;
        return near_.cells.cross(body, window.exit);
    }
    if (!near_.cells.put(body, window.flight.centreAt(time), window.flight.radius, growth))
        return Crossing::nowhere;
    window.growth = growth;
    if (near_.tree.contains(body))
        near_.tree.remove(body);
    return Crossing::toOtherBlock;
}

void EncounterSearch::endBody(std::size_t body) {
    near_.leave(body);
    hits_.cut(body);
    ends_.set(body, infinity);
    windows_[body].isFlight = windows_[body].isFollowed = false;
    for (const std::size_t other : unclear_[body])
        std::erase(unclear_[other], body);
    unclear_[body].clear();
}

EncounterSearch::Renewal EncounterSearch::renew(const Histories& histories) {
    const std::size_t body = ends_.first();
    const double time = ends_.time();
    if (isOver(histories, body, time)) {
        endBody(body);
        return {.body = body, .ended = true};
    }
    openWindow(histories, body, time);
    searchAround(body, time);
    return {.body = body, .ended = false};
}

void EncounterSearch::stand(std::size_t body, double time) {
    Window& window = windows_[body];
    window.from = time;
    window.until = window.pieceEnd = infinity;
    window.box = collision::boundsDuring(world_.moving[body], time, time);
    grow(window.box, near_.slackOf(body));
    near_.tree.put(body, window.box);
    findPartners(body, window.box);
    for (const std::size_t other : near_.partners(body))
        search(std::minmax(body, other), time);
}

void EncounterSearch::searchAround(std::size_t body, double time, std::size_t but) {
    for (const std::size_t other : near_.partners(body))
        if (other != but)
            search(std::minmax(body, other), time);
    if (!near_.cells.contains(body))
        return;
    const auto look = [&](std::size_t other) {
        if (other != but)
            searchFlight(body, other, time);
    };
    if (around_ == Around::all) {
        // Who searched it just now has put itself there.
        if (!unclear_[body].empty())
            std::erase_if(unclear_[body], [&](std::size_t other) { return other != but; });
        std::ranges::for_each(near_.cells.near(body), look);
        return;
    }
    const std::vector<std::size_t> unclear = std::exchange(unclear_[body], {});
    near_.cells.forEachBeyond(body, windows_[body].crossed, look);
    std::ranges::for_each(unclear, look);
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

void EncounterSearch::goOn(const Pair& turned, double time) {
    const std::array<std::size_t, 2> two{turned.first, turned.second};
    for (const std::size_t body : two) {
        if (world_.records[body].isFixed)
            continue;
        Window& window = windows_[body];
        hits_.cut(body);
        world_.moving[body].forget();
        window.number = 0;
        window.from = time;
        const bool isInCell = near_.cells.contains(body);
        const bool stays = isInCell && window.growth == 0;
        const bool entered =
            stays || (isInCell && enterCell(body, time, true) != Crossing::nowhere);
        if (entered && !stays)
            findPartners(body, near_.leafOfBlock(body));
        openFlightWindow(body, time);
        ends_.set(body, windows_[body].until);
        if (!entered)
            enterTree(body);
    }
    around_ = Around::all;
    const bool areTwo =
        !world_.records[turned.first].isFixed && !world_.records[turned.second].isFixed;
    for (const std::size_t body : two)
        if (!world_.records[body].isFixed)
            searchAround(body, time, areTwo && body == turned.second ? turned.first : nobody);
}

void EncounterSearch::enterTree(std::size_t body) {
    if (near_.enterTree(body, windows_[body].box, windows_[body].isFlight))
        findPartners(body, near_.tree.box(body));
}

void EncounterSearch::findPartners(std::size_t body, const geometry::Box& leaf) {
    near_.findPartners(body, leaf, [this](std::size_t ball) {
        if (windows_[ball].isFlight)
            boxFlight(ball);
    });
}

} // namespace simulation
