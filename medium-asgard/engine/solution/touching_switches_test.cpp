// Expressions that touch the surface of their switch without crossing it, or start on it: nothing
// stops, and the side is the one to which the motion goes.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr double accuracies[] = {1e-3, 1e-6, 1e-9};

// By Simpson's rule, kinks and all.
double integralOf(const std::function<double(double)>& f, double to) {
    constexpr int halves = 400'000;
    const double h = to / halves;
    double sum = f(0) + f(to);
    for (int i = 1; i < halves; ++i)
        sum += (i % 2 == 0 ? 2 : 4) * f(i * h);
    return sum * h / 3;
}

void expectIntegral(const std::vector<Line>& lines, double exact, double finish, double off = 1e-9,
                    double times = 10) {
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf(lines), finish, tolerance(accuracy));
        const std::size_t last = lines.size() - 1;
        ASSERT_EQ(solver.histories().stop(last), nullptr)
            << lines[last].derivative << ": " << solver.histories().stop(last)->sentence;
        EXPECT_NEAR(solver.histories().value(last, finish), exact, times * accuracy + off)
            << lines[last].derivative << " at " << accuracy;
    }
}

struct Touching {
    std::string text;
    std::function<double(double)> value;
};

} // namespace

TEST(Touching, AClampedOscillationGoesOn) {
    const std::vector<Touching> all = {
        {"min(1,sin(t))", [](double t) { return std::sin(t); }},
        {"max(-1,cos(t))", [](double t) { return std::cos(t); }},
        {"min(1,sin(2*t))", [](double t) { return std::sin(2 * t); }},
        {"abs(1+cos(t))", [](double t) { return 1 + std::cos(t); }},
        {"max(0,cos(5*t)-1)", [](double) { return 0; }},
        {"max(-1,min(1,sin(3*t)))", [](double t) { return std::sin(3 * t); }},
        {"max(1,min(1,cos(2*t)))", [](double) { return 1; }},
        {"max(1,abs(max(-1,min(1,cos(2*t)))))", [](double) { return 1; }},
        {"(t-2)^2>=0?1:-1", [](double) { return 1; }},
        {"sign((t-2)^2)", [](double) { return 1; }},
        {"abs((t-2)^4)", [](double t) { return std::pow(t - 2, 4); }},
    };
    for (const Touching& one : all)
        expectIntegral({{"x", one.text, 1}}, 1 + integralOf(one.value, 6), 6, 3e-8);
}

// Clamped roots and arcs: beyond its switch the branch has no value. (A step's error, at these
// singularities, is some of its tolerance.)
TEST(Touching, ARootThatASwitchBoundsIsPassed) {
    const auto root = [](double x) { return x > 0 ? std::sqrt(x) : 0; };
    const std::vector<Touching> all = {
        {"sqrt(max(0,1-t))", [&](double t) { return root(1 - t); }},
        {"max(0,1-t)^0.5", [&](double t) { return root(1 - t); }},
        {"max(0,1-t)^1.5", [&](double t) { return std::pow(std::max(0.0, 1 - t), 1.5); }},
        {"t<1?sqrt(1-t):0", [&](double t) { return root(1 - t); }},
        {"sqrt(abs(1-t))", [&](double t) { return root(std::abs(1 - t)); }},
        {"sqrt(abs(sin(2*t)))", [&](double t) { return root(std::abs(std::sin(2 * t))); }},
        {"sqrt(max(0,sin(3*t)))", [&](double t) { return root(std::sin(3 * t)); }},
        {"acos(max(-1,min(1,1.5*sin(t))))",
         [](double t) { return std::acos(std::clamp(1.5 * std::sin(t), -1.0, 1.0)); }},
        {"asin(min(1,max(-1,2*sin(t))))",
         [](double t) { return std::asin(std::clamp(2 * std::sin(t), -1.0, 1.0)); }},
    };
    for (const Touching& one : all)
        expectIntegral({{"x", one.text, 1}}, 1 + integralOf(one.value, 4), 4, 1e-7, 100);
}

// The second touches the third at the start; a step ends where they leave each other, to the last
// bit, and the next one goes across.
TEST(Touching, BallsOfARowLeaveHertzsContactsWithTheirEnergy) {
    const std::string left = "1000*max(0,1-(x1-x0))^1.5", right = "1000*max(0,1-(x2-x1))^1.5";
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-8}) {
        const Solver solver = solved(equationsOf({{"x0", "v0", -0.3, 1},
                                                  {"v0", "-" + left, 1},
                                                  {"x1", "v1", 1, 1},
                                                  {"v1", left + "-" + right, 0},
                                                  {"x2", "v2", 2, 1},
                                                  {"v2", right, 0}}),
                                     1.2, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr) << h.stop(1)->sentence;
        const double v0 = h.value(1, 1.2), v1 = h.value(3, 1.2), v2 = h.value(5, 1.2);
        EXPECT_NEAR(v0 + v1 + v2, 1, 10 * accuracy);
        EXPECT_NEAR(v0 * v0 + v1 * v1 + v2 * v2, 1, 10 * accuracy);
        EXPECT_LT(v0, v1);
        EXPECT_LT(v1, v2);
        EXPECT_LT(solver.statistics().steps, 2000u);
    }
}

TEST(Touching, ABallLeavesHertzsContactAsItCame) {
    for (const double accuracy : accuracies) {
        const Solver solver =
            solved(equationsOf({{"x", "v", -1, 1}, {"v", "-100*max(0,x)^1.5", 1}}), 3,
                   tolerance(accuracy));
        ASSERT_EQ(solver.histories().stop(0), nullptr);
        EXPECT_NEAR(solver.histories().value(1, 3), -1, 10 * accuracy);
        EXPECT_LT(solver.histories().value(0, 3), -1);
    }
}

// v' = -sqrt v comes to rest at t = 2, at x = 2/3, and stays; a tank runs empty so.
TEST(Touching, WhatARootBrakesComesToRest) {
    for (const char* drag : {"-sign(v)*sqrt(abs(v))", "-sqrt(max(0,v))"})
        for (const double accuracy : accuracies) {
            const Solver solver =
                solved(equationsOf({{"x", "v", 0, 1}, {"v", drag, 1}}), 6, tolerance(accuracy));
            ASSERT_EQ(solver.histories().stop(0), nullptr) << drag << " at " << accuracy;
            EXPECT_NEAR(solver.histories().value(0, 6), 2.0 / 3, 10 * accuracy) << drag;
            EXPECT_NEAR(solver.histories().value(1, 6), 0, accuracy) << drag;
        }
}

// From rest, and pulled by what is 0 there: drag counts as nothing until it moves. Values at t = 2
// by 400,000 steps of Runge and Kutta's rule.
TEST(Touching, WhatIsPulledFromRestThroughAirStarts) {
    struct Case {
        const char *pull, *drag;
        double x;
    };
    for (const Case& c :
         {Case{"t-x", "v*abs(v)", 0.8626921169781}, Case{"-t^3-x", "sign(v)*v^2", -1.1047519424388},
          Case{"-200*(x-t/4)", "v*abs(v)", 0.4994455420041},
          Case{"t-x", "v*sqrt(abs(v))", 0.8140398684073},
          Case{"-t^3-x", "v*sqrt(abs(v))", -1.1132151353833},
          Case{"2*sin(t/2)^2-x", "v*sqrt(abs(v))", 0.4174829539244}})
        for (const double accuracy : accuracies) {
            const std::string rate = std::string(c.pull) + "-" + c.drag;
            const Solver solver =
                solved(equationsOf({{"x", "v", 0, 1}, {"v", rate, 0}}), 2, tolerance(accuracy));
            ASSERT_EQ(solver.histories().stop(1), nullptr)
                << rate << " at " << accuracy << ": " << solver.histories().stop(1)->sentence;
            EXPECT_NEAR(solver.histories().value(0, 2), c.x, 10 * accuracy) << rate;
            EXPECT_LT(solver.statistics().steps, 1000u) << rate << " at " << accuracy;
        }
}

// A load on a rope that only pulls, under a trolley that moves off.
TEST(Touching, ALoadUnderACraneStarts) {
    const std::string off = "(x-t*t/4)", length = "hypot(x-t*t/4,y)";
    const std::string pull = "-200*max(0," + length + "-2.8)/" + length;
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf({{"x", "u", 0, 1},
                                                  {"y", "v", -2.8, 1},
                                                  {"u", pull + "*" + off + "-0.02*u*abs(u)", 0},
                                                  {"v", pull + "*y-9.81", 0}}),
                                     2, tolerance(accuracy));
        ASSERT_EQ(solver.histories().stop(0), nullptr) << solver.histories().stop(0)->sentence;
        EXPECT_NEAR(solver.histories().value(0, 2), 0.72575550512411, 10 * accuracy);
        EXPECT_NEAR(solver.histories().value(1, 2), -2.88513808923037, 10 * accuracy);
    }
}

// Two clamps of what touches them at the same and at other times, in random sums.
TEST(Touching, RandomClampsAreTheirIntegrals) {
    std::mt19937 random(5);
    const auto pick = [&random](unsigned n) { return static_cast<unsigned>(random() % n); };
    for (int i = 0; i < 40; ++i) {
        const unsigned w = 1 + pick(4), shape = pick(4), scale = 1 + pick(3);
        const std::string wave = (pick(2) == 0 ? "sin(" : "cos(") + std::to_string(w) + "*t)";
        const bool isSine = wave[0] == 's';
        const auto value = [w, isSine](double t) {
            return isSine ? std::sin(w * t) : std::cos(w * t);
        };
        const std::string s = std::to_string(scale);
        const std::string texts[] = {
            "min(" + s + "," + s + "*" + wave + ")", "max(-" + s + "," + s + "*" + wave + ")",
            "abs(" + s + "-" + s + "*" + wave + ")",
            "max(" + s + "*" + wave + ",-" + s + ")-min(0.5," + wave + ")"};
        const std::function<double(double)> values[] = {
            [&](double t) { return scale * value(t); }, [&](double t) { return scale * value(t); },
            [&](double t) { return scale - scale * value(t); },
            [&](double t) { return scale * value(t) - std::min(0.5, value(t)); }};
        expectIntegral({{"x", texts[shape], 1}}, 1 + integralOf(values[shape], 5), 5, 1e-8);
    }
}

// x = cos t, exact: it starts at the top of its motion, and comes there again.
TEST(Touching, ALinearMotionAtItsExtremum) {
    const std::vector<Line> swing = {{"x", "dx", 1, 1}, {"dx", "-x", 0}};
    const std::vector<Touching> all = {
        {"max(x,1)", [](double) { return 1; }},
        {"abs(x-1)", [](double t) { return 1 - std::cos(t); }},
        {"min(x,1)", [](double t) { return std::cos(t); }},
        {"sign(x-1)", [](double) { return -1; }},
        {"x>=1?1:0", [](double) { return 0; }},
        {"floor(x)", [](double t) { return std::floor(std::cos(t)); }},
        {"ceil(x)", [](double t) { return std::ceil(std::cos(t)); }},
    };
    for (const Touching& one : all) {
        std::vector<Line> lines = swing;
        lines.push_back({"y", one.text, 1});
        // Where what is rounded touches its surface it is there for 1e-7 at most.
        expectIntegral(lines, 1 + integralOf(one.value, 7), 7, 2e-5);
    }
}

// It reads itself too: y'' = max(x, 1).
TEST(Touching, AMotionThatReadsItsOwnExtremum) {
    for (const char* drag : {"-x", "-x-0.1*dx"}) {
        const std::vector<Line> lines = {
            {"x", "dx", 1, 1}, {"dx", drag, 0}, {"y", "dy", 0, 1}, {"dy", "max(x,1)", 0}};
        expectIntegral(lines, 3, 3, 1e-9);
    }
}

// The side to which a motion leaves a surface on which it starts is told by derivatives of any
// order.
TEST(Touching, AStartOnASwitchTakesTheSideToWhichItGoes) {
    const std::pair<const char*, double> all[] = {{"-1", -1}, {"1", 1},     {"-t*t", -1},
                                                  {"t^3", 1}, {"-t^6", -1}, {"1e-3*t^2", 1}};
    for (const auto& [rate, side] : all) {
        const std::vector<Line> lines = {
            {"x", "dx", 1, 1}, {"dx", rate, 0}, {"y", "dy", 1, 1}, {"dy", "sign(x-1)", 0}};
        for (const double accuracy : accuracies) {
            const Solver solver = solved(equationsOf(lines), 3, tolerance(accuracy));
            ASSERT_EQ(solver.histories().stop(2), nullptr) << rate;
            EXPECT_NEAR(solver.histories().value(2, 3), 1 + 4.5 * side, 1e-11) << rate;
        }
    }
}

// What stays on its surface stays there until something moves it.
TEST(Touching, RestOnASwitchLastsUntilItIsLeft) {
    const std::vector<Line> lines = {
        {"x", "dx", 1, 1}, {"dx", "t>1?(t-1)^2:0", 0}, {"y", "sign(x-1)", 0}};
    expectIntegral(lines, 2, 3, 1e-9);
}
