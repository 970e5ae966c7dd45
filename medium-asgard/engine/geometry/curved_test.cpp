#include "geometry/mass.h"
#include "geometry/shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace geometry {
namespace {

constexpr double pi = std::numbers::pi;

Pose turned() { return {{0.3, -1.2, 2.5}, fromRotationVector({0.4, 1.1, -0.7})}; }

struct Expected {
    double volume, across, along; // moments of inertia over the mass
    double below = 0;             // of the centroid below the part's origin
};

// At the origin, and somewhere else: inertia turned, centroid moved.
void expectMass(const Part& plain, const Part& moved, const Expected& expected) {
    for (const auto& [part, pose] : {std::pair(plain, Pose{}), {moved, turned()}}) {
        const MassProperties m = massProperties(Shape{{part}}, 2.5);
        EXPECT_NEAR(m.volume / expected.volume, 1, 1e-15);
        EXPECT_NEAR(m.mass / (2.5 * expected.volume), 1, 1e-15);
        EXPECT_LT((m.centroid - pose.toWorld({0, -expected.below, 0})).norm(), 1e-15);
        const Vector axis = pose.attitude * Vector::UnitY();
        const Matrix inertia =
            m.mass * (expected.across * Matrix::Identity() +
                      (expected.along - expected.across) * axis * axis.transpose());
        EXPECT_LT((m.inertia - inertia).norm(), 2e-15 * inertia.norm());
    }
}

TEST(Curved, MassPropertiesAreTheTextbooks) {
    const double r = 0.7, h = 1.9;
    expectMass(cylinderPart(r, h), cylinderPart(r, h, turned()),
               {pi * r * r * h, r * r / 4 + h * h / 12, r * r / 2});
    expectMass(conePart(r, h), conePart(r, h, turned()),
               {pi * r * r * h / 3, 3 * r * r / 20 + 3 * h * h / 80, 3 * r * r / 10, h / 4});
    // A tube and two half spheres, by the theorem of parallel axes.
    const double tube = pi * r * r * h, ball = 4 * pi * r * r * r / 3, volume = tube + ball;
    const double across =
        tube * (r * r / 4 + h * h / 12) + ball * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8);
    const double along = tube * r * r / 2 + ball * 2 * r * r / 5;
    expectMass(capsulePart(r, h), capsulePart(r, h, turned()),
               {volume, across / volume, along / volume});
}

TEST(Curved, AnEllipsoidsInertiaIsAlongItsAxes) {
    const Vector a(0.5, 1.25, 2);
    const MassProperties m = massProperties(Shape{{ellipsoidPart(a)}}, 3);
    EXPECT_NEAR(m.mass / (4 * pi * a.prod()), 1, 1e-15);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(m.inertia(k, k) / (m.mass * (a.squaredNorm() - a[k] * a[k]) / 5), 1, 1e-15);
    const MassProperties moved = massProperties(Shape{{ellipsoidPart(a, turned())}}, 3);
    const Matrix r = turned().attitude.toRotationMatrix();
    EXPECT_LT((moved.inertia - r * m.inertia * r.transpose()).norm(), 1e-14 * m.inertia.norm());
    // A ball in another guise.
    const MassProperties round = massProperties(Shape{{ellipsoidPart(Vector::Constant(2))}}, 1);
    const MassProperties ball = massProperties(Shape{{spherePart(2)}}, 1);
    EXPECT_LT((round.inertia - ball.inertia).norm(), 1e-15 * ball.inertia.norm());
}

TEST(Curved, PartsOfAUnionAddUp) {
    // A cylinder of two, one on the other.
    const Pose up{{0, 0.5, 0}, Quaternion::Identity()}, down{{0, -1, 0}, Quaternion::Identity()};
    const MassProperties sum =
        massProperties(Shape{{cylinderPart(1, 2, up), cylinderPart(1, 1, down)}}, 1.5);
    const MassProperties whole = massProperties(Shape{{cylinderPart(1, 3)}}, 1.5);
    EXPECT_NEAR(sum.mass / whole.mass, 1, 1e-15);
    EXPECT_LT((sum.centroid - whole.centroid).norm(), 1e-15);
    EXPECT_LT((sum.inertia - whole.inertia).norm(), 1e-14);
}

TEST(Curved, ADiscHasTheMassOfItsAreaAndAPlaneNone) {
    const auto disc = scaledToMass(massProperties(Shape{{cylinderPart(2, 0)}}, 1), 3);
    EXPECT_EQ(disc.volume, 0);
    EXPECT_DOUBLE_EQ(disc.inertia(0, 0), 3);
    EXPECT_DOUBLE_EQ(disc.inertia(1, 1), 6);
    const auto floor = massProperties(Shape{{planePart({{0, 2, 0}, Quaternion::Identity()})}}, 1);
    EXPECT_EQ(floor.mass, 0);
    EXPECT_EQ(floor.centroid, Vector(0, 2, 0));
    EXPECT_EQ(floor.inertia, Matrix(Matrix::Zero()));
    const auto both = massProperties(Shape{{planePart(), spherePart(1, {1, 2, 3})}}, 1);
    EXPECT_EQ(both.centroid, Vector(1, 2, 3));
}

TEST(Curved, ReachesAndBoundsAreExact) {
    const double r = 0.7, h = 1.9;
    EXPECT_DOUBLE_EQ(radiusAbout(cylinderPart(r, h), Vector::Zero()), std::hypot(r, h / 2));
    EXPECT_DOUBLE_EQ(radiusAbout(cylinderPart(r, h), {0.1, 0.3, 0}), std::hypot(0.8, 1.25));
    EXPECT_DOUBLE_EQ(radiusAbout(conePart(r, h), Vector(0, -h / 4, 0)), 3 * h / 4);
    EXPECT_DOUBLE_EQ(radiusAbout(capsulePart(r, h), Vector::Zero()), r + h / 2);
    EXPECT_DOUBLE_EQ(radiusAbout(ellipsoidPart({1, 2, 3}), Vector::Zero()), 3);
    EXPECT_DOUBLE_EQ(radiusAbout(ellipsoidPart({1, 2, 3}), {0, 0, 1}), 4);
    EXPECT_DOUBLE_EQ(radiusAbout(ellipsoidPart({2, 2, 2}), {3, 4, 0}), 7);
    // d/dx of (x - 1/2)^2 + 16 (1 - x^2) is 0 at x = -1/30.
    EXPECT_DOUBLE_EQ(radiusAbout(ellipsoidPart({1, 4, 1}), {0.5, 0, 0}),
                     std::hypot(0.5 + 1.0 / 30, 4 * std::sqrt(1 - 1.0 / 900)));

    const Quaternion lying = fromRotationVector({0, 0, pi / 6});
    const Box b = bounds(Shape{{cylinderPart(1, 4)}}, {{5, 0, 0}, lying});
    const double up = 2 * std::cos(pi / 6) + std::sin(pi / 6);
    EXPECT_NEAR(b.max().y(), up, 1e-15);
    EXPECT_NEAR(b.max().x(), 5 + 2 * std::sin(pi / 6) + std::cos(pi / 6), 2e-15);
    EXPECT_NEAR(b.max().z(), 1, 1e-15);
    const Box e = bounds(Shape{{ellipsoidPart({1, 2, 3})}}, {{0, 0, 0}, lying});
    EXPECT_NEAR(e.max().x(), std::hypot(std::cos(pi / 6), 2 * std::sin(pi / 6)), 1e-15);
}

TEST(Curved, RaysMeetTheTrueSurfaces) {
    const auto hit = [](const Part& part, const Vector& from, const Vector& along) {
        return castRay(Shape{{part}}, from, along);
    };
    const auto side = hit(cylinderPart(1, 4), {-5, 1, 0.6}, {1, 0, 0});
    ASSERT_TRUE(side);
    EXPECT_DOUBLE_EQ(side->distance, 4.2);
    EXPECT_LT((side->normal - Vector(-0.8, 0, 0.6)).norm(), 1e-15);
    const auto cap = hit(cylinderPart(1, 4), {0.5, 9, 0}, {0, -1, 0});
    ASSERT_TRUE(cap);
    EXPECT_DOUBLE_EQ(cap->distance, 7);
    EXPECT_EQ(cap->normal, Vector(0, 1, 0));
    EXPECT_FALSE(hit(cylinderPart(1, 4), {1.5, 9, 0}, {0, -1, 0}));

    const auto cone = hit(conePart(1, 2), {-5, 0, 0}, {1, 0, 0});
    ASSERT_TRUE(cone);
    EXPECT_DOUBLE_EQ(cone->distance, 4.5);
    EXPECT_LT((cone->normal - Vector(-2, 1, 0).normalized()).norm(), 1e-15);
    EXPECT_FALSE(hit(conePart(1, 2), {-5, 1.5, 0}, {1, 0, 0})); // the other nappe is no part of it
    const auto steep = hit(conePart(1, 2), {0.25, 9, 0}, {0, -1, 0});
    ASSERT_TRUE(steep);
    EXPECT_DOUBLE_EQ(steep->distance, 8.5);
    const auto base = hit(conePart(1, 2), {0.25, -9, 0}, {0, 1, 0});
    ASSERT_TRUE(base);
    EXPECT_DOUBLE_EQ(base->distance, 8);
    EXPECT_EQ(base->normal, Vector(0, -1, 0));

    const auto end = hit(capsulePart(1, 2), {0, 9, 0.6}, {0, -1, 0});
    ASSERT_TRUE(end);
    EXPECT_DOUBLE_EQ(end->distance, 9 - 1.8);
    EXPECT_LT((end->normal - Vector(0, 0.8, 0.6)).norm(), 1e-15);
    const auto egg = hit(ellipsoidPart({1, 2, 3}), {0, 0, 10}, {0, 0, -2});
    ASSERT_TRUE(egg);
    EXPECT_DOUBLE_EQ(egg->distance, 3.5);
    const auto floor = hit(planePart(), {0, 3, 0}, {1, -1, 0});
    ASSERT_TRUE(floor);
    EXPECT_DOUBLE_EQ(floor->distance, 3);
    EXPECT_EQ(floor->normal, Vector(0, 1, 0));
    EXPECT_FALSE(hit(planePart(), {0, 3, 0}, {1, 1, 0}));
}

} // namespace
} // namespace geometry
