#include "scene/contact_pairs.h"

#include <cmath>

#include <gtest/gtest.h>

namespace scene {
namespace {

Scene threeBodies() {
    Scene scene;
    for (const char* name : {"a", "b", "c"})
        scene.bodies.emplace_back().name = name;
    scene.bodies[0].friction = 0.1;
    scene.bodies[0].rollingFriction = 0.01;
    scene.bodies[1].friction = 0.4;
    scene.bodies[1].staticFriction = 0.9;
    scene.bodies[1].restitution = 0.5;
    scene.bodies[2].friction = 0.1;
    return scene;
}

TEST(ContactPairs, FollowFromBothBodies) {
    const Scene scene = threeBodies();
    const ContactPairs pairs(scene);
    const PairLaw law = pairs.lawOf(0, 1);
    EXPECT_DOUBLE_EQ(law.sliding, 0.2);
    EXPECT_DOUBLE_EQ(law.sticking, 0.3);
    EXPECT_EQ(law.rolling, 0.01);
    EXPECT_EQ(law.restitution, 0.5);
    EXPECT_EQ(pairs.lawOf(0, 2).sliding, 0.1); // two equal values, bit for bit
    EXPECT_FALSE(pairs.collides(0, 1).has_value());
}

TEST(ContactPairs, AreOverriddenByAContactOfThePairInEitherOrder) {
    Scene scene = threeBodies();
    Contact& contact = scene.contacts.emplace_back();
    contact.body1 = "b";
    contact.body2 = "a";
    contact.friction = 0.7;
    contact.restitution = 0;
    contact.collides = true;
    const ContactPairs pairs(scene);
    for (const PairLaw& law : {pairs.lawOf(0, 1), pairs.lawOf(1, 0)}) {
        EXPECT_EQ(law.sliding, 0.7);
        EXPECT_EQ(law.sticking, 0.7); // of the pair: both
        EXPECT_EQ(law.rolling, 0.01); // of the bodies
        EXPECT_EQ(law.restitution, 0);
    }
    EXPECT_EQ(pairs.collides(1, 0), true);
    EXPECT_EQ(pairs.lawOf(0, 2).restitution, 1); // another pair
}

TEST(ContactPairs, OfABodyThatIsNotThereCountForNothing) {
    Scene scene = threeBodies();
    scene.contacts.push_back({.name = "",
                              .body1 = "a",
                              .body2 = "elsewhere",
                              .friction = 1,
                              .staticFriction = {},
                              .rollingFriction = {},
                              .restitution = {},
                              .collides = {},
                              .source = {}});
    EXPECT_TRUE(ContactPairs(scene).all().empty());
}

} // namespace
} // namespace scene
