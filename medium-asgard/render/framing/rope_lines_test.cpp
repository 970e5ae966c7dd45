#include "framing/rope_lines.h"

#include <gtest/gtest.h>

#include <numbers>

namespace render {
namespace {

scene::Scene twoBalls() {
    scene::Scene scene;
    scene.shapeSets.resize(1);
    scene.shapeSets[0].name = "ball";
    scene.shapeSets[0].parts.resize(1);
    scene.bodies.resize(2);
    scene.bodies[0].name = "a";
    scene.bodies[1].name = "b";
    for (scene::Body& body : scene.bodies)
        body.shape = "ball";
    scene.ropes.resize(1);
    return scene;
}

scene::Rope::Point at(const Vector& place) {
    scene::Rope::Point point;
    point.place = place;
    return point;
}
scene::Rope::Point on(const std::string& body, double radius = 0) {
    scene::Rope::Point point;
    point.body = body;
    point.radius = radius;
    return point;
}

double lengthOf(const std::vector<Vector>& corners) {
    double length = 0;
    for (std::size_t i = 1; i < corners.size(); ++i)
        length += (corners[i] - corners[i - 1]).norm();
    return length;
}

std::vector<Vector> drawn(const scene::Scene& scene) {
    const auto lines = ropeLinesOf(scene, nullptr, 0, Vector::UnitY());
    return lines.empty() ? std::vector<Vector>{} : lines[0].corners;
}

TEST(RopeLines, GoStraightFromPointToPoint) {
    scene::Scene scene = twoBalls();
    scene.bodies[0].initialPosition = {-1, -2, 0};
    scene.ropes[0].points = {on("a"), at({-1, 0, 0}), at({1, 0, 0})};
    const std::vector<Vector> corners = drawn(scene);
    EXPECT_NEAR(lengthOf(corners), 4, 1e-12);
    EXPECT_EQ(corners.front(), Vector(-1, -2, 0));
    EXPECT_EQ(corners.back(), Vector(1, 0, 0));
    EXPECT_EQ(ropeAnchorsOf(scene).size(), 2u);
}

TEST(RopeLines, BendAroundWheels) {
    scene::Scene scene = twoBalls();
    scene.bodies[0].initialPosition = {-1, -2, 0};
    scene.ropes[0].points = {on("a"), on("b", 1), at({1, -2, 0})};
    const std::vector<Vector> corners = drawn(scene);
    EXPECT_NEAR(lengthOf(corners), 4 + std::numbers::pi, 5e-3);
    double highest = -2;
    for (const Vector& corner : corners)
        highest = std::max(highest, corner.y());
    EXPECT_NEAR(highest, 1, 1e-2); // over the top
}

TEST(RopeLines, SagWhereTheyAreSlack) {
    scene::Scene scene = twoBalls();
    scene.bodies[0].initialPosition = {-1, 0, 0};
    scene.bodies[1].initialPosition = {1, 0, 0};
    scene.ropes[0].points = {on("a"), on("b")};
    EXPECT_EQ(drawn(scene).size(), 2u);
    scene.ropes[0].length = 2.1;
    const std::vector<Vector> corners = drawn(scene);
    EXPECT_NEAR(lengthOf(corners), 2.1, 0.01);
    for (const Vector& corner : corners)
        EXPECT_LE(corner.y(), 0);
}

} // namespace
} // namespace render
