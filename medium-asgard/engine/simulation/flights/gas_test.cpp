// Many collisions: how many there are, what they conserve, and how much work they are.
#include "simulation/testing.h"

#include <cmath>
#include <numbers>
#include <random>

namespace simulation::testing {
namespace {

// Work is counted over two runs: the motion, and its twin that shows what rounding does to it.
constexpr std::size_t runs = 2;

// A wall at x = 0, a ball at rest, and one of 100^n times its mass that comes to it: they meet as
// often as the first n + 1 digits of pi say (Galperin 2003).
SceneBuilder galperin(int n) {
    SceneBuilder b(10);
    b.box("wall", {-0.5, 0, 0}, {1, 2, 2}).fixed = true;
    b.ball("light", {1.1, 0, 0});
    b.ball("heavy", {2.3, 0, 0}).mass = std::pow(100.0, n);
    b.scene.bodies[2].initialVelocity = {-1, 0, 0};
    return b;
}

TEST(Galperin, CountsTheDigitsOfPi) {
    const std::vector<std::size_t> counts{3, 31, 314, 3141, 31415, 314159};
    for (int n = 0; n < 6; ++n) {
        const Result result = simulate(galperin(n).scene);
        EXPECT_EQ(result.motion->impacts().size(), counts[static_cast<std::size_t>(n)]) << n;
        EXPECT_FALSE(result.motion->stop(1)) << n;
        // Per meeting one search for each of the three pairs, and some where windows end.
        EXPECT_LT(result.statistics.pairTests / runs, 3 * counts[static_cast<std::size_t>(n)] + 50)
            << n;
    }
}

// Balls in a box with an edge of 2 about the origin, with velocities up to sqrt(3) in each
// direction.
SceneBuilder gas(std::size_t perEdge, double finish) {
    SceneBuilder b(finish);
    b.room();
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> speed(-std::numbers::sqrt3, std::numbers::sqrt3);
    const double spacing = 2.0 / static_cast<double>(perEdge);
    for (std::size_t i = 0; i < perEdge * perEdge * perEdge; ++i) {
        const Vector cell(static_cast<double>(i % perEdge),
                          static_cast<double>(i / perEdge % perEdge),
                          static_cast<double>(i / perEdge / perEdge));
        scene::Body& ball = b.ball("ball" + std::to_string(i),
                                   spacing * (cell + Vector::Constant(0.5)) - Vector::Ones(), 0.05);
        ball.mass = 1;
        ball.initialVelocity = {speed(random), speed(random), speed(random)};
    }
    return b;
}

double kineticEnergy(const Motion& motion, double time) {
    double sum = 0;
    for (std::size_t b = 0; b < motion.bodies(); ++b)
        if (std::isfinite(motion.mass(b)))
            sum += motion.mass(b) * motion.at(b, time).velocity.squaredNorm() / 2;
    return sum;
}

TEST(ElasticGas, KeepsItsEnergyAndItsBox) {
    const Result result = simulate(gas(5, 10).scene);
    const Motion& motion = *result.motion;
    EXPECT_GT(motion.impacts().size(), 1500u);
    EXPECT_EQ(result.statistics.discardedSteps, 0u);
    const double start = kineticEnergy(motion, 0);
    EXPECT_NEAR(kineticEnergy(motion, 10) / start, 1, 1e-12);
    for (std::size_t b = 6; b < motion.bodies(); ++b)
        EXPECT_LT(motion.at(b, 10).position.cwiseAbs().maxCoeff(), 0.95 + 1e-12);
    for (std::size_t a = 6; a < motion.bodies(); ++a)
        for (std::size_t b = a + 1; b < motion.bodies(); ++b)
            EXPECT_GT(distance(motion.at(a, 10).position, motion.at(b, 10).position), 0.1 - 1e-12);
}

// A search costs what a ball's neighbourhood has, not what the scene has.
TEST(ElasticGas, TestsAsManyPairsPerMeetingHoweverManyBallsThereAre) {
    const auto perMeeting = [](std::size_t perEdge, double finish) {
        const Result result = simulate(gas(perEdge, finish).scene);
        return static_cast<double>(result.statistics.pairTests / runs) /
               static_cast<double>(result.motion->impacts().size());
    };
    EXPECT_LT(perMeeting(4, 4), 25);
    EXPECT_LT(perMeeting(8, 0.5), 25);
}

// Discs of bodies apart, each on a way of its own.
Result distant(std::size_t count) {
    SceneBuilder b(10);
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> speed(-1, 1);
    for (std::size_t i = 0; i < count; ++i) {
        scene::Body& ball =
            b.ball("ball" + std::to_string(i), {5.0 * static_cast<double>(i), 0, 0});
        ball.initialVelocity = {0, 10 * speed(random), 10 * speed(random)};
    }
    return simulate(b.scene);
}

TEST(DistantBodies, AreTestedAtMostTwiceEach) {
    const Result result = distant(1000);
    EXPECT_TRUE(result.motion->impacts().empty());
    EXPECT_LE(result.statistics.pairTests, 2000u);
    EXPECT_EQ(result.statistics.steps, 0u);
}

// Two balls between two walls, far from a thousand others: their meetings concern nobody else.
TEST(DistantBodies, AreNotTestedWhereOthersMeet) {
    SceneBuilder b(10);
    b.box("left", {-1.5, 0, 0}, {1, 2, 2}).fixed = true;
    b.box("right", {1.5, 0, 0}, {1, 2, 2}).fixed = true;
    b.ball("a", {-0.5, 0, 0}).initialVelocity = {7, 0, 0};
    b.ball("b", {0.5, 0, 0}).initialVelocity = {-5, 0, 0};
    const Result alone = simulate(b.scene);
    for (std::size_t i = 0; i < 1000; ++i)
        b.ball("far" + std::to_string(i), {10.0 + 3 * static_cast<double>(i), 0, 0})
            .initialVelocity = {0, 1, 0};
    const Result among = simulate(b.scene);
    EXPECT_EQ(among.motion->impacts().size(), alone.motion->impacts().size());
    EXPECT_GT(alone.motion->impacts().size(), 100u);
    EXPECT_EQ(among.statistics.pairTests, alone.statistics.pairTests);
    // 2 per body and event, and windows that end.
    EXPECT_LE(alone.statistics.pairTests / runs, 2 * 2 * alone.motion->impacts().size() + 50);
    EXPECT_EQ(rows(*among.motion, 2), rows(*alone.motion, 2)); // and not by a bit
}

// Steps that collisions throw away, where bodies are integrated: under 5 % of all.
TEST(ElasticGas, ThrowsFewStepsAway) {
    SceneBuilder b = gas(3, 4);
    for (std::size_t i = 6; i < b.scene.bodies.size(); ++i) {
        const std::string name = b.scene.bodies[i].name;
        b.force(name, "-0.1*" + name + ".dx*abs(" + name + ".dx)", "-0.1*" + name + ".dy",
                "-4*" + name + ".z");
    }
    const Result result = simulate(b.scene);
    EXPECT_GT(result.motion->impacts().size(), 60u);
    EXPECT_GT(result.statistics.steps, 500u);
    EXPECT_LT(static_cast<double>(result.statistics.discardedSteps),
              0.05 * static_cast<double>(result.statistics.steps));
}

} // namespace
} // namespace simulation::testing
