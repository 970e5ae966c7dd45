// A motion that would need more memory than it may have ends at a time that follows from the motion
// alone.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

namespace {

using namespace solution;
using namespace solution::testing;

// One of them needs some thousand times the steps of the others.
expression::EquationSet fastAndSlow() {
    return equationsOf({{"x", "dx", 0, 1},
                        {"dx", "sin(1e6*t)", 0},
                        {"y", "dy", 1, 1},
                        {"dy", "-y^3", 0},
                        {"z", "dz", 1, 1},
                        {"dz", "-100*z^3", 0}});
}

Options holding(std::size_t bytes) {
    Options options = tolerance(1e-8);
    options.mostBytes = bytes;
    return options;
}

double endOf(const Solver& solver) {
    const Histories& histories = solver.histories();
    EXPECT_FALSE(histories.stops().empty());
    for (const solution::Stop& stop : histories.stops()) {
        EXPECT_EQ(stop.reason, solution::Stop::Reason::tooMuchKept);
        EXPECT_EQ(stop.time, histories.stops()[0].time);
    }
    return histories.stops().empty() ? 0 : histories.stops()[0].time;
}

TEST(KeptBytes, EndAMotionAtOneTimeWhoeverWatches) {
    const Solver alone = solved(fastAndSlow(), 10, holding(300'000));
    const double end = endOf(alone);
    EXPECT_GT(end, 1e-4);
    EXPECT_LT(end, 0.1);
    EXPECT_LE(alone.statistics().historyBytes, 375'000u);
    EXPECT_GE(alone.statistics().historyBytes, 250'000u);

    Options watched = holding(300'000);
    watched.progress = [](double) {};
    watched.threads = 3;
    EXPECT_EQ(endOf(solved(fastAndSlow(), 10, watched)), end);
    EXPECT_EQ(endOf(solved(fastAndSlow(), 1, watched)), end);
    EXPECT_EQ(endOf(solved(fastAndSlow(), 0.1, holding(300'000))), end);
    const Solver more = solved(fastAndSlow(), 10, holding(600'000));
    EXPECT_GT(endOf(more), 1.5 * end);
    EXPECT_EQ(alone.histories().stop(2), nullptr) << "what needs little goes on";
    EXPECT_GE(alone.histories().reached(4), 10);
    for (const double t : {0.3 * end, 0.99 * end}) // what is known is the same
        EXPECT_EQ(alone.histories().value(0, t), more.histories().value(0, t));
}

TEST(KeptBytes, LeaveAMotionAsItIsThatNeedsLess) {
    const auto set = [] {
        return equationsOf(
            {{"y", "dy", 1, 1}, {"dy", "-y^3", 0}, {"z", "dz", 1, 1}, {"dz", "-z^3", 0}});
    };
    const Solver free = solved(set(), 50);
    const std::size_t kept = free.statistics().keptBytes;
    EXPECT_GE(kept, free.statistics().historyBytes);
    Options options;
    options.mostBytes = kept;
    const Solver bound = solved(set(), 50, options);
    EXPECT_TRUE(bound.histories().stops().empty());
    EXPECT_EQ(bound.statistics().steps, free.statistics().steps);
    EXPECT_EQ(bound.histories().value(0, 43), free.histories().value(0, 43));
}

// What goes ahead of others is not much more than the limit while others catch up.
TEST(KeptBytes, AreNeverFarBeyondTheLimit) {
    std::vector<Line> lines;
    for (int i = 0; i < 12; ++i) {
        const std::string x = "x" + std::to_string(i), v = "v" + std::to_string(i);
        lines.push_back({x, v, 1, 1});
        lines.push_back({v, "-" + std::to_string(100 << i) + "*" + x + "^3", 0});
    }
    Options options = holding(400'000);
    Solver solver(equationsOf(lines), options);
    std::size_t most = 0;
    options.progress = [&](double) { most = std::max(most, solver.statistics().historyBytes); };
    solver = Solver(equationsOf(lines), options);
    (void)solver.advanceTo(100);
    EXPECT_GT(most, 100'000u);
    EXPECT_LT(most, 1'000'000u);
    EXPECT_LE(solver.statistics().keptBytes, 610'000u);
    EXPECT_FALSE(solver.histories().stops().empty());
}

} // namespace
