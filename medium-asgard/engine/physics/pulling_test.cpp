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

// A chain from the origin along -y: rods of length 2, each hinged at its upper end.
scene::Scene chain(std::size_t count) {
    scene::Scene scene = ballAndRod();
    scene.bodies.clear();
    for (std::size_t i = 0; i < count; ++i) {
        scene.bodies.push_back(testing::body("b" + std::to_string(i), "ball1", 1));
        scene.bodies[i].initialPosition = {0, -1 - 2 * static_cast<double>(i), 0};
        join(scene, scene::JointType::hinge, scene.bodies[i].name, {0, 1, 0},
             i == 0 ? std::nullopt : std::optional(scene.bodies[i - 1].name));
    }
    return scene;
}

double fastest(const std::vector<Pulling::Velocity>& all) {
    double most = 0;
    for (const Pulling::Velocity& one : all)
        most = std::max({most, one.linear.norm(), 0.5 * one.angular.norm()});
    return most;
}

TEST(Pulling, WhatNothingLetsGoMovesAsOneAndHasNoVelocity) {
    scene::Scene scene = pendulum();
    scene.joints[0].type = scene::JointType::fixed;
    scene.joints[0].coordinates.clear();
    scene::Scene beam = pendulum();
    join(beam, scene::JointType::hinge, "ball", {1, 2, 0});
    for (const scene::Scene& stuck : {scene, beam}) {
        Pulling pulling(stuck, 0, {0, 0, 0});
        EXPECT_TRUE(pulling.isStuck());
        EXPECT_TRUE(pulling.movesAsOne());
        EXPECT_FALSE(pulling.isLoose());
        pulling.pullTo({1, 1, 0});
        EXPECT_TRUE(pulling.moved().empty());
        EXPECT_LT(fastest(pulling.velocities({{0, {1, 0, 0}, {0, 0, 1}}}, Vector(1, 2, 3))), 1e-9);
    }
    EXPECT_FALSE(Pulling(pendulum(), 0, {0, 0, 0}).isStuck());
}

TEST(Pulling, AChainThatIsDraggedBeyondItsReachIsThrownNoFasterThanThreeHands) {
    const scene::Scene scene = chain(2);
    for (const Vector& hand : {Vector(3, -3.5, 0), Vector(2.5, -3.3, 0), Vector(0.5, -4.2, 0)}) {
        Pulling pulling(scene, 1, {0, -3, 0});
        pulling.pullTo(hand);
        const Vector thrown = 1.4 * hand.normalized();
        const auto after =
            pulling.velocities({{0, {0, 0, 0}, {0, 0, 0}}, {1, {0, 0, 0}, {0, 0, 0}}}, thrown);
        EXPECT_LT(fastest(after), 3 * 1.4) << hand.transpose();
    }
    Pulling bent(scene, 1, {0, -3, 0});
    bent.pullTo({2, -1, 0});
    const auto after =
        bent.velocities({{0, {0, 0, 0}, {0, 0, 0}}, {1, {0, 0, 0}, {0, 0, 0}}}, Vector(1, 0.2, 0));
    EXPECT_GT(after[1].linear.norm(), 0.4); // where it can it follows
}

TEST(Pulling, AWheelIsNotSpunByAHandBesideItsAxle) {
    scene::Scene scene = pendulum();
    scene.joints[0].offset1 = Vector(0, 0, 0);
    Pulling beside(scene, 0, {0.01, 0, 0});
    EXPECT_LT(fastest(beside.velocities({{0, {0, 0, 0}, {0, 0, 0}}}, Vector(0, 1.4, 0))), 1.4);
    Pulling rim(scene, 0, {0.5, 0, 0});
    const auto after = rim.velocities({{0, {0, 0, 0}, {0, 0, 0}}}, Vector(0, 1.4, 0));
    EXPECT_NEAR(after[0].angular.z(), 2.8, 1e-6);
}

TEST(Pulling, ARopeThatHoldsNothingMovesNoOtherBody) {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].initialPosition = {3, 0, 0};
    scene::Rope rope;
    rope.name = "r";
    rope.points = {{"ball", std::nullopt}, {std::nullopt, Vector(0, 2, 0)}, {"rod", std::nullopt}};
    scene.ropes.push_back(rope);
    EXPECT_FALSE(Pulling(scene, 0, {0, 0, 0}).isJoined()); // it measures what it measures then
    for (const bool isTied : {false, true}) {              // to the world
        scene.ropes[0].length = 8;                         // slack by 2.4
        if (!isTied)
            scene.ropes[0].points.erase(scene.ropes[0].points.begin() + 1);
        else
            scene.ropes[0].points = rope.points;
        Pulling pulling(scene, 0, {0, 0.2, 0});
        EXPECT_FALSE(pulling.movesAsOne());
        pulling.pullTo({-1, 0.2, 0});
        ASSERT_EQ(pulling.moved().size(), 1U) << isTied;
        EXPECT_LT((poseOf(pulling, scene, 0).position - Vector(-1, 0, 0)).norm(), 1e-9);
        EXPECT_LT(pulling.turned(), 1e-9);
        pulling.pullTo({-20, 0.2, 0}); // it becomes taut
        EXPECT_GT(pulling.moved().size(), 1U);
    }
}

TEST(Pulling, ARopeThatIsTooShortByRoundingIsNoRod) {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].initialPosition = {50, 0, 0};
    scene::Rope rope;
    rope.name = "r";
    rope.points = {{"ball", std::nullopt}, {std::nullopt, Vector(0, 2, 0)}};
    rope.length = 2 - 1e-9;
    scene.ropes.push_back(rope);
    Pulling pulling(scene, 0, {0, 0, 0});
    pulling.pullTo({1, 1.5, 0});
    EXPECT_LT((poseOf(pulling, scene, 0).position - Vector(1, 1.5, 0)).norm(), 1e-9);
    // It holds a throw that would make it longer, and no other.
    Pulling thrown(scene, 0, {0, 0, 0});
    const std::vector<Pulling::Velocity> rest{{0, {0, 0, 0}, {0, 0, 0}}};
    EXPECT_LT((thrown.velocities(rest, Vector(1, -2, 0))[0].linear - Vector(1, 0, 0)).norm(), 0.01);
    EXPECT_LT((thrown.velocities(rest, Vector(1, 2, 0))[0].linear - Vector(1, 2, 0)).norm(), 1e-6);
}

// The rod goes along x at speed 1, and the bob hangs on it.
TEST(Pulling, VelocitiesKeepThoseOfWhatLeadsABody) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {0, -2, 0};
    scene::Trajectory path;
    path.name = "path";
    path.curves = {{0, 4, {Vector(0, 0, 0), Vector(4, 0, 0)}}};
    scene.trajectories = {path};
    scene::Constraint led;
    led.body = "rod";
    led.trajectory = "path";
    scene.constraints = {led};
    join(scene, scene::JointType::hinge, "ball", {0, 2, 0}, "rod");
    const std::vector<Pulling::Velocity> along{{0, {1, 0, 0}, {0, 0, 0}}};
    Pulling pulling(scene, 0, {0, -2, 0});
    ASSERT_TRUE(pulling.isJoined());
    EXPECT_LT((pulling.velocities(along, std::nullopt)[0].linear - Vector(1, 0, 0)).norm(), 1e-9);
    pulling.pullTo({5, 0, 0});
    const auto aside = pulling.velocities(along, std::nullopt);
    EXPECT_LT((aside[0].linear - Vector(1, 0, 0)).norm(), 1e-9) << aside[0].linear.transpose();
    EXPECT_LT(aside[0].angular.norm(), 1e-9);
    const auto thrown = pulling.velocities(along, Vector(3, 1, 0));
    EXPECT_LT((thrown[0].linear - Vector(1, 1, 0)).norm(), 1e-6) << thrown[0].linear.transpose();
}

TEST(Pulling, AHandDoesNotChangeASpeedThatADriveKeeps) {
    scene::Scene scene = pendulum();
    scene.joints[0].coordinates[0].speed = "2";
    Pulling pulling(scene, 0, {0, 0, 0});
    const auto after = pulling.velocities({{0, {0, 0, 0}, {0, 0, 0}}}, Vector(1, 0, 0));
    EXPECT_LT((after[0].angular - Vector(0, 0, 2)).norm(), 1e-9) << after[0].angular.transpose();
    EXPECT_LT((after[0].linear - Vector(4, 0, 0)).norm(), 1e-9);
}

scene::Scene cartAndBob() {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {0, -3, 0};
    join(scene, scene::JointType::slider, "rod", {0, 0, 0});
    join(scene, scene::JointType::hinge, "ball", {0, 3, 0}, "rod");
    return scene;
}

TEST(Pulling, ABobSwingsUnderItsCartAsLongAsItPointsToTheHand) {
    const scene::Scene scene = cartAndBob();
    Pulling bob(scene, 0, {0, -3, 0});
    bob.pullTo({1, -3, 0});
    EXPECT_LT(poseOf(bob, scene, 1).position.norm(), 1e-9);
    EXPECT_NEAR(bob.turned(), std::atan(1.0 / 3), 1e-3);
    ASSERT_TRUE(bob.turnTo(20 * M_PI / 180));
    EXPECT_LT(poseOf(bob, scene, 1).position.norm(), 1e-9);
    bob.pullTo({20, -2, 0}); // far away the cart follows
    EXPECT_LT((poseOf(bob, scene, 0).position - Vector(20, -2, 0)).norm(), 1e-3);
    bob.pullTo({1, -3, 0}); // and comes back
    EXPECT_LT(poseOf(bob, scene, 1).position.norm(), 1e-9);
    // The way to the hand grows without a leap.
    Vector last = Vector::Zero();
    for (double x = 0; x < 12; x += 0.1) {
        bob.pullTo({x, -3, 0});
        const Vector place = poseOf(bob, scene, 1).position;
        EXPECT_LT((place - last).norm(), 0.5) << x;
        last = place;
    }
    EXPECT_GT(last.x(), 5);
    Pulling thrown(scene, 0, {0, -3, 0});
    thrown.pullTo({1, -3, 0});
    const auto after =
        thrown.velocities({{0, {0, 0, 0}, {0, 0, 0}}, {1, {0, 0, 0}, {0, 0, 0}}}, Vector(1, 0, 0));
    EXPECT_LT(after[1].linear.norm(), 1e-9); // the cart stays
    EXPECT_GT(after[0].linear.x(), 0.8);
}

TEST(Pulling, ARodThatTwoOthersHoldIsNotDrawnToWholeAngles) {
    scene::Scene scene = chain(3); // a crank, a rod, and a slider at the end
    scene.joints.back().offset1 = Vector(0, 2, 0);
    scene.bodies[2].initialPosition = {0, -6, 0};
    scene.joints.back().body2 = "b1";
    scene::Joint& rail = join(scene, scene::JointType::slider, "b2", {0, 0, 0});
    rail.axis = Vector::UnitY();
    Pulling crank(scene, 0, {0, -1, 0});
    crank.pullTo({0.5, -0.9, 0});
    Pulling rod(scene, 1, {0, -3, 0});
    rod.pullTo({0.5, -2.9, 0});
    EXPECT_GT(rod.turned(), 0.01);
    EXPECT_FALSE(rod.turnTo(0.1));
}

TEST(Pulling, MoreThanItsMostBodiesAreToldApart) {
    EXPECT_EQ(Pulling(chain(Pulling::most + 1), 3, {0, -7, 0}).state(), Pulling::State::tooMany);
    Pulling most(chain(Pulling::most), 3, {0, -7, 0});
    EXPECT_EQ(most.state(), Pulling::State::joined);
    EXPECT_EQ(Pulling(ballAndRod(), 0, {0, 0, 0}).state(), Pulling::State::free);
}

TEST(Pulling, OneMoveOfTheHandIsOneShareOfWorkHoweverLongTheChain) {
    for (const std::size_t count : {std::size_t{10}, Pulling::most}) {
        const scene::Scene scene = chain(count);
        const std::size_t body = count / 2;
        const Vector from = scene.bodies[body].initialPosition;
        Pulling pulling(scene, body, from);
        std::size_t most = 0;
        Vector hand = from;
        for (int k = 0; k < 45; ++k) {
            hand += Vector(0.12, 0.16, 0);
            const std::size_t before = pulling.places();
            pulling.pullTo(hand);
            most = std::max(most, pulling.places() - before);
        }
        EXPECT_LT(most * count, 6000U) << count;
        EXPECT_LT((poseOf(pulling, scene, body).position - hand).norm(), 1e-3) << count;
        for (std::size_t i = 1; i < count; ++i) // none of it is torn
            EXPECT_LT((poseOf(pulling, scene, i).toWorld({0, 1, 0}) -
                       poseOf(pulling, scene, i - 1).toWorld({0, -1, 0}))
                          .norm(),
                      1e-9);
    }
}

TEST(Pulling, ABodyTurnsAboutItsHingeAndAboutNoOtherAxis) {
    scene::Scene scene = pendulum(); // its hinge at two units above, along z
    Pulling pulling(scene, 0, {0, 0, 0});
    for (const double angle : {0.5, 4.0, -2.0}) {
        ASSERT_TRUE(pulling.turnAbout(Vector::UnitZ(), angle));
        const geometry::Pose pose = poseOf(pulling, scene, 0);
        const Vector way(std::sin(angle), -std::cos(angle), 0);
        EXPECT_LT((pose.position - (Vector(0, 2, 0) + 2 * way)).norm(), 1e-11) << angle;
    }
    const geometry::Pose before = poseOf(pulling, scene, 0);
    EXPECT_FALSE(pulling.turnAbout(Vector::UnitX(), 0.1));
    EXPECT_EQ(poseOf(pulling, scene, 0).position, before.position);
    scene.joints[0].type = scene::JointType::ball;
    scene.joints[0].coordinates.clear();
    EXPECT_TRUE(Pulling(scene, 0, {0, 0, 0}).turnAbout(Vector::UnitX(), 0.1));
}

TEST(Pulling, ATurnMovesAsLittleAsItMust) {
    const scene::Scene scene = chain(3);
    Pulling middle(scene, 1, {0, -3, 0});
    ASSERT_TRUE(middle.turnAbout(Vector::UnitZ(), 0.5));
    EXPECT_EQ(poseOf(middle, scene, 0).position, scene.bodies[0].initialPosition);
    EXPECT_GT((poseOf(middle, scene, 2).position - scene.bodies[2].initialPosition).norm(), 0.5);
    scene::Scene loose = chain(2); // nothing holds them to the world
    loose.joints.erase(loose.joints.begin());
    Pulling upper(loose, 0, {0, -1, 0});
    ASSERT_TRUE(upper.turnAbout(Vector::UnitZ(), 0.5));
    EXPECT_EQ(poseOf(upper, loose, 1).position, loose.bodies[1].initialPosition);
    ASSERT_TRUE(upper.turnAbout(Vector::UnitX(), 0.5)); // both
    EXPECT_LT((poseOf(upper, loose, 0).position - Vector(0, -1, 0)).norm(), 1e-9);
}

TEST(Pulling, AFixedSupportKeepsItsAttitude) {
    scene::Scene scene = pendulum();
    scene.bodies[1].fixed = true;
    scene.bodies[1].initialPosition = {0, -2, 0};
    join(scene, scene::JointType::hinge, "ball", {0, -2, 0}, "rod");
    Pulling support(scene, 1, {0.8, -2, 0.3});
    ASSERT_TRUE(support.isJoined());
    EXPECT_FALSE(support.turns());
    support.pullTo({2, -1, 0.3});
    EXPECT_LT(support.turned(), 1e-12);
    EXPECT_GT((poseOf(support, scene, 1).position - Vector(0, -2, 0)).norm(), 0.5);
}

} // namespace
} // namespace physics
