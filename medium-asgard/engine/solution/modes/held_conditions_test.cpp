// A mass on three points that carry it together: its forces are redundant.
#include "modes/held_conditions.h"

#include "modes/testing.h"

#include <gtest/gtest.h>

using namespace solution;
using namespace solution::testing;

namespace {

PreparedEquations massOnThreePoints() {
    const std::string rate = "a+b+c-9.81";
    const auto set = setOf({{"dy", rate}, {"a", rate}, {"b", rate}, {"c", rate}});
    for (std::size_t i = 1; i < set->unknowns.size(); ++i)
        set->unknowns[i].phases[0].condition =
            expression::Condition{std::nullopt, expression::testing::parsed(set->graph, "dy")};
    return prepared(set);
}

} // namespace

TEST(HeldConditions, TakeTheShortestForces) {
    const PreparedEquations prepared = massOnThreePoints();
    const auto& bound = *prepared.components.at(0).bound;
    const Mode mode(*bound.model, bound.laws.size());
    HeldConditions held(conditionsOf(bound), bound, mode);
    ASSERT_TRUE(held.factorise(std::vector<double>(9, 1)));
    Eigen::VectorXd m = Eigen::Vector3d::Constant(-9.81);
    held.solve(m, mode.share.forces);
    EXPECT_FALSE(held.isRegular());
    EXPECT_LT((m - Eigen::Vector3d::Constant(3.27)).norm(), 1e-14);
}

TEST(HeldConditions, AreKeptOfManyRatesAsOfEach) {
    const PreparedEquations prepared = massOnThreePoints();
    const auto& bound = *prepared.components.at(0).bound;
    Mode mode(*bound.model, bound.laws.size());
    mode.share.rooms = {2, 1, 1e-3};
    HeldConditions held(conditionsOf(bound), bound, mode);
    for (const double tie : {1.0, 0.5}) { // redundant, and not
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Constant(tie);
        matrix.diagonal().setOnes();
        ASSERT_TRUE(held.factorise({matrix.data(), 9}));
        Eigen::MatrixXd many = matrix * Eigen::Matrix3d{{1, 2, -3}, {0, 5, 1}, {4, 0, 1}};
        const Eigen::MatrixXd rates = many;
        held.solveEach(many);
        for (Eigen::Index i = 0; i < 3; ++i) {
            Eigen::VectorXd one = rates.col(i);
            held.solve(one);
            EXPECT_LT((many.col(i) - one).norm(), 1e-13 * one.norm()) << tie << " " << i;
            EXPECT_LT((matrix * one + rates.col(i)).norm(), 1e-13 * rates.norm()) << tie;
        }
    }
}

// A condition that two others make, but for how far places are off them, has a pivot of its own.
TEST(HeldConditions, AreRedundantWherePlacesOffThemMakeAPivot) {
    const PreparedEquations prepared = massOnThreePoints();
    const auto& bound = *prepared.components.at(0).bound;
    const Mode mode(*bound.model, bound.laws.size());
    HeldConditions held(conditionsOf(bound), bound, mode);
    constexpr double off = 1e-5;
    Eigen::Matrix3d rows;
    rows << 1, 0, 0, 0, 1, 0, 0.6, 0.8, 0.1 * off;
    const Eigen::Matrix3d matrix = rows * rows.transpose();
    const Eigen::Vector3d rates = rows * Eigen::Vector3d(-9.81, 1, 1);
    const std::span<const double> values(matrix.data(), 9);
    Eigen::VectorXd forces = rates;
    ASSERT_TRUE(held.factorise(values));
    EXPECT_TRUE(held.isRegular());
    held.solve(forces);
    EXPECT_GT(forces.norm(), 1e5);
    ASSERT_TRUE(held.factorise(values, [] { return off; }));
    EXPECT_FALSE(held.isRegular());
    forces = rates;
    held.solve(forces);
    EXPECT_LT(forces.norm(), 10);
    EXPECT_LT((matrix * forces + rates).cwiseAbs().maxCoeff(), off);
    ASSERT_TRUE(held.factorise(std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}, [] {
        ADD_FAILURE() << "nothing is next to redundant";
        return off;
    }));
}

// A point that hardly presses takes hardly a part of what changes.
TEST(HeldConditions, ChangeForcesInProportionToTheSquaresOfTheirRooms) {
    const PreparedEquations prepared = massOnThreePoints();
    const auto& bound = *prepared.components.at(0).bound;
    Mode mode(*bound.model, bound.laws.size());
    mode.share.forces = {6, 3.81 - 1e-6, 1e-6};
    mode.share.rooms = {2, 1, 1e-3};
    HeldConditions held(conditionsOf(bound), bound, mode);
    ASSERT_TRUE(held.factorise(std::vector<double>(9, 1)));
    Eigen::VectorXd m = Eigen::Vector3d::Constant(-10.81);
    held.solve(m, mode.share.forces);
    const double part = 1 / (4 + 1 + 1e-6);
    EXPECT_NEAR(m[0], 6 + 4 * part, 1e-11);
    EXPECT_NEAR(m[1], 3.81 - 1e-6 + part, 1e-11);
    EXPECT_NEAR(m[2], 1e-6 + 1e-6 * part, 1e-13);
}

// Four corners of a face, one of which is tilted so little that the others keep it, but for what
// the tilt has of a rate.
TEST(HeldConditions, AreKeptCloselyWhereATiltHasARateOfItsOwn) {
    const std::string rate = "a+b+c+d-9.81";
    const auto set = setOf({{"dy", rate}, {"a", rate}, {"b", rate}, {"c", rate}, {"d", rate}});
    expression::Graph& graph = set->graph;
    for (std::size_t i = 1; i < set->unknowns.size(); ++i) {
        expression::Condition corner{std::nullopt, expression::testing::parsed(graph, "dy")};
        corner.low = 0;
        corner.leaving = 1;
        corner.patch = set->unknowns[1].symbol;
        set->unknowns[i].phases[0].condition = corner;
    }
    const PreparedEquations prepared = solution::testing::prepared(set);
    const auto& bound = *prepared.components.at(0).bound;
    const Mode mode(*bound.model, bound.laws.size());
    HeldConditions held(conditionsOf(bound), bound, mode);
    Eigen::Matrix4d rows; // by the ways and turns of a body, and by what the tilt moves
    rows << 1, 1, 1, 0, 1, -1, 1, 0, 1, -1, -1, 0, 1, 1, -1, 1e-4;
    const Eigen::Matrix4d matrix = rows * rows.transpose();
    const Eigen::Vector4d rates = rows * Eigen::Vector4d(-9.81, 1, 2, 3);
    const std::span<const double> values(matrix.data(), 16);
    ASSERT_TRUE(held.factorise(values));
    Eigen::VectorXd forces = rates;
    held.solve(forces);
    EXPECT_GT((matrix * forces + rates).cwiseAbs().maxCoeff(), 1e-5);
    ASSERT_TRUE(held.factoriseClosely(values));
    forces = rates;
    held.solve(forces);
    EXPECT_LT((matrix * forces + rates).cwiseAbs().maxCoeff(), 1e-9);
}
