#include "geometry/mass.h"

#include "geometry/hull.h"

#include <gtest/gtest.h>

#include <numbers>

namespace geometry {
namespace {

Shape single(const Part& part) { return {{part}}; }

TEST(MassProperties, OfABoxAreTheTextbooks) {
    const Vector e(2, 1, 1.5);
    const MassProperties m = massProperties(single(polyhedronPart(box(e))), 2);
    EXPECT_DOUBLE_EQ(m.mass, 6);
    EXPECT_LT(m.centroid.norm(), 1e-16);
    for (int k = 0; k < 3; ++k) // m (b^2 + c^2) / 12
        EXPECT_NEAR(m.inertia(k, k), 6 * (e.squaredNorm() - e[k] * e[k]) / 12, 1e-14);
    EXPECT_LT((m.inertia - Matrix(m.inertia.diagonal().asDiagonal())).norm(), 1e-15);
}

TEST(MassProperties, OfASphere) {
    const MassProperties m = massProperties(single(spherePart(0.5, {1, 2, 3})), 1);
    EXPECT_NEAR(m.mass, std::numbers::pi / 6, 1e-15);
    EXPECT_EQ(m.centroid, Vector(1, 2, 3));
    EXPECT_LT((m.inertia - 0.4 * m.mass * 0.25 * Matrix::Identity()).norm(), 1e-16);
}

TEST(MassProperties, OfASimplexHasProductsOfInertia) {
    const Polyhedron p =
        std::get<Hull>(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})).polyhedron;
    const MassProperties m = massProperties(single(polyhedronPart(p)), 1);
    EXPECT_NEAR(m.volume, 1.0 / 6, 1e-16);
    EXPECT_LT((m.centroid - Vector::Constant(0.25)).norm(), 1e-15);
    // Integral of x^2 = 1/60, of xy = 1/120 about the corner; moved to the centroid.
    const double xx = 1.0 / 60 - 1.0 / 96, xy = 1.0 / 120 - 1.0 / 96;
    EXPECT_NEAR(m.inertia(0, 0), 2 * xx, 1e-16);
    EXPECT_NEAR(m.inertia(0, 1), -xy, 1e-16);
}

TEST(MassProperties, OfAUnionEqualThoseOfTheWhole) {
    // A box cut into two boxes, one of them given turned.
    Shape halves;
    halves.parts.push_back(polyhedronPart(box({1, 2, 3}), {{-0.5, 0, 0}, Quaternion::Identity()}));
    halves.parts.push_back(polyhedronPart(
        box({2, 1, 3}), {{0.5, 0, 0}, fromRotationVector({0, 0, std::numbers::pi / 2})}));
    const MassProperties sum = massProperties(halves, 1.5);
    const MassProperties whole = massProperties(single(polyhedronPart(box({2, 2, 3}))), 1.5);
    EXPECT_NEAR(sum.mass, whole.mass, 1e-14);
    EXPECT_LT((sum.centroid - whole.centroid).norm(), 1e-15);
    EXPECT_LT((sum.inertia - whole.inertia).norm(), 1e-13);
}

TEST(MassProperties, KeepTheirDigitsFarFromTheOrigin) {
    const Pose away{{1e6, -1e6, 1e6}, Quaternion::Identity()};
    const MassProperties far = massProperties(single(polyhedronPart(box({2, 1, 1.5}), away)), 1);
    const MassProperties near = massProperties(single(polyhedronPart(box({2, 1, 1.5}))), 1);
    EXPECT_LT((far.centroid - away.position).norm(), 1e-9);
    EXPECT_LT((far.inertia - near.inertia).norm(), 1e-8 * near.inertia.norm());
}

TEST(MassProperties, ScaleToAGivenMass) {
    const auto m = massProperties(single(polyhedronPart(box({1, 1, 1}))), 1);
    const auto heavy = scaledToMass(m, 12);
    EXPECT_DOUBLE_EQ(heavy.mass, 12);
    EXPECT_NEAR(heavy.inertia(0, 0), 2, 1e-14);
}

} // namespace
} // namespace geometry
