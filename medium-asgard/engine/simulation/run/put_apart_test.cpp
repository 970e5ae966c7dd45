// Bodies that overlap by less than their text's digits say.
#include "run/put_apart.h"

#include "simulation/testing.h"

#include "scene/shape_of.h"

#include <cmath>

namespace simulation::testing {
namespace {

// Places after it, by body.
std::vector<Vector> placesOf(scene::Scene scene) {
    scene::ShapeReader reader;
    std::vector<geometry::Shape> shapes;
    for (const scene::Body& body : scene.bodies)
        shapes.push_back(
            std::get<geometry::Shape>(reader.of(*scene::findShapeSet(scene, body.shape))));
    putApart(scene, shapes);
    std::vector<Vector> places;
    for (const scene::Body& body : scene.bodies)
        places.push_back(body.initialPosition);
    return places;
}

TEST(PutApart, WhatIsALittleInTheFloorStandsOnIt) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0.25, 0.49998, 0}, {1, 1, 1});
    const Vector place = placesOf(b.scene)[1];
    EXPECT_NEAR(place.y(), 0.5, 1e-9);
    EXPECT_EQ(place.x(), 0.25);
}

TEST(PutApart, WhatIsDeepInTheFloorIsMeant) {
    SceneBuilder b(1);
    b.floor();
    b.box("box", {0, 0.49, 0}, {1, 1, 1});
    EXPECT_EQ(placesOf(b.scene)[1].y(), 0.49);
}

TEST(PutApart, AStackStandsOnItself) {
    SceneBuilder b(1);
    b.floor();
    for (int k = 0; k < 4; ++k)
        b.box("b" + std::to_string(k), {0, 0.5 + 0.99999 * k, 0}, {1, 1, 1});
    const auto places = placesOf(b.scene);
    for (std::size_t k = 2; k < places.size(); ++k)
        EXPECT_NEAR((places[k] - places[k - 1]).y(), 1, 1e-8);
}

TEST(PutApart, WhatJointsHoldTogetherMovesTogether) {
    SceneBuilder b(1);
    b.floor();
    b.box("foot", {0, 0.49999, 0}, {1, 1, 1});
    b.ball("head", {0, 3, 0});
    scene::Joint neck;
    neck.body1 = "head";
    neck.body2 = "foot";
    b.scene.joints.push_back(neck);
    EXPECT_NEAR(placesOf(b.scene)[2].y(), 3.00001, 1e-9);
    neck.body2.reset(); // to the world
    b.scene.joints.push_back(neck);
    EXPECT_EQ(placesOf(b.scene)[1].y(), 0.49999);
}

// Two ends of a can that lies on its side, turned by a quarter with four digits behind the point.
TEST(PutApart, ACanLiesOnAHalfSpace) {
    SceneBuilder b(1);
    b.box("floor", {0, 0, 0}, {1, 1, 1}).fixed = true;
    b.box("can", {0, 0.05, 0}, {1, 1, 1}).initialAttitude =
        geometry::fromRotationVector({1.5708, 0, 0});
    b.scene.shapeSets[0].parts[0].shape = scene::PlaneShape{};
    b.scene.shapeSets[1].parts[0].shape = scene::CylinderShape{0.05, 0.2};
    EXPECT_NEAR(placesOf(b.scene)[1].y(), 0.05 + 0.1 * (1.5708 - std::acos(0.0)), 1e-9);
}

} // namespace
} // namespace simulation::testing
