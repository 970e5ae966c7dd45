#include "geometry/outline.h"

#include <gtest/gtest.h>

namespace geometry {
namespace {

const std::vector<Vector> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
const Vector up = Vector::UnitZ();

TEST(Outline, APointIsAsDeepAsTheNearestEdgeIsFar) {
    EXPECT_NEAR(depthInside(square, up, {0.5, 1, 7}), 0.5, 1e-15);
    EXPECT_NEAR(depthInside(square, up, {-0.25, 1, 7}), -0.25, 1e-15);
    const std::vector<Vector> other(square.rbegin(), square.rend());
    EXPECT_NEAR(depthInside(other, up, {0.5, 1, 7}), 0.5, 1e-15);
}

TEST(Outline, AFeatureIsBesideItWhereNothingOfItIsOverIt) {
    EXPECT_EQ(besideOutline({{1, 1, 3}}, square, up), 0);
    EXPECT_NEAR(besideOutline({{1, -0.5, 3}}, square, up), 0.5, 1e-15);
    EXPECT_EQ(besideOutline({{-1, 1, 3}, {1, 1, 3}}, square, up), 0);
    // Over it between its ends, and past a corner of it.
    EXPECT_EQ(besideOutline({{-5, 1, 3}, {5, 1, 3}}, square, up), 0);
    EXPECT_NEAR(besideOutline({{-5, -0.1, 3}, {5, -0.1, 3}}, square, up), 0.1, 1e-12);
}

TEST(Outline, AFaceThatCoversItIsNotBesideIt) {
    const std::vector<Vector> large{{-5, -5, 3}, {7, -5, 3}, {7, 7, 3}, {-5, 7, 3}};
    EXPECT_EQ(besideOutline(large, square, up), 0);
    std::vector<Vector> away = large;
    for (Vector& vertex : away)
        vertex.x() += 7.5;
    EXPECT_NEAR(besideOutline(away, square, up), 0.5, 1e-15);
}

// Across a corner, where no vertex of either is next to the other.
TEST(Outline, AnEdgeThatCutsACornerIsOverItToTheLastBit) {
    const auto across = [](double by) { // the line x + y = by
        return std::vector<Vector>{{by - 7, 7, 3}, {by + 3, -3, 3}};
    };
    EXPECT_EQ(besideOutline(across(1e-8), square, up), 0);
    EXPECT_NEAR(besideOutline(across(-1e-8), square, up), 0.5e-8, 1e-15);
}

} // namespace
} // namespace geometry
