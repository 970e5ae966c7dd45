// The pace of steps and events, and what of it says that a finish is never reached.
#include "solution/pace.h"
#include "solution/solver_testing.h"
#include "stepping/work_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace solution;
using namespace solution::testing;

TEST(Pace, AnEvenOneGoesABillionFar) {
    const double far =
        farthestFinish(16'384, {.start = 0, .first = 25, .second = 50, .third = 75, .now = 100});
    EXPECT_NEAR(far, 100 + 1e9 / 16'384 * 100, 1e-3);
}

// Quarters that grow by 1 in 50 reach 1e6 in far less than a billion.
TEST(Pace, OneThatGrowsEvenlyGoesOnGrowing) {
    const double a = 1, b = 1.02, c = 1.02 * 1.02;
    EXPECT_GT(
        farthestFinish(
            16'384,
            {.start = 0, .first = 1, .second = 1 + a, .third = 1 + a + b, .now = 1 + a + b + c}),
        1e30);
}

// What note() marks: powers of 2, and 3/4 of them.
TEST(Pace, ABurstThatIsOverIsNone) {
    EXPECT_GT(farthestFinish(16'384, {.start = 0, .first = 1, .second = 2, .third = 3, .now = 1e6}),
              1e9);
}

namespace {

constexpr std::size_t patience = 524'288;
const std::vector<std::size_t> ball = {0, 1, 2}, other = {7, 8};

} // namespace

TEST(EventPaces, TellHowManyEventsAreButOneMore) {
    EventPaces::Island island;
    EXPECT_EQ(island.plainAhead(), patience - 1);
    island.events = patience - 1;
    EXPECT_EQ(island.plainAhead(), 0u);
    island.events = patience;
    EXPECT_EQ(island.plainAhead(), patience - 1);
    island.events = 3 * patience;
    EXPECT_EQ(island.plainAhead(), patience - 1);
}

TEST(EventPaces, CountEachIslandByItself) {
    EventPaces paces(0);
    for (std::size_t n = 1; n < patience; ++n) {
        paces.note(1e-3 * static_cast<double>(n), ball);
        if (n % 1024 == 0)
            paces.note(1e-3 * static_cast<double>(n), other);
    }
    const double now = 1e-3 * patience;
    EXPECT_NEAR(paces.hopelessFrom(now, ball), now + 1e6, 1);
    EXPECT_EQ(paces.hopelessFrom(now, other), std::numeric_limits<double>::infinity());
    EXPECT_EQ(paces.islandOf(1), ball);
    EXPECT_EQ(paces.beyond(), std::numeric_limits<double>::infinity());
    paces.note(now, ball);
    EXPECT_NEAR(paces.beyond(), now + 1e6, 1);
}

// Two paces that were not one say nothing of what follows.
TEST(EventPaces, MeetingBeginsAnew) {
    EventPaces paces(0);
    for (std::size_t n = 1; n < patience; ++n)
        paces.note(1e-3 * static_cast<double>(n), n % 2 == 0 ? ball : other);
    paces.note(1e-3 * patience, std::vector<std::size_t>{2, 7});
    EXPECT_EQ(paces.beyond(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(paces.islandOf(0), (std::vector<std::size_t>{0, 1, 2, 7, 8}));
}

TEST(EventPaces, CountAtOneInstantByIslandToo) {
    EventPaces paces(0);
    const std::vector<std::size_t> nobody, between = {2, 7};
    for (const std::vector<std::size_t>* unknowns : {&ball, &ball, &other, &nobody})
        paces.note(1, *unknowns);
    EXPECT_EQ(paces.atOnce(1, ball), 2u);
    EXPECT_EQ(paces.atOnce(1, between), 2u);
    EXPECT_EQ(paces.atOnce(1, nobody), 1u);
    paces.note(1, between);
    EXPECT_EQ(paces.atOnce(1, other), 4u);
    paces.note(2, other);
    EXPECT_EQ(paces.atOnce(2, ball), 1u);
    EXPECT_EQ(paces.atOnce(3, ball), 0u);
}

// A hundred thousand short steps, and then none.
TEST(Pace, ABurstBeforeASwitchIsNotTakenForIt) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "t<0.1 ? 1e6*sin(1e6*t)-x : -x-0.1*dx", 0}}),
               1e5, tolerance(1e-4));
    EXPECT_EQ(solver.histories().stop(0), nullptr);
    EXPECT_GT(solver.statistics().integratedSteps, 16'384u);
}
