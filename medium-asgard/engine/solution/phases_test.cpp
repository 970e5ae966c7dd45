// What holds a value for a while, jumps, and what ends a motion.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace solution;
using namespace solution::testing;

// ---------------------------------------------------------------------------------------------
// Phases

TEST(Phases, ATrajectoryTakesHoldAndLetsGo) {
    auto set = equationsOf({{"x", "dx", 0, 1}, {"dx", "0", 1}});
    addPhase(set, 0, 2, "2*t", "t^2"); // held: x jumps from 2 to 4
    addPhase(set, 1, 2, "2", "2*t");   // and its velocity with it
    addPhase(set, 0, 3, "dx");         // released: goes on
    addPhase(set, 1, 3, "0");
    const Solver solver = solved(std::move(set), 5);
    const Histories& h = solver.histories();
    EXPECT_NEAR(h.value(0, 1.5), 1.5, 1e-12);
    EXPECT_NEAR(h.pieceBefore(0, 2).value(2), 2, 1e-12);
    EXPECT_NEAR(h.value(0, 2), 4, 1e-12);
    EXPECT_NEAR(h.value(0, 2.5), 6.25, 1e-12);
    EXPECT_NEAR(h.value(0, 4), 9 + 6, 1e-12);
    EXPECT_EQ(h.restarts(0), (std::vector<double>{2, 3}));
    EXPECT_EQ(solver.statistics().steps, 0u);
}

TEST(Phases, AJumpIsAppliedAtItsTime) {
    auto set = equationsOf({{"x", "dx", 0, 1}, {"dx", "-x", 1}});
    addPhase(set, 1, 2, "-x", "", "-dx");
    const Solver solver = solved(std::move(set), 4, tolerance(1e-10));
    // Velocity reversed at t = 2: the motion runs backwards.
    EXPECT_NEAR(solver.histories().value(0, 3), std::sin(1), 1e-8);
    EXPECT_NEAR(solver.histories().value(0, 4), 0, 1e-8);
}

TEST(Phases, AHeldValueThatIsNoPolynomialIsFittedTightly) {
    auto set = equationsOf({{"x", "0", 0, 1}, {"y", "x", 0, 1}});
    set.unknowns[0].phases[0].given = expression::testing::parsed(set.graph, "sin(5*t)+exp(-t)");
    const Solver solver = solved(std::move(set), 10, tolerance(1e-9));
    EXPECT_LT(worst(solver.histories(), 0, 0, 10,
                    [](double t) { return std::sin(5 * t) + std::exp(-t); }),
              1e-11);
    EXPECT_LT(worst(solver.histories(), 1, 0, 10,
                    [](double t) { return (1 - std::cos(5 * t)) / 5 + 1 - std::exp(-t); }),
              1e-9);
}

TEST(Phases, AHeldValueMayReadStates) {
    auto set = equationsOf({{"x", "dx", 1, 1}, {"dx", "-x+0*h", 0}, {"h", "0", 0}});
    set.unknowns[2].phases[0].given = expression::testing::parsed(set.graph, "x*x+t");
    const Solver solver = solved(std::move(set), 10, tolerance(1e-10));
    EXPECT_LT(
        worst(solver.histories(), 2, 0, 10, [](double t) { return std::cos(t) * std::cos(t) + t; }),
        1e-8);
}

TEST(Phases, ValuesThatHoldEachOtherAreALoop) {
    auto set = equationsOf({{"x", "0", 0}, {"y", "0", 0}, {"z", "1", 0}});
    set.unknowns[0].phases[0].given = expression::testing::parsed(set.graph, "y+1");
    set.unknowns[1].phases[0].given = expression::testing::parsed(set.graph, "x+1");
    const Solver solver = solved(std::move(set), 1);
    ASSERT_NE(solver.histories().stop(0), nullptr);
    EXPECT_EQ(solver.histories().stop(0)->reason, Stop::Reason::algebraicLoop);
    EXPECT_EQ(solver.histories().stop(0)->sentence,
              "x, y are held by values that depend on each other in a circle");
    EXPECT_EQ(solver.histories().value(2, 1), 1);
}

// ---------------------------------------------------------------------------------------------
// Motion that ends

TEST(Stops, ARightHandSideThatIsNotFiniteIsNamedAndLocated) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                              {"dx", "sqrt(2-t)", 0},
                                              {"z", "dz", 0, 1},
                                              {"dz", "-z", 1},
                                              {"w", "x+1", 0}}),
                                 10, tolerance(1e-8));
    const Histories& h = solver.histories();
    ASSERT_NE(h.stop(1), nullptr);
    EXPECT_EQ(h.stop(1)->reason, Stop::Reason::notFinite);
    EXPECT_NEAR(h.stop(1)->time, 2, 1e-9);
    EXPECT_EQ(h.stop(1)->culprits, std::vector<std::size_t>{1});
    EXPECT_EQ(h.stop(1)->sentence, "dx has no finite rate");
    // What reads it ends with it; the others go on.
    ASSERT_NE(h.stop(0), nullptr);
    EXPECT_EQ(h.stop(0)->reason, Stop::Reason::inputEnded);
    EXPECT_EQ(h.stop(0)->sentence, "x reads dx, whose motion ended");
    EXPECT_NE(h.stop(4), nullptr);
    EXPECT_NEAR(h.value(1, 1), (std::pow(2, 1.5) - 1) * 2 / 3, 1e-7);
    EXPECT_EQ(h.stop(2), nullptr);
    EXPECT_NEAR(h.value(2, 10), std::sin(10), 1e-6);
    EXPECT_EQ(h.known(), 10);
}

TEST(Stops, ASwitchToNothingEndsAtTheSwitch) {
    const Solver solver = solved(equationsOf({{"x", "t<2?1:1/0", 0}, {"y", "y", 1}}), 5);
    ASSERT_NE(solver.histories().stop(0), nullptr);
    EXPECT_EQ(solver.histories().stop(0)->time, 2);
    EXPECT_EQ(solver.histories().value(0, 2), 2);
    EXPECT_EQ(solver.histories().stop(1), nullptr);
}

TEST(Stops, AnExplosionIsAnAnswer) {
    const Solver solver = solved(equationsOf({{"x", "x^2", 1}}), 5, tolerance(1e-8));
    ASSERT_NE(solver.histories().stop(0), nullptr);
    EXPECT_NEAR(solver.histories().stop(0)->time, 1, 1e-6);
}

TEST(Stops, TooManyStepsIsAnAnswer) {
    Options options = tolerance(1e-8);
    options.maximumSteps = 100;
    const Solver solver =
        solved(equationsOf({{"x", "v", 1}, {"v", "-1e8*sin(x)", 0}}), 10, options);
    ASSERT_NE(solver.histories().stop(0), nullptr);
    EXPECT_EQ(solver.histories().stop(0)->reason, Stop::Reason::tooManySteps);
    EXPECT_EQ(solver.statistics().steps, 101u);
}
