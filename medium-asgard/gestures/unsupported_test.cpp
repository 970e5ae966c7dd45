// (scene, names of the bodies that fall through the grid; whether nothing moves any, or has a
// weight)
#include "gestures/unsupported.h"

#include "script/reader.h"
#include "simulation/simulation.h"

#include <gmock/gmock.h>

namespace gestures {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

scene::Scene readIn(const std::string& text) {
    static script::Reader reader;
    script::ReadResult read = reader.read("shape_set box -desc {-sub {-box {1 1 1}}}\n"
                                          "shape_set plane -desc {-sub {-plane}}\n" +
                                          text);
    EXPECT_TRUE(read.usable) << text;
    return std::move(read.scene);
}

std::vector<std::string> fallingIn(const std::string& text) {
    const scene::Scene scene = readIn(text);
    std::vector<std::string> names;
    for (const std::size_t body : unsupported(scene, nullptr))
        names.push_back(scene.bodies[body].name);
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

// In 5 s, where it may fall.
TEST(Unsupported, ABallThatRollsOffATableFallsPastIt) {
    const std::string table = "simulator -finish 5\nbody desk box -init_pos {0 0.5 0} -fixed 1\n"
                              "body a box -init_pos {0 1.5 0} -init_dpos {2 0 0}\n";
    const auto fallsIn = [](const std::string& text) {
        const scene::Scene scene = readIn(text);
        return unsupported(scene, simulation::simulate(scene).motion.get());
    };
    EXPECT_THAT(fallsIn(table + weight), ElementsAre(1));
    EXPECT_THAT(fallsIn("simulator -finish 2\n" + onGrid + weight), ElementsAre(0));
    // A plate that a drive leads carries it.
    EXPECT_THAT(fallsIn("simulator -finish 2\nbody plate box -init_pos {0 -0.5 0}\n" + onGrid +
                        weight +
                        "joint drive -type slider -body1 plate -axis {1 0 0} "
                        "-position {0.01*(1 - cos(t))}\n"),
                IsEmpty());
    EXPECT_THAT(fallsIn(table + weight + "body f plane -fixed 1 -init_pos {0 -1 0}\n"), IsEmpty());
    EXPECT_THAT(fallsIn(table + "force -body a -gravitational {0 -0.1 0}\n"), IsEmpty()); // near
    EXPECT_THAT(fallsIn(table + "force -body a -gravitational {0 -9.81 0}\n"
                                "joint rail -type slider -body1 a -axis {1 1 0}\n"),
                IsEmpty());
}

TEST(NothingMoves, UntilAForceASpeedOrADriveMovesABody) {
    const std::string joined = onGrid + "joint j -type hinge -body1 a\n";
    EXPECT_TRUE(nothingMoves(readIn(onGrid)));
    EXPECT_TRUE(nothingMoves(readIn(joined)));
    EXPECT_TRUE(nothingMoves(readIn(onGrid + "body b box -init_pos {9 0.5 0} -fixed 1\n")));
    EXPECT_FALSE(nothingMoves(readIn("")));
    EXPECT_FALSE(nothingMoves(readIn("body b box -fixed 1\n"))); // none could
    EXPECT_FALSE(nothingMoves(readIn(onGrid + weight)));
    EXPECT_TRUE(nothingMoves(readIn(onGrid + "rope r -points {{a {0 0 0}} {0 9 0}}\n")));
    EXPECT_FALSE(
        nothingMoves(readIn(onGrid + "body b box -init_drot {0 0 1} -init_pos {5 0 0}\n")));
    EXPECT_FALSE(nothingMoves(readIn(onGrid + "spring s -body1 a -x 0 -y 3 -z 0 -stiffness 20\n")));
    EXPECT_FALSE(
        nothingMoves(readIn(onGrid + "joint j -type hinge -body1 a -speed 1 -max_motor 9\n")));
}

TEST(LacksWeight, WhereAFixedBodyIsAndOneThatWouldFall) {
    const std::string floor = "body f plane -fixed 1\n";
    const std::string bench = "body desk box -fixed 1 -init_pos {0 0.5 0}\n";
    const std::string thrown = "body b box -init_pos {3 2 0} -init_dpos {-4 0 0}\n";
    const std::string stack = onGrid + "body c box -init_pos {0 1.5 0}\n";
    EXPECT_TRUE(lacksWeight(readIn(floor + stack + thrown)));
    EXPECT_TRUE(lacksWeight(readIn(floor + thrown)));
    EXPECT_TRUE(lacksWeight(readIn(floor + stack +
                                   "body b box -init_pos {3 0.5 0} "
                                   "-init_dpos {-4 0 0}\n")));
    EXPECT_TRUE(lacksWeight(readIn(bench + thrown)));
    EXPECT_TRUE(lacksWeight(readIn(floor + "body b box -init_pos {3 0.5 0} "
                                           "-init_dpos {0 4 0}\n")));
    EXPECT_FALSE(lacksWeight(readIn(stack + thrown))); // bodies in space
    EXPECT_FALSE(lacksWeight(readIn(floor + onGrid + weight + thrown)));
    EXPECT_FALSE(lacksWeight(readIn(floor + thrown + "joint j -type hinge -body1 b\n")));
    // A puck glides a hair above its table.
    EXPECT_FALSE(lacksWeight(readIn(bench + "body p box -init_pos {0.2 1.51 0} "
                                            "-init_dpos {1 0 0}\n")));
    EXPECT_FALSE(lacksWeight(readIn(floor + "body p box -init_pos {0 0.51 0} "
                                            "-init_dpos {1 0 0}\n")));
}

} // namespace
} // namespace gestures
