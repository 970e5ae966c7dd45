// Whole runs of small equation sets: accuracy, models, work.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <thread>

using namespace solution;
using namespace solution::testing;

TEST(Solver, FollowsAnExponential) {
    const Solver solver = solved(equationsOf({{"y", "-y", 1}}), 5, tolerance(1e-10));
    EXPECT_LT(worst(solver.histories(), 0, 0, 5, [](double t) { return std::exp(-t); }), 1e-9);
}

// A ballistic coordinate is a polynomial: exact, in no step.
TEST(Solver, ABallisticCoordinateTakesNoStep) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 2, 1}, {"dx", "-9.81", 3}}), 1000, tolerance(1e-4));
    EXPECT_NEAR(solver.histories().value(0, 1000), 2 + 3e3 - 9.81e6 / 2, 1e-9);
    EXPECT_NEAR(solver.histories().derivative(0, 7), 3 - 9.81 * 7, 1e-12);
    EXPECT_EQ(solver.statistics().steps, 0u);
    EXPECT_EQ(solver.statistics().componentList[0].model, "closed-form");
    EXPECT_EQ(solver.statistics().componentList[1].model, "closed-form");
    EXPECT_EQ(solver.histories().reached(0), infinity);
}

// Drag, a damped oscillator about a point that is not 0, and an attitude at a constant rate: exact,
// in some pieces for each time constant and without a step.
TEST(Solver, LinearMotionTakesNoSteps) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                              {"dx", "-2*dx", 3},
                                              {"u", "du", 1, 1},
                                              {"du", "-25*(u-0.5)-2*du", -0.5},
                                              {"w", "0", 3},
                                              {"q0", "-0.5*w*q3", 1},
                                              {"q3", "0.5*w*q0", 0}}),
                                 100, tolerance(1e-4));
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.integratedSteps, 0u);
    EXPECT_EQ(statistics.componentList[0].model, "linear");
    const double w = std::sqrt(24.0);
    const auto oscillation = [w](double t) { return 0.5 + 0.5 * std::exp(-t) * std::cos(w * t); };
    const auto drag = [](double t) { return 1.5 * (1 - std::exp(-2 * t)); };
    EXPECT_LT(worst(solver.histories(), 0, 0, 100, drag), 1e-12);
    EXPECT_LT(worst(solver.histories(), 2, 0, 100, oscillation), 1e-12);
    EXPECT_LT(worst(solver.histories(), 5, 0, 100, [](double t) { return std::cos(1.5 * t); }),
              1e-11);
    // What decayed is one piece after the other, each twice as long.
    EXPECT_LT(statistics.evaluations, 2000u);
}

// One look is enough for ever at rates that are all 0 and read neither time nor other components.
TEST(Solver, WhatRestsTakesNoStep) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "1-x*x*x", 0}}), 1000, tolerance(1e-4));
    EXPECT_EQ(solver.histories().value(0, 1000), 1);
    EXPECT_EQ(solver.histories().reached(0), infinity);
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.steps, 0u);
    EXPECT_EQ(statistics.evaluations, 1u);
    EXPECT_EQ(statistics.componentList[0].model, "closed-form");
    EXPECT_EQ(statistics.integrated.size(), 2u); // at another tolerance it may move
}

TEST(Solver, RestEndsWithItsPhase) {
    auto set = equationsOf({{"x", "dx", 1, 1}, {"dx", "1-x*x*x", 0}});
    addPhase(set, 1, 2, "-x*x*x", "", "3");
    const Solver solver = solved(std::move(set), 3, tolerance(1e-6));
    EXPECT_EQ(solver.histories().value(0, 2), 1);
    EXPECT_NEAR(solver.histories().value(0, 2.01), 1.03, 1e-4);
}

// At the start they are 0 here, too.
TEST(Solver, RatesThatReadTimeOrOthersDoNotRest) {
    const Solver timed =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "1-x*x*x+sin(t)", 0}}), 1, tolerance(1e-6));
    EXPECT_GT(timed.histories().value(0, 1), 1.05);
    const Solver reading =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "u-x*x*x", 0}, {"u", "u*u", 1}}), 0.5,
               tolerance(1e-6));
    EXPECT_GT(reading.histories().value(0, 0.5), 1.01);
}

// A velocity that is not linear is integrated; its position follows from it without a step.
TEST(Solver, APositionFollowsItsVelocityExactly) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-2*dx^2", 3}}), 4, tolerance(1e-10));
    const Statistics statistics = solver.statistics();
    ASSERT_EQ(statistics.componentList.size(), 2u);
    EXPECT_EQ(statistics.componentList[0].model, "explicit");
    EXPECT_EQ(statistics.componentList[1].model, "closed-form");
    EXPECT_LT(worst(solver.histories(), 0, 0, 4, [](double t) { return 0.5 * std::log1p(6 * t); }),
              1e-8);
}

// In seconds and metres its numbers are 14 powers of 10 apart: it is balanced first.
TEST(Solver, StiffLinearMotionIsExactToo) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "-1e14*x-2e7*dx", 0}}), 10, tolerance(1e-6));
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.componentList[0].model, "linear");
    EXPECT_LT(statistics.evaluations, 200u);
    const auto exact = [](double t) { return (1 + 1e7 * t) * std::exp(-1e7 * t); };
    EXPECT_LT(worst(solver.histories(), 0, 0, 5e-6, exact), 1e-12);
    EXPECT_NEAR(solver.histories().value(0, 10), 0, 1e-12);
}

// A gram on a ton: what is fast is gone after a millionth of a second, and twenty doublings of what
// leads through that must not round away how slowly the other moves.
TEST(Solver, WhatMovesSlowlyBesideAStiffEndHasLongPieces) {
    const std::string pull = "(1e4*(a-b)+6324.555320336759*(da-db))";
    const Solver solver = solved(equationsOf({{"a", "da", 1, 1},
                                              {"da", "-1000*" + pull, 0},
                                              {"b", "db", 0, 1},
                                              {"db", "0.001*" + pull, 0}}),
                                 1, tolerance(1e-6));
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.componentList[0].model, "linear");
    EXPECT_EQ(statistics.integratedSteps, 0u);
    EXPECT_LT(statistics.evaluations, 300u);
    // a - b = (l1 exp(l2 t) - l2 exp(l1 t)) / (l1 - l2), of s^2 + 2 d s + w^2 = 0.
    const double mass = 1000.001, d = 0.5 * mass * 6324.555320336759, w2 = mass * 1e4;
    const double fast = -d - std::sqrt(d * d - w2), slow = w2 / fast;
    const auto apart = [&](double t) {
        return (fast * std::exp(slow * t) - slow * std::exp(fast * t)) / (fast - slow);
    };
    for (const double t : {1e-6, 1e-3, 0.1, 0.5, 1.0}) {
        const double found = solver.histories().value(0, t) - solver.histories().value(2, t);
        EXPECT_NEAR(found, apart(t), 1e-12) << t;
    }
}

// Hardly damped, and moved by no more than what a step may err by: a method strides over it.
TEST(Solver, LinearMotionThatDoesNotShowIsIntegrated) {
    Options options = tolerance(1e-6);
    options.extents = {1, 1};
    const Solver solver = solved(equationsOf({{"x", "dx", 1e-9, 1}, {"dx", "-1e12*x-1e3*dx", 0}}),
                                 1, std::move(options));
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.componentList[0].model, "implicit");
    EXPECT_LT(statistics.evaluations, 20'000u); // for a million periods
    EXPECT_NEAR(solver.histories().value(0, 1), 0, 1e-6);
}

// What trembles below the tolerance moves who reads it in resonance: z = -5e-9 (t sin wt - ...).
TEST(Solver, LinearMotionThatIsReadStaysExactWhetherItShowsOrNot) {
    Options options = tolerance(1e-5);
    options.extents = {1, 1, 1, 1};
    const Solver solver = solved(equationsOf({{"x", "dx", 1e-7, 1},
                                              {"dx", "-1e6*x", 0},
                                              {"z", "dz", 0, 1},
                                              {"dz", "-1e6*z+1e7*x+0*sin(z)", 0}}),
                                 50, std::move(options));
    // z'' + w^2 z = k cos(wt) from rest: z = k t sin(wt)/(2 w), of 2.5e-2 here.
    for (const double t : {10.0, 30.0, 50.0})
        EXPECT_NEAR(solver.histories().value(2, t), 1e7 * 1e-7 * t * std::sin(1000 * t) / 2000,
                    1e-2 * t / 2000)
            << t;
    EXPECT_NEAR(solver.histories().value(0, 50), 1e-7 * std::cos(50'000), 1e-12);
}

// Four million pieces, whose ends are rounded: the phase stays.
TEST(Solver, LinearMotionDoesNotDriftOverLongTimes) {
    const double finish = 1e6;
    const Solver solver =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "-x", 0}}), finish, tolerance(1e-6));
    EXPECT_NEAR(solver.histories().value(0, finish), std::cos(finish), 2e-8);
    EXPECT_NEAR(solver.histories().value(1, finish), -std::sin(finish), 2e-8);
}

// --- held values ------------------------------------------------------------------------------

// No error is estimated of them; so there is none but rounding, at any accuracy.
TEST(Solver, HeldValuesAloneFitToRounding) {
    for (const double accuracy : {1e-2, 1e-6}) {
        expression::EquationSet set = equationsOf({{"x", "0", 0, 1}});
        set.unknowns[0].phases[0].given =
            expression::testing::parsed(set.graph, "sin(5*t)+exp(-t)");
        const Solver solver = solved(set, 10, tolerance(accuracy));
        const auto exact = [](double t) { return std::sin(5 * t) + std::exp(-t); };
        EXPECT_LT(worst(solver.histories(), 0, 0, 10, exact), 1e-12) << accuracy;
        EXPECT_LT(solver.statistics().steps, 200u);
    }
}

// At 1000 s each unit in the last place of time is 1e-7 of a turn: no polynomial fits what that
// makes of the sine, and the motion goes on all the same.
TEST(Solver, HeldValuesThatRoundingRoughensAreFollowedNonetheless) {
    for (const std::string text : {"sin(1e6*t)", "sin(1e6*t+1e9)"}) {
        Options options = tolerance(1e-4);
        options.start = 1000;
        expression::EquationSet set = equationsOf({{"x", "0", 0, 1}});
        set.unknowns[0].phases[0].given = expression::testing::parsed(set.graph, text);
        const Solver solver = solved(set, 1000.0001, std::move(options));
        EXPECT_TRUE(solver.histories().stops().empty()) << text;
        EXPECT_LT(solver.statistics().steps, 1000u) << text;
    }
}

// --- motion of an earlier run -----------------------------------------------------------------

namespace {

struct TwoPendulums {
    std::shared_ptr<const PreparedEquations> prepared = std::make_shared<const PreparedEquations>(
        std::make_shared<const expression::EquationSet>(equationsOf({{"x", "dx", 1, 1},
                                                                     {"dx", "-9*sin(x)", 0},
                                                                     {"u", "du", 1, 1},
                                                                     {"du", "-4*sin(u)", 0}})),
        preparationFor({}));
    Options options;
    EventSource* source = nullptr;
    Advance advance;

    Solver run(double first, double second) {
        options.tolerances = {first, first, second, second};
        Solver solver(prepared, options, source);
        advance = solver.advanceTo(10);
        return solver;
    }
    void takeFirstFrom(const Solver& solver) {
        options.taken = std::make_shared<const TakenMotion>(
            TakenMotion{.histories = solver.snapshot(),
                        .unknowns = {true, true, false, false},
                        .components = solver.statistics().componentList});
    }
};

class KickAt final : public EventSource {
public:
    explicit KickAt(std::size_t unknown) : unknown_(unknown) {}
    std::optional<Event> next(const Histories&, double known) override {
        if (known < 3 || done_)
            return std::nullopt;
        done_ = true;
        return Event{.time = 3, .touched = {unknown_}, .tag = 0};
    }
    void apply(const Histories&, const Event&, EquationsInForce&, Changes& changes) override {
        changes.jumps.push_back({unknown_, 1});
    }

private:
    std::size_t unknown_;
    bool done_ = false;
};

} // namespace

TEST(TakenMotion, IsWhatSolvingItAgainGives) {
    TwoPendulums pendulums;
    const Solver loose = pendulums.run(1e-6, 1e-6), tight = pendulums.run(1e-6, 1e-9);
    pendulums.takeFirstFrom(loose);
    const Solver taking = pendulums.run(1e-6, 1e-9);
    const Statistics all = tight.statistics(), some = taking.statistics();
    for (std::size_t u = 0; u < 4; ++u)
        for (double t = 0; t <= 10; t += 0.01)
            ASSERT_EQ(taking.histories().value(u, t), tight.histories().value(u, t)) << u;
    ASSERT_EQ(some.componentList.size(), 2u);
    EXPECT_EQ(some.integratedSteps, all.integratedSteps);
    EXPECT_EQ(some.evaluations + some.componentList[0].evaluations, all.evaluations);
    EXPECT_EQ(some.historyBytes, all.historyBytes);
}

TEST(TakenMotion, EventsElsewhereLeaveItAndOneOnItDisturbsIt) {
    TwoPendulums pendulums;
    const Solver loose = pendulums.run(1e-6, 1e-6);
    pendulums.takeFirstFrom(loose);
    KickAt onOther(3), onTaken(1);
    pendulums.source = &onOther;
    const Solver left = pendulums.run(1e-6, 1e-6);
    EXPECT_FALSE(pendulums.advance.disturbed);
    EXPECT_EQ(pendulums.advance.reached, 10);
    EXPECT_EQ(left.histories().value(3, 3), 1);
    pendulums.source = &onTaken;
    (void)pendulums.run(1e-6, 1e-6);
    EXPECT_TRUE(pendulums.advance.disturbed);
}

TEST(Solver, AFunctionOfTimeIsQuadrature) {
    const Solver solver =
        solved(equationsOf({{"dx", "cos(3*t)", 0}, {"x", "dx", 1, 1}}), 10, tolerance(1e-10));
    EXPECT_EQ(solver.statistics().componentList[0].model, "quadrature");
    EXPECT_LT(
        worst(solver.histories(), 1, 0, 10, [](double t) { return 1 + (1 - std::cos(3 * t)) / 9; }),
        1e-9);
}

// Kepler's orbit with eccentricity 0.9 from its pericentre: x = cos E - e, y = sqrt(1-e^2) sin E,
// t = E - e sin E.
TEST(Solver, FollowsKeplersOrbitBetweenItsSteps) {
    const auto set = [] {
        return equationsOf({{"x", "dx", 0.1, 1},
                            {"y", "dy", 0, 1},
                            {"dx", "-x/(x^2+y^2)^1.5", 0},
                            {"dy", "-y/(x^2+y^2)^1.5", std::sqrt(1.9 / 0.1)}});
    };
    const Solver solver = solved(set(), 2 * std::numbers::pi, tolerance(1e-12));
    double largest = 0;
    for (int k = 0; k <= 500; ++k) {
        const double anomaly = 2 * std::numbers::pi * k / 500, e = 0.9;
        const double t = anomaly - e * std::sin(anomaly);
        largest = std::max(
            {largest, std::abs(solver.histories().value(0, t) - (std::cos(anomaly) - e)),
             std::abs(solver.histories().value(1, t) - std::sqrt(1 - e * e) * std::sin(anomaly))});
    }
    EXPECT_LT(largest, 1e-9); // the problem amplifies errors by 2e5 in an orbit
    EXPECT_LT(solver.statistics().steps, 200u);
}

TEST(Solver, TakesRadauWhereStabilityBoundsTheStepAndGoesBack) {
    // Stiff for t < 5, then not: the fast decay is switched off smoothly.
    const Solver solver =
        solved(equationsOf({{"y", "-1e5*(y-cos(t))/(1+exp(20*(t-5)))-0.1*y+cos(30*t)", 1},
                            {"z", "cos(y*t)*z", 1}}),
               10, tolerance(1e-6));
    const Statistics statistics = solver.statistics();
    EXPECT_EQ(statistics.componentList[0].method, "dop853");
    EXPECT_GT(statistics.componentList[0].factorisations, 10u);
    EXPECT_LT(statistics.componentList[0].evaluations, 20000u);
}

TEST(Solver, AStiffSpringIsNoBurden) {
    for (const double k : {1e8, 1e10, 1e12}) {
        const std::string c = std::to_string(2 * std::sqrt(k));
        const Solver solver = solved(
            equationsOf(
                {{"x", "dx", 0, 1},
                 {"dx", "-" + std::to_string(k) + "*(x-0.1*sin(t))-" + c + "*(dx-0.1*cos(t))",
                  0.1}}),
            10, tolerance(1e-8));
        EXPECT_LT(worst(solver.histories(), 0, 0, 10, [](double t) { return 0.1 * std::sin(t); }),
                  1e-6)
            << k;
        EXPECT_LT(solver.statistics().evaluations, 30000u) << k;
    }
}

// An unrelated component costs only itself, and a slow pendulum is not stepped at a fast one's
// rate.
TEST(Solver, ComponentsKeepTheirOwnPace) {
    const std::vector<Line> slow = {{"x", "dx", 2, 1}, {"dx", "-9.81*sin(x)", 0}};
    std::vector<Line> both = slow;
    both.push_back({"y", "dy", 2, 1});
    both.push_back({"dy", "-9.81e6*sin(y)", 0});
    const Solver alone = solved(equationsOf(slow), 1, tolerance(1e-6));
    const Solver together = solved(equationsOf(both), 1, tolerance(1e-6));
    const auto list = together.statistics().componentList;
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].steps, alone.statistics().steps);
    EXPECT_EQ(list[0].evaluations, alone.statistics().evaluations);
    EXPECT_GT(list[1].steps, 100 * list[0].steps);
    for (int k = 0; k <= 100; ++k)
        EXPECT_EQ(together.histories().value(0, k / 100.0), alone.histories().value(0, k / 100.0));

    Options whole = tolerance(1e-6);
    whole.whole = true;
    const Solver joined = solved(equationsOf(both), 1, whole);
    EXPECT_EQ(joined.statistics().components, 1u);
    EXPECT_NEAR(joined.histories().value(0, 1), alone.histories().value(0, 1), 1e-4);
}

TEST(Solver, AReaderSeesADifferenceBetweenStepsOnlyToTheTolerance) {
    // y' = x with x an oscillator of its own: y = 1 - cos t.
    const Solver solver = solved(
        equationsOf(
            {{"x", "v", 0}, {"v", "-x", 1}, {"y", "x*1.0*cos(0)+0*t", 0}, {"z", "sin(x)", 0}}),
        20, tolerance(1e-9));
    EXPECT_LT(worst(solver.histories(), 2, 0, 20, [](double t) { return 1 - std::cos(t); }), 1e-6);
}

// Steps do not depend on where the run is told to stop, nor on how often it is resumed.
TEST(Solver, TheFinishChangesNoBit) {
    const std::vector<Line> lines = {{"x", "dx", 1, 1},
                                     {"dx", "-x-x^3", 0},
                                     {"y", "dy", 0, 1},
                                     {"dy", "sin(x*t)-y", 0},
                                     {"s", "sin(t)*y", 0}};
    const Solver full = solved(equationsOf(lines), 20);
    Solver pieces(equationsOf(lines), {});
    for (int k = 1; k <= 57; ++k)
        ASSERT_FALSE(pieces.advanceTo(20.0 * k / 57).cancelled);
    const Solver shorter = solved(equationsOf(lines), 3.3);
    for (std::size_t u = 0; u < 5; ++u)
        for (int k = 0; k <= 200; ++k) {
            EXPECT_EQ(full.histories().value(u, k / 10.0), pieces.histories().value(u, k / 10.0));
            if (k <= 33) {
                EXPECT_EQ(full.histories().value(u, k / 10.0),
                          shorter.histories().value(u, k / 10.0));
            }
        }
}

TEST(Solver, CanBeCancelledAndKeepsWhatItHas) {
    int polls = 0;
    Options options;
    options.cancelled = [&] { return ++polls > 20; };
    Solver solver(equationsOf({{"x", "dx", 1, 1}, {"dx", "-1e6*x", 0}}), options);
    const Advance advance = solver.advanceTo(10);
    EXPECT_TRUE(advance.cancelled);
    EXPECT_GT(advance.reached, 0);
    EXPECT_LT(advance.reached, 10);
}

TEST(Solver, SnapshotsNeverChange) {
    Solver solver(equationsOf({{"x", "dx", 1, 1}, {"dx", "-x", 0}}), {});
    ASSERT_FALSE(solver.advanceTo(3).cancelled);
    const auto early = solver.snapshot();
    const double reached = early->reached(0), value = early->value(0, 2.5);
    ASSERT_FALSE(solver.advanceTo(300).cancelled);
    EXPECT_EQ(early->reached(0), reached);
    EXPECT_EQ(early->value(0, 2.5), value);
    EXPECT_EQ(solver.histories().value(0, 2.5), value);
    EXPECT_GT(solver.snapshot()->reached(0), 299);
}

// A renderer reads what was published while the solver goes on.
TEST(Solver, SnapshotsAreReadByAnotherThreadWhileComputing) {
    std::mutex mutex;
    std::shared_ptr<const Histories> published;
    std::atomic<bool> done = false;
    Options options;
    Solver* running = nullptr;
    options.progress = [&](double) {
        const std::lock_guard lock(mutex);
        published = running->snapshot();
    };
    Solver solver(equationsOf({{"x", "dx", 1, 1}, {"dx", "-x", 0}}), options);
    running = &solver;
    double worstEnergy = 0;
    std::thread reader([&] {
        while (!done) {
            std::shared_ptr<const Histories> mine;
            {
                const std::lock_guard lock(mutex);
                mine = published;
            }
            for (int k = 0; mine && k <= 20; ++k) {
                const double t = mine->known() * k / 20;
                worstEnergy = std::max(
                    worstEnergy, std::abs(std::hypot(mine->value(0, t), mine->value(1, t)) - 1));
            }
        }
    });
    EXPECT_EQ(solver.advanceTo(300).reached, 300);
    done = true;
    reader.join();
    EXPECT_LT(worstEnergy, 1e-3);
}
