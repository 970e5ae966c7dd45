#include "gestures/present.h"

#include "script/reader.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using ::testing::HasSubstr;

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

TEST(Present, CoordinatesThatCountFromTheNewStartAreTold) {
    const std::string swing =
        "shape_set s -desc {-sub {-sphere 0.5}}\nbody b s\nbody c s -init_pos "
        "{3 0 0}\njoint pin -type hinge -body1 b -offset1 {0 1 0}\n"
        "joint pin2 -type hinge -body1 c -offset1 {0 1 0}\n";
    EXPECT_EQ(countsAnew(groundOf(swing), 0.5), "");
    EXPECT_EQ(countsAnew(groundOf(swing + "# pin.q is the angle\n"), 0.5), "");
    EXPECT_EQ(countsAnew(groundOf(swing + "plot p -values {{pin2.q} {pin.dq}}\n"), 0.5),
              "pin2.q counts from this moment on: it is 0 at 0.5 s.");
    EXPECT_EQ(countsAnew(groundOf(swing + "foreach j {pin pin2} {plot $j -values $j.q}\n"), 1.25),
              "pin.q, pin2.q count from this moment on: they are 0 at 1.25 s.");
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
