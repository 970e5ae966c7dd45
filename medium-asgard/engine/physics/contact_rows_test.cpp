// The equations of contacts against differences along the motion: rates are those of gaps, second
// rates those of rates, and forces act as rates read velocities.
#include "physics/contact_rows.h"

#include "expression/tape.h"
#include "physics/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace physics::testing {
namespace {

using Kind = SurfacePiece::Kind;

SurfacePiece piece(Kind kind, double radius) {
    SurfacePiece made{.kind = kind, .place = {0.1, -0.2, 0.05}, .radius = radius, .sine = 0.6};
    made.axis = Vector(0.48, 0.6, 0.64);
    made.axes = Vector(0.3, 0.2, 0.25).asDiagonal();
    return made;
}

// The ball of testing.h, whose spin is along the world's axes, and the rod, whose spin is along its
// own, at random places with random velocities, in a contact with forces.
class Moving {
public:
    Moving(const SurfaceGap& gap, bool hasFriction, bool isSwapped)
        : motion_(ballAndRod()), set_(motion_.set) {
        ContactPlace place;
        place.body = isSwapped ? 1 : 0;
        place.support = isSwapped ? 0 : 1;
        place.points.push_back({.gap = gap, .start = 0, .parts = false, .sides = {}});
        if (hasFriction)
            place.friction = {.sticking = 0.5, .sliding = 0.5, .rolling = 0.01};
        for (const expression::Unknown& unknown : set_.unknowns)
            symbols_.push_back(unknown.symbol);
        const std::size_t unknowns = symbols_.size();
        for (std::size_t k = 0; k < place.rows(); ++k)
            symbols_.push_back(set_.graph.symbol("m" + std::to_string(k)));
        symbols_.push_back(set_.time);
        const std::span<const Node> multipliers =
            std::span(symbols_).subspan(unknowns, place.rows());
        ContactRows rows(set_, motion_, 0);
        rows.addContact(place, multipliers);
        for (const expression::Unknown& unknown : set_.unknowns)
            rates_.push_back(unknown.phases[0].derivative);
        const std::array<std::size_t, 2> bodies{0, 1};
        for (const ContactRows::Equation& equation : rows.velocities(bodies))
            rates_[equation.unknown] = equation.phase.derivative;
        conditions_ = rows.conditions();
        std::mt19937 dice(7);
        std::uniform_real_distribution<double> number(-1, 1);
        for (std::size_t i = 0; i < symbols_.size(); ++i)
            state_.push_back(number(dice));
        for (const auto& four : set_.quaternions) {
            double square = 0;
            for (const std::size_t u : four)
                square += state_[u] * state_[u];
            for (const std::size_t u : four)
                state_[u] /= std::sqrt(square);
        }
    }

    [[nodiscard]] const std::vector<expression::Phase>& conditions() const { return conditions_; }
    [[nodiscard]] double value(Node node) const { return valueAt(node, state_); }
    // By a central difference.
    [[nodiscard]] double rateOf(Node node) const {
        constexpr double h = 1e-5;
        std::vector<double> before = state_, after = state_;
        for (std::size_t u = 0; u < rates_.size(); ++u) {
            const double rate = value(rates_[u]);
            before[u] -= h * rate;
            after[u] += h * rate;
        }
        return (valueAt(node, after) - valueAt(node, before)) / (2 * h);
    }
    // Of a second rate by a multiplier, in which it is linear.
    [[nodiscard]] double entry(std::size_t row, std::size_t column) const {
        std::vector<double> more = state_;
        more[set_.unknowns.size() + column] += 1;
        return valueAt(conditions_[row].derivative, more) - value(conditions_[row].derivative);
    }

private:
    [[nodiscard]] double valueAt(Node node, std::span<const double> state) const {
        double found = 0;
        std::vector<double> scratch;
        expression::Tape(set_.graph, symbols_, std::span(&node, 1))
            .evaluate(state, std::span(&found, 1), scratch);
        return found;
    }

    EquationsOfMotion motion_;
    expression::EquationSet set_;
    std::vector<Node> symbols_, rates_; // unknowns, multipliers, the time; of the unknowns
    std::vector<expression::Phase> conditions_;
    std::vector<double> state_;
};

void expectDerivatives(const SurfaceGap& gap) {
    for (const bool hasFriction : {false, true})
        for (const bool isSwapped : {false, true}) {
            const Moving moving(gap, hasFriction, isSwapped);
            const auto& conditions = moving.conditions();
            ASSERT_EQ(conditions.size(), hasFriction ? 5u : 1u);
            const expression::Condition& first = *conditions[0].condition;
            EXPECT_NEAR(moving.value(*first.rate), moving.rateOf(*first.gap), 1e-7);
            for (std::size_t i = 0; i < conditions.size(); ++i) {
                EXPECT_NEAR(moving.value(conditions[i].derivative),
                            moving.rateOf(*conditions[i].condition->rate), 1e-6)
                    << i;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_NEAR(moving.entry(i, k), moving.entry(k, i), 1e-12) << i << k;
                EXPECT_GT(moving.entry(i, i), 0) << i;
            }
        }
}

// Crossings with circles have a gap only where they all but touch (surface_gap.h).
TEST(ContactRows, AreDerivativesOfTheGapsOfAllPieces) {
    const std::array kinds{Kind::point, Kind::line,      Kind::circle,
                           Kind::cone,  Kind::ellipsoid, Kind::plane};
    std::size_t pairs = 0;
    for (const Kind body : kinds)
        for (const Kind support : kinds) {
            const SurfaceGap gap{piece(body, 0.2), piece(support, 0.3)};
            if (!haveGap(body, support) || gap.isCrossing())
                continue;
            SCOPED_TRACE(::testing::Message()
                         << static_cast<int>(body) << " on " << static_cast<int>(support));
            expectDerivatives(gap);
            ++pairs;
        }
    EXPECT_GE(pairs, 12u);
}

TEST(ContactRows, AreDerivativesOfGapsWithinHollows) {
    for (const Kind hollow : {Kind::point, Kind::line}) {
        expectDerivatives({piece(Kind::point, 0.2), piece(hollow, -3)});
        expectDerivatives({piece(hollow, -3), piece(Kind::point, 0.2)});
    }
}

} // namespace
} // namespace physics::testing
