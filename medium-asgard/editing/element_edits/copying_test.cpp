// (text, elements, commands) and (text, commands, text).
#include "editing/test_reading.h"
#include "element_edits/copying.h"

namespace editing {
namespace {

using geometry::Vector;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string pair = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                         "body a s -init_pos {1 2 0} -mass 2\n"
                         "body b s -init_pos {3 2 0}\n"
                         "force -body a -y {-9.81 * a.mass}\n"
                         "joint arm -type distance -body1 a -body2 b\n"
                         "joint pin -type ball -body1 a\n"
                         "plot p -values {a.x b.x}\n";

TEST(Copying, TakesAlongShapesForcesAndWhatJoinsTwoOfThem) {
    const auto scene = readScene(pair);
    EXPECT_EQ(copied(pair, *scene, {{Kind::body, 0}}).commands,
              "shape_set s -desc {-sub {-sphere 0.5}}\nbody a s -init_pos {1 2 0} -mass 2\n"
              "force -body a -y {-9.81 * a.mass}\n");
    EXPECT_THAT(copied(pair, *scene, {{Kind::body, 0}, {Kind::body, 1}}).commands,
                HasSubstr("joint arm -type distance -body1 a -body2 b\n"));
}

TEST(Copying, OfALoopSaysWhyNot) {
    const std::string text = "shape_set s -desc {-sub {-sphere 1}}\n"
                             "foreach i {1 2} {\n  body b$i s\n}\n";
    const Copied copy = copied(text, *readScene(text), {{Kind::body, 1}});
    EXPECT_EQ(copy.reason, "No copy: body \"b2\" is one of 2 that line 3 makes.");
}

TEST(Copying, ACopyInTheSameSceneHasOtherNamesAndStandsBeside) {
    const auto scene = readScene(pair);
    const Copied copy = copied(pair, *scene, {{Kind::body, 0}});
    const Pasted paste = pasted(pair, *scene, copy.commands, Vector(1, 0, 0));
    ASSERT_EQ(paste.reason, "");
    const std::string text = text::applied(pair, paste.edits);
    EXPECT_EQ(text, "shape_set s -desc {-sub {-sphere 0.5}}\n"
                    "body a s -init_pos {1 2 0} -mass 2\n"
                    "body b s -init_pos {3 2 0}\n"
                    "body a2 s -init_pos {2 2 0} -mass 2\n"
                    "force -body a -y {-9.81 * a.mass}\n"
                    "force -body a2 -y {-9.81 * a2.mass}\n"
                    "joint arm -type distance -body1 a -body2 b\n"
                    "joint pin -type ball -body1 a\n"
                    "plot p -values {a.x b.x}\n");
    (void)readScene(text);
    EXPECT_THAT(paste.added, ElementsAre(Element{Kind::body, 2}, Element{Kind::force, 1}));
}

TEST(Copying, ABodyGetsNoSecondWeight) {
    const std::string heavy = "shape_set s -desc {-sub {-sphere 0.5}}\nbody a s\n"
                              "force -body a -gravitational {0 -9.81 0}\n";
    const auto scene = readScene(heavy);
    const Copied weight = copied(heavy, *scene, {{Kind::force, 0}});
    EXPECT_EQ(pasted(heavy, *scene, weight.commands, Vector(1, 0, 0)).reason,
              "a has a weight already: select a body to copy it with its weight.");
    const Copied both = copied(heavy, *scene, {{Kind::body, 0}, {Kind::force, 0}});
    const std::string text =
        text::applied(heavy, pasted(heavy, *scene, both.commands, Vector(1, 0, 0)).edits);
    EXPECT_THAT(text, HasSubstr("force -body a2 -gravitational {0 -9.81 0}\n"));
    EXPECT_EQ(readScene(text)->forces.size(), 2U);
}

TEST(Copying, BothBodiesKeepTheirJoint) {
    const auto scene = readScene(pair);
    const Copied copy = copied(pair, *scene, {{Kind::body, 0}, {Kind::body, 1}});
    const std::string text =
        text::applied(pair, pasted(pair, *scene, copy.commands, Vector(0, 0, 1)).edits);
    EXPECT_THAT(text, HasSubstr("joint arm2 -type distance -body1 a2 -body2 b2\n"));
    (void)readScene(text);
}

// A wheel with its hinge: the copy is held beside by the same body, and by the world.
TEST(Copying, WhatHoldsACopyIsMovedWithIt) {
    const std::string car =
        "shape_set s -desc {-sub {-sphere 0.5}}\n"
        "body box s -init_pos {0 1 0} -init_rot {0 0 1.5707963267948966}\n"
        "body wheel s -init_pos {1 1 0}\n"
        "joint h -type hinge -body1 box -offset1 {0 -1 0} -body2 wheel -offset2 {0 0 0}\n"
        "joint w -type ball -body1 wheel -offset2 {1 1 0}\n";
    const auto scene = readScene(car);
    const Copied copy = copied(car, *scene, {{Kind::body, 1}, {Kind::joint, 0}, {Kind::joint, 1}});
    const std::string text =
        text::applied(car, pasted(car, *scene, copy.commands, Vector(2, 0, 0)).edits);
    EXPECT_THAT(text, HasSubstr("body wheel2 s -init_pos {3 1 0}\n"));
    EXPECT_THAT(text, HasSubstr("joint h2 -type hinge -body1 box -offset1 {0 -3 0} -body2 wheel2 "
                                "-offset2 {0 0 0}\n"));
    EXPECT_THAT(text, HasSubstr("joint w2 -type ball -body1 wheel2 -offset2 {3 1 0}\n"));
}

// Copies stand to each other as the originals do, also where one would stand on another.
TEST(Copying, AllBodiesMoveByOneWay) {
    const std::string row = "shape_set s -desc {-sub {-sphere 0.5}}\n"
                            "body a s\nbody b s -init_pos {1 0 0}\n";
    const auto scene = readScene(row);
    const Copied copy = copied(row, *scene, {{Kind::body, 0}, {Kind::body, 1}});
    const std::string text =
        text::applied(row, pasted(row, *scene, copy.commands, Vector(1, 0, 0)).edits);
    EXPECT_THAT(text, HasSubstr("body a2 s -init_pos {2 0 0}\n"));
    EXPECT_THAT(text, HasSubstr("body b2 s -init_pos {3 0 0}\n"));
}

TEST(Copying, IntoAnotherSceneNamesStayWhereTheyAreFree) {
    const auto scene = readScene(pair);
    const Copied copy = copied(pair, *scene, {{Kind::body, 0}});
    EXPECT_EQ(text::applied("", pasted("", scene::Scene(), copy.commands, Vector::Zero()).edits),
              "shape_set s -desc {-sub {-sphere 0.5}}\nbody a s -init_pos {1 2 0} -mass 2\n"
              "force -body a -y {-9.81 * a.mass}\n");
    const std::string other = "shape_set s -desc {-sub {-box {1 1 1}}}\nbody a s\n";
    const std::string text = text::applied(
        other, pasted(other, *readScene(other), copy.commands, Vector(1, 0, 0)).edits);
    EXPECT_THAT(text, HasSubstr("shape_set s2 -desc {-sub {-sphere 0.5}}\n"));
    EXPECT_THAT(text, HasSubstr("body a2 s2 -init_pos {1 2 0} -mass 2\n"));
    (void)readScene(text);
}

TEST(Copying, OtherTextIsRefused) {
    const auto scene = readScene(pair);
    for (const char* words : {"", "Dear Ann,", "puts hello", "body {a"})
        EXPECT_EQ(pasted(pair, *scene, words, Vector::Zero()).reason,
                  "The clipboard holds no commands of a scene.")
            << words;
}

} // namespace
} // namespace editing
