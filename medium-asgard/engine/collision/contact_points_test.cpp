#include "collision/contact_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace collision {
namespace {

using geometry::fromRotationVector;
using Kind = Feature::Kind;

ContactPoints touching(const Part& part, const Vector& place, const Vector& rotation,
                       const Part& other = geometry::planePart()) {
    const Matrix turn = fromRotationVector(rotation).toRotationMatrix();
    return contactPoints({&part, turn, place}, {&other, Matrix::Identity(), Vector::Zero()}, 1e-9);
}

TEST(ContactPoints, NameThePieceThatBearsOnAFloor) {
    const double right = std::numbers::pi / 2, a = 0.4, c = std::cos(a), s = std::sin(a);
    const Part drum = geometry::cylinderPart(0.5, 2);
    const auto standing = touching(drum, {3, 1, 0}, {0, 0.7, 0});
    EXPECT_EQ(standing.first.kind, Kind::face);
    EXPECT_EQ(standing.first.radius, 0.5);
    EXPECT_EQ(standing.first.axis, Vector(0, -1, 0));
    EXPECT_EQ(standing.second.kind, Kind::face);
    EXPECT_TRUE(standing.isDisc);
    EXPECT_LT((standing.centre - Vector(3, 0, 0)).norm(), 1e-14);

    const auto lying = touching(drum, {3, 0.5, 0}, {right, 0, 0});
    EXPECT_EQ(lying.first.kind, Kind::segment);
    EXPECT_EQ(lying.first.radius, 0.5);
    EXPECT_EQ(lying.first.length, 2);
    ASSERT_EQ(lying.points.size(), 2u);
    EXPECT_NEAR(std::abs(lying.points[0].z()), 1, 1e-14);
    EXPECT_NEAR(lying.points[0].z() + lying.points[1].z(), 0, 1e-14);

    const auto leaning = touching(drum, {3, c + 0.5 * s, 0}, {0, 0, a});
    EXPECT_EQ(leaning.first.kind, Kind::circle);
    EXPECT_EQ(leaning.first.place, Vector(0, -1, 0));
    ASSERT_EQ(leaning.points.size(), 1u);
    EXPECT_LT((leaning.points[0] - Vector(3 + s - 0.5 * c, 0, 0)).norm(), 1e-14);
    EXPECT_NEAR(leaning.gap, 0, 1e-15);

    const Part cone = geometry::conePart(1, 2);
    const double half = std::atan2(1, 2); // between its axis and its side
    const auto side = touching(cone, {0, 1 * std::sin(half), 0}, {0, 0, right + half});
    EXPECT_EQ(side.first.kind, Kind::cone);
    EXPECT_EQ(side.first.place, Vector(0, 1, 0));
    EXPECT_DOUBLE_EQ(side.first.sine, 1 / std::sqrt(5));
    ASSERT_EQ(side.points.size(), 2u);
    EXPECT_NEAR((side.points[0] - side.points[1]).norm(), std::sqrt(5), 1e-14);
    const auto tip = touching(cone, {0, 1, 0}, {2 * right, 0, 0});
    EXPECT_EQ(tip.first.kind, Kind::point);
    EXPECT_EQ(tip.first.place, Vector(0, 1, 0));
    EXPECT_EQ(tip.first.radius, 0);

    const auto end = touching(geometry::capsulePart(0.5, 2), {0, c + 0.5, 0}, {0, 0, a});
    EXPECT_EQ(end.first.kind, Kind::point);
    EXPECT_EQ(end.first.radius, 0.5);
    const auto pill = touching(geometry::capsulePart(0.5, 2), {0, 0.5, 0}, {right, 0, 0});
    EXPECT_EQ(pill.first.kind, Kind::segment);
    EXPECT_EQ(pill.points.size(), 2u);

    const auto egg = touching(geometry::ellipsoidPart({1, 2, 3}), {0, 2, 0}, Vector::Zero());
    EXPECT_EQ(egg.first.kind, Kind::ellipsoid);
    EXPECT_EQ(egg.first.axes, Matrix(Vector(1, 2, 3).asDiagonal()));
    const auto ball = touching(geometry::spherePart(2), {0, 2, 0}, Vector::Zero());
    EXPECT_EQ(ball.first.kind, Kind::point);
    EXPECT_EQ(ball.first.radius, 2);
    const auto box =
        touching(geometry::polyhedronPart(geometry::box({2, 2, 2})), {0, 1, 0}, Vector::Zero());
    EXPECT_EQ(box.first.kind, Kind::face);
    EXPECT_EQ(box.first.outline.size(), 4u);
    EXPECT_EQ(box.points.size(), 4u);
    EXPECT_FALSE(box.isDisc);
}

TEST(ContactPoints, NameBothPieces) {
    const double right = std::numbers::pi / 2;
    const Part drum = geometry::cylinderPart(0.5, 2);
    const auto crossed = touching(drum, {0, 0, 1}, {0, 0, right}, drum);
    EXPECT_EQ(crossed.first.kind, Kind::segment);
    EXPECT_EQ(crossed.second.kind, Kind::segment);
    ASSERT_EQ(crossed.points.size(), 1u);
    EXPECT_LT((crossed.points[0] - Vector(0, 0, 0.5)).norm(), 1e-14);
    const auto onEdge = touching(geometry::polyhedronPart(geometry::box({2, 2, 2})),
                                 {0, 0, std::sqrt(2) + 0.5}, {0, right / 2, 0}, drum);
    EXPECT_EQ(onEdge.first.kind, Kind::segment);
    EXPECT_EQ(onEdge.first.radius, 0);
    EXPECT_EQ(onEdge.second.kind, Kind::segment);
    EXPECT_EQ(onEdge.second.radius, 0.5);
    EXPECT_EQ(onEdge.points.size(), 2u);
    // A coin on a larger one: the whole of the smaller.
    const auto coins =
        touching(geometry::cylinderPart(0.2, 0.1), {0.1, 1.05, 0}, Vector::Zero(), drum);
    EXPECT_EQ(coins.first.kind, Kind::face);
    EXPECT_EQ(coins.second.kind, Kind::face);
    EXPECT_TRUE(coins.isDisc);
    EXPECT_LT((coins.centre - Vector(0.1, 1, 0)).norm(), 1e-14);
}

} // namespace
} // namespace collision
