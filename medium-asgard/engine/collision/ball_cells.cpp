#include "collision/ball_cells.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

constexpr double roomiest = 2.2;     // radii, in a cell's edge at least
constexpr double farthest = 1 << 30; // cells from the origin

// The first s >= 0 at which v s + h s^2 reaches `gap` from below; h is not 0.
double reach(double gap, double v, double h) {
    const double square = v * v + 4 * h * gap;
    if (square < 0 || (v <= 0 && h < 0))
        return HUGE_VAL;
    const double root = std::sqrt(square);
    return v > 0 ? 2 * gap / (v + root) : (root - v) / (2 * h);
}

std::int32_t cellAt(double coordinate, double edge) {
    // Whole blocks end before the last number, so that what counts through them ends, too.
    constexpr double last = 2 * farthest - 8;
    const double cell = std::clamp(coordinate / edge, -last, last);
    const auto towardsZero = static_cast<std::int32_t>(cell);
    return towardsZero - static_cast<std::int32_t>(cell < towardsZero);
}

} // namespace

std::uint32_t BallCells::levelOf(int exponent) {
    const auto found = std::ranges::find(levels_, exponent, &Level::exponent);
    if (found == levels_.end()) {
        levels_.push_back({.exponent = exponent,
                           .edge = std::ldexp(1, exponent),
                           .largest = 0,
                           .members = {},
                           .buckets = std::vector<std::uint32_t>(16, nothing)});
        return static_cast<std::uint32_t>(levels_.size() - 1);
    }
    return static_cast<std::uint32_t>(found - levels_.begin());
}

bool BallCells::put(std::size_t owner, const Vector& centre, double radius, int growth) {
    if (contains(owner))
        remove(owner);
    int exponent = 0;
    (void)std::frexp(roomiest * radius, &exponent);
    const double edge = std::ldexp(1, exponent + growth);
    if (!(centre.cwiseAbs().maxCoeff() < farthest * edge) || !(edge > 0) || !std::isfinite(edge))
        return false;
    Ball& ball = balls_[owner];
    ball.level = levelOf(exponent + growth);
    ball.radius = radius;
    for (std::size_t i = 0; i < 3; ++i)
        ball.place[i] = cellAt(centre[static_cast<Eigen::Index>(i)], edge);
    Level& level = levels_[ball.level];
    level.largest = level.members.empty() ? radius : std::max(level.largest, radius);
    ball.member = static_cast<std::uint32_t>(level.members.size());
    level.members.push_back(static_cast<std::uint32_t>(owner));
    ++members_;
    link(static_cast<std::uint32_t>(owner));
    if (8 * level.members.size() > level.buckets.size())
        rehash(level);
    return true;
}

void BallCells::remove(std::size_t owner) {
    unlink(static_cast<std::uint32_t>(owner));
    Ball& ball = balls_[owner];
    auto& members = levels_[ball.level].members;
    members[ball.member] = members.back();
    balls_[members.back()].member = ball.member;
    members.pop_back();
    ball.level = nothing;
    --members_;
}

void BallCells::link(std::uint32_t owner) {
    ++changes_;
    Ball& ball = balls_[owner];
    std::uint32_t& first = levels_[ball.level].buckets[bucketOf(levels_[ball.level], ball.place)];
    ball.previous = nothing;
    ball.next = first;
    if (first != nothing)
        balls_[first].previous = owner;
    first = owner;
}

void BallCells::unlink(std::uint32_t owner) {
    ++changes_;
    const Ball& ball = balls_[owner];
    if (ball.previous == nothing)
        levels_[ball.level].buckets[bucketOf(levels_[ball.level], ball.place)] = ball.next;
    else
        balls_[ball.previous].next = ball.next;
    if (ball.next != nothing)
        balls_[ball.next].previous = ball.previous;
}

void BallCells::rehash(Level& level) {
    level.buckets.assign(4 * level.buckets.size(), nothing);
    for (const std::uint32_t member : level.members)
        link(member);
}

geometry::Box BallCells::cellBefore(const Ball& ball, const Exit& exit) const {
    Ball before = ball;
    before.place[exit.axis] -= exit.isUp ? 1 : -1;
    return cell(before);
}

geometry::Box BallCells::cell(const Ball& ball) const {
    const double edge = levels_[ball.level].edge;
    const Vector low(ball.place[0], ball.place[1], ball.place[2]);
    return {edge * low, edge * (low + Vector::Ones())};
}

geometry::Box BallCells::block(std::size_t owner) const {
    const Ball& ball = balls_[owner];
    const double edge = levels_[ball.level].edge;
    const Range cells = blocksOf({ball.place, ball.place});
    const Vector low(cells.low[0], cells.low[1], cells.low[2]);
    return {edge * low, edge * (low + Vector::Constant(blockCells))};
}

BallCells::Range BallCells::rangeAbout(const geometry::Box& box, double more, const Level& level) {
    Range range;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        range.low[i] = cellAt(box.min()[axis] - more, level.edge);
        range.high[i] = cellAt(box.max()[axis] + more, level.edge);
    }
    return range;
}

// Of another level: whether it was so near before a crossing is not told by ranges, which have room
// to spare for the largest of a level, other room for each of the two.
bool BallCells::mayTouch(const geometry::Box& cellOfOne, double radius, const Ball& other) const {
    const double reach = radius + other.radius;
    return cellOfOne.squaredExteriorDistance(cell(other)) <= reach * reach;
}

BallCells::Range BallCells::rangeAround(const Ball& ball, const Level& level) const {
    if (&level != &levels_[ball.level])
        return rangeAbout(cell(ball), ball.radius + level.largest, level);
    const Place& p = ball.place;
    return {{p[0] - 1, p[1] - 1, p[2] - 1}, {p[0] + 1, p[1] + 1, p[2] + 1}};
}

BallCells::Exit BallCells::exitOf(std::size_t owner, const BallFlight& flight, double from) const {
    const Ball& ball = balls_[owner];
    const double edge = levels_[ball.level].edge;
    const Vector centre = flight.centreAt(from), velocity = flight.velocityAt(from);
    Exit exit{.time = HUGE_VAL};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const double low = edge * ball.place[i], v = velocity[axis], h = flight.half[axis];
        if (v == 0 && h == 0)
            continue;
        // Where rounding puts the ball outside, it is on the face that it came through.
        const double above = std::max(low + edge - centre[axis], 0.0);
        const double below = std::max(centre[axis] - low, 0.0);
        bool isUp = v > 0;
        double least = (isUp ? above : below) / std::abs(v);
        if (h != 0) {
            const double up = reach(above, v, h), down = reach(below, -v, -h);
            isUp = up < down;
            least = std::min(up, down);
        }
        if (least < exit.time)
            exit = {.time = least, .axis = i, .isUp = isUp};
    }
    exit.time += from;
    return exit;
}

BallCells::Crossing BallCells::cross(std::size_t owner, const Exit& exit) {
    Ball& ball = balls_[owner];
    std::int32_t& place = ball.place[exit.axis];
    if (std::abs(place) >= farthest) {
        remove(owner);
        return Crossing::nowhere;
    }
    unlink(static_cast<std::uint32_t>(owner));
    const std::int32_t from = place;
    place += exit.isUp ? 1 : -1;
    link(static_cast<std::uint32_t>(owner));
    return firstOfBlock(from) == firstOfBlock(place) ? Crossing::withinBlock
                                                     : Crossing::toOtherBlock;
}

} // namespace collision
