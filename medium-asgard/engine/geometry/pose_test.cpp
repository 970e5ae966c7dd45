#include "geometry/pose.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace geometry {
namespace {

TEST(Pose, MapsToWorldAndBack) {
    const Pose pose{{1, 2, 3}, fromRotationVector({0, 0, std::numbers::pi / 2})};
    EXPECT_LT((pose.toWorld({1, 0, 0}) - Vector(1, 3, 3)).norm(), 1e-15);
    EXPECT_LT((pose.toLocal({1, 3, 3}) - Vector(1, 0, 0)).norm(), 1e-15);
}

TEST(RotationVector, QuarterTurnAboutZTakesXToY) {
    const Quaternion q = fromRotationVector({0, 0, std::numbers::pi / 2});
    EXPECT_LT((q * Vector::UnitX() - Vector::UnitY()).norm(), 1e-15);
}

TEST(RotationVector, ComesBackForAnglesUpToPi) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const Vector axis = Vector(uniform(random), uniform(random), uniform(random)).normalized();
        const double angle = std::pow(10, -12 * std::abs(uniform(random))) * 3.14159;
        const Vector v = angle * axis;
        const Quaternion q = fromRotationVector(v);
        EXPECT_LT((toRotationVector(q) - v).norm(), 1e-14 * (1 + angle));
        const Quaternion opposite(-q.w(), -q.x(), -q.y(), -q.z());
        EXPECT_LT((toRotationVector(opposite) - v).norm(), 1e-14 * (1 + angle));
    }
}

TEST(RotationVector, ZeroIsNoRotation) {
    EXPECT_EQ(fromRotationVector(Vector::Zero()).coeffs(), Quaternion::Identity().coeffs());
    EXPECT_EQ(toRotationVector(Quaternion::Identity()), Vector::Zero());
}

} // namespace
} // namespace geometry
