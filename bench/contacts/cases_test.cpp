// The cases' exact motion against the values that the contract of contact and joints names.
#include "answers.h"
#include "bricard.h"
#include "cases.h"
#include "rods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace bench::contacts {
namespace {

constexpr double near = 2e-12;

Case named(const std::string& name) {
    for (Case& scene : allCases(true))
        if (scene.name == name)
            return scene;
    ADD_FAILURE() << name;
    return {};
}

// How far the body has moved by the sample.
Place moved(const Case& scene, std::size_t sample, std::size_t body = 0) {
    Place by = scene.right.at(sample).at(body);
    for (std::size_t a = 0; a < 3; ++a)
        by[a] -= scene.bodies[body].at[a];
    return by;
}

TEST(ContactCases, SampleEachTimeOnce) {
    for (const Case& scene : allCases(true)) {
        EXPECT_EQ(scene.right.size(), scene.times.size()) << scene.name;
        for (const auto& places : scene.right)
            EXPECT_EQ(places.size(), scene.bodies.size()) << scene.name;
    }
}

TEST(ContactCases, SlideAndRoll) {
    const Case up = named("slope slides");
    EXPECT_NEAR(std::hypot(moved(up, 9)[0], moved(up, 9)[1]), 1.880323116519, near);
    const Case rolls = named("ball rolls");
    EXPECT_NEAR(moved(rolls, 9)[0], 0.898708107096 + 15.0 / 7 * (1 - 0.349497597204), near);
    const Case down = named("ball slides");
    EXPECT_NEAR(std::hypot(moved(down, 9)[0], moved(down, 9)[1]), 9.458976851558, near);
}

TEST(ContactCases, BlockAndCartEndTogether) {
    const Case scene = named("block on cart");
    EXPECT_NEAR(moved(scene, 9, 1)[0] - moved(scene, 9, 0)[0], 2.038735983690, near);
    EXPECT_NEAR(moved(scene, 9, 1)[0] - moved(scene, 8, 1)[0], 0.2, near); // v = 1
}

TEST(ContactCases, BallsBounce) {
    for (const auto& [name, speed] :
         {std::pair{"bounce sticks", 3.571428571429}, std::pair{"bounce slips", -0.44}}) {
        const Case scene = named(name);
        const Place before = moved(scene, 8), after = moved(scene, 9);
        EXPECT_NEAR((after[0] - before[0]) / 0.05, speed, 1e-11) << name;
        EXPECT_NEAR((after[1] - before[1]) / 0.05, 3.2, 1e-11) << name;
    }
}

TEST(ContactCases, RodsSlip) {
    const auto back = FallingRod{.back = 0.3, .forward = 0.3}.firstSlip();
    EXPECT_NEAR(back.angle, 0.421205985182, near);
    EXPECT_NEAR(back.time, 1.041421546431, near);
    const auto forward = FallingRod{.back = 1, .forward = 1}.firstSlip();
    EXPECT_NEAR(forward.angle, 0.944358250383, near);
    EXPECT_NEAR(forward.time, 1.345746836502, near);
    const auto ladder =
        FallingRod{.angle = std::numbers::pi / 9, .back = std::numeric_limits<double>::infinity()}
            .firstSlip();
    EXPECT_NEAR(std::numbers::pi / 2 - ladder.angle, 0.677005474853, near);
    EXPECT_NEAR(ladder.time, 0.597527806071, near);
    EXPECT_NEAR(ladder.rate, 2.146902956576, near);
}

TEST(ContactCases, RodMeetsItsStop) {
    const std::vector<double> hits = StoppedRod{}.hits(3);
    EXPECT_NEAR(hits[0], 0.483333713593, near);
    EXPECT_NEAR(hits[1], 1.329872271926, near);
    EXPECT_NEAR(hits[2], 2.155358763246, near);
}

TEST(ContactCases, SliderCrankIsWhereItIs) {
    const SliderCrank model;
    const SliderCrank::Pose pose = model.pose(0.5);
    EXPECT_NEAR(pose.at[2][0], 0.161460495166, near);
    EXPECT_NEAR(model.rate * pose.velocity[2][0], -0.658338024011, near);
}

TEST(ContactCases, BricardSwings) {
    EXPECT_NEAR(Bricard::halfSwing(), 2.49585575684436, near);
    for (const double u : {-0.4, 0.5, 1.2})
        EXPECT_LT(Bricard::gap(u), 1e-15) << u;
}

TEST(ContactCases, TorsionPendulumRests) {
    const Case scene = named("torsion pendulum"); // its centre goes round 0.5 m beside the wire
    for (std::size_t i = 18; i < 20; ++i) {       // 13.3 s, 14 s; at rest from 12.566 s on
        const Place at = scene.right[i][0];
        EXPECT_NEAR(std::atan2(at[1], at[0]) + 2.1, 0.1, near);
    }
}

} // namespace
} // namespace bench::contacts
