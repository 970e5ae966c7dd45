// A block of unit mass and inertia that slides and turns on two feet: y is its height, p its tilt
// about the way along, q how it is turned. Its centre of mass lies above the feet and beside their
// middle, so that friction across shifts the pressure.
#include "modes/testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace solution;
using namespace solution::testing;

namespace {

constexpr double friction = 0.3, beside = 0.4, weight = 9.81;

class Model {
public:
    [[nodiscard]] const std::shared_ptr<expression::EquationSet>& set() const { return set_; }

protected:
    Model() { set_->time = set_->graph.symbol("t"); }
    void add(const std::string& name, const std::string& rate) {
        expression::Unknown unknown;
        unknown.name = name;
        unknown.symbol = set_->graph.symbol(name);
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = parsed(rate);
        set_->unknowns.push_back(unknown);
    }
    // A normal force, or a row of friction.
    void keep(const std::string& name, const std::string& rate, const std::string& second) {
        add(name, second);
        expression::Condition condition{std::nullopt, parsed(rate)};
        condition.resolution = 1e-9;
        set_->unknowns.back().phases[0].condition = condition;
        forces_.push_back(set_->unknowns.back().symbol);
    }
    // The force that was kept last pushes states by the factors by which their rates are in its
    // second rate.
    void sayParts(const std::string& owner, const std::string& steady,
                  const std::vector<std::pair<std::string, std::string>>& factors) {
        expression::ConditionParts parts{
            .owner = parsed(owner), .steady = parsed(steady), .by = {}, .pushes = {}};
        for (const auto& [state, factor] : factors)
            parts.by.push_back({parsed(state), parsed(factor)});
        parts.pushes = parts.by;
        set_->unknowns.back().phases[0].condition->parts = std::move(parts);
    }
    // The last three are the rows of friction; `levers` are those of the others, along and across.
    void rub(double coefficient, const std::vector<std::pair<std::string, std::string>>& levers) {
        expression::Friction disc{.rows = {forces_.end() - 3, forces_.end()},
                                  .normals = {forces_.begin(), forces_.end() - 3},
                                  .sticking = coefficient,
                                  .sliding = coefficient};
        for (const auto& [along, across] : levers)
            disc.levers.push_back({parsed(along), parsed(across)});
        const std::size_t first = set_->unknowns.size() - forces_.size();
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            expression::Condition& condition = *set_->unknowns[first + i].phases[0].condition;
            if (i + 3 < forces_.size())
                condition.low = 0;
            else
                condition.friction = disc;
        }
        forces_.clear();
    }

private:
    [[nodiscard]] expression::Node parsed(const std::string& text) {
        return expression::testing::parsed(set_->graph, text);
    }
    std::shared_ptr<expression::EquationSet> set_ = std::make_shared<expression::EquationSet>();
    std::vector<expression::Node> forces_;
};

// Forces: n and m are the normal ones, f along, g across, c a couple.
struct Block : Model {
    Block() { add("", false); }

protected:
    struct None {};
    explicit Block(None /*of these yet*/) {}
    // Names end in `end`.
    void add(const std::string& end, bool areParts) {
        const auto of = [&](std::string text) {
            for (std::size_t i = text.find('_'); i != std::string::npos; i = text.find('_', i))
                text.replace(i, 1, end);
            return text;
        };
        const auto state = [&](const char* name, const char* rate) {
            Model::add(of(name), of(rate));
        };
        state("x_", "dx_");
        state("q_", "dq_");
        state("dx_", "f_*cos(q_)-g_*sin(q_)");
        state("dz_", "f_*sin(q_)+g_*cos(q_)");
        state("dq_", "c_-0.4*f_");
        state("dy_", "n_+m_-9.81");
        state("dp_", "1.4*n_-0.6*m_-0.8*g_");
        const auto force = [&](const char* name, const char* rate, const std::string& second,
                               const char* steady,
                               const std::vector<std::pair<std::string, std::string>>& factors) {
            keep(of(name), of(rate), of(second));
            std::vector<std::pair<std::string, std::string>> named;
            for (const auto& [symbol, factor] : factors)
                named.emplace_back(of(symbol), of(factor));
            if (areParts)
                sayParts(of("n_"), of(steady), named);
        };
        // Second rates, with those of the states put in.
        const std::string y = "(n_+m_-9.81)", p = "(1.4*n_-0.6*m_-0.8*g_)", q = "(c_-0.4*f_)";
        force("n_", "dy_+1.4*dp_", y + "+1.4*" + p, "0", {{"dy_", "1"}, {"dp_", "1.4"}});
        force("m_", "dy_-0.6*dp_", y + "-0.6*" + p, "0", {{"dy_", "1"}, {"dp_", "-0.6"}});
        force("f_", "dx_*cos(q_)+dz_*sin(q_)-0.4*dq_",
              "f_-0.4*" + q + "+dq_*(dz_*cos(q_)-dx_*sin(q_))", "dq_*(dz_*cos(q_)-dx_*sin(q_))",
              {{"dx_", "cos(q_)"}, {"dz_", "sin(q_)"}, {"dq_", "-0.4"}});
        force("g_", "dz_*cos(q_)-dx_*sin(q_)-0.8*dp_", "g_-dq_*(dx_*cos(q_)+dz_*sin(q_))-0.8*" + p,
              "-dq_*(dx_*cos(q_)+dz_*sin(q_))",
              {{"dz_", "cos(q_)"}, {"dx_", "-sin(q_)"}, {"dp_", "-0.8"}});
        force("c_", "dq_", q, "0", {{"dq_", "1"}});
        rub(friction, {{"-1", of("0.1*sin(x_)")}, {"1", of("0.2*q_")}});
    }
};

// So many that their conditions are composed, where they say their parts.
template <bool areParts> struct Blocks : Block {
    static constexpr std::size_t count = leastComposed / 5 + 1;
    Blocks() : Block(None{}) {
        for (std::size_t i = 0; i < count; ++i)
            add(std::to_string(i), areParts);
    }
};

// A post of unit mass on the corners of a square, 1.78 high and rough: d and r are its tilts.
struct Post : Model {
    static constexpr double rough = 0.97;
    Post() {
        const std::vector<std::pair<std::string, std::string>> corners = {
            {"0.7", "0.7"}, {"0.7", "-0.7"}, {"-0.7", "-0.7"}, {"-0.7", "0.7"}};
        const std::vector<std::string> names = {"n1", "n2", "n3", "n4"};
        std::string lift = "-9.81", d = "-1.78*g", r = "1.78*f";
        std::vector<std::pair<std::string, std::string>> levers;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& [x, z] = corners[i];
            lift += "+" + names[i];
            d += "-(" + z + ")*" + names[i];
            r += "+(" + x + ")*" + names[i];
            levers.emplace_back(z, "-(" + x + ")");
        }
        d = "((" + d + ")/0.42)";
        r = "((" + r + ")/0.16)";
        add("dx", "f");
        add("dz", "g");
        add("dq", "c/0.4");
        add("dy", lift);
        add("dd", d);
        add("dr", r);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto& [x, z] = corners[i];
            keep(names[i], "dy+(" + x + ")*dr-(" + z + ")*dd",
                 lift + "+(" + x + ")*" + r + "-(" + z + ")*" + d);
        }
        keep("f", "dx+1.78*dr", "f+1.78*" + r);
        keep("g", "dz-1.78*dd", "g-1.78*" + d);
        keep("c", "dq", "c/0.4");
        rub(rough, levers);
    }
};

// It holds its normal conditions, and slips.
template <class Of> class Sliding {
public:
    explicit Sliding(std::size_t normals, std::size_t things = 1) {
        Preparation how;
        how.whole = how.everyState = true;
        prepared_.emplace(model_.set(), how);
        equations_.emplace(prepared_->components.at(0).bound, histories_);
        std::vector<double> kept; // as histories keep it
        for (std::size_t i = 0; i < things; ++i) {
            kept.insert(kept.end(), normals, 1);
            kept.insert(kept.end(), 3, 2);
        }
        equations_->takeKept(kept);
    }
    ComponentEquations* operator->() { return &*equations_; }
    std::vector<double> ratesAt(const std::vector<double>& y) {
        std::vector<double> rates(y.size());
        EXPECT_TRUE(equations_->rates(0, y, rates));
        return rates;
    }
    std::vector<double> forces() {
        const auto values = equations_->multiplierValues();
        return {values.begin(), values.end()};
    }
    // By how much derivatives differ from differences of rates.
    double errorOfJacobian(const std::vector<double>& y) {
        (void)ratesAt(y);
        const Pattern pattern = equations_->jacobianPattern();
        std::vector<double> entries(pattern.rows.size());
        EXPECT_TRUE(equations_->jacobian(0, y, entries));
        double worst = 0;
        for (std::size_t column = 0; column < y.size(); ++column) {
            constexpr double step = 1e-5;
            std::vector<double> low = y, high = y, derivative(y.size(), 0);
            low[column] -= step;
            high[column] += step;
            const std::vector<double> before = ratesAt(low), after = ratesAt(high);
            for (auto k = static_cast<std::size_t>(pattern.columnStarts[column]);
                 k < static_cast<std::size_t>(pattern.columnStarts[column + 1]); ++k)
                derivative[static_cast<std::size_t>(pattern.rows[k])] = entries[k];
            for (std::size_t row = 0; row < y.size(); ++row)
                worst = std::max(
                    worst, std::abs(derivative[row] - (after[row] - before[row]) / (2 * step)));
        }
        return worst;
    }

private:
    Of model_;
    std::optional<PreparedEquations> prepared_;
    Histories histories_;
    std::optional<ComponentEquations> equations_;
};

// A block that slides along a straight line has a pressure as far beside its middle as its mass.
TEST(SlipForces, ABlockThatDoesNotTurnGoesOnSo) {
    Sliding<Block> block(2);
    const std::vector<double> y = {0, 0, 5, 0, 0, 0, 0};
    block->takeSlips(0, y);
    const std::vector<double> rates = block.ratesAt(y);
    EXPECT_NEAR(rates[2], -friction * weight, 1e-13);
    EXPECT_NEAR(rates[4], 0, 1e-13);
    EXPECT_NEAR(block.forces()[0], weight * (1 - beside) / 2, 1e-12) << "n";
}

// The friction is the laws' own, and the derivatives are those of the rates.
TEST(SlipForces, ABlockThatTurnsHasItsFrictionAtThePressuresCentre) {
    Sliding<Block> block(2);
    const std::vector<double> y = {0.7, 0.3, 0.4, -0.2, 0.9, 0, 0};
    block->takeSlips(0, y);
    (void)block.ratesAt(y);
    const std::vector<double> m = block.forces();
    const double pressed = m[0] + m[1], s = std::sin(y[1]), c = std::cos(y[1]);
    const double ofX = (m[1] - m[0]) / pressed;
    const double ofZ = (m[0] * 0.1 * std::sin(y[0]) + m[1] * 0.2 * y[1]) / pressed;
    const double along = y[2] * c + y[3] * s - beside * y[4] + ofX * y[4];
    const double across = y[3] * c - y[2] * s + ofZ * y[4];
    const double speed = std::hypot(along, across, y[4]);
    EXPECT_NEAR(m[2], -friction * pressed * along / speed, 1e-8);
    EXPECT_NEAR(m[3], -friction * pressed * across / speed, 1e-8);
    EXPECT_NEAR(m[4], -friction * pressed * y[4] / speed + ofX * m[2] + ofZ * m[3], 1e-8);
    EXPECT_LT(block.errorOfJacobian(y), 1e-8);
}

// Its friction moves the pressure so far that whole steps of Newton's method do not end.
TEST(SlipForces, ATallPostThatTurnsIsInBalance) {
    Sliding<Post> post(4);
    for (const double turning : {1.1, -0.4, 3.0}) {
        const std::vector<double> y = {0.49, -0.21, turning, 0, 0, 0};
        post->takeSlips(0, y);
        const std::vector<double> rates = post.ratesAt(y);
        const std::vector<double> m = post.forces();
        EXPECT_NEAR(rates[3], 0, 1e-11) << turning;
        EXPECT_NEAR(rates[4], 0, 1e-11);
        EXPECT_NEAR(rates[5], 0, 1e-11);
        const double pressed = m[0] + m[1] + m[2] + m[3];
        const double ofX = 0.7 * (m[0] - m[1] - m[2] + m[3]) / pressed;
        const double ofZ = -0.7 * (m[0] + m[1] - m[2] - m[3]) / pressed;
        const Eigen::Vector3d way(y[0] + ofX * turning, y[1] + ofZ * turning, turning);
        const Eigen::Vector3d force = -Post::rough * pressed * way.normalized();
        EXPECT_NEAR(m[4], force[0], 1e-7);
        EXPECT_NEAR(m[5], force[1], 1e-7);
        EXPECT_NEAR(m[6], force[2] + ofX * force[0] + ofZ * force[1], 1e-7);
        EXPECT_LT(post.errorOfJacobian(y), 1e-6) << turning;
    }
}

// Their conditions are put together from blocks: rates, forces and derivatives are the same.
TEST(SlipForces, BlocksOfManyConditionsSlideAsOneExpressionDoes) {
    using Whole = Blocks<false>;
    Sliding<Blocks<true>> blocks(2, Whole::count);
    Sliding<Whole> whole(2, Whole::count);
    ASSERT_TRUE(blocks->isComposed());
    ASSERT_FALSE(whole->isComposed());
    std::vector<double> y;
    for (std::size_t i = 0; i < Whole::count; ++i) {
        const double at = static_cast<double>(i);
        y.insert(y.end(), {0.7 + at, 0.3, 0.4, -0.2 * at, 0.9 - 0.3 * at, 0, 0});
    }
    blocks->takeSlips(0, y);
    whole->takeSlips(0, y);
    const std::vector<double> ofBlocks = blocks.ratesAt(y), ofWhole = whole.ratesAt(y);
    for (std::size_t i = 0; i < y.size(); ++i)
        EXPECT_NEAR(ofBlocks[i], ofWhole[i], 1e-11) << i;
    EXPECT_LT(blocks.errorOfJacobian(y), 1e-7);
    EXPECT_LT(whole.errorOfJacobian(y), 1e-7);
}

} // namespace
