#include "gestures/hand.h"
#include "gestures/snapping.h"
#include "gestures/wireframe.h"

#include "script/reader.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using ::testing::HasSubstr;

scene::Part boxPart() {
    scene::Part part;
    part.shape = scene::BoxShape{};
    return part;
}

// Two boxes, seen along z: 200 pixels for a unit, so that round numbers are
// tenths.
class SnappingTest : public ::testing::Test {
protected:
    SnappingTest() {
        scene.shapeSets.push_back({"box", {boxPart()}, {}, {}});
        for (const double place : {-1.0, 1.0}) {
            scene::Body& body = scene.bodies.emplace_back();
            body.name = place < 0 ? "left" : "right";
            body.shape = "box";
            body.initialPosition.x() = place;
        }
        sight.camera.scale = 0.5;
        drawing.scene = &scene;
        drawing.camera = sight.camera;
    }
    [[nodiscard]] Snapped at(const Vector& wanted, std::optional<std::size_t> but = std::nullopt,
                             std::optional<Vector> before = std::nullopt) const {
        render::Handle held;
        held.element = but.value_or(0);
        held.place = scene.bodies[held.element].initialPosition;
        return Snapping(drawing, sight, 1, but ? &held : nullptr).at(wanted, before);
    }
    // Handles that are moved themselves.
    [[nodiscard]] std::string drawnTo(const Vector& wanted, const render::Handle& held) const {
        return Snapping(drawing, sight, 1, &held).at(wanted).to;
    }

    scene::Scene scene;
    Sight sight{{}, {1200, 800}};
    render::Drawing drawing;
};

TEST_F(SnappingTest, ThingsThatLieAsDeepDrawBeforeThoseInFrontOfThem) {
    const Snapped middle = at({1.02, 0.01, 0});
    EXPECT_EQ(middle.place, Vector(1, 0, 0)); // not the face in front of it
    EXPECT_EQ(middle.to, "the origin of right");
    EXPECT_TRUE(middle.isExact);
    const Snapped edge = at({0.52, 0.49, 0.1}); // it goes away from the viewer
    EXPECT_LT((edge.place - Vector(0.5, 0.5, 0.1)).norm(), 1e-12);
    EXPECT_THAT(edge.to, HasSubstr("edge of right"));
    const Snapped corner = at({-0.49, 0.51, 0.5});
    EXPECT_EQ(corner.place, Vector(-0.5, 0.5, 0.5));
    EXPECT_EQ(corner.to, "a corner of left");
    EXPECT_EQ(at({-1.02, 0.49, 0.5}).to, "the middle of an edge of left");
    EXPECT_EQ(at({-1.25, 0.49, 0.5}).place, Vector(-1.25, 0.5, 0.5)); // along the edge
}

TEST_F(SnappingTest, RoundNumbersAndTheOldOnesDrawEachCoordinate) {
    EXPECT_DOUBLE_EQ(Snapping(drawing, sight, 1).step({0, 0, 0}), 0.1);
    EXPECT_DOUBLE_EQ(Snapping(drawing, sight, 2).step({0, 0, 0}),
                     0.2);                         // pixels are half as large
    const Snapped round = at({0.11, 2.04, 0.123}); // a new place
    EXPECT_LT((round.place - Vector(0.1, 2.04, 0.1)).norm(), 1e-12);
    EXPECT_FALSE(round.isExact);
    EXPECT_EQ(round.to, "");
    // One that is moved: also between, in few digits where one looks along an axis.
    const Snapped between = at({0.11, 2.0537, 0.123}, std::nullopt, Vector(5, 7, 0.123));
    EXPECT_NEAR(between.place.x(), 0.1, 1e-12);
    EXPECT_NEAR(std::remainder(between.place.y(), 0.01), 0, 1e-12);
    EXPECT_NEAR(between.place.y(), 2.05, 0.015);
    const Snapped moved = at({0.11, 2.05, 0.123}, std::nullopt, Vector(0, 2.04, 0.123));
    EXPECT_EQ(moved.place.y(), 2.04);  // straight from where it was
    EXPECT_EQ(moved.place.z(), 0.123); // the hand does not move it
}

TEST_F(SnappingTest, ABodyIsNotDrawnToItself) {
    EXPECT_EQ(at({1.02, 0.013, 0}, 1).to, "");
    EXPECT_EQ(at({-1.02, 0.013, 0}, 1).to, "the origin of left");
}

TEST_F(SnappingTest, NothingThatMovesWithTheHandDrawsIt) {
    scene::Joint& pin = scene.joints.emplace_back();
    pin.name = "pin";
    pin.body1 = "left";
    pin.offset1 = Vector(0, 0.3, 0.5); // in its face
    scene::Trajectory& path = scene.trajectories.emplace_back();
    path.name = "path";
    path.points = {{0, Vector(-1, 2, 0)}, {1, Vector(2, 2, 0)}};
    const Vector nearPin(-1.01, 0.31, 0.5);
    EXPECT_EQ(at(nearPin).to, "a joint");
    EXPECT_EQ(at(nearPin, 1).to, "a joint");
    EXPECT_EQ(at(nearPin, 0).to, ""); // it rides on the body
    render::Handle joint, point;
    joint.kind = render::HandleKind::jointPoint;
    joint.base = joint.place = Vector(-1, 0.3, 0.5);
    EXPECT_EQ(drawnTo(nearPin, joint), "");
    point.kind = render::HandleKind::trajectoryPoint;
    point.base = point.place = path.points[0].second;
    EXPECT_EQ(drawnTo({-1.01, 2.013, 0}, point), "");
    EXPECT_EQ(drawnTo({2.01, 2.013, 0}, point), "a point of path"); // which may close it
    scene::Constraint& led = scene.constraints.emplace_back();
    led.body = "left";
    led.trajectory = "path";
    EXPECT_EQ(drawnTo({-1.01, 0.013, 0}, point), ""); // the body that it leads
}

// 40 N are no place: a force's arrow is drawn to nothing.
TEST_F(SnappingTest, ThePointsOfAForceAreNoPlaces) {
    scene::Trajectory& push = scene.trajectories.emplace_back();
    push.name = "push";
    push.points = {{0, Vector(1, 0, 0)}};
    scene::Force& force = scene.forces.emplace_back();
    force.body = "left";
    force.kind = scene::TrajectoryForce{"push"};
    render::Display display;
    display.trajectories = true;
    const auto all = render::Handles(scene, nullptr).at(0, display).handles;
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(all[0].isValue());
    EXPECT_EQ(at(all[0].place + Vector(0.01, 0.013, 0)).to, "");
}

TEST_F(SnappingTest, RoundStepsAreOneTwoAndFive) {
    EXPECT_DOUBLE_EQ(roundStep(0.1), 0.1);
    EXPECT_DOUBLE_EQ(roundStep(0.11), 0.2);
    EXPECT_DOUBLE_EQ(roundStep(3), 5);
    EXPECT_DOUBLE_EQ(roundStep(6e-7), 1e-6);
    EXPECT_EQ(roundStep(0), 0);
}

TEST_F(SnappingTest, ADragIsDrawnUnlessThatIsHeldOff) {
    const std::string text = "shape_set box -desc {-sub {-box {1 1 1}}}\n"
                             "body left box -init_pos {-1 0 0}\n"
                             "body right box -init_pos {1 0 0}\n";
    static script::Reader ownReader;
    std::string shown;
    Ground ground{text, std::make_shared<const scene::Scene>(ownReader.read(text).scene), nullptr,
                  [&](const std::string& now) { shown = now; },
                  [](const std::string&, const std::string&) {}};
    render::Handle handle;
    handle.element = 1;
    handle.base = handle.place = {1, 0, 0};
    Hand hand;
    const Eigen::Vector2d from = sight.pixels({1, 0, 0});
    hand.take(ground, sight, {Grasp::What::drag, handle}, Hand::Button::left, from, 1);
    hand.move(sight.pixels({-0.49, 0.515, 0}));
    EXPECT_EQ(hand.drag()->place(), Vector(-0.5, 0.5, 0));
    EXPECT_THAT(hand.words(), HasSubstr(", at the middle of an edge of left; Ctrl takes it off"));
    EXPECT_THAT(hand.words(), HasSubstr("; moved 1.58"));
    hand.move(sight.pixels({-0.49, 0.52, 0}), true);
    EXPECT_NEAR(hand.drag()->place().x(), -0.49, 1e-9);
    hand.cancel();
}

TEST_F(SnappingTest, AShapeIsOutlinedWhereItsPartsAre) {
    scene::Part ball;
    ball.shape = scene::SphereShape{0.5};
    ball.position = {0, 2, 0};
    for (const auto& line : wireframeOf({ball}))
        for (const Vector& point : line)
            EXPECT_NEAR((point - Vector(0, 2, 0)).norm(), 0.5, 1e-12);
    EXPECT_EQ(wireframeOf({boxPart()}).size(), 12U);
}

} // namespace
} // namespace gestures
