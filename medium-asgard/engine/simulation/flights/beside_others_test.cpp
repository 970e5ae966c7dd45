// Balls that meet only each other fly to the last bit as they do beside others that hit elsewhere.
#include "simulation/testing.h"

#include <cmath>

namespace simulation::testing {
namespace {

// Far away, a ball between two walls.
void addRestless(SceneBuilder& b) {
    b.box("far left", {499.4, 0, 0}, {1, 2, 2}).fixed = true;
    b.box("far right", {500.63, 0, 0}, {1, 2, 2}).fixed = true;
    b.ball("restless", {500, 0, 0}).initialVelocity = {4.3, 0, 0};
}

// The impacts of a scene alone and beside the restless ball, and the motion of its bodies.
void expectSameBeside(SceneBuilder b, std::size_t least) {
    const std::size_t bodies = b.scene.bodies.size();
    const Result alone = simulate(b.scene);
    addRestless(b);
    const Result beside = simulate(b.scene);
    std::vector<Impact> own;
    for (const Impact& impact : beside.motion->impacts())
        if (std::max(impact.first, impact.second) < bodies)
            own.push_back(impact);
    const std::vector<Impact>& expected = alone.motion->impacts();
    EXPECT_GT(expected.size(), least);
    ASSERT_EQ(own.size(), expected.size());
    EXPECT_GT(beside.motion->impacts().size(), own.size() + 100);
    for (std::size_t i = 0; i < own.size(); ++i) {
        ASSERT_EQ(own[i].time, expected[i].time) << i;
        ASSERT_EQ(own[i].first, expected[i].first) << i;
        ASSERT_EQ(own[i].second, expected[i].second) << i;
        ASSERT_EQ(own[i].impulse, expected[i].impulse) << i;
        ASSERT_EQ(own[i].normal, expected[i].normal) << i;
        ASSERT_EQ(own[i].point, expected[i].point) << i;
    }
    for (std::size_t body = 0; body < bodies; ++body)
        EXPECT_EQ(rows(*beside.motion, body), rows(*alone.motion, body)) << body;
}

SceneBuilder ballsInARoom(std::size_t count, double finish) {
    SceneBuilder b(finish, 1e-4);
    b.room();
    for (std::size_t i = 0; i < count; ++i) {
        const auto k = static_cast<double>(i);
        scene::Body& ball = b.ball("ball" + std::to_string(i),
                                   {-0.6 + 0.55 * k, 0.3 * std::sin(k), 0.2 * std::cos(k)}, 0.25);
        ball.mass = 1 + k;
        ball.initialVelocity = {3 * std::cos(2 * k), 2.5 * std::sin(3 * k + 1), 1.5 - k};
    }
    return b;
}

TEST(BesideOthers, BallsHitAsAlone) {
    SceneBuilder galperin(10);
    galperin.box("wall", {-0.5, 0, 0}, {1, 2, 2}).fixed = true;
    galperin.ball("light", {1.1, 0, 0});
    galperin.ball("heavy", {2.3, 0, 0}).mass = 1e4;
    galperin.scene.bodies[2].initialVelocity = {-1, 0, 0};
    expectSameBeside(galperin, 300);
    expectSameBeside(ballsInARoom(1, 20), 50);
    expectSameBeside(ballsInARoom(3, 20), 100);
}

TEST(BesideOthers, BallsWithWeightHitAsAlone) {
    SceneBuilder b = ballsInARoom(3, 6);
    for (int i = 0; i < 3; ++i)
        b.weight("ball" + std::to_string(i));
    expectSameBeside(b, 50);
}

TEST(BesideOthers, HitsThatTakeEnergyAreAsAlone) {
    SceneBuilder b = ballsInARoom(3, 8);
    for (scene::Body& body : b.scene.bodies)
        body.restitution = 0.95;
    expectSameBeside(b, 40);
}

// A ball comes from afar to two others that rattle at a wall.
TEST(BesideOthers, ABallFromAfarMeetsThem) {
    SceneBuilder b(10);
    b.box("wall", {-0.5, 0, 0}, {1, 2, 2}).fixed = true;
    b.ball("light", {0.3, 0, 0});
    b.ball("heavy", {1, 0, 0}).mass = 1e4;
    b.ball("late", {9, 0, 0}).mass = 1e6;
    b.scene.bodies[1].initialVelocity = {-20, 0, 0};
    b.scene.bodies[3].initialVelocity = {-2, 0, 0};
    const Result result = simulate(b.scene);
    std::size_t before = 0, late = 0;
    for (const Impact& impact : result.motion->impacts()) {
        late += impact.second == 3 ? 1 : 0;
        before += late == 0 ? 1 : 0;
    }
    EXPECT_GT(before, 50u);
    EXPECT_GT(late, 0u);
    for (double t = 0; t < 10; t += 0.01) // in a row, and not into each other
        for (std::size_t body = 1; body < 4; ++body)
            ASSERT_GT(result.motion->at(body, t).position.x() -
                          (body > 1 ? result.motion->at(body - 1, t).position.x() : 0),
                      (body > 1 ? 0.2 : 0.1) - 1e-9)
                << body << " at " << t;
}

} // namespace
} // namespace simulation::testing
