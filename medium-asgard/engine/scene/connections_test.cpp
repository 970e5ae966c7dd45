#include "scene/connections.h"

#include "scene/difference.h"
#include "scene/part_of.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

namespace scene {
namespace {

Joint jointOf(const std::string& name, JointType type, const std::string& first,
              const std::optional<std::string>& second) {
    Joint joint;
    joint.name = name;
    joint.type = type;
    joint.body1 = first;
    joint.body2 = second;
    joint.coordinates.resize(1);
    return joint;
}

// Bodies a to f; hinges "ab" (a on b), "c" (c on the world), "f" (f, fixed, on the world).
Scene hingedScene() {
    Scene scene;
    scene.shapeSets.resize(1);
    scene.shapeSets[0].name = "s";
    for (const char* name : {"a", "b", "c", "d", "e", "f"}) {
        scene.bodies.emplace_back();
        scene.bodies.back().name = name;
        scene.bodies.back().shape = "s";
    }
    scene.bodies.back().fixed = true;
    scene.joints = {jointOf("ab", JointType::hinge, "a", "b"),
                    jointOf("c", JointType::hinge, "c", std::nullopt),
                    jointOf("f", JointType::hinge, "f", std::nullopt)};
    return scene;
}

void pushBy(Scene& scene, const std::string& body, const Expression& text) {
    scene.forces.emplace_back();
    scene.forces.back().body = body;
    scene.forces.back().kind = ComponentForce{{text, "0", "0"}};
}

void gearBetween(Scene& scene, const std::string& first, const std::string& second) {
    scene.gears.emplace_back();
    scene.gears.back().name = "g";
    scene.gears.back().terms = {{first, 0, 1}, {second, 0, -2}};
}

std::vector<bool> changedBy(const Scene& before, const Scene& after) {
    const Version a(std::make_shared<Scene>(before)), b(std::make_shared<Scene>(after));
    return differenceBetween(a, b).changed;
}

using Bodies = std::vector<bool>;

TEST(Connections, OfJointsAndGearsGroupBodies) {
    Scene scene = hingedScene();
    using Groups = std::vector<std::size_t>;
    EXPECT_EQ(Connections(scene).group, (Groups{0, 0, 2, 3, 4, 5}));
    EXPECT_FALSE(Connections(scene).isBroken);
    gearBetween(scene, "ab", "c");
    EXPECT_EQ(Connections(scene).group, (Groups{0, 0, 0, 3, 4, 5}));
    pushBy(scene, "d", "2*ab.q");
    EXPECT_EQ(Connections(scene).group, (Groups{0, 0, 0, 0, 4, 5}));
    scene.joints[1].coordinates[0].speed = "e.x";
    EXPECT_EQ(Connections(scene).group, (Groups{0, 0, 0, 0, 0, 5}));
}

TEST(Connections, OfAJointWithoutItsBodyAreBroken) {
    Scene scene = hingedScene();
    scene.joints[0].body2 = "nobody";
    EXPECT_TRUE(Connections(scene).isBroken);
}

TEST(Difference, SeesEveryOptionOfAJoint) {
    const Scene scene = hingedScene();
    const auto change = [&](auto&& how) {
        Scene changed = scene;
        how(changed.joints[0]);
        return changedBy(scene, changed);
    };
    const Bodies ends{true, true, false, false, false, false};
    EXPECT_EQ(change([](Joint&) {}), Bodies(6, false));
    EXPECT_EQ(change([](Joint& j) { j.type = JointType::ball; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.offset1 = Vector(0, 0, 0); }), ends);
    EXPECT_EQ(change([](Joint& j) { j.offset2 = Vector(0, 0, 0); }), ends);
    EXPECT_EQ(change([](Joint& j) { j.axis = Vector(0, 1, 0); }), ends);
    EXPECT_EQ(change([](Joint& j) { j.axis2 = Vector(0, 1, 0); }), ends);
    EXPECT_EQ(change([](Joint& j) { j.pitch = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.release = "t > 1"; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].upper = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].lower = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].limitRestitution = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].motor = "1"; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].speed = "1"; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].position = "1"; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].maxMotor = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].stiffness = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].rest = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].damping = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.coordinates[0].friction = 1; }), ends);
    EXPECT_EQ(change([](Joint& j) { j.body2 = std::nullopt; }), ends);
}

TEST(Difference, SeesGearsAndWhoReadsAJoint) {
    Scene scene = hingedScene(), geared = scene;
    gearBetween(geared, "ab", "c");
    EXPECT_EQ(changedBy(scene, geared), (Bodies{true, true, true, false, false, false}));
    Scene other = geared;
    other.gears[0].terms[1].ratio = 3;
    EXPECT_EQ(changedBy(geared, other), (Bodies{true, true, true, false, false, false}));
    pushBy(scene, "d", "f.q");
    other = scene;
    other.joints[2].axis = Vector(1, 0, 0);
    EXPECT_EQ(changedBy(scene, other), (Bodies{false, false, false, true, false, true}));
}

TEST(PartOf, HasTheJointsAndGearsOfItsBodies) {
    Scene scene = hingedScene();
    gearBetween(scene, "ab", "c");
    const Version version(std::make_shared<Scene>(scene));
    const Scene part = partOf(version, {0, 1, 2});
    ASSERT_EQ(part.joints.size(), 2u);
    EXPECT_EQ(part.joints[1].name, "c");
    EXPECT_EQ(part.gears.size(), 1u);
    EXPECT_TRUE(partOf(version, {3}).joints.empty());
}

TEST(PartOf, HasTheJointOfAFixedWheelOfAGear) {
    Scene scene = hingedScene();
    gearBetween(scene, "c", "f"); // the last body is fixed
    const Version version(std::make_shared<Scene>(scene));
    const Scene part = partOf(version, {2, 5});
    ASSERT_EQ(part.joints.size(), 2u);
    EXPECT_EQ(part.joints[1].name, "f");
    Scene other = scene;
    other.joints[2].axis = Vector(1, 0, 0);
    EXPECT_TRUE(changedBy(scene, other)[2]);
}

TEST(JoinedBodies, AreTheEndsOfLinksAndJointsAndWhatFixedJointsHold) {
    Scene scene = hingedScene();
    scene.joints = {jointOf("1", JointType::fixed, "a", "b"),
                    jointOf("2", JointType::fixed, "b", "c"),
                    jointOf("3", JointType::hinge, "c", "d")};
    scene.links.emplace_back();
    scene.links.back().first.body = "e";
    scene.links.back().second = BodyEnd{"f", std::nullopt};
    const auto joined = joinedBodies(scene);
    const auto areJoined = [&](std::size_t i, std::size_t k) {
        return std::ranges::count(joined[i], k) > 0 && std::ranges::count(joined[k], i) > 0;
    };
    EXPECT_TRUE(areJoined(0, 1) && areJoined(1, 2) && areJoined(0, 2) && areJoined(2, 3));
    EXPECT_TRUE(areJoined(4, 5));
    EXPECT_FALSE(areJoined(1, 3) || areJoined(0, 3) || areJoined(3, 4));
}

TEST(JoinedBodies, AreApartOnceTheirJointIsReleased) {
    Scene scene = hingedScene();
    scene.joints = {jointOf("1", JointType::fixed, "a", "b"),
                    jointOf("2", JointType::fixed, "b", "c"),
                    jointOf("3", JointType::hinge, "a", "b")};
    EXPECT_EQ(joinedBodies(scene, {.joints = {1}, .links = {}})[2], std::vector<std::size_t>());
    const auto first = joinedBodies(scene, {.joints = {0}, .links = {}})[0];
    EXPECT_EQ(first, std::vector<std::size_t>{1}); // by the hinge, and not to c
}

TEST(JoinedBodies, AreTheBodiesOfAGear) {
    Scene scene = hingedScene();
    gearBetween(scene, "ab", "c");
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[0], 2u), 1);
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[2], 1u), 0); // it carries the first
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[2], 5u), 0);
    EXPECT_TRUE(joinedBodies(scene, {.joints = {}, .links = {}, .gears = {0}})[2].empty());
    scene.bodies[0].fixed = true; // then b turns on a
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[2], 1u), 1);
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[2], 0u), 0);
}

TEST(JoinedBodies, AreTwoOfAGearWhereOneOfThemTurns) {
    Scene scene = hingedScene();
    gearBetween(scene, "ab", "c");
    scene.joints[0].type = JointType::slider;
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[0], 2u), 1); // a rack
    scene.joints[1].type = JointType::slider;
    EXPECT_EQ(std::ranges::count(joinedBodies(scene)[0], 2u), 0); // jaws
}

} // namespace
} // namespace scene
