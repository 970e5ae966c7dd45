// A block of unit mass and inertia that slides and turns on two feet: y is its height, p its tilt
// about the way along, q how it is turned. Its centre of mass lies beside the middle of the feet.
#include "modes/testing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr double friction = 0.3, beside = 0.4, weight = 9.81;

struct Block {
    std::shared_ptr<expression::EquationSet> set = std::make_shared<expression::EquationSet>();
    std::vector<expression::Node> forces; // along both normals, along and across, a couple

    Block() {
        set->time = set->graph.symbol("t");
        for (const auto& [name, rate] :
             std::vector<std::pair<std::string, std::string>>{{"x", "dx"},
                                                              {"q", "dq"},
                                                              {"dx", "f*cos(q)-g*sin(q)"},
                                                              {"dz", "f*sin(q)+g*cos(q)"},
                                                              {"dq", "c-0.4*f"},
                                                              {"dy", "n+m-9.81"},
                                                              {"dp", "1.4*n-0.6*m"}})
            add(name, rate);
        // Second rates, with those of the states put in.
        const std::string y = "(n+m-9.81)", p = "(1.4*n-0.6*m)", q = "(c-0.4*f)";
        keep("n", "dy+1.4*dp", y + "+1.4*" + p);
        keep("m", "dy-0.6*dp", y + "-0.6*" + p);
        keep("f", "dx*cos(q)+dz*sin(q)-0.4*dq", "f-0.4*" + q + "+dq*(dz*cos(q)-dx*sin(q))");
        keep("g", "dz*cos(q)-dx*sin(q)", "g-dq*(dx*cos(q)+dz*sin(q))");
        keep("c", "dq", q);
        for (std::size_t i = 0; i < 5; ++i) {
            expression::Condition& condition = *set->unknowns[7 + i].phases[0].condition;
            condition.low = i < 2 ? 0 : condition.low;
            condition.resolution = 1e-9;
            if (i >= 2)
                condition.friction = discOf();
        }
    }
    [[nodiscard]] expression::Friction discOf() {
        const auto parsed = [&](const char* text) {
            return expression::testing::parsed(set->graph, text);
        };
        return {.rows = {forces.begin() + 2, forces.end()},
                .normals = {forces[0], forces[1]},
                .sticking = friction,
                .sliding = friction,
                .levers = {{parsed("-1"), parsed("0.1*sin(x)")}, {parsed("1"), parsed("0.2*q")}}};
    }

private:
    void add(const std::string& name, const std::string& rate) {
        expression::Unknown unknown;
        unknown.name = name;
        unknown.symbol = set->graph.symbol(name);
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = expression::testing::parsed(set->graph, rate);
        set->unknowns.push_back(unknown);
    }
    void keep(const std::string& name, const std::string& rate, const std::string& second) {
        add(name, second);
        set->unknowns.back().phases[0].condition =
            expression::Condition{std::nullopt, expression::testing::parsed(set->graph, rate)};
        forces.push_back(set->unknowns.back().symbol);
    }
};

class Sliding : public ::testing::Test {
protected:
    Sliding() {
        Preparation how;
        how.whole = how.everyState = true;
        prepared_.emplace(block_.set, how);
        equations_.emplace(prepared_->components.at(0).bound, histories_);
        const double held = 1, slips = 2; // as histories keep it
        equations_->takeKept(std::vector<double>{held, held, slips, slips, slips});
    }
    std::vector<double> ratesAt(const std::vector<double>& y) {
        std::vector<double> rates(y.size());
        EXPECT_TRUE(equations_->rates(0, y, rates));
        return rates;
    }

    Block block_;
    std::optional<PreparedEquations> prepared_;
    Histories histories_;
    std::optional<ComponentEquations> equations_;
};

// A block that slides along a straight line has a pressure as far beside its middle as its mass.
TEST_F(Sliding, ABlockThatDoesNotTurnGoesOnSo) {
    const std::vector<double> y = {0, 0, 5, 0, 0, 0, 0};
    equations_->takeSlips(0, y);
    const std::vector<double> rates = ratesAt(y);
    EXPECT_NEAR(rates[2], -friction * weight, 1e-13);
    EXPECT_NEAR(rates[4], 0, 1e-13);
    EXPECT_NEAR(equations_->multiplierValues()[0], weight * (1 - beside) / 2, 1e-12) << "n";
}

// The friction is the laws' own, and the derivatives are those of the rates.
TEST_F(Sliding, ABlockThatTurnsHasItsFrictionAtThePressuresCentre) {
    const std::vector<double> y = {0.7, 0.3, 0.4, -0.2, 0.9, 0, 0};
    equations_->takeSlips(0, y);
    (void)ratesAt(y);
    const std::vector<double> m(equations_->multiplierValues().begin(),
                                equations_->multiplierValues().end());
    const double pressed = m[0] + m[1], s = std::sin(y[1]), c = std::cos(y[1]);
    const double ofX = (m[1] - m[0]) / pressed;
    const double ofZ = (m[0] * 0.1 * std::sin(y[0]) + m[1] * 0.2 * y[1]) / pressed;
    const double along = y[2] * c + y[3] * s - beside * y[4] + ofX * y[4];
    const double across = y[3] * c - y[2] * s + ofZ * y[4];
    const double speed = std::hypot(along, across, y[4]);
    EXPECT_NEAR(m[2], -friction * pressed * along / speed, 1e-8);
    EXPECT_NEAR(m[3], -friction * pressed * across / speed, 1e-8);
    EXPECT_NEAR(m[4], -friction * pressed * y[4] / speed + ofX * m[2] + ofZ * m[3], 1e-8);

    const Pattern pattern = equations_->jacobianPattern();
    std::vector<double> entries(pattern.rows.size());
    ASSERT_TRUE(equations_->jacobian(0, y, entries));
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(7, 7), differences(7, 7);
    for (int column = 0; column < 7; ++column) {
        for (int k = pattern.columnStarts[static_cast<std::size_t>(column)];
             k < pattern.columnStarts[static_cast<std::size_t>(column) + 1]; ++k)
            jacobian(pattern.rows[static_cast<std::size_t>(k)], column) =
                entries[static_cast<std::size_t>(k)];
        constexpr double step = 1e-5;
        std::vector<double> low = y, high = y;
        low[static_cast<std::size_t>(column)] -= step;
        high[static_cast<std::size_t>(column)] += step;
        const std::vector<double> before = ratesAt(low), after = ratesAt(high);
        for (int row = 0; row < 7; ++row)
            differences(row, column) =
                (after[static_cast<std::size_t>(row)] - before[static_cast<std::size_t>(row)]) /
                (2 * step);
    }
    EXPECT_LT((jacobian - differences).cwiseAbs().maxCoeff(), 1e-8) << jacobian << "\n\n"
                                                                    << differences;
}

} // namespace
