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
    const Mode mode(*bound.model);
    HeldConditions held(*bound.model, bound, mode);
    ASSERT_TRUE(held.factorise(std::vector<double>(9, 1)));
    Eigen::VectorXd m = Eigen::Vector3d::Constant(-9.81);
    held.solve(m, mode.share.forces);
    EXPECT_FALSE(held.isRegular());
    EXPECT_LT((m - Eigen::Vector3d::Constant(3.27)).norm(), 1e-14);
}

// A point that hardly presses takes hardly a part of what changes.
TEST(HeldConditions, ChangeForcesInProportionToTheSquaresOfTheirRooms) {
    const PreparedEquations prepared = massOnThreePoints();
    const auto& bound = *prepared.components.at(0).bound;
    Mode mode(*bound.model);
    mode.share.forces = {6, 3.81 - 1e-6, 1e-6};
    mode.share.rooms = {2, 1, 1e-3};
    HeldConditions held(*bound.model, bound, mode);
    ASSERT_TRUE(held.factorise(std::vector<double>(9, 1)));
    Eigen::VectorXd m = Eigen::Vector3d::Constant(-10.81);
    held.solve(m, mode.share.forces);
    const double part = 1 / (4 + 1 + 1e-6);
    EXPECT_NEAR(m[0], 6 + 4 * part, 1e-11);
    EXPECT_NEAR(m[1], 3.81 - 1e-6 + part, 1e-11);
    EXPECT_NEAR(m[2], 1e-6 + 1e-6 * part, 1e-13);
}
