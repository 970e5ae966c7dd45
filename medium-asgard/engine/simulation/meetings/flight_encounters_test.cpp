// Balls in flight meet whatever is in their way, wherever that is.
#include "simulation/testing.h"

#include <cmath>

namespace simulation::testing {
namespace {

// Each falls from a height of its own onto a slab of its own, at any depth below the origin.
TEST(Flights, EndOnFloorsAtAnyDepth) {
    SceneBuilder b(7, 1e-4);
    constexpr int count = 120;
    for (int k = 1; k <= count; ++k) {
        const std::string name = std::to_string(k);
        const double x = 10.0 * k, top = -k / 7.0;
        b.box("slab" + name, {x, top - 1, 0.3}, {4, 2, 4}).fixed = true;
        b.ball("ball" + name, {x, 3, 0.3}, 0.5);
        b.weight("ball" + name);
    }
    const Result result = simulate(b.scene);
    std::vector<int> hits(b.scene.bodies.size());
    for (const Impact& impact : result.motion->impacts())
        ++hits[std::max(impact.first, impact.second)];
    for (int k = 1; k <= count; ++k)
        EXPECT_GT(hits[static_cast<std::size_t>(2 * k - 1)], 0) << k;
}

// The order of the lines decides nothing; one has weight, the other floats.
TEST(Flights, OfDifferentWeightsMeetInEitherOrder) {
    std::vector<double> times;
    for (const bool floatsFirst : {true, false}) {
        SceneBuilder b(0.5);
        if (floatsFirst)
            b.ball("still", {0.125, 0.02, 0.125});
        b.ball("falling", {0.125, 0.45, 0.125});
        if (!floatsFirst)
            b.ball("still", {0.125, 0.02, 0.125});
        b.weight("falling");
        const Result result = simulate(b.scene);
        ASSERT_EQ(result.motion->impacts().size(), 1u) << floatsFirst;
        times.push_back(result.motion->impacts()[0].time);
    }
    EXPECT_NEAR(times[0], std::sqrt(2 * 0.23 / g), 1e-9);
    EXPECT_EQ(times[0], times[1]);
}

// Every other ball has weight: formulas answer for few pairs, and none may pass through another.
TEST(Flights, OfDifferentWeightsKeepApart) {
    SceneBuilder b(3, 1e-4);
    b.room();
    for (int i = 0; i < 27; ++i) {
        const std::string name = "ball" + std::to_string(i);
        const Vector cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        b.ball(name, 0.6 * cell, 0.15).initialVelocity = {std::sin(7.0 * i), std::cos(5.0 * i),
                                                          std::sin(3.0 * i + 1)};
        if (i % 2 == 0)
            b.weight(name, {0, -0.5 - 0.1 * i, 0});
    }
    const Result result = simulate(b.scene);
    EXPECT_GT(result.motion->impacts().size(), 100u);
    for (int sample = 1; sample <= 60; ++sample)
        for (std::size_t one = 6; one < 33; ++one)
            for (std::size_t other = one + 1; other < 33; ++other)
                EXPECT_GT(distance(result.motion->at(one, 0.05 * sample).position,
                                   result.motion->at(other, 0.05 * sample).position),
                          0.3 - 1e-9)
                    << one << " " << other << " " << sample;
}

// What a body does is the same to the last bit whether another reads it or not: an edit that adds a
// reader keeps its motion.
TEST(Flights, AreTheSameWhetherTheyAreReadOrNot) {
    SceneBuilder b(20);
    b.box("left", {-1.5, 0, 0}, {1, 8, 8}).fixed = true;
    b.box("right", {1.5, 0, 0}, {1, 8, 8}).fixed = true;
    b.ball("flies", {0.1, 0.2, 0.3}).initialVelocity = {2.3, 0.013, 0.0171};
    const Result unread = simulate(b.scene);
    b.ball("reads", {100, 0, 0});
    b.force("reads", "0", "0.1*flies.dy+0.01*flies.z", "0");
    const Result read = simulate(b.scene);
    EXPECT_GT(unread.motion->impacts().size(), 20u);
    EXPECT_EQ(rows(*read.motion, 2), rows(*unread.motion, 2));
}

// Nothing that is solved is touched by the blow: the ball was still, the racket is held.
TEST(Flights, BeginWhereWhatIsHeldHitsWhatIsStill) {
    SceneBuilder b(3);
    b.ball("racket", {-1, 0, 0}, 0.3);
    b.hold("racket", 0, 1, {{-1, 0, 0}, {0, 0, 0}});
    b.ball("ball", {0, 0, 0}, 0.3);
    const Result result = simulate(b.scene);
    ASSERT_EQ(result.motion->impacts().size(), 1u);
    EXPECT_NEAR(result.motion->impacts()[0].time, 0.4, 1e-12);
    EXPECT_NEAR(result.motion->at(1, 3).velocity.x(), 2, 1e-12);
    EXPECT_NEAR(result.motion->at(1, 3).position.x(), 5.2, 1e-11);
}

// What ends the attitude ends neither the place nor the hits of a ball, whenever they come.
TEST(Flights, GoOnWhereTheAttitudeIsNotKnownAnyMore) {
    for (const double away : {1.6, 3.0, 9.0})
        for (const double weight : {0.0, 0.1}) {
            SceneBuilder b(20, 1e-5);
            b.ball("a", {0, 0, 0}, 0.5).initialVelocity = {0.5, 0, 0};
            b.ball("b", {away, 0, 0}, 0.5);
            b.force("a", "1/(1-t)^2", "0", "0").couple = true;
            if (weight > 0)
                b.weight("b", {-weight, 0, 0});
            const Result result = simulate(b.scene);
            EXPECT_TRUE(result.motion->stop(0));
            EXPECT_FALSE(result.motion->stop(1));
            ASSERT_FALSE(result.motion->impacts().empty()) << away;
            const double hit = result.motion->impacts()[0].time;
            EXPECT_NEAR(0.5 * hit + weight * hit * hit / 2, away - 1, 1e-9) << away;
        }
}

// Cells grow with the way: a lonely ball crosses few, however far it goes.
TEST(Flights, GoFarInFewSteps) {
    SceneBuilder b(1e6);
    b.ball("fast", {0, 0, 0}, 1e-3).initialVelocity = {1e6, 0, 0};
    b.ball("still", {0, 5, 0}, 1e-3);
    b.box("block", {9e6, 50, 0}, {1, 1, 1});
    const Result result = simulate(b.scene);
    EXPECT_TRUE(result.motion->impacts().empty());
    EXPECT_EQ(result.motion->at(0, 1e6).position.x(), 1e12);
}

} // namespace
} // namespace simulation::testing
