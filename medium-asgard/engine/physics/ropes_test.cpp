#include "physics/testing.h"

#include "expression/tape.h"

#include <gtest/gtest.h>

#include <numbers>

namespace physics {
namespace {

using testing::ballAndRod;

scene::Rope::Point at(const Vector& place) { return {.body = {}, .place = place}; }
scene::Rope::Point on(const std::string& body, double radius = 0) {
    return {.body = body, .place = Vector::Zero(), .radius = radius};
}

scene::Scene ropeThrough(std::vector<scene::Rope::Point> points) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {0, -3, 0};
    scene.bodies[1].initialPosition = {4, 0, 0};
    scene.ropes.emplace_back().name = "r";
    scene.ropes[0].points = std::move(points);
    return scene;
}

std::string faultOf(const scene::Scene& scene) {
    const EquationsOfMotion motion(scene);
    return motion.faults.empty() ? "" : motion.faults[0];
}

double lengthOf(const scene::Scene& scene) {
    const EquationsOfMotion motion(scene);
    expression::Graph g = motion.set.graph;
    const auto parsed = motion.scope->parse(g, "r.length", scene::Reading::quantities);
    const Node node = std::get<Node>(parsed);
    std::vector<Node> inputs;
    std::vector<double> values;
    for (const expression::Unknown& unknown : motion.set.unknowns) {
        inputs.push_back(unknown.symbol);
        values.push_back(unknown.initial);
    }
    double length = 0;
    expression::Tape::Scratch scratch;
    expression::Tape(g, inputs, std::span(&node, 1))
        .evaluate(values, std::span(&length, 1), scratch);
    return length;
}

TEST(Ropes, MeasureSpansAndArcs) {
    EXPECT_NEAR(lengthOf(ropeThrough({on("ball"), at({0, 0, 0}), on("rod")})), 7, 1e-15);
    // Around the rod's wheel from below and back down: two spans of 3 and half a turn.
    scene::Scene around = ropeThrough({on("ball"), on("rod", 0.5), at({4.5, -3, 0})});
    around.bodies[0].initialPosition = {3.5, -3, 0};
    EXPECT_NEAR(lengthOf(around), 6 + 0.5 * std::numbers::pi, 1e-14);
    // Round the other side it makes three halves of a turn, less what the spans lean.
    around.ropes[0].points[1].radius = -0.5;
    const double lean = 2 * std::asin(0.5 / std::hypot(0.5, 3)), span = std::sqrt(9);
    EXPECT_NEAR(lengthOf(around), 2 * span + 0.5 * (std::numbers::pi + 2 * lean), 1e-14);
}

// The wheel's plane is across its axis; a point a little beside it is as far away as it is in
// space.
TEST(Ropes, ThatLeaveThePlaneOfTheirWheelAreAsLongAsTheirWay) {
    scene::Scene around = ropeThrough({on("ball"), on("rod", 0.5), at({4.5, -3, 0.003})});
    around.bodies[0].initialPosition = {3.5, -3, 0};
    EXPECT_NEAR(lengthOf(around), 3 + std::hypot(3, 0.003) + 0.5 * std::numbers::pi, 1e-14);
}

// A rope that begins at a drum of positive radius leads down on the side of -x.
TEST(Ropes, ThatLeadAskewFromTheWrongSideOfADrumAreNoted) {
    scene::Scene winch = ropeThrough({on("rod", 0.5), on("ball")});
    const auto notesOf = [](const scene::Scene& scene) {
        const EquationsOfMotion motion(scene);
        EXPECT_TRUE(motion.faults.empty());
        return motion.notes;
    };
    winch.bodies[0].initialPosition = {4.5, -3, 0};
    EXPECT_EQ(notesOf(winch),
              std::vector<std::string>{
                  "rope \"r\": leads askew from the one side of the wheel at point 1, and straight "
                  "from the other with a radius of -0.5"});
    winch.ropes[0].points[0].radius = -0.5;
    EXPECT_EQ(notesOf(winch), std::vector<std::string>());
    winch.bodies[0].initialPosition = {4.2, -3, 0}; // on neither side
    EXPECT_EQ(notesOf(winch), std::vector<std::string>());
}

TEST(Ropes, OfACircleCountTheirArcs) {
    scene::Scene belt = ropeThrough({on("ball", 0.5), on("rod", 0.5)});
    belt.bodies[0].initialPosition = {0, 0, 0};
    belt.ropes[0].isClosed = true;
    EXPECT_NEAR(lengthOf(belt), 8 + std::numbers::pi, 1e-14);
    // Crossed: the second wheel turns the other way.
    belt.ropes[0].points[1].radius = -0.5;
    const double lean = std::asin(1.0 / 4);
    EXPECT_NEAR(lengthOf(belt), 2 * std::sqrt(15) + std::numbers::pi + 2 * lean, 1e-14);
}

TEST(Ropes, ThatAreTooShortSayByHowMuch) {
    scene::Scene scene = ropeThrough({at({0, 0, 0}), on("ball")});
    scene.ropes[0].length = 2.75;
    EXPECT_EQ(faultOf(scene),
              "rope \"r\": its -length is 0.25 under what it measures at the start");
    scene.ropes[0].length = 3;
    EXPECT_EQ(faultOf(scene), "");
}

TEST(Ropes, LieInThePlanesOfTheirWheels) {
    EXPECT_EQ(faultOf(ropeThrough({at({0, 0, 0.5}), on("rod", 0.5)})),
              "rope \"r\": point 1 lies 0.5 off the plane of the wheel at point 2, which is "
              "across its axis");
    EXPECT_EQ(faultOf(ropeThrough({at({3.9, 0, 0}), on("rod", 0.5)})),
              "rope \"r\": point 1 lies 0.1 from the centre of the wheel at point 2, and a "
              "rope cannot leave it");
    scene::Scene scene = ropeThrough({on("ball", 0.1), on("rod", 0.5)});
    scene.ropes[0].points[1].axis = {0.6, 0, 0.8};
    scene.ropes[0].points[0].axis = {0, 0, 1};
    scene.bodies[0].initialPosition = {4, 3, 0};
    EXPECT_EQ(faultOf(scene),
              "rope \"r\": the axes of the wheels at points 1 and 2 are not parallel");
}

} // namespace
} // namespace physics
