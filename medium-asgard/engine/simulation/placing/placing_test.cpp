#include "placing/placing.h"
#include "resimulation/resimulation_testing.h"

#include <cmath>
#include <string>

namespace simulation::testing {
namespace {

double heightOf(const physics::Assembly& made, std::size_t body, double otherwise) {
    for (const physics::Assembly::Moved& moved : made.moved)
        if (moved.body == body)
            return moved.pose.position.y();
    return otherwise;
}

using ::testing::ElementsAre;

TEST(Placing, ABoxInTheFloorMovesUpByItsDepthAndDoesNotTurn) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0.3, 0.4, 0}, {1, 1, 1});
    const physics::Assembly made = placed(b.scene);
    EXPECT_EQ(made.reason, "");
    ASSERT_EQ(made.moved.size(), 1u);
    EXPECT_FALSE(made.moved[0].turns);
    EXPECT_LT(distance(made.moved[0].pose.position, {0.3, 0.5, 0}), 1e-14);
}

TEST(Placing, AStackMovesUpAsAWholeWhereEachBoxIsInTheNext) {
    SceneBuilder b(1);
    b.floor();
    for (int i = 0; i < 4; ++i)
        b.box("box" + std::to_string(i), {0, 0.45 + 0.9 * i, 0}, {1, 1, 1});
    const physics::Assembly made = placed(b.scene);
    EXPECT_EQ(made.reason, "");
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(heightOf(made, 1 + i, 0), 0.5 + static_cast<double>(i), 1e-12);
}

TEST(Placing, TwoFreeBallsShareTheWay) {
    SceneBuilder b(1);
    b.ball("left", {-0.08, 0, 0});
    b.ball("right", {0.08, 0, 0});
    const physics::Assembly made = placed(b.scene);
    ASSERT_EQ(made.moved.size(), 2u);
    EXPECT_LT(distance(made.moved[0].pose.position, {-0.1, 0, 0}), 1e-14);
    EXPECT_LT(distance(made.moved[1].pose.position, {0.1, 0, 0}), 1e-14);
}

TEST(Placing, APendulumInAWallTurnsAboutItsHinge) {
    SceneBuilder b(1);
    b.box("wall", {0.6, -1, 0}, {1, 4, 4}).fixed = true; // its face: x = 0.1
    b.ball("bob", {0.05, -1, 0});
    scene::Joint pin;
    pin.name = "pin";
    pin.type = scene::JointType::hinge;
    pin.body1 = "bob";
    pin.offset1 = {-0.05, 1, 0};
    pin.offset2 = {0, 0, 0};
    b.scene.joints.push_back(pin);
    const physics::Assembly made = placed(b.scene);
    EXPECT_EQ(made.reason, "");
    ASSERT_EQ(made.moved.size(), 1u);
    EXPECT_TRUE(made.moved[0].turns);
    EXPECT_NEAR(made.moved[0].pose.position.x(), 0, 1e-12);
    EXPECT_NEAR(made.moved[0].pose.position.norm(), std::hypot(0.05, 1), 1e-12);
}

// Each turns about one corner and would lower another one that it had lifted.
TEST(Placing, TwoHingedBoxesInAFloorCloseAndLieOnIt) {
    const Vector edges(1.2, 0.6, 0.7);
    for (int k = 0; k < 12; ++k) {
        SceneBuilder b(1);
        b.floor();
        b.box("left", {0, 0.25 + 0.02 * k, 0}, edges).initialAttitude =
            geometry::fromRotationVector({0, 0, 0.3 - 0.05 * k});
        b.box("right", {1.2, 0.45 - 0.02 * k, 0.1}, edges).initialAttitude =
            geometry::fromRotationVector({0, 0, 0.04 * k - 0.2});
        scene::Joint pin;
        pin.name = "pin";
        pin.type = scene::JointType::hinge;
        pin.body1 = "left";
        pin.offset1 = {0.5, 0, 0};
        pin.body2 = "right";
        pin.offset2 = {-0.5, 0, 0};
        b.scene.joints.push_back(pin);
        const physics::Assembly made = placed(b.scene);
        EXPECT_EQ(made.reason, "") << k;
        ASSERT_EQ(made.moved.size(), 2U) << k;
        for (const physics::Assembly::Moved& moved : made.moved)
            for (int corner = 0; corner < 8; ++corner) {
                const Vector local(corner & 1 ? 0.6 : -0.6, corner & 2 ? 0.3 : -0.3,
                                   corner & 4 ? 0.35 : -0.35);
                EXPECT_GT(moved.pose.toWorld(local).y(), -1e-9) << k;
            }
        EXPECT_LT(distance(made.moved[0].pose.toWorld({0.5, 0, 0}),
                           made.moved[1].pose.toWorld({-0.5, 0, 0})),
                  1e-9)
            << k;
    }
}

TEST(Placing, ABodyWithoutRoomIsNamed) {
    SceneBuilder b(1);
    b.floor();
    b.box("lid", {0, 1, 0}, {5, 0.2, 5}).fixed = true;
    b.box("box", {0, 0.5, 0}, {1, 1, 1});
    EXPECT_THAT(placed(b.scene).reason, ::testing::HasSubstr("have no room to move apart"));
}

TEST(Placing, ABoxThatOverlapsByLittleBeginsWhereItTouches) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0, 0.499999, 0}, {1, 1, 1}).restitution = 0;
    b.weight("box");
    const Result result = simulate(b.scene);
    EXPECT_TRUE(result.motion->notes().empty());
    EXPECT_NEAR(result.motion->at(1, 1).position.y(), 0.5, 1e-12);
}

TEST(Placing, ADeepOverlapIsToldWithItsDepthAndTheOffer) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0, 0.4, 0}, {1, 1, 1}).restitution = 0;
    b.weight("box");
    const Result result = simulate(b.scene);
    ASSERT_EQ(result.motion->notes().size(), 1u);
    EXPECT_THAT(result.motion->notes()[0], ::testing::HasSubstr("overlap by 0.1 at the start"));
    EXPECT_TRUE(physics::asksToPart(result.motion->notes()[0]));
}

// A stack that is exact in itself, too low by little: no box goes into the next one.
TEST(Placing, ABoxOnABodyThatMovesUpMovesWithIt) {
    SceneBuilder b(1);
    b.floor();
    for (int i = 0; i < 3; ++i) {
        b.box("box" + std::to_string(i), {0, 0.4999 + i, 0}, {1, 1, 1}).restitution = 0;
        b.weight("box" + std::to_string(i));
    }
    const Result result = simulate(b.scene);
    EXPECT_EQ(result.motion->notes().size(), 1u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(result.motion->at(1 + i, 0.5).position.y(), 0.5 + static_cast<double>(i), 1e-9);
}

// Rounding is a part of the ball where the touch is at the origin.
TEST(Placing, ABallTouchesASlopeAtTheOrigin) {
    for (const double tilt : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
        SceneBuilder b(0.1);
        b.box("slope", {0.5 * std::sin(tilt), -0.5 * std::cos(tilt), 0}, {4, 1, 4});
        b.scene.bodies.back().fixed = true;
        b.scene.bodies.back().initialAttitude = geometry::fromRotationVector({0, 0, tilt});
        b.ball("ball", {-0.0999 * std::sin(tilt), 0.0999 * std::cos(tilt), 0});
        const auto told = startSentences(b.scene);
        ASSERT_EQ(told.size(), 1u) << tilt;
        EXPECT_THAT(told[0], ::testing::HasSubstr("begin moved apart")) << tilt;
    }
}

// Rounded upwards, and the restitution forgotten.
TEST(Placing, ABodyThatWouldHopForEverIsTold) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0, 0.50001, 0}, {1, 1, 1}).initialVelocity = {1, 0, 0};
    EXPECT_TRUE(startSentences(b.scene).empty()) << "nothing pulls it";
    b.weight("box");
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told[0], ::testing::HasSubstr("\"box\" and \"floor\" are 1e-05 apart"));
    b.scene.bodies.back().initialVelocity = {0, 1, 0};
    EXPECT_TRUE(startSentences(b.scene).empty()) << "it is thrown up";
    b.scene.bodies.back().initialVelocity = {0, 0, 0};
    b.scene.bodies.back().restitution = 0.9;
    EXPECT_TRUE(startSentences(b.scene).empty()) << "it comes to rest";
}

// The floor holds the lower one, which holds the upper one, though both are pulled alike.
TEST(Placing, ABoxOnAnotherBoxThatStandsWouldHop) {
    SceneBuilder b(1);
    b.box("low", {0, 0.5, 0}, {1, 1, 1});
    b.box("high", {0, 1.50001, 0}, {1, 1, 1});
    b.weight("low");
    b.weight("high");
    EXPECT_TRUE(startSentences(b.scene).empty()) << "both fall";
    b.floor();
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told[0], ::testing::HasSubstr("\"low\" and \"high\" are 1e-05 apart"));
    EXPECT_THAT(told[0], ::testing::HasSubstr("-restitution 0 body \"high\" hops no more"));
    b.box("highest", {0, 2.50002, 0}, {1, 1, 1});
    b.weight("highest");
    EXPECT_THAT(startSentences(b.scene),
                ElementsAre("Bodies \"low\" and \"high\" are 1e-05 apart at the start, and 1 more "
                            "pair no farther (\"high\" and \"highest\"); they bounce without "
                            "loss: they hop for ever; with -restitution 0 they hop no more."));
    b.scene.bodies[1].restitution = 0;
    EXPECT_TRUE(startSentences(b.scene).empty()) << "it comes to rest";
}

// A lift takes its boxes along as a floor that stands still bears them.
TEST(Placing, ABoxOnALiftWouldHop) {
    SceneBuilder b(1);
    b.box("lift", {0, -0.5, 0}, {4, 1, 4});
    scene::Joint rail;
    rail.name = "rail";
    rail.type = scene::JointType::slider;
    rail.body1 = "lift";
    rail.axis = {0, 1, 0};
    rail.coordinates.resize(1);
    rail.coordinates[0].speed = "0.5";
    b.scene.joints.push_back(rail);
    b.box("box", {0, 0.50001, 0}, {1, 1, 1});
    b.weight("box");
    EXPECT_TRUE(startSentences(b.scene).empty()) << "the lift hits it from below";
    b.scene.bodies.back().initialVelocity = {0, 0.5, 0};
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told[0], ::testing::HasSubstr("are 1e-05 apart"));
    b.scene.joints[0].coordinates[0].maxMotor = 1;
    EXPECT_TRUE(startSentences(b.scene).empty()) << "the motor takes its time";
    b.scene.bodies[0].initialVelocity = {0, 0.5, 0};
    EXPECT_EQ(startSentences(b.scene).size(), 1u);
}

// A spring may carry it, and a force lift it.
TEST(Placing, ABodyWithASpringOrAForceIsNotSaidToHop) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0, 0.50001, 0}, {1, 1, 1});
    b.weight("box");
    EXPECT_EQ(startSentences(b.scene).size(), 1u);
    SceneBuilder lifted = b;
    lifted.force("box", "0", "20", "0");
    EXPECT_TRUE(startSentences(lifted.scene).empty());
    scene::Link spring;
    spring.first.body = "box";
    spring.second = scene::PointEnd{{"0", "3", "0"}};
    spring.tightness = 10;
    b.scene.links.push_back(spring);
    EXPECT_TRUE(startSentences(b.scene).empty());
}

// A box slides away under the next one on a smooth slope, as fast, unless a wall stops it.
TEST(Placing, ABoxThatSlidesBesideAnotherOneDoesNotHop) {
    const double tilt = 0.3;
    const geometry::Quaternion turn = geometry::fromRotationVector({0, 0, tilt});
    SceneBuilder b(1);
    const auto put = [&](const std::string& name, const Vector& at, const Vector& edges) {
        scene::Body& made = b.box(name, turn * at, edges);
        made.initialAttitude = turn;
        return &made;
    };
    put("slope", {0, -0.5, 0}, {20, 1, 4})->fixed = true;
    put("low", {0, 0.5, 0}, {1, 1, 1});
    put("high", {1.00001, 0.5, 0}, {1, 1, 1});
    b.weight("low");
    b.weight("high");
    EXPECT_TRUE(startSentences(b.scene).empty());
    put("wall", {-1, 0.5, 0}, {1, 1, 1})->fixed = true;
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_THAT(told[0], ::testing::HasSubstr("\"low\" and \"high\" are 1e-05 apart"));
}

TEST(Placing, ABallBesideAnotherOneDoesNotHop) {
    SceneBuilder b(0.1);
    b.ball("left", {0, 0, 0});
    b.ball("right", {0.20001, 0, 0});
    b.weight("left");
    b.weight("right");
    EXPECT_TRUE(startSentences(b.scene).empty());
}

TEST(Placing, BodiesThatTrajectoriesHoldStay) {
    SceneBuilder b(1);
    b.floor();
    b.ball("ball", {0, 0.0999, 0});
    b.hold("ball", 0, 1, {{0, 0.0999, 0}});
    EXPECT_TRUE(simulate(b.scene).refusal.empty());
    EXPECT_TRUE(placed(b.scene).moved.empty());
}

TEST(Placing, ALargeHeapTakesNoTime) {
    SceneBuilder b(0);
    b.floor(100);
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k)
            b.ball("ball" + std::to_string(20 * i + k), {0.19999 * i, 0.09999 + 0.19999 * k, 0});
    const auto told = startSentences(b.scene);
    EXPECT_FALSE(told.empty());
}

TEST(Placing, ACartWithAPendulumIsMovedUp) {
    SceneBuilder b(1);
    b.floor();
    b.box("cart", {0, 0.0999, 0}, {0.6, 0.2, 0.4});
    b.ball("bob", {0, 0.6, 0});
    scene::Joint pin;
    pin.name = "pin";
    pin.type = scene::JointType::hinge;
    pin.body1 = "bob";
    pin.offset1 = {0, -0.5, 0};
    pin.body2 = "cart";
    b.scene.joints.push_back(pin);
    const physics::Assembly made = placed(b.scene);
    EXPECT_EQ(made.reason, "");
    EXPECT_NEAR(heightOf(made, 1, 0), 0.1, 1e-9);
}

TEST(Placing, OverlapsAreToldWithoutAMotion) {
    SceneBuilder b(1);
    b.floor();
    b.box("low", {0, 0.4, 0}, {1, 1, 1});
    b.box("near", {3, 0.4999, 0}, {1, 1, 1});
    b.box("rounded", {6, 0.4999999, 0}, {1, 1, 1});
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 2u);
    EXPECT_THAT(told[1], ::testing::StartsWith(
                             "Bodies \"low\" and \"floor\" overlap by 0.1 at the start, and pass"));
    EXPECT_THAT(told[0],
                ::testing::StartsWith(
                    "Bodies \"near\" and \"floor\" overlap by 0.0001 at the start, and begin"));
}

// One mistake, and one message; another heap has its own.
TEST(Placing, AHeapIsToldOnceByItsDeepestPair) {
    SceneBuilder b(1);
    b.floor();
    for (int i = 0; i < 4; ++i)
        b.box("box" + std::to_string(i), {0, 0.5 + (i == 3 ? 2.65 : 0.9 * i), 0}, {1, 1, 1});
    b.box("elsewhere", {5, 0.4, 0}, {1, 1, 1});
    const std::string heap = "Bodies \"box2\" and \"box3\" overlap by 0.15 at the start, and 2 "
                             "more pairs no deeper (\"box0\" and \"box1\", \"box1\" and "
                             "\"box2\"); they pass through each other until they are apart; " +
                             physics::partAdvice() + ".";
    const auto told = startSentences(b.scene);
    ASSERT_EQ(told.size(), 2u);
    EXPECT_EQ(told[0], heap);
    EXPECT_THAT(told[1], ::testing::HasSubstr("\"elsewhere\" and \"floor\" overlap by 0.1 at"));
    EXPECT_THAT(simulate(b.scene).motion->notes(), ::testing::UnorderedElementsAreArray(told));
    for (int i = 4; i < 9; ++i)
        b.box("box" + std::to_string(i), {0, 0.15 + 0.9 * i, 0}, {1, 1, 1});
    EXPECT_THAT(startSentences(b.scene)[0], ::testing::HasSubstr("and 7 more pairs no deeper; "));
}

// A body that an edit does not concern keeps all bits, also when two places are mended.
TEST(Placing, AnEditElsewhereChangesNoBit) {
    SceneBuilder b(1);
    b.floor();
    for (const double x : {-3.0, 3.0}) {
        const std::string name = x < 0 ? "left" : "right";
        b.box(name, {x, 0.499999, 0}, {1, 1, 1}).restitution = 0;
        b.weight(name);
    }
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[2].initialVelocity.x() = 0.5;
    const Result edited = updated(kept, b.scene); // compares
    EXPECT_EQ(kept.work().print(), "solved: right; kept: 1; rounds: 1");
    EXPECT_NEAR(edited.motion->at(1, 0.7).position.y(), 0.5, 1e-12);
}

} // namespace
} // namespace simulation::testing
