#include "collision/ball_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace collision {
namespace {

using Set = std::set<std::size_t>;

struct Balls {
    std::mt19937_64 random{7};
    std::vector<BallFlight> flights;
    BallCells cells;

    explicit Balls(std::size_t count) : cells(count) {
        std::uniform_real_distribution<double> place(-1, 1), speed(-2, 2), size(-5, -2.5);
        for (std::size_t i = 0; i < count; ++i) {
            BallFlight& flight = flights.emplace_back();
            for (int k = 0; k < 3; ++k) {
                flight.place[k] = place(random);
                flight.velocity[k] = speed(random);
            }
            flight.half = {0, i % 2 == 0 ? -5.0 : 0, 0};
            flight.radius = std::exp2(size(random));
            EXPECT_TRUE(cells.put(i, flight.place, flight.radius, static_cast<int>(i % 3)));
        }
    }
    [[nodiscard]] Set near(std::size_t ball) const {
        Set found;
        cells.forEachNear(ball, [&](std::size_t other) { found.insert(other); });
        return found;
    }
    [[nodiscard]] bool touch(std::size_t a, std::size_t b, double time) const {
        return (flights[a].centreAt(time) - flights[b].centreAt(time)).norm() <=
               flights[a].radius + flights[b].radius;
    }
};

// The list that is kept is what a look tells, whoever asked before and whoever crossed since.
TEST(BallCells, KeepWhoIsNearUntilSomeBallMoves) {
    constexpr std::size_t count = 40;
    Balls b(count);
    std::vector<BallCells::Exit> exits;
    for (std::size_t i = 0; i < count; ++i)
        exits.push_back(b.cells.exitOf(i, b.flights[i], 0));
    for (std::size_t event = 0; event < 2000; ++event) {
        for (const std::size_t ball : {event % count, (7 * event + 3) % count, event % count}) {
            const std::vector<std::uint32_t>& list = b.cells.near(ball);
            EXPECT_EQ(Set(list.begin(), list.end()), b.near(ball));
        }
        const auto next = std::ranges::min_element(exits, {}, &BallCells::Exit::time);
        const auto ball = static_cast<std::size_t>(next - exits.begin());
        ASSERT_NE(b.cells.cross(ball, *next), BallCells::Crossing::nowhere);
        *next = b.cells.exitOf(ball, b.flights[ball], next->time);
    }
}

// Through many cells, in order of time: whoever touches a ball is near it, and whoever comes to be
// near it when it crosses lies beyond the face.
TEST(BallCells, KnowWhomABallTouches) {
    constexpr std::size_t count = 60;
    Balls b(count);
    std::vector<BallCells::Exit> exits;
    for (std::size_t i = 0; i < count; ++i)
        exits.push_back(b.cells.exitOf(i, b.flights[i], 0));
    std::size_t touches = 0;
    double time = 0;
    for (int event = 0; event < 3000; ++event) {
        const auto next = std::ranges::min_element(exits, {}, &BallCells::Exit::time);
        ASSERT_GE(next->time, time);
        const double middle = (time + next->time) / 2;
        const auto ball = static_cast<std::size_t>(next - exits.begin());
        const Set before = b.near(ball);
        for (std::size_t other = 0; other < count; ++other)
            if (other != ball && b.touch(ball, other, middle)) {
                ++touches;
                EXPECT_TRUE(before.contains(other)) << ball << " and " << other;
            }
        time = next->time;
        const BallCells::Exit crossed = *next;
        ASSERT_NE(b.cells.cross(ball, crossed), BallCells::Crossing::nowhere);
        Set seen = before;
        b.cells.forEachBeyond(ball, crossed, [&](std::size_t other) { seen.insert(other); });
        EXPECT_TRUE(std::ranges::includes(seen, b.near(ball)));
        EXPECT_FALSE(seen.contains(ball));
        *next = b.cells.exitOf(ball, b.flights[ball], time);
    }
    EXPECT_GT(touches, 30u);
}

// A ball is in its block, and a box that the ball comes into finds it.
TEST(BallCells, FindWhoComesIntoABox) {
    Balls b(200);
    for (int i = 0; i < 100; ++i)
        b.cells.remove(static_cast<std::size_t>(2 * i));
    std::uniform_real_distribution<double> place(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Vector corner(place(b.random), place(b.random), place(b.random));
        const geometry::Box box(corner, corner + Vector(0.3, 0.1, 0.2));
        Set found;
        b.cells.forEachIn(box, [&](std::size_t ball) { found.insert(ball); });
        for (std::size_t ball = 0; ball < 200; ++ball) {
            EXPECT_EQ(b.cells.contains(ball), ball % 2 == 1);
            if (ball % 2 == 0) {
                EXPECT_FALSE(found.contains(ball));
                continue;
            }
            EXPECT_TRUE(b.cells.block(ball).contains(b.flights[ball].place));
            EXPECT_TRUE(found.contains(ball) ||
                        box.exteriorDistance(b.flights[ball].place) > b.flights[ball].radius);
        }
    }
}

// Up and down through many blocks, on both sides of the origin.
TEST(BallCells, TellWhenABallComesIntoAnotherBlock) {
    BallCells cells(1);
    for (const bool isUp : {false, true}) {
        const double side = isUp ? -1 : 1;
        ASSERT_TRUE(cells.put(0, {0.5, side * 20.5, 0.5}, 0.4, 0)); // edge 1
        std::size_t blocks = 0;
        for (int i = 0; i < 40; ++i) {
            const geometry::Box before = cells.block(0);
            const auto crossing = cells.cross(0, {.time = 0, .axis = 1, .isUp = isUp});
            const bool isOther = !before.isApprox(cells.block(0));
            EXPECT_EQ(crossing == BallCells::Crossing::toOtherBlock, isOther) << i;
            blocks += isOther ? 1 : 0;
        }
        EXPECT_EQ(blocks, 10u);
    }
}

// A small ball passes a large one, cell by cell: it is told of it when it comes near, once.
TEST(BallCells, TellOfABallOfAnotherSizeOnce) {
    BallCells cells(2);
    ASSERT_TRUE(cells.put(0, {0.5, 0.5, 0.5}, 20, 0));
    ASSERT_TRUE(cells.put(1, {-200.5, 0.5, 0.5}, 0.4, 0));
    std::size_t told = 0;
    cells.forEachNear(1, [&](std::size_t) { ++told; });
    for (int i = 0; i < 400; ++i) {
        const BallCells::Exit exit{.time = 0, .axis = 0, .isUp = true};
        ASSERT_NE(cells.cross(1, exit), BallCells::Crossing::nowhere);
        cells.forEachBeyond(1, exit, [&](std::size_t) { ++told; });
    }
    EXPECT_EQ(told, 1u);
}

// Many balls, so that cells are counted through, and a box beyond the last of them.
TEST(BallCells, CountToTheEndOfTheirNumbers) {
    constexpr std::size_t count = 1000;
    BallCells cells(count);
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_TRUE(cells.put(i, {0.01 * static_cast<double>(i), 0, 0}, 1e-3, 0));
    for (const double far : {1e7, -1e7, 1e300}) {
        std::size_t found = 0;
        const Vector corner(far, far, far);
        cells.forEachIn({corner, corner + Vector::Ones()}, [&](std::size_t) { ++found; });
        EXPECT_EQ(found, 0u);
    }
}

TEST(BallCells, EndWhereTheirNumbersDo) {
    BallCells cells(1);
    EXPECT_FALSE(cells.put(0, {1e12, 0, 0}, 1e-3, 0));
    EXPECT_FALSE(cells.contains(0));
    EXPECT_TRUE(cells.put(0, {1e12, 0, 0}, 1e4, 0));
    EXPECT_TRUE(cells.contains(0));
}

// A ball that comes to a face and turns there stays on its side.
TEST(BallCells, LetABallTurnAtAFace) {
    BallCells cells(1);
    BallFlight flight;
    flight.radius = 0.4; // edge 1
    flight.place = {0.5, 0.5, 0.5};
    flight.velocity = {0, 1, 0};
    flight.half = {0, -0.5, 0}; // y = 0.5 + t - t^2 / 2 is 1 at its highest
    ASSERT_TRUE(cells.put(0, flight.place, flight.radius, 0));
    double time = 0;
    std::vector<bool> ways;
    for (int i = 0; i < 4; ++i) {
        const BallCells::Exit exit = cells.exitOf(0, flight, time);
        ASSERT_EQ(exit.axis, 1u);
        ASSERT_GE(exit.time, time);
        ways.push_back(exit.isUp);
        time = exit.time;
        ASSERT_NE(cells.cross(0, exit), BallCells::Crossing::nowhere);
    }
    EXPECT_EQ(ways.back(), false);
    EXPECT_GT(time, 2.4);
}

} // namespace
} // namespace collision
