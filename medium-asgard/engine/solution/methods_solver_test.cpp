// Methods asked for by name, through the solver: which models are switched off, where steps end.
#include "integrators/methods.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

Options asked(const std::string& method, double tolerance, std::optional<double> step = {}) {
    Options options;
    options.method = method;
    options.tolerance = tolerance;
    options.fixedStep = step;
    return options;
}

expression::EquationSet swing() { return equationsOf({{"x", "dx", 1, 1}, {"dx", "-9*sin(x)", 0}}); }

} // namespace

// A ballistic coordinate is a closed form for `auto`; any other method takes its steps there too.
TEST(AskedFor, AMethodSwitchesTheLadderOff) {
    for (const std::string& method : methodNames()) {
        const Solver solver = solved(equationsOf({{"x", "dx", 2, 1}, {"dx", "-10", 3}}), 1,
                                     asked(method, 1e-6, 1.0 / 64));
        const Statistics statistics = solver.statistics();
        EXPECT_GE(statistics.steps, 2u * 64) << method;
        for (const ComponentStatistics& component : statistics.componentList)
            EXPECT_EQ(component.method, method);
    }
}

TEST(AskedFor, FixedStepsAreThatLongFromTheStart) {
    for (const std::string& method : methodNames()) {
        const Solver solver = solved(swing(), 1, asked(method, 1e-6, 1.0 / 128));
        double t = 0;
        std::size_t steps = 0;
        while (t < 1) {
            const double next = solver.histories().piece(0, t).until;
            ASSERT_EQ(next, t + 1.0 / 128) << method;
            t = next;
            ++steps;
        }
        EXPECT_EQ(steps, 128u) << method;
    }
}

// The branch of max() that holds has no value beyond x = 0: the last step ends there, and none goes
// far across. From there on the speed is kept.
TEST(AskedFor, FixedStepsEndWhereABranchHasNoValue) {
    const expression::EquationSet set =
        equationsOf({{"x", "dx", 1, 1}, {"dx", "-sqrt(max(0,x))", -1}});
    const double speed = solved(set, 4, tolerance(1e-10)).histories().value(1, 4);
    EXPECT_NEAR(speed, -std::sqrt(1 + 4.0 / 3), 1e-6);
    for (const std::string method : {"dop853", "tsit5", "rk4"}) {
        const Solver solver = solved(set, 4, asked(method, 1e-6, 0.05));
        ASSERT_EQ(solver.histories().stop(1), nullptr) << method;
        EXPECT_NEAR(solver.histories().value(1, 4), speed, 1e-3) << method;
    }
}

// A ball on an elastic table: where it lifts off, the branch of max() that held has no value any
// more, and a step may end beyond by less than counts.
TEST(AskedFor, NoMethodStopsWhereABranchHasNoValue) {
    const expression::EquationSet set =
        equationsOf({{"x", "dx", 1, 1}, {"dx", "-9.81+100000*max(0,-x)^1.5", 0}});
    for (const std::string& method : methodNames())
        for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6}) {
            const Solver solver = solved(set, 20, asked(method, accuracy));
            ASSERT_EQ(solver.histories().stop(1), nullptr) << method << ", " << accuracy;
        }
}

// The step before a phase is shortened, and steps are counted from there.
TEST(AskedFor, FixedStepsBeginAgainAtAnEvent) {
    for (const std::string& method : methodNames()) {
        expression::EquationSet set = swing();
        addPhase(set, 1, 0.3, "-9*sin(x)", "", "dx+1");
        const Solver solver = solved(std::move(set), 1, asked(method, 1e-6, 0.125));
        const auto until = [&](double t) { return solver.histories().piece(0, t).until; };
        EXPECT_EQ(until(0.26), 0.3) << method;
        EXPECT_EQ(until(0.31), 0.3 + 0.125) << method;
    }
}

// Adaptive: the error of the pendulum's half swing falls with the tolerance. The dissertation's
// rule knows no tolerance.
TEST(AskedFor, AdaptiveMethodsFollowTheTolerance) {
    const Solver exact = solved(swing(), 2, asked("dop853", 1e-13));
    for (const std::string& method : methodNames()) {
        if (method == "original")
            continue;
        const auto errorAt = [&](double tolerance) {
            const Solver solver = solved(swing(), 2, asked(method, tolerance));
            return std::abs(solver.histories().value(0, 2) - exact.histories().value(0, 2));
        };
        EXPECT_LT(errorAt(1e-4), 0.1) << method;
        EXPECT_LT(errorAt(1e-7), 2e-3) << method;
    }
}

// Explicit Euler beyond its limit: the run ends with the time at which it left all bounds.
TEST(AskedFor, ARunThatBlowsUpStopsWithTheTime) {
    const Solver solver =
        solved(equationsOf({{"x", "-100*x", 1, 1}}), 100, asked("forward-euler", 1e-6, 0.1));
    const auto stops = solver.histories().stops();
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_EQ(stops[0].reason, Stop::Reason::overflow);
    // |1 - 100 h|^n = 1e100
    EXPECT_NEAR(stops[0].time, 0.1 * 100 / std::log10(9), 0.2);
}
