// (scene, names of the bodies that fall through the grid)
#include "gestures/unsupported.h"

#include "script/reader.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> fallingIn(const std::string& text) {
    static script::Reader reader;
    const script::ReadResult read = reader.read("shape_set box -desc {-sub {-box {1 1 1}}}\n"
                                                "shape_set plane -desc {-sub {-plane}}\n" +
                                                text);
    EXPECT_TRUE(read.usable) << text;
    std::vector<std::string> names;
    for (const std::size_t body : unsupported(read.scene))
        names.push_back(read.scene.bodies[body].name);
    return names;
}

const std::string onGrid = "body a box -init_pos {0 0.5 0}\n";
const std::string weight = "force -body a -gravitational {0 -9.81 0}\n";

TEST(Unsupported, WhatStandsOnTheGridFallsOnceItHasAWeight) {
    EXPECT_THAT(fallingIn(onGrid), IsEmpty());
    EXPECT_THAT(fallingIn(onGrid + weight), ElementsAre("a"));
    EXPECT_THAT(fallingIn("body a box -init_pos {0 0 0.5}\nforce -body a "
                          "-gravitational {0 0 -9.81}\n"),
                ElementsAre("a"));
    // Above the grid it is thrown, or falls as its author wants.
    EXPECT_THAT(fallingIn("body a box -init_pos {0 3 0}\n" + weight), IsEmpty());
}

TEST(Unsupported, AFloorATableOrAJointHoldsIt) {
    EXPECT_THAT(fallingIn(onGrid + weight + "body f plane -fixed 1\n"), IsEmpty());
    EXPECT_THAT(fallingIn(onGrid + weight + "body desk box -init_pos {0.2 -2 0} -fixed 1\n"),
                IsEmpty());
    EXPECT_THAT(fallingIn(onGrid + weight + "body desk box -init_pos {5 -2 0} -fixed 1\n"),
                ElementsAre("a"));
    EXPECT_THAT(fallingIn(onGrid + weight + "joint j -type hinge -body1 a\n"), IsEmpty());
    EXPECT_THAT(fallingIn(onGrid + weight + "body b box -init_pos {9 0.5 0} -fixed 1\n"),
                ElementsAre("a"));
}

} // namespace
} // namespace gestures
