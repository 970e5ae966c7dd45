// Motion that is held between the branches of its switches: on several at once, to which it comes
// in ever shorter swings, and on the whole numbers of floor and ceil.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr double accuracies[] = {1e-3, 1e-6, 1e-9};

std::vector<Line> body(const std::string& force, double x, double dx = 0) {
    return {{"x", "dx", x, 1}, {"dx", force, dx}};
}

void expectAt(const std::vector<Line>& lines, double t, double x, double dx, double off = 1e-9) {
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf(lines), t, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr) << lines[1].derivative << ": " << h.stop(1)->sentence;
        EXPECT_NEAR(h.value(0, t), x, 10 * accuracy + off) << lines[1].derivative;
        EXPECT_NEAR(h.value(1, t), dx, 10 * accuracy + off) << lines[1].derivative;
        EXPECT_LT(solver.statistics().steps, 1000u) << lines[1].derivative << " at " << accuracy;
    }
}

// The time at which -sign(x) - sign(dx)/2 has brought x from 1 at rest to 0: 2 s for the first way,
// then swings, each 1/sqrt(3) of the one before.
double lastSwing() {
    const double shrink = 1 / std::sqrt(3.0);
    return 2 + (1 / 1.5 + 2 * shrink) / (1 - shrink);
}

} // namespace

TEST(Holding, EverShorterSwingsEndWhereTheyLead) {
    const std::vector<Line> lines = body("-sign(x)-0.5*sign(dx)", 1);
    expectAt(lines, lastSwing() + 4, 0, 0);
    const Solver solver = solved(equationsOf(lines), 100, tolerance(1e-9));
    for (double t = lastSwing() + 1e-6; t < 100; t += 9) {
        EXPECT_LT(std::abs(solver.histories().value(0, t)), 1e-15);
        EXPECT_LT(std::abs(solver.histories().value(1, t)), 1e-12);
    }
    EXPECT_NE(solver.histories().value(1, lastSwing() - 1e-6), 0);
    EXPECT_LT(solver.statistics().switches, 150u);
    EXPECT_LT(solver.statistics().steps, 300u);
}

TEST(Holding, WithASpringADamperOrAWind) {
    expectAt(body("-sign(x)-0.5*sign(dx)-x", 1), 20, 0, 0);
    expectAt(body("-2*sign(x)-0.9*sign(dx)-dx", 1), 20, 0, 0);
    expectAt(body("-sign(x)-0.5*sign(dx)+0.3*sin(t)", 1), 20, 0, 0);
    expectAt(body("-sign(x-0.1*t)-0.5*sign(dx-0.1)", 1), 20, 2, 0.1);
    expectAt(body("-3*sign(2*x-1)-sign(dx+0.2*(x-0.5))", 2), 20, 0.5, 0);
}

// Friction 2 binds two bodies, one of which is pulled by 1: both gain speed by 1/2, whichever way
// it is written; a gauge of it reads 1 of a block that is pulled by 1 and held.
TEST(Holding, ByFrictionThatIsWrittenInTwoWays) {
    for (const std::string force :
         {"2*sign(dx-dy)", "-2*sign(dy-dx)", "2*sign(3*(dx-dy))", "2*sign(3*dx-3*dy)",
          "dx/2>dy/2?2:-2", "2*sign((dx-dy)*abs(dx-dy))"}) {
        std::vector<Line> lines = body("1-2*sign(dx-dy)", 0);
        lines.push_back({"y", "dy", 0, 1});
        lines.push_back({"dy", force, 0});
        const Solver solver = solved(equationsOf(lines), 4);
        ASSERT_EQ(solver.histories().stop(3), nullptr) << force;
        EXPECT_NEAR(solver.histories().value(1, 4), 2, 1e-9) << force;
        EXPECT_NEAR(solver.histories().value(3, 4), 2, 1e-9) << force;
    }
    std::vector<Line> gauge = body("1-2*sign(dx)", 0);
    gauge.push_back({"g", "-2*sign(3*dx)", 0});
    EXPECT_NEAR(solved(equationsOf(gauge), 4).histories().value(2, 4), -4, 1e-9);
}

TEST(Holding, ByWhatHasNoSlopeThere) {
    expectAt(body("1-2*sign(dx*abs(dx))", 1, -1), 4, 1 - 1.0 / 6, 0);
    expectAt(body("1-2*sign(max(0,dx)^2)", 1, -1), 4, 0.5, 0);
    expectAt(body("-sign(sign(dx)*sqrt(abs(dx)))", 0, 1), 4, 0.5, 0);
}

// The denominator is kept away from 0, and has no value a little beyond it on the other branch.
TEST(Holding, AtTheEndOfABranchThatHasNoValueBeyond) {
    for (const std::string small : {"1e-8", "1e-9", "1e-10", "1e-12"})
        expectAt(body("-dx/sqrt(abs(dx)+" + small + ")", 0, -1), 4, -2.0 / 3, 0, 1e-4);
}

// What is more than both together lets it go: from t = 23 on, when the push is 1.5.
TEST(Holding, LetsGoWhenItIsOvercome) {
    const std::string force = "-sign(x)-0.5*sign(dx)+max(0,0.1*(t-8))";
    expectAt(body(force, 1), 22, 0, 0);
    expectAt(body(force, 1), 26, 0.1 * 27 / 6, 0.1 * 9 / 2, 1e-6);
}

// Swings that grow, and swings that stay as they are, are none that end.
TEST(Holding, SwingsThatDoNotShrinkGoOn) {
    const Solver solver = solved(equationsOf(body("-sign(x)", 1)), 100, tolerance(1e-6));
    ASSERT_EQ(solver.histories().stop(1), nullptr);
    const double quarter = std::sqrt(2.0), phase = std::fmod(100, 4 * quarter);
    EXPECT_NEAR(solver.histories().value(0, 100), std::pow(phase - 2 * quarter, 2) / 2 - 1, 1e-4);
    EXPECT_NE(solved(equationsOf(body("-sign(x)+0.3*sign(dx)", 0, 1e-6)), 20, tolerance(1e-6))
                  .histories()
                  .value(0, 20),
              0);
}

// From 2.3 by -2.25, -1.25 and -0.25 to 0, where it is held.
TEST(Holding, OnAWholeNumberOfTheVelocity) {
    const double way = 2.15 * 0.3 / 2.25 + 1.5 / 1.25 + 0.5 / 0.25;
    expectAt(body("-0.25-floor(dx)", 0, 2.3), 10, way, 0);
    expectAt(body("-0.25-floor(dx)", 0, 0), 10, 0, 0);
    expectAt(body("0.25-ceil(dx)", 0, -2.3), 10, -way, 0);
}

// Along x + dx/2 = 1: x goes to 1 as exp(-2t), from where it comes to there.
TEST(Holding, AlongAWholeNumberOfPlaceAndVelocity) {
    for (const double accuracy : accuracies) {
        const Solver solver =
            solved(equationsOf(body("-floor(x+0.5*dx)", 0.5, 0.4)), 6, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr) << h.stop(1)->sentence;
        // It gets there by itself, at x = 0.8, and is on that line at once.
        const double left = 0.2 * std::exp(-2 * (6 - 0.75));
        EXPECT_NEAR(h.value(0, 6), 1 - left, 10 * accuracy);
        EXPECT_NEAR(h.value(1, 6), 2 * left, 10 * accuracy);
        EXPECT_LT(solver.statistics().switches, 10u);
    }
}

// Beyond the step nothing acts: it goes on at that speed, as where it is written with comparisons.
TEST(Holding, NothingThatActsBeyondAStepIsRest) {
    const double before = 2.15 * 0.15 + 1.5; // by 2 and by 1, for 1.15 s
    for (const char* force : {"-floor(dx)", "-(dx>=1)-(dx>=2)", "1-ceil(dx)", "-floor(dx+5)+5"})
        expectAt(body(force, 0, 2.3), 10, before + 8.85, 1);
    expectAt(body("-ceil(dx)", 0, -2.3), 10, -before - 8.85, -1);
    expectAt(body("-floor(dx+0.5)", 0, 2.3), 10, 1.9 * 0.4 + 1 + 0.5 * 8.6, 0.5);
    expectAt(body("-floor(dx)", 0, 1), 5, 5, 1);
}

// sign at 0, floor and ceil at whole numbers, comparisons with these: they switch together, however
// they are written and whichever way the motion comes.
TEST(Holding, OnWhatSwitchesAtTheSamePlace) {
    const double way = 2.15 * 0.1 + 1.5 * 0.5 + 0.5; // by 3, by 2 and by 1
    for (const char* force :
         {"-sign(dx)-floor(dx)", "-floor(dx)-sign(2*dx)", "-sign(dx)+1-ceil(dx)",
          "-sign(dx)-floor(dx+3)+3", "-floor(dx)-(dx>0?1:-1)", "-0.5-(ceil(dx)+floor(dx))/2"})
        expectAt(body(force, 0, 2.3), 10, way, 0);
    expectAt(body("sign(-dx)-ceil(dx)", 0, -2.3), 10, -way, 0);
    expectAt(body("-0.3-ceil(dx)-floor(dx)", 0, 2.3), 10, 2.15 * 0.3 / 5.3 + 1.5 / 3.3 + 0.5 / 1.3,
             0);
}

// Friction that is written with sign and floor of the same speed keeps the momentum of two bodies,
// one of which has it the other way round.
TEST(Holding, OnWhatSwitchesAtTheSamePlaceOfTwoBodies) {
    for (const char* force : {"sign(dx-dy)+floor(dx-dy)", "-sign(dy-dx)-ceil(dy-dx)"}) {
        std::vector<Line> lines = body("-sign(dx-dy)-floor(dx-dy)", 0, 2.3);
        lines.push_back({"y", "dy", 0, 1});
        lines.push_back({"dy", force, 0});
        expectAt(lines, 6, 0.5 * (2.3 * 6 + 2.15 * 0.05 + 1.5 * 0.25 + 0.5 * 0.5), 1.15);
    }
}

// The same where it moves on by itself, so that rounding alone says on which side of the step it
// is.
TEST(Holding, RestOnAStepWhileOthersMove) {
    expectAt(body("-1.3*ceil(dx)-1.3*ceil(x)", -0.2, -1.4), 0.7,
             -0.2 - 1.2 * 0.4 / 1.3 - (0.7 - 0.4 / 1.3), -1);
    std::vector<Line> lines = body("-9.8-x-floor(dx-dy)", 0, 2.3);
    lines.push_back({"y", "dy", 0, 1});
    lines.push_back({"dy", "-9.8-x", 0});
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf(lines), 6, tolerance(accuracy));
        const Histories& h = solver.histories();
        ASSERT_EQ(h.stop(1), nullptr) << h.stop(1)->sentence;
        EXPECT_NEAR(h.value(1, 6) - h.value(3, 6), 1, 1e-9);
        EXPECT_NEAR(h.value(0, 6) - h.value(2, 6), 1.8225 + 4.85, 10 * accuracy + 1e-9);
        EXPECT_LT(solver.statistics().switches, 12u);
    }
}

// Two bodies that rub on the ground and on each other come to rest at the same time: of three
// switches no two say all, and no order of passing them comes to an end.
TEST(Holding, WhereMoreSwitchesMeetThanThereAreSpeeds) {
    const auto expectEnd = [](const std::vector<Line>& lines, double dx, double dy) {
        for (const double accuracy : accuracies) {
            const Solver solver = solved(equationsOf(lines), 9, tolerance(accuracy));
            ASSERT_EQ(solver.histories().stop(1), nullptr) << solver.histories().stop(1)->sentence;
            EXPECT_NEAR(solver.histories().value(1, 9), dx, 1e-12);
            EXPECT_NEAR(solver.histories().value(3, 9), dy, 1e-12);
        }
    };
    expectEnd({{"x", "dx", 0, 1},
               {"dx", "-2*sign(dx-dy)-0.5*floor(dx)-sign(dx)", 1.5},
               {"y", "dy", 0, 1},
               {"dy", "2*sign(dx-dy)-0.5*floor(dy)-sign(dy)", 0.5}},
              0, 0);
    expectEnd({{"x", "dx", 0, 1},
               {"dx", "-0.7*floor(dx-dy)-1.3*ceil(dx)-0.7*floor(2*dx)+0.3*ceil(dx)", 0},
               {"y", "dy", 0, 1},
               {"dy", "0.3*ceil(dy)-0.7*floor(dy-dx)-0.5*floor(dy)+0.25-0.25*dy", 0.9}},
              0, 1);
}

// A belt that turns back, or goes faster from some place on: what it carried rubs until it keeps
// pace again. The guard is far from 0 then, although the motion was held there.
TEST(Holding, EndsWhereItsGuardJumps) {
    const double ramp = 0.5; // seconds of rubbing from 0 to 1 at 2
    for (const char* friction : {"2*sign((t<3?1:-1)-dx)", "dx < (t<3?1:-1) ? 2 : -2"}) {
        const auto belt = body(friction, 0);
        expectAt(belt, 3, 3 - ramp / 2, 1);
        expectAt(belt, 3.75, 2.9375, -0.5);
        expectAt(belt, 6, 0.75, -1);
    }
    const auto two = body("2*sign((x<2?1:2)-dx)", 0);
    expectAt(two, 2.25 + ramp / 2, 2 + ramp / 2 + ramp * ramp / 4, 1.5);
    expectAt(two, 5.75, 2 + 1.5 * ramp + 2 * 3, 2);
    expectAt(body("2*sign(floor(t/2)-dx)", 0), 5, 0.25 + 1.5 + 0.75 + 1, 2);
    const double turn = std::acos(-1.0);
    const auto square = body("2*sign(sign(sin(t))-dx)", 0);
    expectAt(square, 0.25, 0.0625, 0.5);
    expectAt(square, turn, turn - ramp / 2, 1);
    expectAt(square, turn + 0.75, turn - 0.0625, -0.5);
}

// Time-optimal control: braked along the switching curve, it comes to its end in 2 sqrt(3) and
// stays there.
TEST(Holding, ASwitchingCurveLeadsToRest) {
    const auto lines = body("-sign(x+dx*abs(dx)/2)", 3);
    const double turn = std::sqrt(3.0);
    expectAt(lines, turn + 1, 1.5 - turn + 0.5, 1 - turn);
    expectAt(lines, 6, 0, 0);
    for (const double accuracy : accuracies) {
        const Solver solver = solved(equationsOf(lines), 100, tolerance(accuracy));
        EXPECT_EQ(solver.histories().value(1, 4), 0);
        EXPECT_LT(solver.statistics().steps, 1000u);
    }
    expectAt(body("-2*sign(x-1+dx*abs(dx)/4)", 3, -1), 12, 1, 0);
}
