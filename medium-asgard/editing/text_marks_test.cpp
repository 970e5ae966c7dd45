// What of a text viewers mark: what gestures can change, and long lists of points.
#include "editing/editable.h"
#include "editing/number_text.h"
#include "editing/point_lists.h"

#include "script/reader.h"

#include <gtest/gtest.h>

namespace editing {
namespace {

std::string editables(const std::string& text) {
    static script::Reader reader;
    const auto result = reader.read(text);
    EXPECT_TRUE(result.usable) << text;
    std::string out;
    for (const Editable& one :
         editablesOf(text, std::make_shared<const scene::Scene>(result.scene)))
        out += one.option + " " + text.substr(one.range.from, one.range.to - one.range.from) + "\n";
    return out;
}

const std::string markedBall = "shape_set s -desc {-sub {-sphere 1}}\n";

TEST(Editables, AreWordsThatAreTheValue) {
    EXPECT_EQ(editables(markedBall + "body b s -init_pos {1  2 3} -mass 4 -init_dpos \"0 0 1\"\n"),
              "-init_pos {1  2 3}\n-init_dpos \"0 0 1\"\n");
    EXPECT_EQ(editables("trajectory path -points {{0 1 2 3} {1 2 3 4}}\n"),
              "-points {{0 1 2 3} {1 2 3 4}}\n");
}

TEST(Editables, AreAJointsPointsAndItsAxis) {
    EXPECT_EQ(editables(markedBall + "body b s\njoint p -type hinge -body1 b -offset1 {0 1 0} "
                                     "-offset2 {0 2 0} -axis {0 0 2} -limits {-1 1}\n"),
              "-offset1 {0 1 0}\n-offset2 {0 2 0}\n-axis {0 0 2}\n");
}

TEST(Editables, AreTheNumbersThatAValueComesFrom) {
    EXPECT_EQ(editables(markedBall + "set h 3\nbody b s -init_pos [list 1 $h 0]\n"),
              "-init_pos 3\n-init_pos 1\n-init_pos 0\n");
    EXPECT_EQ(editables(markedBall + "body b s\nforce -body b -x 0 -y {-10 * b.mass} -z {2*t}\n"),
              "-x 0\n-y -10\n");
}

TEST(Editables, AreNotWhatALoopOrAnExpressionMakes) {
    EXPECT_EQ(editables(markedBall + "foreach i {1 2} { body b$i s -init_pos {9 0 0} -ct 1 }\n"),
              "");
    EXPECT_EQ(editables(markedBall + "body b s -init_pos [list [expr {1 + 2}] 0 0]\n"), "");
}

std::string lists(const std::string& text, std::size_t longerThan = 10) {
    std::string out;
    for (const PointList& list : pointListsOf(text, script::structureOf(text), longerThan))
        out += std::to_string(list.count) +
               (list.what == Listed::points   ? " points "
                : list.what == Listed::curves ? " curves "
                                              : " faces ") +
               text.substr(list.range.from, list.range.to - list.range.from) + "\n";
    return out;
}

TEST(PointLists, AreThoseOfTrajectoriesAndShapes) {
    EXPECT_EQ(lists("trajectory t -points {{0 0 0 0} {1 1 1 1}}\n"),
              "2 points {{0 0 0 0} {1 1 1 1}}\n");
    EXPECT_EQ(lists("trajectory t -bezier {{0 1 {0 0 0} {1 1 1}}}\n"),
              "1 curves {{0 1 {0 0 0} {1 1 1}}}\n");
    EXPECT_EQ(lists("shape_set s -desc {-sub {-pos {0 0 0} -points {{0 0 0} {1 0 0}}}}\n"),
              "2 points {{0 0 0} {1 0 0}}\n");
    EXPECT_EQ(lists("shape_set s -desc {-face {{0 0 0} {1 0 0}} -face {{0 0 1}} -sub {-sphere 2}}"),
              "2 faces -face {{0 0 0} {1 0 0}} -face {{0 0 1}}\n");
    EXPECT_EQ(lists("foreach i {1} {\n  set p {{0 0 0} {1 1 1} {2 2 2}}\n}\n"),
              "3 points {{0 0 0} {1 1 1} {2 2 2}}\n");
}

TEST(PointLists, AreLong) {
    EXPECT_EQ(lists("trajectory t -points {{0 0 0 0} {1 1 1 1}}\n", 40), "");
    EXPECT_EQ(
        lists("body b s -init_pos {0.0000000 0.000000 0.00000}\nset x {some words of mine}\n"), "");
}

// "|" stands for the place.
std::string number(std::string text) {
    const std::size_t place = text.find('|');
    text.erase(place, 1);
    const auto range = numberAt(text, place);
    return range ? text.substr(range->from, range->to - range->from) : "";
}

TEST(NumberAt, IsTheNumberWithItsSign) {
    EXPECT_EQ(number("-init_pos {-1|.5 0 0}"), "-1.5");
    EXPECT_EQ(number("-init_pos {|-1.5 0 0}"), "-1.5");
    EXPECT_EQ(number("-y {-10| * b1.mass}"), "-10");
    EXPECT_EQ(number("-y {3 - |4}"), "4");
    EXPECT_EQ(number("-y {x-|4}"), "4");
    EXPECT_EQ(number("-accuracy 1e|-4"), "1e-4");
    EXPECT_EQ(number("-mass 10|"), "10");
    EXPECT_EQ(number("a\n|12 b"), "12");
    EXPECT_EQ(number("|7"), "7");
}

TEST(NumberAt, IsNoneInNamesColoursAndWords) {
    EXPECT_EQ(number("body b|1 ball"), "");
    EXPECT_EQ(number("-color #1|02030"), "");
    EXPECT_EQ(number("-offset|1 x"), "");
    EXPECT_EQ(number("$x|2"), "");
    EXPECT_EQ(number("|"), "");
    EXPECT_EQ(number("1.2.|3"), "");
}

} // namespace
} // namespace editing
