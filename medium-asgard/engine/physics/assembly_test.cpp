#include "physics/assembly.h"

#include "physics/testing.h"

#include <gtest/gtest.h>

#include <numbers>

namespace physics {
namespace {

using testing::ballAndRod;

scene::Joint joint(const std::string& name, scene::JointType type, const std::string& body,
                   const Vector& offset, const Vector& place) {
    scene::Joint made;
    made.name = name;
    made.type = type;
    made.body1 = body;
    made.offset1 = offset;
    made.offset2 = place;
    return made;
}

TEST(Assembly, MovesABodyAsFarAsItsJointIsOpen) {
    scene::Scene scene = ballAndRod();
    scene.joints.push_back(joint("pin", scene::JointType::ball, "ball", {0, 0, 0}, {0.3, 0.4, 0}));
    const Assembly made = assembled(scene);
    EXPECT_EQ(made.reason, "");
    ASSERT_EQ(made.moved.size(), 1u);
    EXPECT_EQ(made.moved[0].body, 0u);
    EXPECT_NEAR(made.moved[0].by, 0.5, 1e-12);
    EXPECT_FALSE(made.moved[0].turns);
    EXPECT_LT((made.moved[0].pose.position - Vector(0.3, 0.4, 0)).norm(), 1e-12);
}

TEST(Assembly, TurnsWhatTwoPointsHold) {
    scene::Scene scene = ballAndRod();
    scene.joints.push_back(
        joint("one", scene::JointType::ball, "rod", {-1, 0, 0}, {-0.8, -0.6, 0}));
    scene.joints.push_back(joint("two", scene::JointType::ball, "rod", {1, 0, 0}, {0.8, 0.6, 0}));
    const Assembly made = assembled(scene);
    EXPECT_EQ(made.reason, "");
    ASSERT_EQ(made.moved.size(), 1u);
    EXPECT_TRUE(made.moved[0].turns);
    EXPECT_LT(made.moved[0].pose.position.norm(), 1e-12);
    EXPECT_LT((made.moved[0].pose.attitude * Vector(1, 0, 0) - Vector(0.8, 0.6, 0)).norm(), 1e-12);
}

TEST(Assembly, EndsBetweenTwoStepsWhenItIsCancelled) {
    scene::Scene scene = ballAndRod();
    scene.joints.push_back(
        joint("one", scene::JointType::ball, "rod", {-1, 0, 0}, {-0.8, -0.6, 0}));
    scene.joints.push_back(joint("two", scene::JointType::ball, "rod", {1, 0, 0}, {0.8, 0.6, 0}));
    int asked = 0;
    EXPECT_FALSE(assembled(scene, [&] { return ++asked < 0; }).cancelled);
    EXPECT_GT(asked, 4); // it takes several steps, and would go on
    asked = 0;
    const Assembly made = assembled(scene, [&] { return ++asked == 3; });
    EXPECT_TRUE(made.cancelled);
    EXPECT_EQ(asked, 3);
    EXPECT_TRUE(made.moved.empty());
    EXPECT_EQ(made.reason, "");
}

// Both ends of the gap give way alike: a ball as far as a rod that moves without turning.
TEST(Assembly, MovesBothBodiesOfAJoint) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {3, 0, 0};
    scene.joints.push_back(joint("pin", scene::JointType::ball, "ball", {0, 0, 0}, {1, 0, 0}));
    scene.joints[0].body2 = "rod";
    const Assembly made = assembled(scene);
    ASSERT_EQ(made.moved.size(), 2u);
    EXPECT_NEAR(made.moved[0].by, 1, 1e-9);
    EXPECT_NEAR(made.moved[1].by, 1, 1e-9);
}

// Two rods and an elbow, one of which must reach farther: the angles of the hinges follow.
TEST(Assembly, HingesTurnWhileALinkageCloses) {
    scene::Scene scene = ballAndRod();
    scene::Body second = scene.bodies[1];
    scene.bodies[1].initialPosition = {1, 0, 0};
    second.name = "other";
    second.initialPosition = {2, 1, 0};
    second.initialAttitude = geometry::fromRotationVector(Vector(0, 0, std::numbers::pi / 2));
    scene.bodies.push_back(second);
    scene.joints.push_back(joint("p", scene::JointType::hinge, "rod", {-1, 0, 0}, {0, 0, 0}));
    scene.joints.push_back(joint("q", scene::JointType::hinge, "rod", {1, 0, 0}, {-1, 0, 0}));
    scene.joints[1].body2 = "other";
    scene.joints.push_back(joint("r", scene::JointType::hinge, "other", {1, 0, 0}, {3, 0, 0}));
    const Assembly made = assembled(scene);
    EXPECT_EQ(made.reason, "");
    ASSERT_EQ(made.moved.size(), 2u);
    const auto end = [&](std::size_t i, double x) {
        return Vector(made.moved[i].pose.position + made.moved[i].pose.attitude * Vector(x, 0, 0));
    };
    EXPECT_LT(end(0, -1).norm(), 1e-12);
    EXPECT_LT((end(0, 1) - end(1, -1)).norm(), 1e-12);
    EXPECT_LT((end(1, 1) - Vector(3, 0, 0)).norm(), 1e-12);
}

TEST(Assembly, SaysWhatIsLeftWhereNothingCloses) {
    scene::Scene scene = ballAndRod();
    scene.joints.push_back(joint("one", scene::JointType::ball, "rod", {-1, 0, 0}, {-2, 0, 0}));
    scene.joints.push_back(joint("two", scene::JointType::ball, "rod", {1, 0, 0}, {2, 0, 0}));
    EXPECT_EQ(assembled(scene).reason, "the joints do not close by moving the bodies that are free "
                                       "to move; a gap of 1 is left");
}

} // namespace
} // namespace physics
