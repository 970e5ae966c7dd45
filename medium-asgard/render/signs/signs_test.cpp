// Coils, trails, and forces of contacts as they are read.
#include "framing/test_scenes.h"
#include "signs/coils.h"
#include "signs/contact_forces.h"
#include "signs/trails.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

const scene::Color red{0.9, 0.1, 0.1}, blue{0.1, 0.2, 0.9}, green{0.1, 0.8, 0.2};

// A box that rests on a floor: its weight, upwards, within the cone of friction.
void expectWeightOnFloor(bool isDeclared) {
    scene::Scene scene;
    scene::Body& floor = addBody(scene, box({4, 0.2, 4}), {0, -0.1, 0}, red);
    floor.fixed = true;
    floor.friction = 0.5;
    scene::Body& block = addBody(scene, box({0.4, 0.4, 0.4}), {0.3, 0.2, 0}, blue);
    block.mass = 2;
    block.friction = 0.5;
    block.restitution = 0;
    for (scene::Body& body : scene.bodies)
        body.restitution = 0;
    scene.forces.push_back({scene.bodies[1].name,
                            false,
                            std::nullopt,
                            scene::GravitationalForce{{0, -10, 0}},
                            {},
                            {}});
    scene.simulator.finish = 1;
    if (isDeclared) { // without a name
        scene::Contact& contact = scene.contacts.emplace_back();
        contact.body1 = scene.bodies[1].name;
        contact.body2 = scene.bodies[0].name;
    }
    const auto motion = simulation::simulate(scene).motion;
    ASSERT_NE(motion, nullptr);
    ContactForces forces;
    const auto seen = forces.at(scene, motion, 0.5);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_LT((seen[0].force - Vector(0, -20, 0)).norm(), 1e-3); // on the floor, the first
    EXPECT_LT((seen[0].normal - Vector(0, -1, 0)).norm(), 1e-6);
    EXPECT_NEAR(seen[0].friction, 0.5, 1e-12);
    EXPECT_NEAR(seen[0].point.y(), 0, 1e-6);
}

TEST(Coil, HasItsTurnsAtAnyLength) {
    for (const double length : {0.1, 1.0, 7.0}) {
        const auto points = coilBetween({0, 0, 0}, {length, 0, 0}, 0.05, 16);
        EXPECT_EQ(points.front(), Vector(0, 0, 0));
        EXPECT_EQ(points.back(), Vector(length, 0, 0));
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_GT(points[i].x(), points[i - 1].x());
            EXPECT_LT(std::hypot(points[i].y(), points[i].z()), 0.05 + 1e-12);
        }
    }
    EXPECT_EQ(coilBetween({1, 0, 0}, {1, 0, 0}, 1, 16).size(), 2U);
}

// See Framed.AMotionIsReadTimeAfterTime.
TEST(Trails, ReadAMotionPieceAfterPiece) {
    scene::Scene scene;
    double last = 0, back = 0;
    std::vector<GivenMotion::Law> laws;
    for (int i = 0; i < 8; ++i) {
        addBody(scene, sphere(1), Vector(4 * i, 0, 0), red);
        laws.push_back([&, i](double t) {
            back = std::max(back, last - t);
            last = t;
            return placed({4.0 * i + t, std::sin(3 * t), 0});
        });
    }
    Drawing drawing;
    drawing.scene = &scene;
    drawing.motion = std::make_shared<GivenMotion>(36, laws);
    const Extent extent = extentOf(scene, drawing.motion.get());
    last = back = 0;
    Trails trails;
    trails.follow(drawing, extent);
    EXPECT_GT(last, 35);
    EXPECT_LT(back, 0.2); // a piece is a tenth of a second
}

TEST(ContactForces, AreReadOfContactsThatTheSceneDoesNotName) {
    expectWeightOnFloor(false);
    expectWeightOnFloor(true);
}

} // namespace
} // namespace render
