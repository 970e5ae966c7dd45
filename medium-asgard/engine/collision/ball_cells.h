// Finds the balls near a ball in flight. Each ball lies in the cell of a grid that holds its
// centre; every ball that it can meet while both stay in their cells lies in one of the cells
// around (Rapaport 1980).
//
// Cells are cubes with edges of powers of 2, by the ball's size: at least 2.2 radii, so that of
// balls of like size only the 27 cells about each other's count. A ball that flies far without
// turning may take larger cells (`growth`), so that the cells that it crosses grow in number like
// the logarithm of its way. Cells are found by hashing: space has no bounds, and empty cells cost
// nothing. A ball that crosses a face has new neighbours beyond it only; balls that were near
// before were asked about already.
#pragma once

#include "collision/ball_flight.h"

#include <array>
#include <cstdint>
#include <vector>

namespace collision {

class BallCells {
public:
    explicit BallCells(std::size_t owners) : balls_(owners) {}

    // False: too far out for its cells to be numbered; then it is in none.
    [[nodiscard]] bool put(std::size_t owner, const Vector& centre, double radius, int growth);
    void remove(std::size_t owner);
    [[nodiscard]] bool contains(std::size_t owner) const { return balls_[owner].level != nothing; }
    [[nodiscard]] bool empty() const { return members_ == 0; }
    [[nodiscard]] geometry::Box cell(std::size_t owner) const { return cell(balls_[owner]); }
    // The box that holds its cell and those about it that a ball crosses next: blocks, aligned too.
    [[nodiscard]] geometry::Box block(std::size_t owner) const;

    // When and through which face the ball leaves its cell; infinity: never.
    struct Exit {
        double time = 0;
        std::size_t axis = 0;
        bool isUp = false;
    };
    [[nodiscard]] Exit exitOf(std::size_t owner, const BallFlight& flight, double from) const;
    // Into the next cell, in the same block or another; or, as with put(), there is none.
    enum class Crossing { withinBlock, toOtherBlock, nowhere };
    [[nodiscard]] Crossing cross(std::size_t owner, const Exit& exit);

    // Other balls that it can meet while both stay in their cells, and some more.
    template <typename Visit> void forEachNear(std::size_t owner, Visit&& visit) const {
        const Ball& ball = balls_[owner];
        for (const Level& level : levels_)
            if (!level.members.empty())
                visitIn(level, rangeAround(ball, level), owner, visit);
    }
    // The same as a list, which holds until the next call for another ball's but one, or until any
    // ball changes its cell: an impact asks twice for two balls.
    [[nodiscard]] const std::vector<std::uint32_t>& near(std::size_t owner) {
        for (const Near& known : near_)
            if (known.owner == owner && known.changes == changes_)
                return known.balls;
        Near& made = near_[nextNear_];
        nextNear_ = 1 - nextNear_;
        made.owner = owner;
        made.changes = changes_;
        made.balls.clear();
        forEachNear(owner, [&](std::size_t ball) {
            made.balls.push_back(static_cast<std::uint32_t>(ball));
        });
        return made.balls;
    }
    // Of these, those that were not before it crossed.
    template <typename Visit>
    void forEachBeyond(std::size_t owner, const Exit& exit, Visit&& visit) const {
        const Ball& ball = balls_[owner];
        for (const Level& level : levels_) {
            if (level.members.empty())
                continue;
            Range range = rangeAround(ball, level);
            if (&level == &levels_[ball.level]) {
                (exit.isUp ? range.low : range.high)[exit.axis] =
                    (exit.isUp ? range.high : range.low)[exit.axis];
                visitIn(level, range, owner, visit);
                continue;
            }
            const geometry::Box before = cellBefore(ball, exit);
            visitIn(level, range, owner, [&](std::size_t other) {
                if (!mayTouch(before, ball.radius, balls_[other]))
                    visit(other);
            });
        }
    }
    // Balls that come into the box while they stay in their blocks, and some more.
    template <typename Visit> void forEachIn(const geometry::Box& box, Visit&& visit) const {
        for (const Level& level : levels_)
            if (!level.members.empty())
                visitIn(level, blocksOf(rangeAbout(box, level.largest, level)), balls_.size(),
                        visit);
    }

private:
    using Place = std::array<std::int32_t, 3>;
    static constexpr std::int32_t blockCells = 4; // along each edge
    static constexpr std::uint32_t nothing = ~std::uint32_t{0};
    struct Ball {
        std::uint32_t level = nothing, member = 0;        // its place among the level's members
        std::uint32_t next = nothing, previous = nothing; // in its bucket
        Place place{};
        double radius = 0;
    };
    struct Level {
        int exponent = 0;
        double edge = 1, largest = 0; // radius
        std::vector<std::uint32_t> members;
        std::vector<std::uint32_t> buckets; // the first of each; a power of 2 of them
    };
    struct Range { // of cells, both ends included
        Place low, high;
        [[nodiscard]] bool contains(const Place& p) const {
            return low[0] <= p[0] && p[0] <= high[0] && low[1] <= p[1] && p[1] <= high[1] &&
                   low[2] <= p[2] && p[2] <= high[2];
        }
        [[nodiscard]] double cells() const {
            return (1.0 + high[0] - low[0]) * (1.0 + high[1] - low[1]) * (1.0 + high[2] - low[2]);
        }
    };

    [[nodiscard]] static std::int32_t firstOfBlock(std::int32_t cell) {
        return cell & ~(blockCells - 1);
    }
    [[nodiscard]] static Range blocksOf(Range range) {
        for (std::size_t i = 0; i < 3; ++i) {
            range.low[i] = firstOfBlock(range.low[i]);
            range.high[i] |= blockCells - 1;
        }
        return range;
    }
    [[nodiscard]] static std::uint32_t mixed(std::int32_t x, std::int32_t y) {
        return static_cast<std::uint32_t>(x) * 73856093U ^
               static_cast<std::uint32_t>(y) * 19349663U;
    }
    [[nodiscard]] static std::uint32_t mixed(std::uint32_t row, std::int32_t z) {
        const std::uint32_t hash = row ^ static_cast<std::uint32_t>(z) * 83492791U;
        return hash ^ (hash >> 15U);
    }
    [[nodiscard]] static std::size_t bucketOf(const Level& level, const Place& place) {
        return mixed(mixed(place[0], place[1]), place[2]) & (level.buckets.size() - 1);
    }
    // Those of the cells in the range, or of all where that is less.
    template <typename Visit>
    void visitIn(const Level& level, const Range& range, std::size_t but, Visit&& visit) const {
        if (range.cells() >= static_cast<double>(level.members.size())) {
            for (const std::uint32_t ball : level.members)
                if (ball != but && range.contains(balls_[ball].place))
                    visit(static_cast<std::size_t>(ball));
            return;
        }
        const std::uint32_t* buckets = level.buckets.data();
        const auto mask = static_cast<std::uint32_t>(level.buckets.size() - 1);
        for (std::int32_t x = range.low[0]; x <= range.high[0]; ++x)
            for (std::int32_t y = range.low[1]; y <= range.high[1]; ++y) {
                const std::uint32_t row = mixed(x, y);
                for (std::int32_t z = range.low[2]; z <= range.high[2]; ++z)
                    for (std::uint32_t b = buckets[mixed(row, z) & mask]; b != nothing;
                         b = balls_[b].next) {
                        const Place& at = balls_[b].place;
                        if (at[0] == x && at[1] == y && at[2] == z && b != but)
                            visit(static_cast<std::size_t>(b));
                    }
            }
    }
    [[nodiscard]] Range rangeAround(const Ball& ball, const Level& level) const;
    [[nodiscard]] static Range rangeAbout(const geometry::Box& box, double more,
                                          const Level& level);
    [[nodiscard]] geometry::Box cell(const Ball& ball) const;
    [[nodiscard]] geometry::Box cellBefore(const Ball& ball, const Exit& exit) const;
    [[nodiscard]] bool mayTouch(const geometry::Box& cellOfOne, double radius,
                                const Ball& other) const;
    [[nodiscard]] std::uint32_t levelOf(int exponent);
    void link(std::uint32_t owner);
    void unlink(std::uint32_t owner);
    void rehash(Level& level);

    struct Near { // what near() answered
        std::size_t owner = ~std::size_t{0};
        std::uint64_t changes = 0;
        std::vector<std::uint32_t> balls;
    };
    std::array<Near, 2> near_;
    std::size_t nextNear_ = 0;
    std::uint64_t changes_ = 1; // of cells
    std::vector<Ball> balls_;   // by owner
    std::vector<Level> levels_;
    std::size_t members_ = 0;
};

} // namespace collision
