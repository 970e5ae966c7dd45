#include "collision/broad_phase.h"

#include "collision/flying_body.h"

#include <gtest/gtest.h>

#include <random>

namespace collision {
namespace {

const auto anyPair = [](std::size_t, std::size_t) { return true; };

TEST(CandidatePairs, AreThoseOfAllPairsThatOverlap) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0, 20), size(0, 3);
    std::vector<geometry::Box> boxes;
    for (int i = 0; i < 200; ++i) {
        const Vector corner(place(random), place(random), place(random));
        boxes.emplace_back(corner, corner + Vector(size(random), size(random), size(random)));
    }
    std::vector<Pair> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (boxes[i].intersects(boxes[j]) && (i + j) % 3)
                expected.emplace_back(i, j);
    const auto found =
        candidatePairs(boxes, [](std::size_t i, std::size_t j) { return (i + j) % 3 != 0; });
    EXPECT_EQ(found.pairs, expected);
    EXPECT_FALSE(expected.empty());
}

TEST(CandidatePairs, OfDistantBodiesCostNoTests) {
    std::vector<geometry::Box> boxes;
    for (int i = 0; i < 1000; ++i)
        boxes.emplace_back(Vector(3.0 * i, 0, 0), Vector(3.0 * i + 1, 1, 1));
    const auto found = candidatePairs(boxes, anyPair);
    EXPECT_TRUE(found.pairs.empty());
    EXPECT_EQ(found.tests, 0u);
}

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
