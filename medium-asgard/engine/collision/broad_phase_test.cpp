#include "collision/broad_phase.h"

#include "collision/flying_body.h"

#include <gtest/gtest.h>

#include <random>

namespace collision {
namespace {

TEST(BoundsDuring, HoldTheShapeAtAllTimes) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> uniform(-3, 3);
    const auto vector = [&] { return Vector(uniform(random), uniform(random), uniform(random)); };
    for (int trial = 0; trial < 200; ++trial) {
        FlyingBody body = flyingBox(vector().cwiseAbs(), vector(), vector());
        body.acceleration = vector();
        if (trial % 2)
            body.spin = vector();
        const geometry::Box all = boundsDuring(body, 0.5, 2.5);
        for (double t = 0.5; t <= 2.5; t += 0.01)
            ASSERT_TRUE(all.contains(geometry::bounds(body.form, poseAt(body, t))));
    }
}

TEST(BoundsDuring, OfAFixedFloorAreItsOwn) {
    const auto floor = flyingBox({4000, 1, 4000}, {0, -0.5, 0});
    EXPECT_NEAR(boundsDuring(floor, 0, 10).max().y(), 0, 1e-8);
}

} // namespace
} // namespace collision
