// (text, fixed or let loose, text): the bounce of a table.
#include "editing/test_reading.h"
#include "element_edits/fixing.h"

namespace editing {
namespace {

const std::string block = "shape_set block -desc {-sub {-box {1 1 1}}}\n";

std::string whenFixed(const std::string& text, bool fixed) {
    const auto scene = readScene(text);
    const Properties properties(text, scene);
    const std::vector<Element> all{{Kind::body, 0}};
    const OptionHint& option = *hintOf(hintOf(*scene, all.front()), "-fixed");
    const Answer answer = withBounce(properties, *scene, all, fixed,
                                     properties.set(all, option, {std::string(fixed ? "1" : "0")}));
    EXPECT_EQ(answer.reason, "") << text;
    return text::applied(text, answer.edits);
}

TEST(Fixing, AFixedBodyDeadensNothing) {
    EXPECT_EQ(whenFixed(block + "body b block -restitution 0 -friction 0.3\n", true),
              block + "body b block -friction 0.3 -fixed 1\n");
    // A value that somebody has chosen stays.
    EXPECT_EQ(whenFixed(block + "body b block -restitution 0.2\n", true),
              block + "body b block -restitution 0.2 -fixed 1\n");
    EXPECT_EQ(whenFixed("set e 0\n" + block + "body b block -restitution $e -fixed 0\n", true),
              "set e 0\n" + block + "body b block -fixed 1\n");
}

TEST(Fixing, ABodyOfARoomThatIsLetLooseComesToRest) {
    EXPECT_EQ(whenFixed(block + "body b block -fixed 1 -friction 0.3\n", false),
              block + "body b block -fixed 0 -friction 0.3 -restitution 0\n");
    EXPECT_EQ(whenFixed(block + "body b block -fixed 1\n", false), // an ideal one
              block + "body b block -fixed 0\n");
}

TEST(Fixing, WhatALoopMakesKeepsItsBounce) {
    const std::string loop =
        "foreach i {1} {\n  body b$i block -restitution 0 -fixed 0\n}\n"; // once
    const std::string made = whenFixed(block + loop, true);
    EXPECT_NE(made.find("-fixed 1"), std::string::npos) << made;
}

} // namespace
} // namespace editing
