// The machine code that solves for the multipliers and the rates at once checks itself: where its
// checks fail, the answer is that of the elimination in steps, to the last bit.
#include "modes/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace solution;
using namespace solution::testing;

namespace {

struct Kept {
    std::string name, rate, second;
};
using Answer = std::vector<double>; // rates, then multipliers

class Solved {
public:
    enum class Way { atOnce, inSteps };
    Solved(const Rates& rates, const std::vector<Kept>& conditions, Way way) {
        Rates all = rates;
        for (const Kept& kept : conditions)
            all.emplace_back(kept.name, kept.second);
        const auto set = setOf(all);
        for (std::size_t k = 0; k < conditions.size(); ++k) {
            expression::Condition condition{
                std::nullopt, expression::testing::parsed(set->graph, conditions[k].rate)};
            condition.resolution = 1e-9;
            set->unknowns[rates.size() + k].phases[0].condition = condition;
        }
        prepared_.emplace(prepared(set));
        equations_.emplace(prepared_->components.at(0).bound, histories_);
        equations_->takeKept(std::vector<double>(conditions.size(), 1));
        if (way == Way::inSteps)
            equations_->solveMultipliersInSteps();
    }
    Answer at(const std::vector<double>& y) {
        Answer answer(y.size());
        EXPECT_TRUE(equations_->rates(0, y, answer));
        const auto forces = equations_->multiplierValues();
        answer.insert(answer.end(), forces.begin(), forces.end());
        return answer;
    }
    std::vector<double> projected(std::vector<double> y) {
        equations_->project(0, y);
        return y;
    }
    bool hasCode() { return equations_->place() != nullptr; }

private:
    std::optional<PreparedEquations> prepared_;
    Histories histories_;
    std::optional<ComponentEquations> equations_;
};

// The slide u is driven by y as by a cam that has a slope next to -1 alone; the drive pushes u, and
// not y. The other condition couples u, y' = v and w.
const Rates ofCam = {{"y", "v"}, {"u", "a+b"}, {"v", "-b-9.81"}, {"w", "b"}};
const std::string slope = "0.5*exp(-((y+1)/0.1)^2)";
const std::vector<Kept> camConditions = {
    {"a", "u-" + slope + "*v", "(a+b)-" + slope + "*(-b-9.81)+200*(y+1)*" + slope + "*v^2"},
    {"b", "u-v+w", "a+3*b+9.81"}};

// They are a = f - (1 + s) b  and  a = -9.81 - 3 b.
void expectCam(const Answer& answer, double y, double v) {
    const double s = 0.5 * std::exp(-std::pow((y + 1) / 0.1, 2));
    const double f = -s * 9.81 - 200 * (y + 1) * s * v * v;
    const double b = (f + 9.81) / (s - 2), a = -9.81 - 3 * b;
    EXPECT_NEAR(answer[4], a, 1e-9) << y;
    EXPECT_NEAR(answer[5], b, 1e-9);
    EXPECT_NEAR(answer[1], a + b, 1e-9);
}

} // namespace

TEST(SolvedAtOnce, FollowsACamThatHasASlopeNextToOnePlaceAlone) {
    Solved cam(ofCam, camConditions, Solved::Way::atOnce);
    Solved inSteps(ofCam, camConditions, Solved::Way::inSteps);
    expectCam(cam.at({0, 0, 0, 0}), 0, 0);
    EXPECT_TRUE(cam.hasCode());
    (void)inSteps.at({0, 0, 0, 0});
    EXPECT_FALSE(inSteps.hasCode());
    for (int i = 0; i < 200; ++i) { // until the machine is sure that code pays
        const double y = -2 + 0.01 * i;
        const std::vector<double> at = {y, 0.1, -1.5, 0.3};
        const Answer answer = cam.at(at);
        expectCam(answer, y, -1.5);
        const std::vector<double> moved = cam.projected(at), expected = inSteps.projected(at);
        if (std::abs(y + 1) < 0.4) {
            EXPECT_EQ(answer, inSteps.at(at)) << y;
            EXPECT_EQ(moved, expected) << y;
        }
        for (std::size_t k = 0; k < at.size(); ++k)
            EXPECT_NEAR(moved[k], expected[k], 1e-11) << y;
    }
}

TEST(SolvedAtOnce, IsNotTriedWhereTheFirstPointHasNoSymmetricMatrix) {
    Solved cam(ofCam, camConditions, Solved::Way::atOnce);
    expectCam(cam.at({-1.1, 0, -1, 0}), -1.1, -1);
    EXPECT_FALSE(cam.hasCode());
    expectCam(cam.at({0, 0, -1, 0}), 0, -1);
    EXPECT_FALSE(cam.hasCode());
}

// The conditions a and c are one where q is 0.
TEST(SolvedAtOnce, IsNotTriedWhereConditionsAreRedundantAtTheFirstPoint) {
    const Rates rates = {{"q", "0"}, {"u", "a+c*cos(q)-1"}, {"v", "b-2"}, {"w", "b+c*sin(q)"}};
    const std::vector<Kept> conditions = {
        {"a", "u", "a+c*cos(q)-1"},
        {"b", "v+w", "2*b+c*sin(q)-2"},
        {"c", "u*cos(q)+w*sin(q)", "(a+c*cos(q)-1)*cos(q)+(b+c*sin(q))*sin(q)"}};
    for (const double first : {0.0, 1.0}) {
        Solved solved(rates, conditions, Solved::Way::atOnce);
        Solved inSteps(rates, conditions, Solved::Way::inSteps);
        for (const double q : {first, 0.0, 1e-5, 0.5}) {
            const std::vector<double> at = {q, 0, 0, 0};
            const Answer answer = solved.at(at), expected = inSteps.at(at);
            EXPECT_EQ(solved.hasCode(), first != 0);
            EXPECT_NEAR(answer[1], 0, 1e-12) << first << " " << q;
            for (std::size_t k = 0; k < answer.size(); ++k)
                EXPECT_NEAR(answer[k], expected[k], 1e-12) << first << " " << q;
        }
    }
}
