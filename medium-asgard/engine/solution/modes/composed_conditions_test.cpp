// A rope of beads: what blocks make of its conditions is what one expression of all makes.
#include "modes/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

using namespace solution;
using namespace solution::testing;

namespace {

using expression::Node;

// Beads at x, y of velocities u, v; each is kept at its distance from the next. A wind blows.
class Rope {
public:
    static constexpr std::size_t beads = leastComposed + 1;
    explicit Rope(bool areParts) {
        Rates rates;
        for (std::size_t i = 0; i < beads; ++i)
            for (const char* name : {"x", "y"})
                rates.emplace_back(of(name, i), of(*name == 'x' ? "u" : "v", i));
        for (std::size_t i = 0; i < beads; ++i) {
            std::string ofU = "0.1*sin(t)+exp(-((t-1)/0.01)^2)", ofV = "-9.81-0.2*" + of("v", i);
            for (const auto& [which, sign] : {std::pair(i - 1, "+"), {i, "-"}})
                if (which < beads - 1) {
                    ofU += sign + push(which, i, "x");
                    ofV += sign + push(which, i, "y");
                }
            rates.emplace_back(of("u", i), ofU);
            rates.emplace_back(of("v", i), ofV);
        }
        for (std::size_t i = 0; i + 1 < beads; ++i)
            rates.emplace_back(of("m", i), second(rates, i));
        const auto set = setOf(rates);
        for (std::size_t i = 0; i < 2 * beads; ++i)
            set->unknowns[i].lengthPerUnit = 1;
        for (std::size_t i = 0; i + 1 < beads; ++i)
            set->unknowns[4 * beads + i].phases[0].condition = condition(*set, i, areParts);
        prepared_.emplace(prepared(set));
        equations_.emplace(prepared_->components.at(0).bound, histories_);
    }
    ComponentEquations* operator->() { return &*equations_; }

private:
    static std::string of(const std::string& name, std::size_t i) {
        return name + std::to_string(i);
    }
    static std::string between(const std::string& name, std::size_t i) {
        return "(" + of(name, i + 1) + "-" + of(name, i) + ")";
    }
    static std::string massOf(std::size_t i) { return std::to_string(1 + i % 3); }
    static std::string push(std::size_t which, std::size_t on, const std::string& axis) {
        return between(axis, which) + "/" + massOf(on) + "*" + of("m", which);
    }
    static std::string steady(std::size_t i) {
        return between("u", i) + "*" + between("u", i) + "+" + between("v", i) + "*" +
               between("v", i);
    }
    static std::string second(const Rates& rates, std::size_t i) {
        const auto rateOf = [&](std::size_t bead, std::size_t axis) {
            return "(" + rates[2 * beads + 2 * bead + axis].second + ")";
        };
        return steady(i) + "+" + between("x", i) + "*(" + rateOf(i + 1, 0) + "-" + rateOf(i, 0) +
               ")+" + between("y", i) + "*(" + rateOf(i + 1, 1) + "-" + rateOf(i, 1) + ")";
    }
    static expression::Condition condition(expression::EquationSet& set, std::size_t i,
                                           bool areParts) {
        const auto node = [&](const std::string& text) {
            return expression::testing::parsed(set.graph, text);
        };
        expression::Condition made;
        made.gap = node("(" + between("x", i) + "*" + between("x", i) + "+" + between("y", i) +
                        "*" + between("y", i) + "-1)/2");
        made.rate = node(between("x", i) + "*" + between("u", i) + "+" + between("y", i) + "*" +
                         between("v", i));
        if (!areParts)
            return made;
        expression::ConditionParts parts{
            .owner = node(of("m", i)), .steady = node(steady(i)), .by = {}, .pushes = {}};
        for (const auto& [bead, sign] : {std::pair(i + 1, ""), {i, "-"}})
            for (const auto& [speed, axis] : {std::pair("u", "x"), {"v", "y"}}) {
                const Node state = node(of(speed, bead));
                parts.by.push_back({state, node(sign + between(axis, i))});
                parts.pushes.push_back({state, node(sign + between(axis, i) + "/" + massOf(bead))});
            }
        made.parts = std::move(parts);
        return made;
    }

    std::optional<PreparedEquations> prepared_;
    Histories histories_;
    std::optional<ComponentEquations> equations_;
};

// Next to its conditions, as within a step.
std::vector<double> places() {
    std::vector<double> y(4 * Rope::beads);
    for (std::size_t i = 0; i < Rope::beads; ++i) {
        const auto at = static_cast<double>(i);
        y[2 * i] = at * 0.8;
        y[2 * i + 1] = at * 0.6 + 1e-4 * std::sin(7 * at);
        y[2 * Rope::beads + 2 * i] = 0.3 * std::sin(3 * at);
        y[2 * Rope::beads + 2 * i + 1] = 0.2 * std::cos(5 * at);
    }
    return y;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

} // namespace

TEST(ComposedConditions, HaveTheRatesOfOneExpression) {
    Rope blocks(true), whole(false);
    ASSERT_TRUE(blocks->isComposed());
    ASSERT_FALSE(whole->isComposed());
    const std::vector<double> y = places();
    std::vector<double> ofBlocks(y.size()), ofWhole(y.size());
    ASSERT_TRUE(blocks->rates(0.7, y, ofBlocks));
    ASSERT_TRUE(whole->rates(0.7, y, ofWhole));
    EXPECT_LT(distance(ofBlocks, ofWhole), 1e-11);
    std::vector<double> forces(blocks->multiplierValues().begin(),
                               blocks->multiplierValues().end());
    const std::vector<double> same(whole->multiplierValues().begin(),
                                   whole->multiplierValues().end());
    EXPECT_LT(distance(forces, same), 1e-11);
    EXPECT_GT(distance(forces, std::vector<double>(forces.size(), 0)), 1);
}

TEST(ComposedConditions, PutStatesOntoTheSamePlaces) {
    Rope blocks(true), whole(false);
    std::vector<double> ofBlocks = places(), ofWhole = ofBlocks;
    blocks->project(0.7, ofBlocks);
    whole->project(0.7, ofWhole);
    EXPECT_LT(distance(ofBlocks, ofWhole), 1e-11);
    EXPECT_GT(distance(ofBlocks, places()), 1e-5);
}

TEST(ComposedConditions, HaveTheDerivativesOfOneExpression) {
    Rope blocks(true), whole(false);
    std::vector<double> y = places();
    whole->project(0, y);
    const auto full = [&](Rope& rope) {
        std::vector<double> rates(y.size()), matrix(y.size() * y.size(), 0);
        EXPECT_TRUE(rope->rates(0.7, y, rates));
        const Pattern pattern = rope->jacobianPattern();
        std::vector<double> entries(pattern.entries());
        EXPECT_TRUE(rope->jacobian(0.7, y, entries));
        for (std::size_t column = 0; column < y.size(); ++column)
            for (auto k = static_cast<std::size_t>(pattern.columnStarts[column]);
                 k < static_cast<std::size_t>(pattern.columnStarts[column + 1]); ++k)
                matrix[column * y.size() + static_cast<std::size_t>(pattern.rows[k])] = entries[k];
        return matrix;
    };
    EXPECT_LT(distance(full(blocks), full(whole)), 1e-10);
}

// Multipliers stand behind the symbols of the model, which has none.
TEST(ComposedConditions, HaveTheirPeaksSeen) {
    Rope blocks(true);
    ASSERT_TRUE(blocks->bound()->canPeak);
    const auto& peaks = blocks->model().peaks();
    const std::vector<double> y = places();
    std::vector<double> rates(y.size()), causes(peaks.causes.tape().outputs());
    ASSERT_TRUE(blocks->rates(0.7, y, rates));
    blocks->functions().peakCauses(peaks, 0.7, y, rates, causes);
    std::vector<double> heights(peaks.heights.tape().outputs());
    blocks->functions().peakHeights(1, y, heights);
    ASSERT_FALSE(heights.empty());
    EXPECT_NEAR(heights[0], 1, 1e-12);
}

// A block of two beads is the same model wherever it is.
TEST(ComposedConditions, ShareTheModelOfABlock) {
    Rope blocks(true);
    const auto& all = blocks->bound()->composed->blocks;
    ASSERT_EQ(all.size(), Rope::beads - 1);
    EXPECT_EQ(all[1].model, all[4].model);
}
