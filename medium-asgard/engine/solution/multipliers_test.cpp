// Motion that multipliers keep on conditions: against the same motion in coordinates without any.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

struct Kept {
    std::string name, gap, rate, second;
};

// Multipliers behind the unknowns of `lines`; each reads the others.
expression::EquationSet keeping(const std::vector<Line>& lines, const std::vector<Kept>& kept) {
    expression::EquationSet set = equationsOf(lines);
    for (const Kept& one : kept) {
        expression::Unknown unknown;
        unknown.name = one.name;
        unknown.symbol = set.graph.symbol(one.name);
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = expression::testing::parsed(set.graph, one.second);
        unknown.phases[0].condition =
            expression::Condition{std::nullopt, expression::testing::parsed(set.graph, one.rate)};
        if (!one.gap.empty())
            unknown.phases[0].condition->gap = expression::testing::parsed(set.graph, one.gap);
        set.unknowns.push_back(unknown);
    }
    return set;
}

// Two masses of 1 kg on massless rods of 1 m, from the horizontal.
const std::vector<Line> twoMasses = {
    {"x1", "dx1", 1, 1},   {"y1", "dy1", 0, 1},         {"x2", "dx2", 2, 1},
    {"y2", "dy2", 0, 1},   {"dx1", "m1*x1-m2*(x2-x1)"}, {"dy1", "-9.81+m1*y1-m2*(y2-y1)"},
    {"dx2", "m2*(x2-x1)"}, {"dy2", "-9.81+m2*(y2-y1)"},
};
const std::vector<Kept> twoRods = {
    {"m1", "(x1^2+y1^2-1)/2", "x1*dx1+y1*dy1",
     "dx1^2+dy1^2+x1*(m1*x1-m2*(x2-x1))+y1*(-9.81+m1*y1-m2*(y2-y1))"},
    {"m2", "((x2-x1)^2+(y2-y1)^2-1)/2", "(x2-x1)*(dx2-dx1)+(y2-y1)*(dy2-dy1)",
     "(dx2-dx1)^2+(dy2-dy1)^2+(x2-x1)*(m2*(x2-x1)-(m1*x1-m2*(x2-x1)))"
     "+(y2-y1)*(-9.81+m2*(y2-y1)-(-9.81+m1*y1-m2*(y2-y1)))"},
};
// The same in angles from the horizontal.
const std::vector<Line> twoAngles = {
    {"a", "da", 0, 1},
    {"b", "db", 0, 1},
    {"da", "(-2*9.81*cos(a)-sin(a-b)*db^2+cos(a-b)*(9.81*cos(b)-sin(a-b)*da^2))"
           "/(2-cos(a-b)^2)"},
    {"db", "(2*sin(a-b)*da^2-2*9.81*cos(b)+cos(a-b)*(2*9.81*cos(a)+sin(a-b)*db^2))"
           "/(2-cos(a-b)^2)"},
};

double largestGap(const Histories& histories, double t) {
    const auto at = [&](std::size_t i) { return histories.value(i, t); };
    return std::max(std::abs(std::hypot(at(0), at(1)) - 1),
                    std::abs(std::hypot(at(2) - at(0), at(3) - at(1)) - 1));
}

} // namespace

// The error follows the tolerance as it does in angles, at as many steps.
TEST(Multipliers, ADoublePendulumCostsWhatItCostsInAngles) {
    const Solver exact = solved(equationsOf(twoAngles), 10, tolerance(1e-13));
    const double a = exact.histories().value(0, 10), b = exact.histories().value(1, 10);
    for (const double asked : {1e-4, 1e-6, 1e-8, 1e-10}) {
        const Solver rods = solved(keeping(twoMasses, twoRods), 10, tolerance(asked));
        const Solver angles = solved(equationsOf(twoAngles), 10, tolerance(asked));
        ASSERT_TRUE(rods.histories().stops().empty());
        const auto& h = rods.histories();
        const double error = std::hypot(h.value(2, 10) - std::cos(a) - std::cos(b),
                                        h.value(3, 10) - std::sin(a) - std::sin(b));
        EXPECT_LT(error, 200 * asked) << asked;
        EXPECT_LT(rods.statistics().steps, 1.5 * static_cast<double>(angles.statistics().steps))
            << asked;
        EXPECT_LT(largestGap(h, 10), asked); // of the polynomial of its last step
    }
}

TEST(Multipliers, DriftNeverGrows) {
    const Solver rods = solved(keeping(twoMasses, twoRods), 1000, tolerance(1e-4));
    for (double t = 0; t < 1000; t += 0.37)
        ASSERT_LT(largestGap(rods.histories(), t), 1e-3) << t;
}

// A second rod where the first is: the same motion.
TEST(Multipliers, RedundantConditionsChangeNothing) {
    std::vector<Line> lines = {
        {"x", "dx", 1, 1}, {"y", "dy", 0, 1}, {"dx", "(m1+m2)*x"}, {"dy", "-9.81+(m1+m2)*y"}};
    const std::string second = "dx^2+dy^2+(m1+m2)*x^2+y*(-9.81+(m1+m2)*y)";
    const Kept one = {"m1", "(x^2+y^2-1)/2", "x*dx+y*dy", second};
    Kept other = one;
    other.name = "m2";
    const Solver twice = solved(keeping(lines, {one, other}), 3, tolerance(1e-9));
    ASSERT_TRUE(twice.histories().stops().empty());
    const Solver angle =
        solved(equationsOf({{"a", "da", 0, 1}, {"da", "-9.81*cos(a)", 0}}), 3, tolerance(1e-12));
    EXPECT_NEAR(twice.histories().value(1, 3), std::sin(angle.histories().value(0, 3)), 1e-7);
}

// A second condition that the first makes on the circle alone: off it, as within a step, both are
// two, and no forces keep them. The same motion at the same cost, and its steps end on the circle.
TEST(Multipliers, WhatIsRedundantOnItsPlacesAloneCostsNothing) {
    const std::string push = "((2+x)*x+(x^2+y^2-1)/2)";
    const std::string ddx = "(m1*x+m2*" + push + ")", ddy = "(-9.81+m1*y+m2*(2+x)*y)";
    const std::string gap = "(x^2+y^2-1)/2", rate = "(x*dx+y*dy)";
    const std::string second = "(dx^2+dy^2+x*" + ddx + "+y*" + ddy + ")";
    const std::vector<Line> lines = {
        {"x", "dx", 1, 1}, {"y", "dy", 0, 1}, {"dx", ddx}, {"dy", ddy}};
    const Kept one = {"m1", gap, rate, second};
    const Kept other = {"m2", gap + "*(2+x)", rate + "*(2+x)+" + gap + "*dx",
                        second + "*(2+x)+2*" + rate + "*dx+" + gap + "*" + ddx};
    const std::vector<Line> alone = {
        {"x", "dx", 1, 1}, {"y", "dy", 0, 1}, {"dx", "m1*x"}, {"dy", "-9.81+m1*y"}};
    const Kept rod = {"m1", gap, rate, "(dx^2+dy^2+m1*x^2+y*(-9.81+m1*y))"};
    const Solver angle =
        solved(equationsOf({{"a", "da", 0, 1}, {"da", "-9.81*cos(a)", 0}}), 3, tolerance(1e-12));
    const double truth = std::sin(angle.histories().value(0, 3));
    for (const double asked : {1e-3, 1e-5, 1e-7}) {
        const Solver twice = solved(keeping(lines, {one, other}), 3, tolerance(asked));
        const Solver once = solved(keeping(alone, {rod}), 3, tolerance(asked));
        ASSERT_TRUE(twice.histories().stops().empty());
        EXPECT_LT(std::abs(twice.histories().value(1, 3) - truth), asked);
        EXPECT_LT(twice.statistics().evaluations,
                  1.1 * static_cast<double>(once.statistics().evaluations))
            << asked;
        EXPECT_LE(twice.statistics().rejectedSteps, once.statistics().rejectedSteps + 2) << asked;
    }
}

// A condition that says that 1 = 0 stops what it reads.
TEST(Multipliers, AContradictionStopsTheMotion) {
    const std::vector<Line> lines = {{"x", "dx", 1, 1}, {"dx", "m1+m2-9.81*x", 0}};
    const Solver solver = solved(
        keeping(lines, {{"m1", "", "dx", "m1+m2-9.81*x"}, {"m2", "", "dx-t", "m1+m2-9.81*x-1"}}), 3,
        tolerance(1e-6));
    ASSERT_EQ(solver.histories().stops().size(), 1u);
    EXPECT_EQ(solver.histories().stops()[0].reason, Stop::Reason::contradiction);
    EXPECT_NE(solver.histories().stops()[0].sentence.find("no forces keep"), std::string::npos);
}

// What nothing moves off its condition is not solved for.
TEST(Multipliers, AConditionThatStaysKeptCostsNothing) {
    std::vector<Line> lines = twoMasses;
    lines.push_back({"z1", "dz1", 0, 1});
    lines.push_back({"dz1", "m3", 0});
    std::vector<Kept> kept = twoRods;
    kept.push_back({"m3", "z1", "dz1", "m3"});
    const Solver solver = solved(keeping(lines, kept), 1, tolerance(1e-6));
    EXPECT_EQ(solver.statistics().componentList.size(), 1u);
    EXPECT_EQ(solver.statistics().componentList[0].unknowns.size(), 10u);
}

// With a stiff spring, so that the Jacobian is used.
TEST(Multipliers, AnImplicitMethodFollowsConditions) {
    std::vector<Line> lines = twoMasses;
    lines[6].derivative += "-1e6*(hypot(x2,y2)-1.5)*x2/hypot(x2,y2)-2000*dx2";
    lines[7].derivative += "-1e6*(hypot(x2,y2)-1.5)*y2/hypot(x2,y2)-2000*dy2";
    std::vector<Kept> kept = twoRods;
    for (const char* const c : {"x", "y"}) {
        const std::string x = std::string(c) + "2", first = std::string(c) + "1";
        kept[1].second += "+(" + x + "-" + first + ")*(-1e6*(hypot(x2,y2)-1.5)*" + x +
                          "/hypot(x2,y2)-2000*d" + x + ")";
    }
    const auto at = [&](const std::string& method, double asked) {
        Options options = tolerance(asked);
        options.method = method;
        const Solver solver = solved(keeping(lines, kept), 1, options);
        EXPECT_TRUE(solver.histories().stops().empty());
        EXPECT_LT(largestGap(solver.histories(), 1), asked);
        return solver.histories().value(0, 1);
    };
    const double exact = at("dop853", 1e-11);
    EXPECT_NEAR(at("radau5", 1e-8), exact, 1e-6);
}

namespace {

// A multiplier with bounds, behind `lines`.
expression::EquationSet bounded(const std::vector<Line>& lines, const Kept& kept, double low,
                                double high, double restitution = 0) {
    expression::EquationSet set = keeping(lines, {kept});
    expression::Condition& condition = *set.unknowns.back().phases[0].condition;
    condition.low = low;
    condition.high = high;
    condition.restitution = restitution;
    condition.resolution = 1e-9;
    return set;
}

const std::vector<Line> falling = {{"x", "dx", 1, 1}, {"dx", "m-9.81", 0}};
const Kept floorBelow = {"m", "x", "dx", "m-9.81"};
const std::vector<Line> sliding = {{"x", "dx", 0, 1}, {"dx", "m+4*sin(t)", 0}};
const Kept brakeOf = {"m", "", "dx", "m+4*sin(t)"};

} // namespace

// Let fall from 1, e = 0.5: hits at t0, 2 t0, 2.5 t0, ..., and rests from 3 t0 on.
TEST(Bounds, AStopIsHitAtItsTimesAndHolds) {
    const double t0 = std::sqrt(2 / 9.81);
    const Solver solver =
        solved(bounded(falling, floorBelow, 0, infinity, 0.5), 3, tolerance(1e-6));
    const Histories& h = solver.histories();
    ASSERT_TRUE(h.stops().empty());
    const double speed = 9.81 * t0;
    for (int k = 1; k <= 8; ++k) {
        const double hit = t0 + 2 * t0 * (1 - std::pow(0.5, k - 1));
        EXPECT_NEAR(h.value(0, hit), 0, 1e-13) << k;
        EXPECT_NEAR(h.value(1, hit + 1e-6), speed * std::pow(0.5, k), 1e-4) << k;
    }
    EXPECT_NEAR(h.value(0, 2), 0, 1e-15);
    EXPECT_EQ(h.value(2, 2), 1); // inside: it holds
    EXPECT_EQ(h.value(2, 0.2), 2);
    for (double t = 0; t < 3; t += 0.001)
        ASSERT_GE(h.value(0, t), -1e-9) << t;
}

// Into a groove of two walls, cos 0.72 between their normals: a blow at one wall drives the other
// open. It falls on both at one instant but for rounding, or far aside; there its hops end.
TEST(Bounds, AGrooveIsHitOnBothWallsAndHolds) {
    const std::string a = "0.37416573867739417", b = "0.92736184954957035"; // of the normals
    const auto fallFrom = [&](double x) {
        const std::string ax = a + "*(m1-m2)", ay = "(" + b + "*(m1+m2)-9.81)";
        expression::EquationSet set =
            keeping({{"x", "dx", x, 1}, {"y", "dy", 0.5, 1}, {"dx", ax, 0}, {"dy", ay, 0}},
                    {{"m1", a + "*x+" + b + "*y", a + "*dx+" + b + "*dy",
                      a + "*" + ax + "+" + b + "*" + ay},
                     {"m2", b + "*y-" + a + "*x", b + "*dy-" + a + "*dx",
                      b + "*" + ay + "-" + a + "*" + ax}});
        for (std::size_t i = 4; i < 6; ++i) {
            expression::Condition& condition = *set.unknowns[i].phases[0].condition;
            condition.low = 0;
            condition.resolution = 1e-9;
        }
        return solved(set, 3, tolerance(1e-6));
    };
    for (const double x : {0.0, 1e-13, -1e-10, 1e-4, 0.1}) {
        const Solver solver = fallFrom(x);
        const Histories& h = solver.histories();
        ASSERT_TRUE(h.stops().empty()) << x << ": " << h.stops()[0].sentence;
        for (const std::size_t i : {0u, 1u})
            EXPECT_NEAR(h.value(i, 3), 0, 1e-8) << x;
        for (const std::size_t i : {2u, 3u})
            EXPECT_NEAR(h.value(i, 3), 0, 1e-8) << x;
        if (std::abs(x) < 1e-9) { // at once, and not after hops
            EXPECT_NEAR(h.value(3, std::sqrt(1 / 9.81) + 1e-6), 0, 1e-8) << x;
        }
    }
}

// A rope that becomes slack where it is longer by rounding does not become taut at once, though the
// first step ends in the same last places.
TEST(Bounds, AStopThatOpensFromAnOverlapByRoundingIsOpen) {
    const std::vector<Line> thrown = {{"x", "dx", -2e-16, 1}, {"dx", "m-1", 1}};
    Options options = tolerance(1e-6);
    options.start = 1;
    options.firstStep = 1e-16;
    const Solver solver = solved(bounded(thrown, {"m", "x", "dx", "m-1"}, 0, infinity), 4, options);
    const Histories& h = solver.histories();
    ASSERT_TRUE(h.stops().empty()) << h.stops()[0].sentence;
    EXPECT_NEAR(h.value(0, 2), 0.5, 1e-12);
    EXPECT_NEAR(h.value(0, 3.5), 0, 1e-9);
}

// A stop whose force pulls towards it holds nothing: the sentence names it, and no expression.
TEST(Bounds, AStopThatCannotHoldIsNamed) {
    const std::vector<Line> pulled = {{"x", "dx", 1, 1}, {"dx", "-catch-9.81", 0}};
    const Solver solver = solved(bounded(pulled, {"catch", "x", "dx", "-catch-9.81"}, 0, infinity),
                                 3, tolerance(1e-6));
    const auto& stops = solver.histories().stops();
    ASSERT_FALSE(stops.empty());
    EXPECT_EQ(stops[0].reason, Stop::Reason::unheld) << stops[0].sentence;
    EXPECT_NE(stops[0].sentence.find("no forces of catch"), std::string::npos) << stops[0].sentence;
    EXPECT_EQ(stops[0].sentence.find("expression"), std::string::npos);
}

// A force 4 sin t against dry friction of 2: it sticks until sin t = 1/2, and slides until its
// momentum is spent.
TEST(Bounds, ABrakeHoldsSlipsAndReverses) {
    const Solver solver = solved(bounded(sliding, brakeOf, -2, 2), 10, tolerance(1e-9));
    const Histories& h = solver.histories();
    ASSERT_TRUE(h.stops().empty());
    const double from = std::asin(0.5);
    EXPECT_EQ(h.value(0, from), 0);
    EXPECT_EQ(h.value(1, from - 1e-9), 0);
    const auto speed = [&](double t) {
        return 4 * (std::cos(from) - std::cos(t)) - 2 * (t - from);
    };
    double a = 3, b = 4; // where it comes to rest; the force is over 2 there, and it turns back
    for (int i = 0; i < 60; ++i)
        (speed(0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
    EXPECT_NEAR(h.value(1, 1.5), speed(1.5), 1e-8);
    EXPECT_GT(h.value(1, a - 1e-4), 0);
    EXPECT_LT(h.value(1, a + 1e-4), 0);
    EXPECT_EQ(h.value(2, a - 1e-4), 2); // the force is -2 while it goes forward
    EXPECT_EQ(h.value(2, a + 1e-4), 3);
    EXPECT_NEAR(h.value(1, a + 0.5), 4 * (std::cos(a) - std::cos(a + 0.5)) + 2 * 0.5, 1e-8);
}

// A motor of at most 3 against a load of 5: it slips, and its condition is left.
TEST(Bounds, AMotorThatIsTooWeakSlips) {
    const std::vector<Line> lines = {{"x", "dx", 0, 1}, {"dx", "m-5", 1}};
    const Solver solver =
        solved(bounded(lines, {"m", "", "dx-1", "m-5"}, -3, 3), 2, tolerance(1e-9));
    EXPECT_NEAR(solver.histories().value(1, 2), 1 - 2 * 2, 1e-12);
    EXPECT_EQ(solver.histories().value(2, 1), 3); // at its upper bound
}

// A mass on a rod that goes at t = 1, or once it pulls with more than 25: from then on it flies.
TEST(Release, AConditionGoesForEver) {
    for (const char* const when : {"t>1", "-m>25"}) {
        expression::EquationSet set =
            keeping({{"x", "dx", 1, 1}, {"y", "dy", 0, 1}, {"dx", "m*x"}, {"dy", "-9.81+m*y"}},
                    {{"m", "(x^2+y^2-1)/2", "x*dx+y*dy", "dx^2+dy^2+m*(x^2+y^2)-9.81*y"}});
        expression::Unknown release;
        release.name = "release";
        release.symbol = set.graph.symbol("release");
        release.phases.emplace_back();
        release.phases[0].derivative = set.graph.constant(0);
        release.phases[0].given = expression::testing::parsed(set.graph, when);
        set.unknowns.back().phases[0].condition->release = release.symbol;
        set.unknowns.push_back(release);
        const Solver solver = solved(set, 2, tolerance(1e-9));
        const Histories& h = solver.histories();
        ASSERT_TRUE(h.stops().empty()) << h.stops()[0].sentence;
        // The pull is 3 * 9.81 * depth.
        double from = 1;
        if (when[0] == '-') {
            for (from = 0; h.value(1, from) > -25 / (3 * 9.81);)
                from += 1e-5;
            EXPECT_NEAR(h.value(4, from - 1e-4), 1, 0);
        }
        EXPECT_EQ(h.value(4, from + 1e-4), releasedMode);
        EXPECT_EQ(h.value(4, 2), releasedMode);
        const double t = 2 - from - 1e-4, vx = h.value(2, from + 1e-4),
                     vy = h.value(3, from + 1e-4);
        EXPECT_NEAR(h.value(2, 2), vx, 1e-12);
        EXPECT_NEAR(h.value(1, 2), h.value(1, from + 1e-4) + vy * t - 9.81 * t * t / 2, 1e-9);
    }
}
