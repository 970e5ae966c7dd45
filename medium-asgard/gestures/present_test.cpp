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

TEST(Present, WhatCountsFromTheStartSaysWhyItCannotBe) {
    const Ground spring = groundOf(thrown + "spring s -body1 b -x 0 -y 8 -z 0 -stiffness 10\n");
    EXPECT_THAT(startingAt(spring, 0.5).reason, HasSubstr("takes its length -rest from the start"));
    EXPECT_THAT(startingAt(groundOf(thrown), 99).reason, HasSubstr("not computed up to this time"));
}

} // namespace
} // namespace gestures
