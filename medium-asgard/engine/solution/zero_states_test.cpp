// What stays 0 is not integrated, until an event wakes it.
#include "equations/zero_states.h"
#include "solution/solver_testing.h"

#include <gmock/gmock.h>

#include <cmath>
#include <deque>
#include <random>

using namespace solution;
using namespace solution::testing;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

ZeroStates zerosOf(const expression::EquationSet& set) {
    std::vector<double> values;
    for (const expression::Unknown& unknown : set.unknowns)
        values.push_back(unknown.initial);
    return ZeroStates(set, 0, values);
}

// A spring pendulum in the plane z = 0: unknowns x dx y dy z dz.
std::vector<Line> springPendulum(double dz) {
    const std::string pull = "(1-1/sqrt(x^2+y^2+z^2))*50";
    return {{"x", "dx", 1, 1}, {"dx", "-x*" + pull, 0},
            {"y", "dy", 0, 1}, {"dy", "-9.81-y*" + pull, 0},
            {"z", "dz", 0, 1}, {"dz", "-z*" + pull, dz}};
}

// Once, at its time, it sets dz.
class ZeroKick final : public EventSource {
public:
    ZeroKick(double time, double speed, double other = 0)
        : time_(time), speed_(speed), other_(other) {}
    std::optional<Event> next(const Histories&, double known) override {
        if (done_ || known < time_)
            return std::nullopt;
        return Event{time_, {0, 1, 2, 3, 4, 5}, 0};
    }
    void apply(const Histories&, const Event&, EquationsInForce&, Changes& changes) override {
        done_ = true;
        changes.jumps.push_back({5, speed_});
        if (other_ != 0)
            changes.jumps.push_back({1, other_});
    }

private:
    double time_, speed_, other_;
    bool done_ = false;
};

} // namespace

TEST(ZeroStates, AreTheGreatestSetThatStaysZero) {
    EXPECT_THAT(zerosOf(equationsOf(springPendulum(0))).unknowns(), ElementsAre(4, 5));
    EXPECT_THAT(zerosOf(equationsOf(springPendulum(1e-300))).unknowns(), IsEmpty());
    // Each of them is 0 if the other is.
    EXPECT_THAT(zerosOf(equationsOf({{"a", "b", 0}, {"b", "a*t", 0}})).unknowns(),
                ElementsAre(0, 1));
    EXPECT_THAT(zerosOf(equationsOf({{"a", "b", 0}, {"b", "cos(a)", 0}})).unknowns(), IsEmpty());
    EXPECT_THAT(
        zerosOf(equationsOf({{"a", "sin(a)*b+hypot(a,c)/b", 0}, {"b", "1", 2}, {"c", "a*b", 0}}))
            .unknowns(),
        ElementsAre(0, 2));
}

TEST(ZeroStates, ZeroByZeroIsNone) {
    for (const std::string rate :
         {"a/0", "sin(a)/a", "a/hypot(a,b)^3", "a/(2*b)", "-a/(hypot(a,b)*(a^2+b^2))",
          "a/(b*hypot(a,b))", "sin(a)/hypot(a,b)", "-a/sqrt(a+b)", "a/sqrt(b*a^2)"})
        EXPECT_THAT(zerosOf(equationsOf({{"a", rate, 0}, {"b", "-b", 0}})).unknowns(),
                    ElementsAre(1))
            << rate;
    // but where friction rests
    for (const std::string rate :
         {"-a/hypot(a,b)", "-a/abs(a)", "-3*a/(2*sqrt(a^2+b^2))", "-a^3/abs(a)",
          "-a/sqrt(a*a+2*b*b)", "(b-a)/hypot(a-b,2*b)", "-a*cos(b)/((2+b)*hypot(a,b))"})
        EXPECT_THAT(zerosOf(equationsOf({{"a", rate, 0}, {"b", "-b", 0}})).unknowns(),
                    ElementsAre(0, 1))
            << rate;
}

TEST(ZeroStates, EndWhereAPhaseHoldsOrResetsThem) {
    auto held = equationsOf({{"a", "0", 0}, {"b", "a", 0}});
    addPhase(held, 0, 3, "1", "t-3");
    EXPECT_THAT(zerosOf(held).unknowns(), IsEmpty());
    auto jumps = equationsOf({{"a", "0", 0}, {"b", "t*0", 0}});
    addPhase(jumps, 0, 3, "0", "", "2");
    EXPECT_THAT(zerosOf(jumps).unknowns(), ElementsAre(1));
    auto pushed = equationsOf({{"a", "0", 0}});
    addPhase(pushed, 0, 3, "1");
    EXPECT_THAT(zerosOf(pushed).unknowns(), IsEmpty());
}

TEST(ZeroStates, AreNotIntegratedAndChangeNothing) {
    const Solver flat = solved(equationsOf(springPendulum(0)), 5, tolerance(1e-9));
    auto asked = tolerance(1e-9);
    asked.method = "dop853";
    const Solver full = solved(equationsOf(springPendulum(0)), 5, asked);
    EXPECT_EQ(flat.statistics().largestComponent, 4u);
    EXPECT_EQ(full.statistics().largestComponent, 6u);
    EXPECT_THAT(flat.statistics().zeroStates, ElementsAre(4, 5));
    EXPECT_THAT(full.statistics().zeroStates, IsEmpty());
    EXPECT_LT(flat.statistics().equationEvaluations, 0.7 * full.statistics().equationEvaluations);
    for (int k = 0; k <= 50; ++k) {
        EXPECT_NEAR(flat.histories().value(0, 0.1 * k), full.histories().value(0, 0.1 * k), 1e-7);
        EXPECT_EQ(flat.histories().value(4, 0.1 * k), 0);
    }
}

TEST(ZeroStates, WakeWhenAnEventMovesThem) {
    ZeroKick kick(1, 0.5);
    const Solver solver = solved(equationsOf(springPendulum(0)), 3, tolerance(1e-10), &kick);
    EXPECT_THAT(solver.statistics().zeroStates, IsEmpty());
    EXPECT_EQ(solver.statistics().largestComponent, 6u);
    EXPECT_EQ(solver.histories().value(4, 1), 0);
    EXPECT_EQ(solver.histories().pieceBefore(5, 1).value(1), 0);
    EXPECT_EQ(solver.histories().value(5, 1), 0.5);

    // The same as if it had been integrated from that instant on.
    std::vector<Line> after = springPendulum(0.5);
    for (std::size_t i = 0; i < 4; ++i)
        after[i].initial = solver.histories().value(i, 1);
    const Solver again = solved(equationsOf(after), 2, tolerance(1e-10));
    for (std::size_t u = 0; u < 6; ++u)
        EXPECT_NEAR(solver.histories().value(u, 3), again.histories().value(u, 2), 1e-7) << u;
}

// A second pendulum, which no event touches, keeps its steps; and the order of stepping is no
// matter.
TEST(ZeroStates, WakeWithTheSameBitsForAnyScheduleAndAlone) {
    std::vector<Line> lines = springPendulum(0);
    for (Line line : springPendulum(0)) {
        line.name += "2";
        for (const char* name : {"dx", "dy", "dz"}) // a rate that is a velocity
            if (line.derivative == name)
                line.derivative += "2";
        if (line.name[0] == 'd')
            line.derivative = line.name == "dx2"   ? "-x2*(1-1/hypot(x2,hypot(y2,z2)))*40"
                              : line.name == "dy2" ? "-9-y2*(1-1/hypot(x2,hypot(y2,z2)))*40"
                                                   : "-z2*(1-1/hypot(x2,hypot(y2,z2)))*40";
        lines.push_back(line);
    }
    std::deque<ZeroKick> kicks; // which outlive the solvers
    const auto run = [&kicks](const std::vector<Line>& scene, bool eventDriven) {
        Options options = tolerance(1e-8);
        options.eventDriven = eventDriven;
        return solved(equationsOf(scene), 3, options, &kicks.emplace_back(1, 0.5));
    };
    const Solver both = run(lines, true), other = run(lines, false);
    const Solver alone = run(springPendulum(0), true);
    EXPECT_THAT(both.statistics().zeroStates, ElementsAre(10, 11));
    for (std::size_t u = 0; u < 12; ++u)
        for (const double t : {0.3, 1.0, 1.7, 3.0}) {
            EXPECT_EQ(both.histories().value(u, t), other.histories().value(u, t)) << u << " " << t;
            if (u < 6) {
                EXPECT_EQ(both.histories().value(u, t), alone.histories().value(u, t)) << u;
            }
        }
}

// Of a thousand pendulums an event wakes one: no other's expressions are looked at.
TEST(ZeroStates, WakeByLookingAtWhatDependsOnThemAlone) {
    const auto work = [](int pendulums) {
        std::vector<Line> lines;
        for (int i = 0; i < pendulums; ++i) {
            const std::string n = std::to_string(i), x = "x" + n, y = "y" + n;
            const std::string pull = "*(1-1/sqrt(" + x + "^2+" + y + "^2))*(50+" + n + ")";
            for (const std::string& q : {x, y}) {
                lines.push_back({q, "d" + q, q == x ? 1.0 : 0.0, 1});
                lines.push_back({"d" + q, "-" + q + pull, 0});
            }
        }
        const auto set = equationsOf(lines);
        ZeroStates zero = zerosOf(set);
        EXPECT_EQ(zero.unknowns().size(), 2 * static_cast<std::size_t>(pendulums));
        const std::vector<std::size_t> roused{7};
        EXPECT_THAT(zero.wake(set, 1, roused, {}), ElementsAre(6, 7));
        EXPECT_THAT(zero.readersOf(set, std::vector<std::size_t>{6, 7}), ElementsAre(5, 6, 7));
        return zero.looks();
    };
    const std::size_t few = work(2);
    EXPECT_EQ(work(1000), few);
    EXPECT_LT(few, 40u);
}

// Of many events on one unknown each looks at the equation that it gives, not at all before it.
TEST(ZeroStates, WakeByLookingAtTheEquationsInForce) {
    auto set = equationsOf({{"a", "0", 0}, {"b", "0", 0}});
    ZeroStates zero = zerosOf(set);
    std::vector<std::size_t> looks;
    for (int event = 1; event <= 50; ++event) {
        const std::size_t before = zero.looks();
        addPhase(set, 1, event, "a*cos(" + std::to_string(event + 1) + "*t)");
        EXPECT_THAT(zero.wake(set, event, {}, std::vector<std::size_t>{1}), IsEmpty());
        looks.push_back(zero.looks() - before);
    }
    EXPECT_EQ(looks.back(), looks[1]);
}

// An event gives equations: what they read and what reads them is known at the next one.
TEST(ZeroStates, WakeByEquationsThatCameLater) {
    auto set = equationsOf({{"a", "0", 0}, {"b", "0", 0}, {"c", "b*t", 0}, {"d", "a", 0}});
    ZeroStates zero = zerosOf(set);
    addPhase(set, 1, 1, "a*cos(t)");
    EXPECT_THAT(zero.wake(set, 1, {}, std::vector<std::size_t>{1}), IsEmpty());
    EXPECT_THAT(zero.readersOf(set, std::vector<std::size_t>{0}), ElementsAre(1, 3));
    const std::vector<std::size_t> roused{0};
    EXPECT_THAT(zero.wake(set, 2, roused, {}), ElementsAre(0, 1, 2, 3));
}

// Random equations: what wakes is what the greatest set loses, found again from the start.
TEST(ZeroStates, WakeAsIfFoundAgain) {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        const std::size_t n = 3 + random() % 8;
        const auto name = [&] { return "q" + std::to_string(random() % n); };
        std::vector<Line> lines;
        for (std::size_t i = 0; i < n; ++i) {
            const std::string a = name(), b = name(), c = name();
            const std::string rates[] = {a + "*" + b, a + "+" + b, "sin(" + a + ")-" + c + "*t",
                                         a + "*cos(" + b + ")", "0"};
            lines.push_back({"q" + std::to_string(i), rates[random() % 5], 0});
        }
        const auto set = equationsOf(lines);
        ZeroStates zero = zerosOf(set);
        std::vector<double> values(n, 0.0);
        for (int event = 0; event < 3; ++event) {
            const std::size_t u = random() % n;
            values[u] = 1;
            (void)zero.wake(set, event, std::vector<std::size_t>{u}, {});
            EXPECT_EQ(zero.unknowns(), ZeroStates(set, event, values).unknowns());
        }
    }
}

TEST(ZeroStates, StayWhenAnEventLeavesThemZero) {
    ZeroKick kick(1, 0);
    const Solver solver = solved(equationsOf(springPendulum(0)), 3, tolerance(1e-10), &kick);
    EXPECT_THAT(solver.statistics().zeroStates, ElementsAre(4, 5));
}

// An impact in the plane is computed in three dimensions, and leaves its rounding in the third.
TEST(ZeroStates, StayWhenAnEventLeavesNextToNothingBesideLargerJumps) {
    ZeroKick kick(1, 3e-17, -2);
    const Solver solver = solved(equationsOf(springPendulum(0)), 3, tolerance(1e-10), &kick);
    EXPECT_THAT(solver.statistics().zeroStates, ElementsAre(4, 5));
    EXPECT_EQ(solver.histories().value(5, 1), 0);
    EXPECT_EQ(solver.histories().value(1, 1), -2);
    ZeroKick alone(1, 3e-17);
    EXPECT_THAT(
        solved(equationsOf(springPendulum(0)), 3, tolerance(1e-10), &alone).statistics().zeroStates,
        IsEmpty());
}

// A turn about one axis has two of four entries, and they keep their length.
TEST(ZeroStates, ATurnAboutOneAxisNeedsTwoEntries) {
    auto set = equationsOf({{"qw", "-0.5*(qx*wx+qy*wy+qz*wz)", 1},
                            {"qx", "0.5*(qw*wx+qy*wz-qz*wy)", 0},
                            {"qy", "0.5*(qw*wy+qz*wx-qx*wz)", 0},
                            {"qz", "0.5*(qw*wz+qx*wy-qy*wx)", 0},
                            {"wx", "(qx*qz+qy*qw)*wx", 0},
                            {"wy", "wx*wz", 0},
                            {"wz", "-wz*abs(wz)", 3}});
    set.quaternions.push_back({0, 1, 2, 3});
    const Solver solver = solved(set, 4, tolerance(1e-8));
    EXPECT_THAT(solver.statistics().zeroStates, ElementsAre(1, 2, 4, 5));
    EXPECT_EQ(solver.statistics().largestComponent, 2u);
    const double angle = std::log(13.0); // wz = 3/(1+3t)
    EXPECT_NEAR(solver.histories().value(0, 4), std::cos(angle / 2), 1e-6);
    EXPECT_NEAR(solver.histories().value(3, 4), std::sin(angle / 2), 1e-6);
}
