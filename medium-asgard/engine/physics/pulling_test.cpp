#include "physics/pulling.h"

#include "physics/testing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace physics {
namespace {

using testing::ballAndRod;

scene::Joint& join(scene::Scene& scene, scene::JointType type, const std::string& body,
                   const Vector& offset, const std::optional<std::string>& other = std::nullopt) {
    scene::Joint made;
    made.name = "j" + std::to_string(scene.joints.size());
    made.type = type;
    made.body1 = body;
    made.offset1 = offset;
    made.body2 = other;
    if (type == scene::JointType::hinge)
        made.coordinates.resize(1);
    if (type == scene::JointType::slider) {
        made.axis = Vector::UnitX();
        made.coordinates.resize(1);
    }
    scene.joints.push_back(made);
    return scene.joints.back();
}

geometry::Pose poseOf(const Pulling& pulling, const scene::Scene& scene, std::size_t body) {
    for (const Assembly::Moved& moved : pulling.moved())
        if (moved.body == body)
            return moved.pose;
    return {scene.bodies[body].initialPosition, scene.bodies[body].initialAttitude};
}

// A bob two units under its hinge.
scene::Scene pendulum() {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].initialPosition = {50, 0, 0};
    join(scene, scene::JointType::hinge, "ball", {0, 2, 0});
    return scene;
}

TEST(Pulling, APendulumSwingsAboutItsPivotTowardsTheHand) {
    const scene::Scene scene = pendulum();
    Pulling pulling(scene, 0, {0, 0, 0});
    ASSERT_TRUE(pulling.isJoined());
    EXPECT_FALSE(pulling.movesAsOne());
    for (const double angle : {0.3, 1.2, 2.5, 3.6}) {
        const Vector way(std::sin(angle), -std::cos(angle), 0);
        pulling.pullTo(Vector(0, 2, 0) + 7 * way);
        const geometry::Pose pose = poseOf(pulling, scene, 0);
        EXPECT_LT((pose.position - (Vector(0, 2, 0) + 2 * way)).norm(), 1e-4) << angle;
        EXPECT_LT((pose.toWorld({0, 2, 0}) - Vector(0, 2, 0)).norm(), 1e-12) << angle;
    }
    pulling.pullTo({0, 0, 0});
    EXPECT_LT(poseOf(pulling, scene, 0).position.norm(), 1e-9);
    for (const Vector& place : {Vector(2, 1, 0), Vector(4, 2, 0), Vector(-3, 1, 0)}) {
        pulling.pullTo(place);
        const Vector way = (place - Vector(0, 2, 0)).normalized();
        EXPECT_LT((poseOf(pulling, scene, 0).position - (Vector(0, 2, 0) + 2 * way)).norm(), 1e-4)
            << place.transpose() << ": " << pulling.turned();
    }
}

TEST(Pulling, OneWayToGoIsTurnedByAWholeAngle) {
    const scene::Scene scene = pendulum();
    Pulling pulling(scene, 0, {0, 0, 0});
    pulling.pullTo({1, 0.2, 0});
    ASSERT_TRUE(pulling.turnTo(M_PI / 6));
    EXPECT_NEAR(pulling.turned(), M_PI / 6, 1e-12);
    EXPECT_LT((poseOf(pulling, scene, 0).position - Vector(1, 2 - std::sqrt(3), 0)).norm(), 1e-12);
    scene::Scene ball = pendulum();
    ball.joints[0].type = scene::JointType::ball;
    ball.joints[0].coordinates.clear();
    Pulling free(ball, 0, {0, 0, 0});
    free.pullTo({1, 0.2, 0});
    EXPECT_FALSE(free.turnTo(M_PI / 6));
}

TEST(Pulling, AWheelTurnsByItsRimAndIsMovedByItsMiddle) {
    scene::Scene scene = pendulum();
    scene.joints[0].offset1 = Vector(0, 0, 0);
    EXPECT_TRUE(Pulling(scene, 0, {0.01, 0, 0}).movesAsOne());
    Pulling rim(scene, 0, {0.4, 0, 0});
    EXPECT_FALSE(rim.movesAsOne());
    rim.pullTo({0, 0.4, 0});
    EXPECT_NEAR(rim.turned(), M_PI / 2, 1e-6);
}

TEST(Pulling, WhatHangsOnABodyGoesWithItAndWhatHoldsItFollowsOnlyWhereItMust) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {0, -3, 0};
    join(scene, scene::JointType::slider, "rod", {0, 0, 0});
    join(scene, scene::JointType::hinge, "ball", {0, 3, 0}, "rod");
    Pulling cart(scene, 1, {0, 0, 0});
    cart.pullTo({1, 0.5, 0});
    EXPECT_LT((poseOf(cart, scene, 1).position - Vector(1, 0, 0)).norm(), 1e-6);
    EXPECT_LT((poseOf(cart, scene, 0).position - Vector(1, -3, 0)).norm(), 1e-3);
    Pulling bob(scene, 0, {0, -3, 0});
    const double angle = 0.4;
    bob.pullTo({3 * std::sin(angle), -3 * std::cos(angle), 0});
    EXPECT_LT(
        (poseOf(bob, scene, 0).position - Vector(3 * std::sin(angle), -3 * std::cos(angle), 0))
            .norm(),
        1e-4);
    EXPECT_LT(poseOf(bob, scene, 1).position.norm(), 0.01);
}

TEST(Pulling, WhatNothingHoldsToTheWorldMovesAsOne) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {1, -1, 0};
    join(scene, scene::JointType::hinge, "ball", {0, 0, 0}, "rod");
    const Pulling pulling(scene, 1, {0.9, 0, 0});
    EXPECT_TRUE(pulling.isJoined());
    EXPECT_TRUE(pulling.movesAsOne());
    EXPECT_EQ(pulling.bodies().size(), 2U);
    EXPECT_FALSE(Pulling(ballAndRod(), 0, {0, 0, 0}).isJoined());
}

TEST(Pulling, ARopeOfAGivenLengthHoldsWhereItIsTautOnly) {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].initialPosition = {50, 0, 0};
    scene::Rope rope;
    rope.name = "r";
    rope.points = {{"ball", std::nullopt}, {std::nullopt, Vector(0, 2, 0)}};
    rope.length = 2;
    scene.ropes.push_back(rope);
    Pulling pulling(scene, 0, {0, 0, 0});
    pulling.pullTo({3, 2, 0});
    EXPECT_LT((poseOf(pulling, scene, 0).position - Vector(2, 2, 0)).norm(), 1e-6);
    pulling.pullTo({1, 1.5, 0});
    EXPECT_LT((poseOf(pulling, scene, 0).position - Vector(1, 1.5, 0)).norm(), 1e-9);
}

TEST(Pulling, AHandGivesTheVelocityThatJointsAllow) {
    const scene::Scene scene = pendulum();
    Pulling pulling(scene, 0, {0, 0, 0});
    const auto after = pulling.velocities({{0, {0, 1, 0}, {0, 0, 0}}}, Vector(3, 5, 0));
    ASSERT_EQ(after.size(), 1U);
    EXPECT_LT((after[0].linear - Vector(3, 0, 0)).norm(), 1e-5);
    EXPECT_LT((after[0].angular - Vector(0, 0, 1.5)).norm(), 1e-5);
    const auto slow = pulling.velocities({{0, {2, 1, 0}, {0, 0, 1}}}, std::nullopt);
    EXPECT_LT((slow[0].linear - Vector(2, 0, 0)).norm(), 1e-9);
}

} // namespace
} // namespace physics
