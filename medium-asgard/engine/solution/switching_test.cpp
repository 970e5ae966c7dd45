// Switching expressions: located, passed, slid upon; and what cannot be.
#include "equations/surfaces.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace solution;
using namespace solution::testing;

TEST(Surfaces, GuardsThatDifferInSignAreOneSurface) {
    expression::Graph graph;
    const expression::Node node = expression::testing::parsed(
        graph, "(v>0?-3:v<0?3:0) + sign(-v) + abs(x-y) + (y<=x) + min(x,y) + floor(x)");
    const auto surfaces = surfacesOf(graph, {&node, 1});
    ASSERT_EQ(surfaces.size(), 3u);
    std::size_t whole = 0, members = 0;
    for (const Surface& surface : surfaces) {
        whole += surface.whole ? 1 : 0;
        members += surface.members.size();
    }
    EXPECT_EQ(whole, 1u);
    EXPECT_EQ(members, 7u);
}

// v' = f(t) - v |v| / 2 from rest, f = 5 exp(-(t - 6.37)^2): 1e-17 at first, far less than a step
// may err by, so that polynomials cross v = 0 where the motion never does. Reference: RK4 in 2e6
// steps.
TEST(Switches, AStartBelowAllErrorsDoesNotSwitch) {
    double v = 0, x = 0;
    constexpr int steps = 2'000'000;
    constexpr double h = 10.0 / steps;
    const auto rate = [](double t, double w) {
        return 5 * std::exp(-(t - 6.37) * (t - 6.37)) - 0.5 * w * std::abs(w);
    };
    for (int i = 0; i < steps; ++i) {
        const double t = i * h, a = rate(t, v), b = rate(t + h / 2, v + h / 2 * a),
                     c = rate(t + h / 2, v + h / 2 * b), d = rate(t + h, v + h * c);
        x += h * v + h * h / 6 * (a + b + c);
        v += h / 6 * (a + 2 * b + 2 * c + d);
    }
    for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
        const Solver solver =
            solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "5*exp(-(t-6.37)^2)-0.5*dx*abs(dx)", 0}}),
                   10, tolerance(accuracy));
        ASSERT_EQ(solver.histories().stop(1), nullptr) << accuracy;
        EXPECT_NEAR(solver.histories().value(0, 10), x, 100 * accuracy);
        EXPECT_LE(solver.statistics().switches, 2u);
    }
}

// A spring that only pushes: free flight, then half an oscillation.
TEST(Switches, AContactSpringIsEnteredAndLeftAtItsRoots) {
    // x0 = 1, g = 10; contact at t1 = sqrt(2/10) with v1 = -sqrt(20).
    const Solver solver = solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "-10+(x<0?-1e4*x:0)", 0}}),
                                 2, tolerance(1e-11));
    const double t1 = std::sqrt(0.2);
    const auto restarts = solver.histories().restarts(1);
    ASSERT_GE(restarts.size(), 2u);
    EXPECT_NEAR(restarts[0], t1, 1e-14);
    // Inside: x'' = -10 - 1e4 x, from 0 with v1; leaves with the opposite velocity.
    const double w = 100, rest = -10 / 1e4, amplitude = std::hypot(rest, std::sqrt(20) / w);
    const double phase = std::asin(-rest / amplitude);
    EXPECT_NEAR(restarts[1], t1 + (std::numbers::pi + 2 * phase) / w, 1e-9);
    EXPECT_NEAR(solver.histories().value(1, restarts[1]), std::sqrt(20), 1e-7);
}

TEST(Switches, TimesAreExact) {
    const Solver solver = solved(equationsOf({{"x", "t<2?1:-1", 0}, {"y", "abs(t-3)", 0}}), 5);
    EXPECT_EQ(solver.histories().restarts(0), std::vector<double>{2});
    EXPECT_NEAR(solver.histories().value(0, 5), -1, 1e-15);
    EXPECT_NEAR(solver.histories().value(1, 5), 4.5 + 2, 1e-14);
    EXPECT_EQ(solver.statistics().steps, 0u);
}

TEST(Switches, AStaircaseIsClimbedStepByStep) {
    const Solver solver =
        solved(equationsOf({{"x", "floor(t)", 0}, {"y", "ceil(0.5-t)", 0}}), 10.5);
    EXPECT_NEAR(solver.histories().value(0, 10.5), 45 + 5, 1e-12);
    EXPECT_NEAR(solver.histories().value(1, 10.5), 0.5 - 45, 1e-12);
    const auto restarts = solver.histories().restarts(0);
    ASSERT_GE(restarts.size(), 10u);
    for (std::size_t k = 0; k < 10; ++k)
        EXPECT_EQ(restarts[k], static_cast<double>(k + 1));
}

TEST(Switches, ASquareWaveDrivesAnOscillatorWithoutAKink) {
    // x'' = -x + s, s = 1 on even half periods of sin(3t): compare with a run in pieces.
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-x+(sin(3*t)>0?1:0)", 0}}),
                                 6, tolerance(1e-11));
    double x = 0, v = 0, t = 0;
    for (int k = 0; t < 6; ++k) {
        const double end = std::min(6.0, (k + 1) * std::numbers::pi / 3), h = end - t;
        const double s = k % 2 == 0 ? 1 : 0, c = x - s;
        x = s + c * std::cos(h) + v * std::sin(h);
        v = -c * std::sin(h) + v * std::cos(h);
        t = end;
    }
    EXPECT_NEAR(solver.histories().value(0, 6), x, 1e-9);
    EXPECT_NEAR(solver.histories().value(1, 6), v, 1e-9);
}

// A block that friction stops on a floor stops and stays; no force is large enough to move it until
// the push exceeds mu m g.
TEST(Friction, ABlockStopsAndStaysAndStartsAgain) {
    // mu g = 2, v0 = 3: stops at t = 1.5 after 2.25 m. Push (t > 5) grows as t - 5: starts at 7.
    const Solver solver = solved(
        equationsOf({{"x", "dx", 0, 1}, {"dx", "-2*sign(dx)+max(0,t-5)", 3}}), 9, tolerance(1e-9));
    const Histories& h = solver.histories();
    EXPECT_NEAR(h.value(0, 1.5), 2.25, 1e-12);
    for (const double t : {1.6, 3.0, 5.0, 6.9}) {
        EXPECT_EQ(h.value(1, t), 0) << t;
        EXPECT_NEAR(h.value(0, t), 2.25, 1e-12) << t;
    }
    EXPECT_NEAR(h.value(1, 9), 2, 1e-8); // v = (t-7)^2/2
    EXPECT_NEAR(h.value(0, 9), 2.25 + 8.0 / 6, 1e-8);
    EXPECT_EQ(h.stop(0), nullptr);
}

TEST(Friction, WrittenAsComparisonsIsTheSame) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "dx>0?-2:dx<0?2:0", 3}}), 9, tolerance(1e-9));
    EXPECT_EQ(solver.histories().value(1, 5), 0);
    EXPECT_NEAR(solver.histories().value(0, 5), 2.25, 1e-12);
}

// v/|v| has no value at rest, and means the sign.
TEST(Friction, WrittenAsAQuotientIsTheSame) {
    for (const double speed : {3.0, 0.0}) {
        const Solver solver =
            solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-2*dx/abs(dx)+max(0,t-5)", speed}}), 9,
                   tolerance(1e-9));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr);
        EXPECT_EQ(h.value(1, 5), 0);
        EXPECT_NEAR(h.value(1, 9), 2, 1e-7);
        EXPECT_LT(solver.statistics().steps, 100u);
    }
}

// Along a line that is no axis the speed is a sum, and friction has a part along each axis: down
// the slope 0.6 against at most 0.8, so that it stops after 1.4 t = 2.1 and stays.
TEST(Friction, WrittenAsAQuotientAlongASlope) {
    for (const char* quotient :
         {"(0.8*dx+0.6*dy)/abs(0.8*dx+0.6*dy)",
          "(0.8*dx+0.6*dy==0?0:(0.8*dx+0.6*dy)/abs(0.8*dx+0.6*dy))", "sign(4*dx+3*dy)"}) {
        const std::string q = quotient;
        const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                  {"dx", "-0.48-0.64*" + q, 1.68},
                                                  {"y", "dy", 0, 1},
                                                  {"dy", "-0.36-0.48*" + q, 1.26}}),
                                     6, tolerance(1e-9));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr) << q << ": " << h.stop(1)->sentence;
        EXPECT_NEAR(h.value(0, 6), 0.8 * 2.1 * 1.5 / 2, 1e-9) << q;
        EXPECT_NEAR(h.value(2, 6), 0.6 * 2.1 * 1.5 / 2, 1e-9) << q;
        EXPECT_NEAR(h.value(1, 6), 0, 1e-12) << q;
    }
}

TEST(Friction, ABlockAtRestThatIsNotPushedHardStays) {
    const Solver solver =
        solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "1.9*sin(3*t)-2*sign(dx)", 0}}), 20);
    EXPECT_EQ(solver.histories().value(0, 20), 0);
    EXPECT_EQ(solver.histories().value(1, 20), 0);
    EXPECT_LT(solver.statistics().evaluations, 3000u);
}

// A block on a spring with dry friction comes to rest where the spring is too weak.
TEST(Friction, ASpringAndFrictionEndInRest) {
    // x'' = -x - 0.3 sign(x'), from 2: turning points 2, -1.4, 0.8, -0.2 (rest: |x| < 0.3).
    const Solver solver = solved(equationsOf({{"x", "dx", 2, 1}, {"dx", "-x-0.3*sign(dx)", 0}}), 30,
                                 tolerance(1e-11));
    const Histories& h = solver.histories();
    EXPECT_NEAR(h.value(0, std::numbers::pi), -1.4, 1e-9);
    EXPECT_NEAR(h.value(0, 2 * std::numbers::pi), 0.8, 1e-9);
    EXPECT_NEAR(h.value(0, 3 * std::numbers::pi), -0.2, 1e-8);
    EXPECT_NEAR(h.value(0, 30), -0.2, 1e-8);
    EXPECT_EQ(h.value(1, 30), 0);
}

// On a belt: the block takes on the belt's speed and keeps it until the spring pulls it off.
TEST(Friction, ABlockOnABeltSticksAndSlips) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-4*x-2*sign(dx-0.5)", 0}}),
                                 20, tolerance(1e-10));
    const Histories& h = solver.histories();
    // Sticks until 4 x = 2.
    const auto restarts = h.restarts(1);
    ASSERT_GE(restarts.size(), 2u);
    EXPECT_NEAR(h.value(1, 0.5 * (restarts[0] + restarts[1])), 0.5, 1e-12);
    EXPECT_NEAR(h.value(0, restarts[1]), 0.5, 1e-9);
    EXPECT_EQ(h.stop(0), nullptr);
}

// Two blocks, coupled by a spring, each on its own friction: both surfaces are held at once.
TEST(Friction, TwoCoupledBlocksBothComeToRest) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                              {"dx", "5*(y-x)-sign(dx)", 3},
                                              {"y", "dy", 0, 1},
                                              {"dy", "5*(x-y)-sign(dy)", 0}}),
                                 20, tolerance(1e-9));
    const Histories& h = solver.histories();
    EXPECT_EQ(h.stop(0), nullptr);
    EXPECT_EQ(h.value(1, 20), 0);
    EXPECT_EQ(h.value(3, 20), 0);
    EXPECT_LE(5 * std::abs(h.value(0, 20) - h.value(2, 20)), 1.0);
}

// The block's velocity is compared with that of another body on which it slides.
TEST(Friction, ABlockOnASlidingPlankEndsAtCommonSpeed) {
    const Solver solver = solved(equationsOf({{"a", "-4*sign(a-b)", 3}, {"b", "1*sign(a-b)", 0}}),
                                 5, tolerance(1e-9));
    const Histories& h = solver.histories();
    EXPECT_NEAR(h.value(0, 5), 0.6, 1e-12); // 1 : 4 in mass
    EXPECT_NEAR(h.value(1, 5), 0.6, 1e-12);
    EXPECT_NEAR(h.value(0, 0.6), 0.6, 1e-12);
}

// A relay drives to zero from both sides of two surfaces in ever shorter turns (the twisting
// algorithm): no time passes between them in the end, and that is said.
TEST(Switches, AnEndlessSequenceEndsInBoundedWork) {
    const Solver solver = solved(
        equationsOf({{"x", "dx", 1, 1}, {"dx", "-2*sign(x)-sign(dx)", 0}, {"z", "-z", 1}}), 20);
    const Histories& h = solver.histories();
    EXPECT_LT(solver.statistics().evaluations, 20000u);
    if (h.stop(0)) {
        EXPECT_EQ(h.stop(0)->reason, Stop::Reason::decisions);
        EXPECT_NEAR(h.value(0, h.stop(0)->time), 0, 1e-6);
    } else {
        EXPECT_NEAR(h.value(0, 20), 0, 1e-6);
    }
    EXPECT_EQ(h.stop(2), nullptr);
    EXPECT_EQ(h.known(), 20);
}

TEST(Switches, ARestOnASurfaceThatPushesFromBothSidesIsKept) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-sign(x)", 0}}), 10);
    EXPECT_EQ(solver.histories().value(0, 10), 0);
    EXPECT_EQ(solver.histories().stop(0), nullptr);
}

TEST(Switches, ABlockAtRestOnASpringContactFallsIntoIt) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1}, {"dx", "-10+(x<0?-100*x:0)", 0}}),
                                 3, tolerance(1e-10));
    // x = -0.1 (1 - cos 10 t)
    EXPECT_NEAR(solver.histories().value(0, 1), -0.1 * (1 - std::cos(10)), 1e-8);
    EXPECT_NEAR(solver.histories().value(0, 3), -0.1 * (1 - std::cos(30)), 1e-7);
}

TEST(Switches, AStiffContactIsLeftOnTime) {
    // k = 1e8 with critical damping: the implicit method meets switches too.
    const Solver solver =
        solved(equationsOf({{"x", "dx", 1, 1}, {"dx", "-10+(x<0?-1e8*x-2e4*dx:0)", 0}}), 3,
               tolerance(1e-8));
    EXPECT_EQ(solver.histories().stop(0), nullptr);
    EXPECT_NEAR(solver.histories().value(0, 0.4), 0.2, 1e-12);
    EXPECT_LT(solver.statistics().evaluations, 60000u);
}

// ---------------------------------------------------------------------------------------------
// Each kind of switch, on p = sin t and q = cos t, which are integrated

namespace {

constexpr double pi = std::numbers::pi;

struct Kind {
    std::string rate;
    std::vector<double> switches;        // all within 0 .. 6
    std::function<double(double)> rate6; // the rate as a function of time
};

Solver solvedKind(const std::string& rate) {
    return solved(equationsOf({{"p", "q", 0, 1}, {"q", "-p", 1}, {"x", rate, 0}}), 6,
                  tolerance(1e-11));
}

// Between the switches by Gauss's rule of five points, on pieces.
double integral(const Kind& kind) {
    std::vector<double> ends{0};
    ends.insert(ends.end(), kind.switches.begin(), kind.switches.end());
    ends.push_back(6);
    constexpr double at[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831,
                             0.9061798459386640};
    constexpr double weight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                 0.4786286704993665, 0.2369268850561891};
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (int piece = 0; piece < 16; ++piece) {
            const double h = (ends[i + 1] - ends[i]) / 32, middle = ends[i] + (2 * piece + 1) * h;
            for (std::size_t k = 0; k < 5; ++k)
                sum += h * weight[k] * kind.rate6(middle + at[k] * h);
        }
    return sum;
}

} // namespace

TEST(Switches, OfEachKindAreLocated) {
    const double half = std::asin(0.5); // sin t = 1/2 at half and pi - half
    const double third = std::asin(1 / 1.9);
    const auto s = [](double t) { return std::sin(t); };
    const auto c = [](double t) { return std::cos(t); };
    const std::vector<Kind> kinds = {
        {"p<0.5?1:3", {half, pi - half}, [&](double t) { return s(t) < 0.5 ? 1.0 : 3.0; }},
        {"p<=0.5?1:3", {half, pi - half}, [&](double t) { return s(t) < 0.5 ? 1.0 : 3.0; }},
        {"p>0.5?1:3", {half, pi - half}, [&](double t) { return s(t) > 0.5 ? 1.0 : 3.0; }},
        {"p>=0.5?1:3", {half, pi - half}, [&](double t) { return s(t) > 0.5 ? 1.0 : 3.0; }},
        {"(p>0.5)+q", {half, pi - half}, [&](double t) { return (s(t) > 0.5) + c(t); }},
        {"abs(p)", {pi}, [&](double t) { return std::abs(s(t)); }},
        {"sign(p)", {pi}, [&](double t) { return t < pi ? 1.0 : -1.0; }},
        {"min(p,0.5)", {half, pi - half}, [&](double t) { return std::min(s(t), 0.5); }},
        {"max(p,q)", {pi / 4, 5 * pi / 4}, [&](double t) { return std::max(s(t), c(t)); }},
        {"floor(1.9*p)",
         {third, pi - third, pi, pi + third, 2 * pi - third},
         [&](double t) { return std::floor(1.9 * s(t)); }},
        {"ceil(1.9*p)",
         {third, pi - third, pi, pi + third, 2 * pi - third},
         [&](double t) { return std::ceil(1.9 * s(t)); }},
        {"p>0&&q>0?1:0", {pi / 2, pi, 3 * pi / 2}, [&](double t) { return t < pi / 2 ? 1.0 : 0; }},
        {"p<0||q<0?1:0", {pi / 2, pi, 3 * pi / 2}, [&](double t) { return t < pi / 2 ? 0 : 1.0; }},
        {"!(p>0)?1:2", {pi}, [&](double t) { return t < pi ? 2.0 : 1.0; }}};
    for (const Kind& kind : kinds) {
        const Solver solver = solvedKind(kind.rate);
        EXPECT_NEAR(solver.histories().value(2, 6), integral(kind), 1e-8) << kind.rate;
        const auto restarts = solver.histories().restarts(2);
        for (const double time : kind.switches)
            EXPECT_TRUE(
                std::ranges::any_of(restarts, [&](double t) { return std::abs(t - time) < 1e-8; }))
                << kind.rate << " at " << time;
    }
}

TEST(Switches, WithinSwitchesAreLocated) {
    const double half = std::asin(0.5), third = std::asin(1 / 1.9);
    const auto s = [](double t) { return std::sin(t); };
    const auto c = [](double t) { return std::cos(t); };
    const std::vector<Kind> kinds = {
        {"p>0?(q>0?1:2):(q>0?3:4)",
         {pi / 2, pi, 3 * pi / 2},
         [&](double t) {
             return t < pi / 2 ? 1.0 : t < pi ? 2.0 : t < 3 * pi / 2 ? 4.0 : 3.0;
         }},
        {"min(abs(p),0.5)",
         {half, pi - half, pi, pi + half, 2 * pi - half},
         [&](double t) { return std::min(std::abs(s(t)), 0.5); }},
        {"abs(abs(p)-0.5)",
         {half, pi - half, pi, pi + half, 2 * pi - half},
         [&](double t) { return std::abs(std::abs(s(t)) - 0.5); }},
        {"max(p,0)>0.5?1:min(q,p)",
         {half, pi - half, 5 * pi / 4},
         [&](double t) { return std::max(s(t), 0.0) > 0.5 ? 1.0 : std::min(s(t), c(t)); }},
        {"floor(abs(1.9*p))", {third, pi - third, pi + third, 2 * pi - third}, [&](double t) {
             return std::floor(std::abs(1.9 * s(t)));
         }}};
    for (const Kind& kind : kinds) {
        Kind all = kind;
        if (kind.rate.starts_with("max")) // min(q, p) changes inside the branch too
            all.switches = {half, pi - half, pi, 5 * pi / 4};
        EXPECT_NEAR(solvedKind(kind.rate).histories().value(2, 6), integral(all), 1e-8)
            << kind.rate;
    }
}

// Conditions that are next to constant but for a moment: the time for which each holds, at p = 1 or
// at t = 5.3, is known.
TEST(Switches, ThatHoldForAMomentAreLocated) {
    struct Moment {
        std::string condition;
        double length;
    };
    constexpr double w = 1e-4;
    const std::vector<Moment> moments = {
        {"exp(-((t-5.3)/1e-4)^2)>exp(-1)", 2 * w},
        {"1/(1+((t-5.3)/1e-4)^2)>0.5", 2 * w},
        {"tanh((t-5.3)/1e-4)^2<0.25", 2 * w * std::atanh(0.5)},
        {"hypot(t-5.3,0)<1e-4", 2 * w},
        {"hypot(t-5.3,1e-5)<1e-4", 2 * std::sqrt(w * w - 1e-10)},
        {"sqrt((t-5.3)^2)<1e-4", 2 * w},
        {"(t-5.3)^2<1e-14", 2e-7},
    };
    for (const Moment& moment : moments) {
        EXPECT_NEAR(solvedKind(moment.condition + "?1000:0").histories().value(2, 6),
                    1000 * moment.length, 1e-3 * 1000 * moment.length)
            << moment.condition;
        // Beside something that is integrated.
        const Solver pushed =
            solved(equationsOf({{"x", "v", 0}, {"v", "-x+(" + moment.condition + "?1000:0)", 0}}),
                   6, tolerance(1e-8));
        EXPECT_NEAR(pushed.histories().value(1, 6), 1000 * moment.length * std::cos(0.7),
                    1000 * moment.length * 2e-3)
            << moment.condition;
    }
    const double near = 2 * std::acos(1 - 1e-8); // p is within 1e-8 of its greatest
    EXPECT_NEAR(solvedKind("exp(-((p-1)/1e-8)^2)>exp(-1)?1:0").histories().value(2, 6), near,
                1e-2 * near);
}

// p comes to 1 and goes back: what switches above 1 never does, what switches a millionth below it
// does for a moment of 2 acos(1 - 1e-6), and what only touches has no kink.
TEST(Switches, ThatAreGrazedAreFoundAsFarAsTheyArePassed) {
    EXPECT_EQ(solvedKind("p>1.000001?100:0").histories().value(2, 6), 0);
    const Solver dip = solvedKind("p>0.999999?100:0");
    EXPECT_NEAR(dip.histories().value(2, 6), 200 * std::acos(0.999999), 1e-5);
    EXPECT_GE(dip.histories().restarts(2).size(), 2u);
    // Whole numbers that are touched: an error of 1e-12 passes them for as long as 2e-6.
    EXPECT_NEAR(solvedKind("floor(2*p)").histories().value(2, 6), pi - 6, 3e-6);
    EXPECT_NEAR(solvedKind("ceil(2*p)").histories().value(2, 6), pi, 3e-6);
    // Passed by as little as rounding leaves, too little for the way back to be found.
    for (const double excess : {1e-16, 4e-16, 1e-15, 4e-15, 1.6e-14, 6e-14}) {
        const std::string touching = std::to_string(2e14 * (1 + excess)) + "*p*1e-14";
        EXPECT_NEAR(solvedKind("floor(" + touching + ")").histories().value(2, 6), pi - 6, 3e-6)
            << excess;
        EXPECT_NEAR(solvedKind("ceil(" + touching + ")").histories().value(2, 6), pi, 3e-6)
            << excess;
    }
    const double smooth = 6 - (1 - std::cos(6.0)); // of 1 - sin
    EXPECT_NEAR(solvedKind("abs(p-1.0000001)").histories().value(2, 6), smooth + 6e-7, 1e-8);
    EXPECT_NEAR(solvedKind("max(1-p,0)").histories().value(2, 6), smooth, 1e-7);
}

// Each passing is late by what time is resolved to; were that not made up for, the swings would
// gain 1e-12 of their energy in 160 s, and be off by the cube of the time.
TEST(Switching, SwingsAboutASwitchGainNothingByTheResolutionOfTime) {
    const double top = 0.9, quarter = std::sqrt(2 * top);
    for (const char* force : {"-sign(x)", "-1-2*floor(x)", "x < 0 ? 1 : -1"}) {
        const Solver solver =
            solved(equationsOf({{"x", "dx", top, 1}, {"dx", force, 0}}), 1700, tolerance(1e-7));
        const double x = solver.histories().value(0, 1700), v = solver.histories().value(1, 1700);
        EXPECT_NEAR(v * v / 2 + std::abs(x), top, 4e-12) << force;
        const double phase = std::abs(std::remainder(1700, 4 * quarter));
        const double left = phase < quarter ? phase : 2 * quarter - phase; // since the nearest end
        EXPECT_NEAR(x, (phase < quarter ? 1 : -1) * (top - left * left / 2), 4e-9) << force;
    }
}

// What switches fast does so as often after a late start as after an early one.
TEST(Switching, ALateStartMakesNoSwitchesEndless) {
    for (const double start : {0.0, 1e6}) {
        Options options = tolerance(1e-6);
        options.start = start;
        const Solver solver = solved(equationsOf({{"x", "dx", 1e-4, 1}, {"dx", "-4e5*sign(x)", 0}}),
                                     start + 0.2, options);
        EXPECT_TRUE(solver.histories().stops().empty()) << start;
        const double v = solver.histories().value(1, start + 0.2);
        EXPECT_NEAR(v * v / 2 + 4e5 * std::abs(solver.histories().value(0, start + 0.2)), 40, 0.01);
    }
}

// Of a drive, and of a body that goes round: the rate jumps by 2 pi where the angle does.
TEST(Switching, TheAngleJumpsAtItsCut) {
    const double pi = std::acos(-1.0);
    for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
        const Solver driven =
            solved(equationsOf({{"x", "atan2(sin(t),cos(t))", 0, 1}}), 30, tolerance(accuracy));
        const double left = 30 - 10 * pi; // since the last whole turn
        EXPECT_NEAR(driven.histories().value(0, 30), 0.5 * left * left, 1e-11) << accuracy;
        EXPECT_EQ(driven.statistics().switches, 15u); // ten between left and right, five at the cut
        const Solver round = solved(equationsOf({{"x", "dx", 1, 1},
                                                 {"y", "dy", 0, 1},
                                                 {"dx", "-x", 0},
                                                 {"dy", "-y", 1},
                                                 {"w", "atan2(y,x)", 0}}),
                                    30, tolerance(accuracy));
        EXPECT_NEAR(round.histories().value(4, 30), 0.5 * left * left, 30 * accuracy) << accuracy;
    }
}
