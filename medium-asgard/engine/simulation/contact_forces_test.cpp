// The forces of contacts at a time: of all that press on each other, named or not, also where
// motion was solved in parts.
#include "motion/contact_forces.h"
#include "resimulation/resimulation_testing.h"
#include "simulation/testing.h"

#include <cmath>

namespace simulation::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two boxes far from each other on one floor, without bounce.
SceneBuilder twoBoxes() {
    SceneBuilder b(1);
    b.floor(60).friction = 0.5;
    for (const double x : {-20.0, 20.0}) {
        const std::string name = x < 0 ? "left" : "right";
        b.box(name, {x, 0.2, 0}, {0.4, 0.4, 0.4}).mass = 2;
        b.scene.bodies.back().friction = 0.5;
        b.weight(name);
    }
    for (scene::Body& body : b.scene.bodies)
        body.restitution = 0;
    return b;
}

void expectWeights(const Motion& motion) {
    const auto forces = contactForcesAt(motion, 0.5);
    ASSERT_THAT(forces, SizeIs(2));
    for (const ContactForce& one : forces) {
        const Vector place = motion.at(one.on, 0.5).position;
        EXPECT_LT(distance(one.force, {0, 2 * g, 0}), 1e-9);
        EXPECT_LT(distance(one.point, {place.x(), 0, place.z()}), 1e-9);
        EXPECT_LT(distance(one.normal, {0, 1, 0}), 1e-12);
        EXPECT_EQ(one.friction, 0.5);
    }
    EXPECT_NE(forces[0].on, forces[1].on);
}

TEST(ContactForces, AreWeightsOfBoxesThatRest) {
    expectWeights(*simulate(twoBoxes().scene).motion);
}

TEST(ContactForces, AreThoseOfAMotionInParts) {
    SceneBuilder b = twoBoxes();
    Resimulation kept;
    (void)kept.update(shared(b.scene));
    b.scene.bodies[1].initialPosition.z() = 1;
    const Result result = kept.update(shared(b.scene));
    EXPECT_EQ(kept.work().kept, 1u);
    expectWeights(*result.motion);
}

TEST(ContactForces, AreThoseOfADraftToo) {
    SceneBuilder b = twoBoxes();
    b.force("left", "0.1*sin(20*left.x)", "0", "0"); // which friction holds
    int drafts = 0;
    Observer observer;
    observer.progress = [&](const MotionPointer& motion) {
        if (!motion->draft() || motion->computed() < 0.5)
            return;
        ++drafts;
        EXPECT_THAT(contactForcesAt(*motion, 0.5), SizeIs(2));
    };
    (void)simulate(b.scene, {}, observer);
    EXPECT_GT(drafts, 0);
}

// One lies on the other: the force on the lower one is downwards, with all that lies on it.
TEST(ContactForces, OfBodiesThatBothMoveAreOnTheFirst) {
    SceneBuilder b = twoBoxes();
    b.scene.bodies[2].initialPosition = b.scene.bodies[1].initialPosition + Vector(0, 0.4, 0);
    const auto forces = contactForcesAt(*simulate(b.scene).motion, 2); // its end counts
    ASSERT_THAT(forces, SizeIs(2));
    for (const ContactForce& one : forces) {
        EXPECT_EQ(one.on, 1u);
        const bool isBetween = one.point.y() > 0.2;
        EXPECT_LT(distance(one.force, {0, isBetween ? -2 * g : 4 * g, 0}), 1e-9);
        EXPECT_LT(distance(one.normal, {0, isBetween ? -1.0 : 1.0, 0}), 1e-12);
    }
}

TEST(ContactForces, OfABodyThatHasStoppedAreNone) {
    SceneBuilder b = twoBoxes();
    b.force("left", "0.1/(0.5-t)", "0", "0");
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion->stop(1));
    EXPECT_THAT(contactForcesAt(*result.motion, 0.2), SizeIs(2));
    const auto late = contactForcesAt(*result.motion, 0.9);
    ASSERT_THAT(late, SizeIs(1));
    EXPECT_EQ(late[0].on, 2u);
}

TEST(ContactForces, OfABallInAGrooveAreTwo) {
    SceneBuilder b(1);
    for (const double side : {-1.0, 1.0}) {
        scene::Body& wall = b.box(side < 0 ? "left" : "right", Vector(side, -0.5, 0), {4, 1, 4});
        wall.fixed = true;
        const Quaternion tilt(Eigen::AngleAxisd(side * M_PI / 4, Vector::UnitZ()));
        wall.initialAttitude = tilt;
        wall.initialPosition = tilt * Vector(side, -0.5, 0); // both upper sides go through 0
    }
    b.ball("ball", {0, 0.2 * std::sqrt(2), 0}, 0.2).mass = 3;
    b.weight("ball");
    for (scene::Body& body : b.scene.bodies)
        body.restitution = body.friction = 0;
    const auto forces = contactForcesAt(*simulate(b.scene).motion, 0.5);
    ASSERT_THAT(forces, SizeIs(2));
    EXPECT_LT(distance(forces[0].force + forces[1].force, {0, 3 * g, 0}), 1e-9);
    for (const ContactForce& one : forces)
        EXPECT_NEAR(one.force.dot(one.normal), 3 * g / std::sqrt(2), 1e-9);
    EXPECT_NEAR(forces[0].point.y(), 0.2 * std::sqrt(2) - 0.2 / std::sqrt(2), 1e-7);
}

TEST(ContactForces, OfFlyingBodiesAreNone) {
    SceneBuilder b = row(2);
    EXPECT_THAT(contactForcesAt(*simulate(b.scene).motion, 0.5), IsEmpty());
}

// A box that slides and a ball that rolls down a slope have the forces that a named contact reads.
TEST(ContactForces, AreThoseThatNamesRead) {
    for (const bool isBall : {false, true}) {
        SceneBuilder b(1);
        const Quaternion tilt(Eigen::AngleAxisd(0.5, Vector(0.3, 0, -1).normalized()));
        const Vector up = tilt * Vector::UnitY();
        scene::Body& ramp = b.box("ramp", -0.5 * up, {50, 1, 50});
        ramp.fixed = true;
        ramp.initialAttitude = tilt;
        scene::Body& body =
            isBall ? b.ball("body", 0.2 * up, 0.2) : b.box("body", 0.2 * up, {0.6, 0.4, 0.5});
        body.initialAttitude = tilt;
        b.weight("body");
        for (scene::Body& one : b.scene.bodies) {
            one.restitution = 0;
            one.friction = isBall ? 0.6 : 0.2;
        }
        scene::Contact& contact = b.scene.contacts.emplace_back();
        contact.name = "c";
        contact.body1 = "body";
        contact.body2 = "ramp";
        const auto motion = simulate(b.scene).motion;
        std::vector<std::string> faults;
        Quantities named(b.scene, {}, motion, {"c.fx", "c.fy", "c.fz", "c.px", "c.py", "c.pz"},
                         faults);
        ASSERT_THAT(faults, IsEmpty());
        for (const double time : {0.1, 0.5, 0.9}) {
            const auto values = named.at(time);
            const auto forces = contactForcesAt(*motion, time);
            ASSERT_THAT(forces, SizeIs(1));
            EXPECT_GT(forces[0].force.norm(), 5);
            EXPECT_LT(distance(forces[0].force, {values[0], values[1], values[2]}), 1e-9);
            EXPECT_LT(distance(forces[0].point, {values[3], values[4], values[5]}), 1e-9);
            EXPECT_LT(distance(forces[0].normal, up), 1e-9);
        }
    }
}

} // namespace
} // namespace simulation::testing
