// Pushes that last a moment are not passed over.
#include "solution/oversight.h"

#include "expression/testing.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

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

TEST(Oversight, CostsAnEvaluationForEachWatchedTimeAndNoStepWhereThereIsNothing) {
    const auto set = [] { return equationsOf({{"x", "dx", 1, 1}, {"dx", "-x*exp(-0.1*x^2)", 0}}); };
    const Statistics with = solved(set(), 10, watched(1e-6)).statistics();
    Options unwatched = tolerance(1e-6);
    unwatched.isWatched = false;
    const Statistics without = solved(set(), 10, unwatched).statistics();
    EXPECT_EQ(with.steps, without.steps);
    EXPECT_EQ(with.rejectedSteps, without.rejectedSteps);
    EXPECT_LE(with.evaluations, without.evaluations + 500);
    EXPECT_GT(with.evaluations, without.evaluations);
}

TEST(Oversight, CostsNothingWhereNothingCanPeak) {
    const auto set = [] { return equationsOf({{"x", "dx", 1, 1}, {"dx", "-sin(x)", 0}}); };
    Options unwatched = tolerance(1e-6);
    unwatched.isWatched = false;
    EXPECT_EQ(solved(set(), 10, watched(1e-6)).statistics().evaluations,
              solved(set(), 10, unwatched).statistics().evaluations);
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
