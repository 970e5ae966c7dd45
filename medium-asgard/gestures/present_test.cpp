#include "gestures/joined.h"
#include "gestures/present.h"

#include "run/quantities.h"
#include "scene/joint_types.h"
#include "script/reader.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

script::Reader& theReader() {
    static script::Reader shared;
    return shared;
}

Ground groundOf(const std::string& text) {
    const script::ReadResult read = theReader().read(text);
    EXPECT_TRUE(read.usable) << text;
    auto scene = std::make_shared<const scene::Scene>(read.scene);
    auto motion = simulation::simulate(*scene).motion;
    return {text, scene, motion, [](const std::string&) {},
            [](const std::string&, const std::string&) {}};
}

const std::string thrown = "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
                           "body b ball -init_pos {0 5 0} -init_dpos {1 0 0} -init_drot {0 0 1}\n"
                           "force -body b -gravitational {0 -10 0}\n";

// Whoever starts at a moment goes where the motion went anyway.
TEST(Present, TheMotionGoesOnFromHereAsItWould) {
    for (const std::string& text : {thrown, thrown.substr(thrown.find('\n') + 1)}) {
        const Ground before = groundOf(text);
        const editing::Answer answer = startingAt(before, 0.5);
        ASSERT_TRUE(answer.possible()) << answer.reason;
        const Ground after = groundOf(text::applied(text, answer.edits));
        EXPECT_DOUBLE_EQ(after.motion->start(), 0.5);
        EXPECT_THAT(text::applied(text, answer.edits), HasSubstr("-init_dpos {1 -5 0}"));
        for (const double time : {0.5, 1.0, 1.7}) {
            const auto a = before.motion->at(0, time), b = after.motion->at(0, time);
            EXPECT_LT((a.position - b.position).norm(), 1e-6) << time;
            EXPECT_LT((a.velocity - b.velocity).norm(), 1e-6) << time;
            EXPECT_LT(a.attitude.angularDistance(b.attitude), 1e-6) << time;
        }
    }
}

// Of the first body, at a time after the moment.
void expectSame(const Ground& before, const Ground& after, double time) {
    const auto a = before.motion->at(0, time), b = after.motion->at(0, time);
    EXPECT_LT((a.position - b.position).norm(), 1e-6) << time;
    EXPECT_LT((a.velocity - b.velocity).norm(), 1e-6) << time;
    EXPECT_LT(a.attitude.angularDistance(b.attitude), 1e-5) << time;
}

TEST(Present, ABodyThatIsLedInPartOrForAWhileGoesOnToo) {
    const std::string turned = "simulator -finish 3\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
                               "body b ball -init_dpos {1 0 2} -init_drot {0 0 1}\n"
                               "trajectory up -points {{0 0 0 0} {1 0 1 0} {3 0 2 0}}\n";
    for (const char* led : {"constrain b -pos up\n", "constrain b -pos up -to 1\n"}) {
        const Ground before = groundOf(turned + led);
        for (const double time : {0.5, 2.0}) {
            const editing::Answer answer = startingAt(before, time);
            ASSERT_TRUE(answer.possible()) << answer.reason;
            const Ground after = groundOf(text::applied(before.text, answer.edits));
            expectSame(before, after, time);
            expectSame(before, after, 2.5);
        }
    }
}

TEST(Present, AnElementThatWasReleasedStaysSo) {
    const std::string held = "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.2}}\n"
                             "body b ball -init_pos {1 0 0}\n"
                             "force -body b -gravitational {0 -10 0}\n";
    for (const char* torn :
         {"joint pin -type hinge -body1 b -offset1 {-1 0 0} -offset2 {0 0 0} -axis {0 0 1} "
          "-release {t > 0.4}\n",
          "force -body b -x 3 -release {t > 0.4}\n",
          "spring s -body1 b -x 0 -y 0 -z 0 -stiffness 10 -release {t > 0.4}\n",
          "rope r -points {{b {0 0 0}} {0 0 0}} -release {t > 0.4}\n"}) {
        const Ground before = groundOf(held + torn);
        const editing::Answer answer = startingAt(before, 1);
        ASSERT_TRUE(answer.possible()) << answer.reason;
        const std::string text = text::applied(before.text, answer.edits);
        EXPECT_THAT(text, HasSubstr("-release 1\n"));
        expectSame(before, groundOf(text), 1.7);
        const editing::Answer early = startingAt(before, 0.2); // it holds still
        EXPECT_THAT(text::applied(before.text, early.edits), HasSubstr("t > 0.4"));
    }
}

TEST(Present, ABodyThatWasPutElsewhereStartsThereWithItsVelocityOrTheHands) {
    const Ground before = groundOf(thrown);
    const auto after = [&](const Put& put) {
        const editing::Answer answer = startingAt(before, 0.5, {put});
        EXPECT_TRUE(answer.possible()) << answer.reason;
        return groundOf(text::applied(thrown, answer.edits)).motion->at(0, 0.5);
    };
    const geometry::Vector place(2, 3, 0), hand(-4, 1, 0);
    const auto put = after({0, place, std::nullopt, 0.01});
    EXPECT_LT((put.position - place).norm(), 1e-9);
    EXPECT_LT((put.velocity - before.motion->at(0, 0.5).velocity).norm(), 1e-9);
    const auto cast = after({0, place, hand, 0.01});
    EXPECT_LT((cast.velocity - hand).norm(), 1e-9);
}

double quantityAt(const Ground& ground, const std::string& name, double time) {
    std::vector<std::string> faults;
    return simulation::Quantities(*ground.scene, {}, ground.motion, {name}, faults).at(time)[0];
}

const std::string arm =
    "simulator -finish 3 -accuracy 1e-8\n"
    "shape_set s -desc {-sub {-box {1 0.2 0.2}}}\nbody b s -init_pos {0.5 0 0}\n"
    "force -body b -gravitational {0 -10 0}\n"
    "joint pin -type hinge -body1 b -offset1 {-0.5 0 0}";

// Limits, springs, drives and expressions find the joint where it was, also in a branch of a
// branch.
TEST(Present, TheAngleOfAJointGoesOn) {
    for (const char* counted : {" -limits {-1 0.1}\n", " -limits {-1 0.1} -limit_restitution 0.8\n",
                                " -stiffness 3 -rest -0.4 -damping 0.1\n",
                                " -position {-0.2 * t}\n", "\nforce -body b -y {-4 * pin.q}\n"}) {
        const Ground before = groundOf(arm + counted);
        const editing::Answer first = startingAt(before, 0.8);
        ASSERT_TRUE(first.possible()) << first.reason;
        const Ground branch = groundOf(text::applied(before.text, first.edits));
        EXPECT_THAT(branch.text, HasSubstr(" -from -"));
        const editing::Answer second = startingAt(branch, 1.5);
        ASSERT_TRUE(second.possible()) << second.reason;
        const Ground twig = groundOf(text::applied(branch.text, second.edits));
        for (const double time : {1.5, 2.2, 3.0}) {
            expectSame(before, branch, time);
            expectSame(before, twig, time);
            EXPECT_NEAR(quantityAt(before, "pin.q", time), quantityAt(twig, "pin.q", time), 1e-5);
        }
    }
    const Ground bare = groundOf(arm + "\n"); // nothing asks for it
    EXPECT_THAT(text::applied(bare.text, startingAt(bare, 0.8).edits), Not(HasSubstr("-from")));
    EXPECT_EQ(countsAnew(groundOf(arm + "\nplot p -values {pin.q}\n"), 0.8), "");
}

// A hand puts the bodies where the motion has them later: so far goes each coordinate.
TEST(Present, TheCoordinatesOfAJointGoWithTheHand) {
    for (const char* joint : {"hinge -axis {1 1 0} -from 5", "slider -axis {1 1 0}",
                              "screw -axis {1 0 0} -pitch 0.3", "cylindrical -axis {1 0 0}",
                              "universal -axis {1 0 0}", "universal -axis {1 0 0} -axis2 {0 1 0}",
                              "planar -axis {1 0 0}", "planar -axis {0 0 1} -axis2 {1 2 0}"}) {
        const std::string type = joint;
        const Ground before = groundOf(
            "simulator -finish 2 -accuracy 1e-8 -collisions 0\n"
            "shape_set s -desc {-sub {-box {1 0.3 0.2}}}\n"
            "body a s -init_dpos {0.2 0.4 0} -init_drot {0.3 1 -0.5} -init_rot {0.3 0.2 0}\n"
            "body b s -init_pos {0.6 0.5 0.2} -init_rot {0.3 0.2 0} -init_drot {1.5 0.2 0.4}\n"
            "joint j -body1 b -body2 a -type " +
            type + "\nplot p -values {j.q" +
            (type.starts_with("c") || type.starts_with("u") ? "1 j.q2"
             : type.starts_with("p")                        ? "1 j.q2 j.q3"
                                                            : "") +
            "}\n");
        constexpr double moment = 0.3, later = 0.9;
        std::vector<Put> puts;
        for (const std::size_t body : {0U, 1U})
            puts.push_back({body, before.motion->shapePose(body, later).position, std::nullopt,
                            1e-9, before.motion->shapePose(body, later).attitude});
        const editing::Answer answer = startingAt(before, moment, puts);
        ASSERT_TRUE(answer.possible()) << type << ": " << answer.reason;
        const Ground after = groundOf(text::applied(before.text, answer.edits));
        const auto& coordinates = after.scene->joints[0].coordinates;
        for (std::size_t k = 0; k < coordinates.size(); ++k) {
            const std::string name =
                "j.q" + scene::coordinateSuffix(after.scene->joints[0].type, k);
            const double value = quantityAt(before, name, later);
            EXPECT_GT(std::abs(value - quantityAt(before, name, moment)), 1e-3) << type << name;
            EXPECT_NEAR(coordinates[k].from, value, 1e-6) << type << " " << name;
        }
    }
}

TEST(Present, AHandCannotTakeAJointBeyondItsLimitsNorADrivenOneElsewhere) {
    Put put{0, {0.5, 0, 0}, std::nullopt, 1e-9, geometry::Quaternion::Identity()};
    EXPECT_THAT(
        startingAt(groundOf(arm + " -limits {-2 -0.05} -from -0.1\n"), 0.3, {put}).possible(),
        testing::IsTrue());
    put.attitude = geometry::fromRotationVector({0, 0, 0.4});
    EXPECT_THAT(startingAt(groundOf(arm + " -limits {-2 0.3}\n"), 0.3, {put}).reason,
                HasSubstr("beyond its -limits"));
    EXPECT_THAT(startingAt(groundOf(arm + " -position {-0.2 * t}\n"), 0.3, {put}).reason,
                HasSubstr("follows its -position"));
}

// The arm, in the hand at 0.3 s, is pulled round to the other side and back.
TEST(Present, APulledJointStopsAtItsLimitAndComesBack) {
    const Ground ground = groundOf(arm + " -limits {-2 0.3}\n");
    constexpr double moment = 0.3;
    const scene::Scene then = sceneAt(ground, moment);
    const Vector end =
        then.bodies[0].initialPosition + then.bodies[0].initialAttitude * Vector(0.5, 0, 0);
    const auto joined = Joined::of(then, 0, end);
    ASSERT_TRUE(joined);
    const JointLimits limits(ground, moment);
    const auto put = [](const Joined& one) {
        return Put{0, one.poseOf(0).position, std::nullopt, 0, one.poseOf(0).attitude};
    };
    joined->keep([&](const Joined& now) { return limits.areKept({put(now)}); });
    const auto angle = [&] { return geometry::toRotationVector(joined->poseOf(0).attitude).z(); };
    const auto pullTo = [&](double wanted) {
        joined->pull(Vector(std::cos(wanted), std::sin(wanted), 0) - end);
    };
    pullTo(0.2);
    EXPECT_NEAR(angle(), 0.2, 1e-6);
    for (const double beyond : {0.6, 1.5, 1.2}) {
        pullTo(beyond);
        EXPECT_NEAR(angle(), 0.3, 1e-5) << beyond;
        EXPECT_TRUE(startingAt(ground, moment, {put(*joined)}).possible());
    }
    pullTo(-0.7);
    EXPECT_NEAR(angle(), -0.7, 1e-6);
    joined->keep(nullptr); // a hand that asks for no limits
    pullTo(1.2);
    EXPECT_NEAR(angle(), 1.2, 1e-6);
    EXPECT_FALSE(startingAt(ground, moment, {put(*joined)}).possible());
}

TEST(Present, WhatCountsFromTheNewStartIsTold) {
    const std::string swing =
        "shape_set s -desc {-sub {-sphere 0.5}}\nbody b s\nbody c s -init_pos "
        "{3 0 0}\njoint pin -type ball -body1 b -offset1 {0 1 0}\n"
        "joint pin2 -type ball -body1 c -offset1 {0 1 0}\n";
    EXPECT_EQ(countsAnew(groundOf(swing), 0.5), "");
    EXPECT_EQ(countsAnew(groundOf(swing + "# pin.q is the angle\n"), 0.5), "");
    EXPECT_EQ(countsAnew(groundOf(swing + "plot p -values {{pin2.q} {pin.dq}}\n"), 0.5),
              "pin2.q counts from this moment on: it is 0 at 0.5 s.");
    EXPECT_EQ(countsAnew(groundOf(swing + "foreach j {pin pin2} {plot $j -values $j.q}\n"), 1.25),
              "pin.q, pin2.q count from this moment on: they are 0 at 1.25 s.");
    EXPECT_EQ(countsAnew(groundOf(swing + "plot p -values {b.rz}\n"), 0.5),
              "b.rz counts from this moment on: it is 0 at 0.5 s.");
}

TEST(Present, AMomentIsRoundToAThousandthAndWithinTheMotion) {
    const Ground two = groundOf(thrown);
    EXPECT_DOUBLE_EQ(roundMoment(*two.motion, 0.5617432), 0.562);
    EXPECT_EQ(roundMoment(*two.motion, -1), 0);
    EXPECT_EQ(roundMoment(*two.motion, 9), 2);
}

TEST(Present, WhatCountsFromTheStartSaysWhyItCannotBe) {
    const Ground spring = groundOf(thrown + "spring s -body1 b -x 0 -y 8 -z 0 -stiffness 10\n");
    EXPECT_THAT(startingAt(spring, 0.5).reason, HasSubstr("takes its length -rest from the start"));
    EXPECT_THAT(startingAt(groundOf(thrown), 99).reason, HasSubstr("not computed up to this time"));
    EXPECT_THAT(startingAt(groundOf(thrown), 2).reason, HasSubstr("Nothing of the motion is left"));
}

} // namespace
} // namespace gestures
