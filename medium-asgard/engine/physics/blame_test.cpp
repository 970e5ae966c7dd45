// Which force ends a motion is told by its values.
#include "physics/blame.h"

#include "physics/testing.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace physics {
namespace {

using testing::ballAndRod;

Instant instant(const std::vector<double>& state, double time) {
    return {.value = [&state](std::size_t unknown) { return state.at(unknown); }, .time = time};
}

std::vector<std::size_t> allBodies(const scene::Scene& scene) {
    std::vector<std::size_t> all(scene.bodies.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<std::string> notFinite(const scene::Scene& scene, const EquationsOfMotion& motion,
                                   const std::vector<double>& state, double time) {
    std::vector<std::string> found;
    for (const Blame& blame :
         Suspects(scene, motion).notFinite(instant(state, time), allBodies(scene)))
        found.push_back(inWords(scene, motion, blame) + optionOf(blame));
    return found;
}

using Words = std::vector<std::string>;

TEST(Blame, AForceThatIsNotFiniteIsNamed) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "1", "1/ball.x", "0"),
                    testing::force("rod", "1", "0", "0")};
    const EquationsOfMotion motion(scene);
    std::vector<double> state(motion.set.unknowns.size(), 0.5);
    EXPECT_EQ(notFinite(scene, motion, state, 0), Words());
    state[0] = 0;
    EXPECT_EQ(
        notFinite(scene, motion, state, 0),
        Words{"the force on body \"ball\" is not finite: its y, \"1/ball.x\", is infinite-y"});
}

// A couple makes no force, and a force in the body's axes another than is written.
TEST(Blame, WhatIsNotFiniteIsNamedAsItIsWritten) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("rod", "0", "0", "log(-t)"),
                    testing::force("ball", "0", "sqrt(rod.x-1)", "0")};
    scene.forces[0].couple = true;
    std::get<scene::ComponentForce>(scene.forces[1].kind).frame = scene::Frame::body;
    const EquationsOfMotion motion(scene);
    const std::vector<double> state(motion.set.unknowns.size(), 0.5);
    EXPECT_EQ(notFinite(scene, motion, state, 1),
              (Words{"the force on body \"rod\" is not finite: its z, \"log(-t)\", is not a "
                     "number-z",
                     "the force on body \"ball\" is not finite: its y, \"sqrt(rod.x-1)\", is not a "
                     "number-y"}));
}

TEST(Blame, ARopeThatComesOverTheSideOfItsWheelIsNamed) {
    scene::Scene scene = ballAndRod();
    scene.bodies[0].initialPosition = {0, -3, 0};
    scene.bodies[1].initialPosition = {0.5, 0, 0};
    scene.ropes.emplace_back().name = "r";
    scene.ropes[0].points = {{.body = "rod", .place = Vector::Zero(), .radius = 0.5},
                             {.body = "ball", .place = Vector::Zero()}};
    const EquationsOfMotion motion(scene);
    std::vector<double> state;
    for (const expression::Unknown& unknown : motion.set.unknowns)
        state.push_back(unknown.initial);
    EXPECT_EQ(notFinite(scene, motion, state, 0), Words());
    const std::size_t ball = motion.bodies[0].firstUnknown;
    const Vector over{0.6, 0, 1}, within{0.7, 0, 0};
    std::copy(over.begin(), over.end(), state.begin() + static_cast<std::ptrdiff_t>(ball));
    const std::string side =
        "rope \"r\" at the wheel of body \"rod\" leads 84.3 degrees out of its "
        "plane and over its side, which is not modelled";
    EXPECT_EQ(notFinite(scene, motion, state, 0), (Words{side, side}));
    std::copy(within.begin(), within.end(), state.begin() + static_cast<std::ptrdiff_t>(ball));
    const std::string near = "rope \"r\" at the wheel of body \"rod\" comes as near as 0.2 to its "
                             "centre, from where a rope cannot leave the wheel";
    EXPECT_EQ(notFinite(scene, motion, state, 0), (Words{near, near}));
}

TEST(Blame, AtAPoleTheForceThatGrowsIsNamed) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "1e9", "0", "0"),
                    testing::force("ball", "0", "0", "1/(2-t)^2")};
    const EquationsOfMotion motion(scene);
    const std::vector<double> state(motion.set.unknowns.size(), 0.5);
    const Suspects suspects(scene, motion);
    const auto growing =
        suspects.growing(instant(state, 0), instant(state, 2 - 1e-10), allBodies(scene));
    ASSERT_TRUE(growing);
    EXPECT_EQ(inWords(scene, motion, *growing),
              "the force on body \"ball\" grows without bound: its z, \"1/(2-t)^2\", is 1e+20");
    EXPECT_FALSE(suspects.growing(instant(state, 0), instant(state, 1), allBodies(scene)));
}

// Of a thousand bodies that stop, each costs what its own forces read.
TEST(Blame, NothingElseIsReadThanWhatTheForcesRead) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "log(ball.x)", "0", "0"),
                    testing::force("rod", "rod.y", "0", "0")};
    const EquationsOfMotion motion(scene);
    std::set<std::string> read;
    const Instant now{.value =
                          [&](std::size_t unknown) {
                              read.insert(motion.set.unknowns[unknown].name);
                              return -1.0;
                          },
                      .time = 0};
    const std::size_t ball = 0;
    EXPECT_EQ(Suspects(scene, motion).notFinite(now, {&ball, 1}).size(), 1u);
    EXPECT_EQ(read, std::set<std::string>{"ball.x"});
}

TEST(Blame, LongExpressionsAreShown) {
    scene::Scene scene = ballAndRod();
    std::string sum = "1/t";
    for (int i = 0; i < 100; ++i)
        sum += " + " + std::to_string(i);
    scene.forces = {testing::force("ball", sum, "0", "0")};
    const EquationsOfMotion motion(scene);
    const std::vector<double> state(motion.set.unknowns.size(), 0.5);
    const Words found = notFinite(scene, motion, state, 0);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find("\"1/t + 0 + 1 + 2"), std::string::npos) << found[0];
    EXPECT_NE(found[0].find(" ... "), std::string::npos) << found[0];
    EXPECT_NE(found[0].find(" + 98 + 99\","), std::string::npos) << found[0];
    EXPECT_LT(found[0].size(), 170u);
}

} // namespace
} // namespace physics
