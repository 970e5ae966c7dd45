// Pushes that last a moment are not passed over.
#include "equations/peaks.h"
#include "oversight/peak_centres.h"
#include "oversight/watched_times.h"

#include "expression/testing.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <map>

using namespace solution;
using namespace solution::testing;

namespace {

Options watched(double allowed, const std::string& method = "auto") {
    Options options = tolerance(allowed);
    options.method = method;
    return options;
}

std::vector<Line> pushed(const std::string& push, double speed = 0) {
    return {{"x", "dx", 0, 1}, {"dx", push, speed}};
}

std::string replaced(std::string text, const std::map<char, std::string>& names) {
    for (const auto& [name, value] : names)
        for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
            text.replace(at, 1, value);
    return text;
}

} // namespace

TEST(WatchedTimes, LieAsFarApartAsTimeIsLongAndAreTheSameForAllSteps) {
    const WatchedTimes watched(3);
    const std::vector<double> all = watched.between(4, 103);
    ASSERT_GT(all.size(), 150u);
    ASSERT_LT(all.size(), 200u);
    for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_GT(all[i] - all[i - 1], 0.4 * watched.spacing(all[i]));
        EXPECT_LT(all[i] - all[i - 1], 1.6 * watched.spacing(all[i]));
    }
    EXPECT_EQ(watched.between(all[4], all[9]), std::vector(all.begin() + 5, all.begin() + 9));
    EXPECT_LT(watched.between(3, 1e9).size(), 200u);
}

TEST(Oversight, APushThatLastsAMomentIsFoundByEveryMethod) {
    for (const std::string method : {"auto", "tsit5", "gbs", "radau5", "sdirk4"})
        for (const double width : {1.0, 0.7, 0.3, 0.1, 0.05}) {
            const std::string w = std::to_string(width);
            const Solver s = solved(equationsOf(pushed("5*exp(-((t-4)/" + w + ")^2)")), 10,
                                    watched(1e-6, method));
            const double gained = 5 * width * std::sqrt(std::acos(-1.0));
            EXPECT_NEAR(s.histories().value(1, 10), gained, 1e-4 * gained) << method << " " << w;
        }
}

TEST(Oversight, APlaceThatPushesIsFoundByWhoFliesPast) {
    std::vector<Line> lines = pushed("0", 1);
    lines.push_back({"y", "dy", 0, 1});
    lines.push_back({"dy", "2*exp(-((x-9)/0.4)^2)", 0});
    const Solver s = solved(equationsOf(lines), 20, watched(1e-6));
    const double gained = 0.8 * std::sqrt(std::acos(-1.0));
    EXPECT_NEAR(s.histories().value(3, 20), gained, 1e-4 * gained);
}

// Far narrower than the distance of watched times: found by the sign of what is 0 in its middle.
TEST(Oversight, APushAsShortAsOneLikesIsFoundByEveryMethod) {
    const double pi = std::acos(-1.0);
    struct Shape {
        std::string text; // of u = (t-60)/w
        double area;
    };
    const std::vector<Shape> shapes = {{"exp(-(U)^2)", std::sqrt(pi)},
                                       {"1/(1+(U)^2)^2", pi / 2},
                                       {"1/cosh(U)^2", 2},
                                       {"exp(-abs(U))", 2},
                                       {"exp(-(U)*(U)/2)", std::sqrt(2 * pi)},
                                       {"exp(-(t*t-120*t+3600)/W^2)", std::sqrt(pi)}};
    for (const std::string method : {"auto", "dop853", "gbs", "radau5", "sdirk4"})
        for (const std::string width : {"0.02", "1e-4"})
            for (const Shape& shape : shapes) {
                const std::string text =
                    replaced(shape.text, {{'U', "(t-60)/" + width}, {'W', width}});
                const double area = shape.area * std::stod(width), size = 1 / area;
                const Solver s = solved(equationsOf(pushed(std::to_string(size) + "*" + text)), 100,
                                        watched(1e-6, method));
                EXPECT_NEAR(s.histories().value(1, 100), 1, 1e-4) << method << " " << text;
            }
}

// What is 0 in its middle too, or ends a step there, or has a flat middle.
TEST(Oversight, APushWithTwoHumpsIsFoundByEveryMethod) {
    const double root = std::sqrt(std::acos(-1.0));
    struct Shape {
        std::string text; // of u = (t-A)/w
        double area;
    };
    const std::vector<Shape> shapes = {{"(U)^2*exp(-(U)^2)", root / 2},
                                       {"(U)^2/(1+(U)^2)^3", std::acos(-1.0) / 8},
                                       {"exp(-(U)^4)", 2 * std::tgamma(1.25)},
                                       {"exp(-((U)*(U))^2)", 2 * std::tgamma(1.25)}};
    for (const std::string method : {"auto", "dop853", "tsit5"})
        for (const auto& [middle, finish] : {std::pair("60", 100.0), {"0.1", 1.0}})
            for (const std::string width : {"1e-3", "1e-4", "1e-6"})
                for (const Shape& shape : shapes) {
                    const std::string u = std::string("(t-") + middle + ")/" + width;
                    const std::string text = replaced(shape.text, {{'U', u}});
                    const double size = 1 / (shape.area * std::stod(width));
                    const Solver s = solved(equationsOf(pushed(std::to_string(size) + "*" + text)),
                                            finish, watched(1e-6, method));
                    EXPECT_NEAR(s.histories().value(1, finish), 1, 2e-4) << method << " " << text;
                }
}

// Hills by their forces, which are 0 on their tops: what is too slow for one turns back.
TEST(Oversight, AHillAsNarrowAsOneLikesTurnsBackWhatIsTooSlow) {
    const std::vector<std::string> slopes = {"2*(U)*exp(-(U)^2)", "2*tanh(U)/cosh(U)^2",
                                             "2*(U)/(1+(U)^2)^2"}; // of hills of height 1
    for (const std::string method : {"auto", "tsit5", "radau5"})
        for (const std::string width : {"1", "0.1", "1e-3", "1e-5"})
            for (const std::string& slope : slopes)
                for (const double height : {60.0, 40.0}) { // it comes with 50
                    const std::string force = std::to_string(height / std::stod(width)) + "*" +
                                              replaced(slope, {{'U', "(x-700)/" + width}});
                    const Solver s =
                        solved(equationsOf(pushed(force, 10)), 100, watched(1e-6, method));
                    const double speed = s.histories().value(1, 100);
                    EXPECT_NEAR(speed, height > 50 ? -10 : 10, 1e-2) << method << " " << force;
                }
}

TEST(Oversight, AWallAsThinAsOneLikesIsMetWhereverItIs) {
    for (const std::string method : {"auto", "tsit5", "radau5"})
        for (const std::string width : {"0.01", "1e-5"}) {
            const double area = std::sqrt(std::acos(-1.0)) * std::stod(width);
            const std::string wall =
                std::to_string(17.5 / area) + "*exp(-((x-700)/" + width + ")^2)";
            const Solver s = solved(equationsOf(pushed(wall, 10)), 100, watched(1e-6, method));
            EXPECT_NEAR(s.histories().value(1, 100), std::sqrt(135), 1e-4)
                << method << " " << width;
        }
}

// 0 on both sides, and between two edges that are far apart beside their width.
TEST(Oversight, AForceBetweenTwoEdgesIsFoundByEveryMethod) {
    for (const std::string method : {"auto", "tsit5", "radau5"})
        for (const std::string width : {"1e-2", "1e-4"})
            for (const std::string text : {"tanh((X-A)/W+10)-tanh((X-A)/W-10)",
                                           "2/(1+exp((A-X)/W-10))-2/(1+exp((A-X)/W+10))"}) {
                const std::string force = std::to_string(17.5 / (40 * std::stod(width))) + "*(" +
                                          replaced(text, {{'A', "700"}, {'X', "x"}, {'W', width}}) +
                                          ")";
                const Solver s = solved(equationsOf(pushed(force, 10)), 100, watched(1e-6, method));
                EXPECT_NEAR(s.histories().value(1, 100), std::sqrt(135), 1e-3)
                    << method << " " << force;
            }
}

// It switches in its middle, where steps end.
TEST(Oversight, APeakWithAKinkIsFollowedUpToIt) {
    for (const double allowed : {1e-3, 1e-4, 1e-6}) {
        const Solver s = solved(equationsOf(pushed("875000*exp(-abs((x-700)/1e-5))", 10)), 100,
                                watched(allowed));
        EXPECT_NEAR(s.histories().value(1, 100), std::sqrt(135), 10 * allowed + 1e-4) << allowed;
    }
}

// Within one step it goes through the wall, turns, and comes back through it.
TEST(Oversight, AWallThatIsPassedTwiceInAStepIsMetTwice) {
    for (const double height : {400.0, 499.0, 499.9}) {
        const std::string field = std::to_string(height) + ")/0.01)^2)";
        std::vector<Line> lines = pushed("-10", 100); // up to 500, down at 20
        lines.push_back({"y", "dy", 0, 1});
        lines.push_back({"dy", "30*exp(-((x-" + field, 0});
        const Solver s = solved(equationsOf(lines), 20, watched(1e-6));
        const double speed = std::sqrt(20 * (500 - height));
        const double gained = 2 * 0.3 * std::sqrt(std::acos(-1.0)) / speed;
        EXPECT_NEAR(s.histories().value(3, 20), gained, 2e-3 * gained) << height;
    }
}

TEST(Oversight, PushesThatComeAgainAndAgainAreAllFound) {
    const double pi = std::acos(-1.0), times = 159.5; // at 0, 2 pi, ...
    for (const std::string method : {"auto", "radau5"})
        for (const auto& [push, area] :
             std::map<std::string, double>{{"exp(-(sin(t/2)/1e-3)^2)", 2e-3 * std::sqrt(pi)},
                                           {"cos(t/2)^100000", 2 * std::sqrt(2 * pi / 1e5)}}) {
            const Solver s = solved(equationsOf(pushed(push)), 1000, watched(1e-6, method));
            EXPECT_NEAR(s.histories().value(1, 1000) / (times * area), 1, 2e-4) << method << push;
        }
}

TEST(Oversight, ValuesThatAreHeldFollowTheirPeaks) {
    expression::EquationSet set = equationsOf({{"x", "0"}});
    set.unknowns[0].phases[0].given =
        expression::testing::parsed(set.graph, "1/(1+((t-60)/1e-5)^2)");
    const Solver s = solved(std::move(set), 100, watched(1e-6));
    EXPECT_NEAR(s.histories().value(0, 60), 1, 1e-9);
    EXPECT_NEAR(s.histories().value(0, 60 + 1e-5), 0.5, 1e-6);
}

// Past a heavy point at a distance much smaller than a step: an angle of 2 atan(m / (b v^2)).
TEST(Oversight, AFlyPastAHeavyPointTurnsTheWay) {
    for (const std::string method : {"auto", "dop853"}) {
        const double near = 1e-4, mass = 1e-4;
        std::vector<Line> lines = {{"x", "dx", -60, 1},
                                   {"dx", "-1e-4*x/hypot(x,y)^3", 1},
                                   {"y", "dy", near, 1},
                                   {"dy", "-1e-4*y/hypot(x,y)^3", 0}};
        const Solver s = solved(equationsOf(lines), 100, watched(1e-6, method));
        const double angle = 2 * std::atan(mass / near);
        EXPECT_NEAR(s.histories().value(3, 100), -std::sin(angle), 1e-3) << method;
    }
}

// And first steps, which are limited.
TEST(Oversight, CostsAnEvaluationForEachWatchedTimeAndNoLaterStepWhereThereIsNothing) {
    const auto set = [] { return equationsOf({{"x", "dx", 1, 1}, {"dx", "-x*exp(-0.1*x^2)", 0}}); };
    const Statistics with = solved(set(), 10, watched(1e-6)).statistics();
    Options unwatched = tolerance(1e-6);
    unwatched.isWatched = false;
    const Statistics without = solved(set(), 10, unwatched).statistics();
    EXPECT_LE(with.steps, without.steps + 5);
    EXPECT_EQ(with.rejectedSteps, without.rejectedSteps);
    EXPECT_LE(with.evaluations, without.evaluations + 500);
    EXPECT_GT(with.evaluations, without.evaluations);
}

TEST(Oversight, CostsNothingButFirstStepsWhereNothingCanPeak) {
    const auto set = [] { return equationsOf({{"x", "dx", 1, 1}, {"dx", "-sin(x)", 0}}); };
    Options unwatched = tolerance(1e-6);
    unwatched.isWatched = false;
    const Statistics with = solved(set(), 10, watched(1e-6)).statistics();
    const Statistics without = solved(set(), 10, unwatched).statistics();
    EXPECT_LE(with.steps, without.steps + 5);
    EXPECT_LE(with.evaluations, without.evaluations + 5 * 12);
}

// The reader's own equation is a sum; what it reads is kicked for a moment, and shows it by the
// steps that it takes.
TEST(Oversight, AKickOfWhatIsReadIsSeenByWhoReadsIt) {
    for (const double at : {4.4, 5.3, 6.1, 6.9, 7.7}) {
        std::vector<Line> lines = pushed("5*exp(-((t-" + std::to_string(at) + ")/0.1)^2)-40*dx");
        lines.push_back({"y", "dy", 0, 1});
        lines.push_back({"dy", "10*dx-1e-3*sin(y)", 0});
        const Solver s = solved(equationsOf(lines), 10, watched(1e-6));
        const Solver truth = solved(equationsOf(lines), 10, tolerance(1e-12));
        EXPECT_NEAR(s.histories().value(3, 10), truth.histories().value(3, 10), 1e-5) << at;
    }
}

TEST(Peaks, HaveCentresWhereWhatTheyPeakByIsLeastOrMostOrZero) {
    const auto centresOf = [](const std::string& text) {
        expression::Graph graph;
        const expression::Node c = graph.symbol("c");
        const std::vector outputs = {expression::testing::parsed(graph, text)};
        std::vector<Moving> moving = {{graph.symbol("t"), graph.constant(1)}};
        for (const std::string name : {"x", "z"})
            moving.push_back({graph.symbol(name), graph.symbol("d" + name)});
        std::string all;
        for (const Peaks::Cause& cause : peaksOf(graph, outputs, std::vector{c}, {}, moving).causes)
            all += print(graph, cause.value) + "; " + print(graph, cause.rate) +
                   (cause.ratio > 0 ? " by " + std::to_string(cause.ratio).substr(0, 6) : "") +
                   "; ";
        return all;
    };
    EXPECT_EQ(centresOf("exp(-c*(t-60)^2)"), "-c*(t - 60)^2; -2*c*(t - 60); ");
    EXPECT_EQ(centresOf("exp(-(t*t-120*t+3600)/c)"),
              "-((t^2 - 120*t + 3600)/c); -((2*t - 120)/c); ");
    EXPECT_EQ(centresOf("tanh((x-c)/0.1)"), "(x - c)/0.1; 10*dx; ");
    EXPECT_EQ(centresOf("x/hypot(x,z)^3"), "x^2 + z^2; 2*x*dx + 2*z*dz by 6.3496; ");
    EXPECT_EQ(centresOf("1/(c+(x-3)^4)"), "c + (x - 3)^4; 4*(x - 3)^3*dx by 16.000; ");
    EXPECT_EQ(centresOf("exp(-(t-60)^4)"), "t - 60; 1 by inf; -(t - 60)^4; -4*(t - 60)^3; ");
    EXPECT_EQ(centresOf("1/(t-60)"), "t - 60; 1 by 16.000; ");
    EXPECT_EQ(centresOf("sin(t)^100"), "sin(t); cos(t) by 1.0281; ");
    EXPECT_EQ(centresOf("c*x/hypot(x,z)"), ""); // turns there, and no more
    EXPECT_EQ(centresOf("sin(x)^2+c*t^2"), "");
}

TEST(Peaks, HaveTheirCentresPassedAsOftenAsTheyAre) {
    const auto passed = [](const std::function<double(double)>& value,
                           const std::function<double(double)>& rate, bool isPolynomial) {
        std::size_t asked = 0;
        const auto evaluate = [&](double t, std::span<double> values) {
            values[0] = value(t);
            values[1] = rate(t);
            ++asked;
        };
        const auto times = centresPassed({16}, isPolynomial, evaluate, 0, 10);
        return std::pair(times.size(), asked);
    };
    using Times = std::pair<std::size_t, std::size_t>;
    const auto one = [](double) { return 1; };
    EXPECT_EQ(passed([](double t) { return t + 1; }, one, true), Times(0, 3));
    EXPECT_EQ(passed([](double t) { return t - 4; }, one, true).first, 1u);
    EXPECT_EQ(passed([](double t) { return t; }, one, true).first, 0u); // at the start
    const auto falls = [](double t) { return 2 * (t - 5); };
    EXPECT_EQ(passed([](double t) { return (t - 5) * (t - 5) + 1e-6; }, falls, true).first, 1u);
    EXPECT_EQ(passed([](double t) { return (t - 5) * (t - 5) + 200; }, falls, true), Times(0, 3));
    EXPECT_EQ(passed([](double t) { return (t - 5) * (t - 5) - 0.1; }, falls, true).first, 3u);
    const auto wave = [](double t) { return std::sin(3 * t); };
    const auto waves = [](double t) { return 3 * std::cos(3 * t); };
    EXPECT_EQ(passed(wave, waves, false).first, 9u + 10u);
    // A square touches 0 where it turns.
    EXPECT_EQ(passed([](double t) { return (t - 5) * (t - 5); }, falls, true).first, 1u);
    // What stays as it is, but for rounding.
    EXPECT_EQ(passed([](double t) { return 1 + 1e-12 * std::sin(1e6 * t); }, wave, true).second,
              3u);
}

TEST(CanPeak, IsSaidOfExponentialsAndQuotientsOfWhatMoves) {
    const auto says = [](const std::string& text, std::vector<double> values = {}) {
        expression::Graph graph;
        const expression::Node t = graph.symbol("t"), q = graph.symbol("q"), c = graph.symbol("c");
        (void)t;
        const std::vector outputs = {expression::testing::parsed(graph, text)};
        return canPeak(graph, outputs, std::vector{c}, std::vector{q}, values);
    };
    for (const std::string text : {"exp(-t^2)", "1/(1+t^2)", "c*tanh(t)", "t^-2", "t^8", "2^t"})
        EXPECT_TRUE(says(text)) << text;
    for (const std::string text : {"c*t^2", "sin(c*t)", "t/exp(c)", "t*2/(q*q)", "sqrt(t)"})
        EXPECT_FALSE(says(text)) << text;
    for (const std::string text :
         {"t/(c-cos(t)^2)", "1/(c+sin(t)*cos(2*t))", "1/(abs(sin(t))-c)", "t/(c-sin(t)*sin(t))"}) {
        EXPECT_TRUE(says(text)) << text;
        EXPECT_FALSE(says(text, {2})) << text;
        EXPECT_TRUE(says(text, {1.01})) << text;
    }
    for (const std::string text :
         {"1/(c+t^2)", "1/(c+t*sin(t))", "exp(-t^2)/(c+cos(t))", "1/cos(t)", "1/(c+0.5*exp(-t))"})
        EXPECT_TRUE(says(text, {2})) << text;
}
