// Friction in a plane, k a/|a|: it brings to rest, holds, and lets go.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr double accuracies[] = {1e-2, 1e-4, 1e-6, 1e-8};
constexpr double friction = 2.943;

std::vector<Line> puck(const std::string& forceX, const std::string& forceZ, double dx, double dz) {
    const std::string unit = "/hypot(dx,dz)";
    return {{"x", "dx", 0, 1},
            {"z", "dz", 0, 1},
            {"dx", forceX + "-2.943*dx" + unit, dx},
            {"dz", forceZ + "-2.943*dz" + unit, dz}};
}

using State = std::array<double, 5>; // x, z, dx, dz, t

// The same motion by Runge and Kutta's method over s, with dt = |v| ds: smooth to the rest, which
// lies at the end of all s.
template <class Force> std::vector<State> slid(State y, const Force& force, double until) {
    const auto rates = [&](const State& at) {
        const double v = std::hypot(at[2], at[3]);
        const auto [fx, fz] = force(at);
        return State{v * at[2], v * at[3], v * fx - friction * at[2], v * fz - friction * at[3], v};
    };
    const auto moved = [](const State& from, const State& rate, double h) {
        State to = from;
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += h * rate[i];
        return to;
    };
    const double h = 1e-3;
    std::vector<State> path{y};
    while (y[4] < until && std::hypot(y[2], y[3]) > 1e-12) {
        const State a = rates(y), b = rates(moved(y, a, h / 2)), c = rates(moved(y, b, h / 2)),
                    d = rates(moved(y, c, h));
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
        path.push_back(y);
    }
    return path;
}

// Of both places, at every so many points of that path.
double farthest(const Histories& h, const std::vector<State>& path) {
    double largest = 0;
    for (std::size_t k = 0; k + 1 < path.size(); k += 17)
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
            largest = std::max(largest, std::abs(h.value(i, path[k][4]) - path[k][i]));
    return largest;
}

} // namespace

TEST(PlanarFriction, StopsWhatSlidesStraight) {
    const double v = 5, rest = v / friction;
    for (const std::string length : {"hypot(dx,dz)", "sqrt(dx*dx+dz*dz)", "sqrt(dx^2+dz^2)"})
        for (const double accuracy : accuracies) {
            const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                      {"z", "dz", 0, 1},
                                                      {"dx", "-0.3*9.81*dx/" + length, 3},
                                                      {"dz", "-0.3*9.81*dz/" + length, 4}}),
                                         4, tolerance(accuracy));
            const Histories& h = solver.histories();
            ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
            const auto way = [&](double t) {
                const double s = std::min(t, rest);
                return v * s - friction * s * s / 2;
            };
            EXPECT_LT(worst(h, 0, 0, 4, [&](double t) { return 0.6 * way(t); }), 5 * accuracy);
            EXPECT_LT(worst(h, 1, 0, 4, [&](double t) { return 0.8 * way(t); }), 5 * accuracy);
            EXPECT_EQ(h.value(2, rest + 0.1), 0) << length << " " << accuracy;
            EXPECT_EQ(h.value(3, 4), 0);
            EXPECT_EQ(h.value(0, 4), h.value(0, rest + 0.1));
            EXPECT_LT(solver.statistics().steps, 60u);
        }
}

// Along an axis the other speed is 0 throughout, and so is no part of the length.
TEST(PlanarFriction, StopsWhatSlidesAlongAnAxisHoweverTheLengthIsWritten) {
    for (const std::string divided :
         {"dx/hypot(dx,dz)", "dx/sqrt(dx*dx+dz*dz)", "dx/(dx^2+dz^2)^0.5", "dx*(dx^2+dz^2)^-0.5",
          "2*dx/sqrt(dz^2+4*dx^2)", "dx/sqrt(dz^2+dx^2+dy^2)"})
        for (const double accuracy : accuracies) {
            SCOPED_TRACE(divided);
            const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                      {"z", "dz", 0, 1},
                                                      {"dx", "-2.943*" + divided, 5},
                                                      {"dy", "-dy", 0},
                                                      {"dz", "-2.943*dz/hypot(dx,dy,dz)", 0}}),
                                         4, tolerance(accuracy));
            const Histories& h = solver.histories();
            ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
            EXPECT_LT(worst(h, 0, 0, 4,
                            [&](double t) {
                                const double s = std::min(t, 5 / friction);
                                return 5 * s - friction * s * s / 2;
                            }),
                      5 * accuracy);
            EXPECT_LT(solver.statistics().steps, 60u);
        }
}

// Below the slope that friction holds it comes to rest, above it goes on.
TEST(PlanarFriction, OnASlopeItTurnsDownwardsAndRestsOrGoesOn) {
    for (const double pull : {1.0, 2.0, 3.5})
        for (const double accuracy : accuracies) {
            const Solver solver =
                solved(equationsOf(puck(std::to_string(pull), "0", -1, 2)), 3, tolerance(accuracy));
            const Histories& h = solver.histories();
            ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
            const auto path = slid(
                {0, 0, -1, 2, 0}, [&](const State&) { return std::pair(pull, 0.0); }, 3);
            EXPECT_LT(farthest(h, path), 5 * accuracy) << pull;
            EXPECT_LT(solver.statistics().steps, 150u) << pull << " " << accuracy;
            if (pull < friction) {
                EXPECT_NEAR(h.value(0, 3), path.back()[0], 5 * accuracy);
                EXPECT_EQ(h.value(2, 3), 0);
                EXPECT_EQ(h.value(3, 3), 0);
                EXPECT_NEAR(h.value(1, 3), path.back()[1], 5 * accuracy);
            } else {
                EXPECT_GT(h.value(2, 3), 1);
            }
        }
}

// Straight up a slope that friction does not hold: it stands for no time, and comes down.
TEST(PlanarFriction, WhatGoesUpStraightComesDownStraight) {
    for (const double accuracy : accuracies) {
        const Solver solver =
            solved(equationsOf(puck("3.5*0.6", "3.5*0.8", -1.2, -1.6)), 5, tolerance(accuracy));
        const double up = 2 / (3.5 + friction), down = 5 - up;
        const double way = (3.5 - friction) * down * down / 2 - 2 * up / 2;
        EXPECT_NEAR(solver.histories().value(0, 5), 0.6 * way, 20 * accuracy);
        EXPECT_NEAR(solver.histories().value(1, 5), 0.8 * way, 20 * accuracy);
        EXPECT_LT(solver.statistics().steps, 60u);
    }
}

// Where nothing moves before that time.
Solver heldUntil(double begins, const std::vector<Line>& lines, double finish, double accuracy) {
    Solver solver = solved(equationsOf(lines), finish, tolerance(accuracy));
    EXPECT_EQ(solver.histories().stop(2), nullptr);
    EXPECT_EQ(solver.histories().value(0, begins - 1e-6), 0);
    return solver;
}

// It holds until the pull is as strong as friction, and then goes the way of the pull.
TEST(PlanarFriction, LetsGoWhenThePullIsStronger) {
    const double begins = friction / 1.5;
    for (const double accuracy : accuracies) {
        const Solver solver = heldUntil(begins, puck("1.5*0.6*t", "1.5*0.8*t", 0, 0), 5, accuracy);
        const Histories& h = solver.histories();
        const double s = 5 - begins, way = 1.5 * s * s * s / 6;
        EXPECT_NEAR(h.value(0, 5), 0.6 * way, 5 * accuracy);
        EXPECT_NEAR(h.value(1, 5), 0.8 * way, 5 * accuracy);
        EXPECT_LT(solver.statistics().steps, 60u);
    }
}

// A pull that turns as it grows: at first friction points along the pull, a' = F - k F/|F|, which
// the midpoint rule takes through the first thousandth of a second.
TEST(PlanarFriction, LetsGoInTheDirectionOfThePull) {
    const auto force = [](const State& at) { return std::pair(1.5 * at[4], 0.7); };
    const double begins = std::sqrt(friction * friction - 0.49) / 1.5;
    State start{0, 0, 0, 0, begins};
    const int parts = 20000;
    const double h = 1e-3 / parts;
    for (int k = 0; k < parts; ++k) {
        const auto [fx, fz] = force({0, 0, 0, 0, start[4] + h / 2});
        const double surplus = 1 - friction / std::hypot(fx, fz);
        start = {start[0] + h * start[2], start[1] + h * start[3], start[2] + h * surplus * fx,
                 start[3] + h * surplus * fz, start[4] + h};
    }
    const auto path = slid(start, force, 4);
    for (const double accuracy : accuracies) {
        const Solver solver = heldUntil(begins, puck("1.5*t", "0.7", 0, 0), 4, accuracy);
        EXPECT_LT(farthest(solver.histories(), path), 10 * accuracy + 2e-9);
        EXPECT_LT(solver.statistics().steps, 300u);
    }
}

// A spring that is drawn away: slips and sticks, since friction at rest is more than in motion. It
// is drawn straight, so that it is the motion along one axis, whose switch is a sign.
TEST(PlanarFriction, SticksAndSlipsOnASpringAsAlongOneAxis) {
    const std::string pulls = "-20*(x-0.5*t)", rubs = "(2+exp(-3*hypot(dx,dz)))";
    const auto across = [&](double part) {
        const std::string p = std::to_string(part);
        return "-20*(" + std::string(part > 0.7 ? "z" : "x") + "-0.5*" + p + "*t)-" + rubs + "*" +
               (part > 0.7 ? "dz" : "dx") + "/hypot(dx,dz)";
    };
    const Solver along = solved(
        equationsOf({{"s", "ds", 0, 1}, {"ds", "-20*(s-0.5*t)-(2+exp(-3*abs(ds)))*sign(ds)", 0}}),
        5, tolerance(1e-10));
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                  {"z", "dz", 0, 1},
                                                  {"dx", across(0.6), 0},
                                                  {"dz", across(0.8), 0}}),
                                     5, tolerance(accuracy));
        ASSERT_EQ(solver.histories().stop(2), nullptr) << solver.histories().stop(2)->sentence;
        for (double t = 0.25; t <= 5; t += 0.25) {
            const double s = along.histories().value(0, t);
            EXPECT_NEAR(solver.histories().value(0, t), 0.6 * s, 10 * accuracy) << t;
            EXPECT_NEAR(solver.histories().value(1, t), 0.8 * s, 10 * accuracy) << t;
        }
        EXPECT_LT(solver.statistics().steps, 300u);
    }
}

// On a plate that moves on springs: both come to move together, and their momentum is that of the
// springs' pull, which here is none.
TEST(PlanarFriction, TakesAnotherBodyAlong) {
    const std::string x = "2*(dx-du)/hypot(dx-du,dz-dw)", z = "2*(dz-dw)/hypot(dx-du,dz-dw)";
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                  {"z", "dz", 0, 1},
                                                  {"u", "du", 0, 1},
                                                  {"w", "dw", 0, 1},
                                                  {"dx", "-" + x, 1.2},
                                                  {"dz", "-" + z, 1.6},
                                                  {"du", x + "/4", 0},
                                                  {"dw", z + "/4", 0}}),
                                     4, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(4), nullptr) << h.stop(4)->sentence;
        const double together = 2 / 2.5, way = 2 * together / 2; // of one over the other
        EXPECT_NEAR(h.value(0, 4) - h.value(2, 4), 0.6 * way, 5 * accuracy);
        EXPECT_NEAR(h.value(4, 4), 1.2 / 5, accuracy);
        EXPECT_NEAR(h.value(4, 4) - h.value(6, 4), 0, 1e-13);
        EXPECT_NEAR(h.value(5, 4) - h.value(7, 4), 0, 1e-13);
        EXPECT_NEAR(h.value(4, 4) + 4 * h.value(6, 4), 1.2, 5 * accuracy);
        EXPECT_LT(solver.statistics().steps, 60u);
    }
}

// What lies on a belt is carried until the belt turns back at t = 2, and then slides.
TEST(PlanarFriction, ABeltThatTurnsBackCarriesNothingAtOnce) {
    const std::string belt = "(t<2?0.6:-0.6)", unit = "/hypot(dx-" + belt + ",dz)";
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                  {"z", "dz", 0, 1},
                                                  {"dx", "-2*(dx-" + belt + ")" + unit, 0.6},
                                                  {"dz", "-2*dz" + unit, 0}}),
                                     4, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
        EXPECT_NEAR(h.value(0, 2), 1.2, accuracy);
        EXPECT_NEAR(h.value(2, 2.5), -0.4, accuracy);
        EXPECT_NEAR(h.value(0, 4), 1.2 - 0.6 * 1.4, 5 * accuracy);
    }
}

// What lies on a plate that sways is carried and slides in turn, and lets go while its vector is
// 0 but for what the integration errs, falling by next to nothing. Along a line it is the motion
// along one axis, whose switch is a sign.
TEST(PlanarFriction, APlateThatSwaysCarriesAndLetsGo) {
    const Solver along =
        solved(equationsOf({{"s", "ds", 0, 1}, {"ds", "-sign(ds-0.4*sin(5*t))", 0.4}}), 5,
               tolerance(1e-10));
    for (const auto& [x, z] : {std::pair(1.0, 0.0), std::pair(0.6, 0.8)})
        for (const double accuracy : {1e-3, 5e-4, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
            const std::string p = "0.4*sin(5*t)*", dx = "(dx-" + p + std::to_string(x) + ")",
                              dz = "(dz-" + p + std::to_string(z) + ")",
                              unit = "/hypot(" + dx + "," + dz + ")";
            const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                                      {"z", "dz", 0, 1},
                                                      {"dx", "-" + dx + unit, 0.4 * x},
                                                      {"dz", "-" + dz + unit, 0.4 * z}}),
                                         5, tolerance(accuracy));
            ASSERT_EQ(solver.histories().stop(2), nullptr) << solver.histories().stop(2)->sentence;
            for (double t = 0.25; t <= 5; t += 0.25) {
                const double s = along.histories().value(0, t);
                EXPECT_NEAR(solver.histories().value(0, t), x * s, 10 * accuracy) << accuracy;
                EXPECT_NEAR(solver.histories().value(1, t), z * s, 10 * accuracy) << accuracy;
            }
            EXPECT_LT(solver.statistics().steps, 500u) << accuracy;
        }
}

// It slips at 2.78 s, and next to rest hardly moves at first: rates that lead back to rest by
// rounding lead nowhere. An independent integration ends within 2e-9 of these places.
TEST(PlanarFriction, SlipsOffATableThatIsSpunUp) {
    const std::string u = "(dx+0.5*t*z)", w = "(dz-0.5*t*x)",
                      length = "/hypot" + ("(" + u) + "," + w + ")";
    for (const double accuracy : {1e-2, 1e-4, 1e-5, 1e-6, 3e-7, 1e-7, 1e-8}) {
        const Solver solver = solved(equationsOf({{"x", "dx", 0.5, 1},
                                                  {"z", "dz", 0, 1},
                                                  {"dx", "-" + u + length, 0},
                                                  {"dz", "-" + w + length, 0}}),
                                     5, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
        EXPECT_NEAR(h.value(0, 5), 0.12308641637, 5 * accuracy);
        EXPECT_NEAR(h.value(1, 5), -1.39398308538, 5 * accuracy);
        EXPECT_LT(solver.statistics().steps, 300u);
    }
}

// Two on a spring, thrown or let go along its line, aslant to the axes.
struct Pair {
    double m0, m1;              // masses
    double k0, k1;              // friction
    double stiffness;           // of the spring
    std::array<double, 2> rest; // of the spring
    std::array<double, 8> start;
    std::array<double, 4> end; // places after 4 s, by an independent integration
};

std::vector<Line> linesOf(const Pair& p) {
    const auto number = [](double v) {
        std::ostringstream text;
        text << std::setprecision(17) << '(' << v << ')';
        return text.str();
    };
    const auto slowed = [&](const std::string& name, double sign, double mass, double friction) {
        std::vector<std::string> forces;
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            const std::string axis = i == 0 ? "x" : "z", of = "d" + axis + name;
            forces.push_back(number(sign * p.stiffness / mass) + "*(" + axis + "b-" + axis + "a-" +
                             number(p.rest.at(i)) + ")-" + number(friction / mass) + "*" + of +
                             "/hypot(dx" + name + ",dz" + name + ")");
        }
        return forces;
    };
    const auto a = slowed("a", 1, p.m0, p.k0), b = slowed("b", -1, p.m1, p.k1);
    return {{"xa", "dxa", p.start[0], 1}, {"za", "dza", p.start[1], 1},
            {"dxa", a[0], p.start[2]},    {"dza", a[1], p.start[3]},
            {"xb", "dxb", p.start[4], 1}, {"zb", "dzb", p.start[5], 1},
            {"dxb", b[0], p.start[6]},    {"dzb", b[1], p.start[7]}};
}

// Where what pulls is nearly as strong as friction, steps towards rest swung about the way for
// millions; where both set off at once, no motion was found.
TEST(PlanarFriction, TwoOnASpringAlongALineAslantComeToRestAndSetOff) {
    const Pair pairs[] = {{2.05,
                           2.42,
                           4.504752,
                           3.2998878000000005,
                           19.9,
                           {0.9509738925181552, 0.36884774060426123},
                           {0, 0, 1.4730772060575346, 0.5713523825046399, 0.9323273456060345,
                            0.361615431964962, 2.5545769269605345, 0.9908262835839959},
                           {1.4058192755, 0.5452655089, 2.2888817456, 0.88777291051}},
                          {2.13,
                           2.53,
                           2.0268441,
                           3.8221722,
                           6.1,
                           {0.7707916475285035, 0.3078639896127756},
                           {0, 0, -0.8450848183746243, -0.33753762716581426, 0.9286646355765102,
                            0.3709204694129827, -0.3528925615190739, -0.14094977837693343},
                           {-0.21305099774, -0.085095278818, 0.85748357225, 0.34248984719}},
                          {1,
                           1,
                           0.981,
                           0.981,
                           20,
                           {1.6506712298193567, 1.1292849467900707},
                           {0, 0, 0, 0, 0.8253356149096783, 0.5646424733950354, 0, 0},
                           {-0.32479833155, -0.2222064939, 1.1501339465, 0.7868489673}}};
    for (const Pair& pair : pairs)
        for (const double accuracy : accuracies) {
            const Solver solver = solved(equationsOf(linesOf(pair)), 4, tolerance(accuracy));
            const Histories& h = solver.histories();
            ASSERT_EQ(h.stop(2), nullptr) << h.stop(2)->sentence;
            for (const std::size_t i : {0, 1, 4, 5})
                EXPECT_NEAR(h.value(i, 4), pair.end.at(i < 2 ? i : i - 2), 20 * accuracy)
                    << accuracy;
            EXPECT_LT(solver.statistics().steps, 3000u) << accuracy;
        }
}

// In space, weaker along one axis, and as steps of fixed length make it.
TEST(PlanarFriction, InSpaceAndByAxes) {
    const std::string unit = "/sqrt(dx^2+dy^2+dz^2)";
    const Solver space = solved(equationsOf({{"x", "dx", 0, 1},
                                             {"y", "dy", 0, 1},
                                             {"z", "dz", 0, 1},
                                             {"dx", "-2*dx" + unit, 1},
                                             {"dy", "-2*dy" + unit, 2},
                                             {"dz", "-2*dz" + unit, 2}}),
                                4, tolerance(1e-8));
    EXPECT_NEAR(space.histories().value(1, 4), 2.0 / 3 * 9 / 4, 1e-7);
    EXPECT_EQ(space.histories().value(4, 4), 0);
    // Held while (Fx/1)^2 + (Fz/3)^2 < 1.
    const Solver axes = solved(equationsOf({{"x", "dx", 0, 1},
                                            {"z", "dz", 0, 1},
                                            {"dx", "0.1*t-dx/hypot(dx,dz)", 0},
                                            {"dz", "0.4*t-3*dz/hypot(dx,dz)", 0}}),
                               7, tolerance(1e-8));
    const double begins = 6; // (0.6)^2 + (2.4/3)^2 = 1
    EXPECT_EQ(axes.histories().value(0, begins - 1e-6), 0);
    EXPECT_GT(axes.histories().value(2, begins + 1e-2), 0);
    Options fixed;
    fixed.method = "rk4";
    fixed.fixedStep = 0.01;
    const Solver steps = solved(equationsOf(puck("1", "0", -1, 2)), 3, fixed);
    EXPECT_EQ(steps.histories().value(2, 3), 0);
    EXPECT_LT(steps.statistics().steps, 1000u); // of three components
}

// What else reads the force reads what holds, as a gauge does.
TEST(PlanarFriction, AGaugeReadsWhatHolds) {
    std::vector<Line> lines = puck("2", "1", 0, 0);
    lines.push_back({"g", "2.943*dx/hypot(dx,dz)", 0});
    const Solver solver = solved(equationsOf(lines), 4, tolerance(1e-6));
    ASSERT_EQ(solver.histories().stop(4), nullptr) << solver.histories().stop(4)->sentence;
    EXPECT_NEAR(solver.histories().value(4, 4), 8, 1e-6);
    EXPECT_EQ(solver.histories().value(0, 4), 0);
}

// Force along the speed is no friction, a root beside it is no length: nothing is held.
TEST(PlanarFriction, WhatDrivesIsNotHeld) {
    const Solver solver = solved(equationsOf({{"x", "dx", 0, 1},
                                              {"z", "dz", 0, 1},
                                              {"dx", "2*dx/hypot(dx,dz)", 0.3},
                                              {"dz", "2*dz/hypot(dx,dz)", 0.4}}),
                                 4, tolerance(1e-8));
    EXPECT_NEAR(solver.histories().value(2, 4), 0.6 * 8.5, 1e-7);
}
