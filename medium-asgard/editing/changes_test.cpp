// Which element of the text after an edit is which of the text before.
#include "editing/changes.h"
#include "editing/test_reading.h"

#include <gtest/gtest.h>

namespace editing {
namespace {

// "body b1: kept", "force 1 -> 0: modified", ... one line for each element that is not as it was.
std::string story(const std::string& before, const std::string& after) {
    const auto one = reader().read(before), two = reader().read(after);
    EXPECT_TRUE(one.usable) << before;
    EXPECT_TRUE(two.usable) << after;
    const Changes changes = changesBetween({before, one.scene}, {after, two.scene});
    const auto words = [](const scene::Scene& scene, const Element& element) {
        constexpr const char* kinds[] = {"simulator", "shape", "body", "force",     "link",
                                         "joint",     "gear",  "rope", "contact",   "path",
                                         "hold",      "light", "view", "parameter", "plot"};
        const std::string name = nameOf(scene, element);
        return std::string(kinds[static_cast<int>(element.kind)]) + " " +
               (name.empty() ? std::to_string(element.index) : name);
    };
    std::string text;
    for (const Kept& kept : changes.kept)
        if (kept.modified || kept.before.index != kept.after.index)
            text += words(one.scene, kept.before) + " -> " + words(two.scene, kept.after) +
                    (kept.modified ? " modified\n" : " moved\n");
    for (const Element& element : changes.added)
        text += "+ " + words(two.scene, element) + "\n";
    for (const Element& element : changes.removed)
        text += "- " + words(one.scene, element) + "\n";
    return text;
}

const std::string head = "shape_set s -desc {-sub {-sphere 1}}\n"
                         "body a s -init_pos {0 0 0}\nbody b s -init_pos {9 0 0}\n";
const std::string down = "force -body a -y -1\n", up = "force -body a -y 2\n",
                  other = "force -body b -y 3\n";

TEST(Changes, BlanksCommentsAndLinesAreNone) {
    EXPECT_EQ(story(head + down, "# new\n\n" + head + "   force  -body   a -y  {-1}\n"), "");
}

TEST(Changes, ColoursAreSomeThoughNothingMovesByThem) {
    EXPECT_EQ(story(head, head.substr(0, head.size() - 1) + " -color red\n"),
              "body b -> body b modified\n");
}

TEST(Changes, ANamedElementIsTheOneOfItsName) {
    EXPECT_EQ(story(head, "shape_set s -desc {-sub {-sphere 1}}\n"
                          "body b s -init_pos {9 0 0}\nbody a s -init_pos {0 1 0}\n"),
              "body b -> body b moved\nbody a -> body a modified\n");
    EXPECT_EQ(story(head, "shape_set s -desc {-sub {-sphere 1}}\n"
                          "body a s -init_pos {0 0 0}\nbody c s -init_pos {9 0 0}\n"),
              "+ body c\n- body b\n");
}

TEST(Changes, AnElementUnderANewNameAtItsPlaceIsRenamed) {
    const std::string shape = "shape_set s -desc {-sub {-sphere 1}}\n";
    const auto renamed = [&](const std::string& before, const std::string& after) {
        std::string all;
        for (const Renamed& one : renamedBetween(reader().read(shape + before).scene,
                                                 reader().read(shape + after).scene))
            all += one.before + " to " + one.now + "; ";
        return all;
    };
    EXPECT_EQ(renamed("body a s\nbody b s\n", "body a s\nbody c s\n"), "b to c; ");
    EXPECT_EQ(renamed("body a s\nbody b s\n", "body b s\nbody a s\n"), "");
    EXPECT_EQ(renamed("body a s\nbody b s\n", "body c s\n"), "");
}

TEST(Changes, AJointAndAGearAreModifiedByEachOfTheirValues) {
    const std::string pins = head + "joint p -type hinge -body1 a -offset1 {0 1 0}\n"
                                    "joint q -type hinge -body1 b -offset1 {0 1 0}\n";
    const std::string gear = "gear g -joint1 p -joint2 q -ratio 2\n";
    const std::string rope = "rope r -points {{a} {0 3 0}}\n";
    EXPECT_EQ(story(pins + rope, pins + "rope r -points {{a} {0 4 0}}\n"),
              "rope r -> rope r modified\n");
    EXPECT_EQ(story(pins + gear, pins + "\n" + gear), "");
    EXPECT_EQ(story(pins + gear, pins + "gear g -joint1 p -joint2 q -ratio 3\n"),
              "gear g -> gear g modified\n");
    for (const char* more :
         {"-offset1 {0 2 0}", "-offset2 {0 2 0}", "-axis {0 1 0}", "-body2 b", "-limits {-1 {}}",
          "-damping 2", "-motor t", "-friction 1", "-limits {-1 1} -limit_restitution 0.5",
          "-stiffness 1", "-release t>2"}) {
        const std::string pin = "joint p -type hinge -body1 a ";
        EXPECT_EQ(story(head + pin + "\n", head + pin + more + "\n"),
                  "joint p -> joint p modified\n")
            << more;
    }
    EXPECT_EQ(story(pins + gear, pins), "- gear g\n");
}

TEST(Changes, AForceKeepsItsIdentityWhenItsValueChanges) {
    EXPECT_EQ(story(head + down + up, head + "force -body a -y -5\n" + up),
              "force 0 -> force 0 modified\n");
}

TEST(Changes, AForceKeepsItsIdentityWhenItIsMovedOrOthersCome) {
    EXPECT_EQ(story(head + down + up, head + up + down),
              "force 1 -> force 0 moved\nforce 0 -> force 1 moved\n");
    EXPECT_EQ(story(head + down, head + other + down), "force 0 -> force 1 moved\n+ force 0\n");
    EXPECT_EQ(story(head + other + down, head + down), "force 1 -> force 0 moved\n- force 0\n");
}

TEST(Changes, OfSeveralAlikeThePlaceDecides) {
    // Two alike; the first is removed: the second is the one that is left.
    EXPECT_EQ(story(head + down + "\n# between\n" + down, head + "\n# between\n" + down),
              "force 1 -> force 0 moved\n- force 0\n");
}

TEST(Changes, MovedAndEditedAtOnceItIsTheNextOnTheSameBodies) {
    EXPECT_EQ(story(head + down + other, head + "force -body b -y 4\nforce -body a -y -2\n"),
              "force 1 -> force 0 modified\nforce 0 -> force 1 modified\n");
}

TEST(Changes, RunsOfALoopAreToldApart) {
    const std::string loop = "foreach y {1 2 3} { force -body a -y $y }\n";
    EXPECT_EQ(story(head + loop, head + "foreach y {1 5 3} { force -body a -y $y }\n"),
              "force 1 -> force 1 modified\n");
    EXPECT_EQ(story(head + loop, head + "foreach y {2 3} { force -body a -y $y }\n"),
              "force 1 -> force 0 moved\nforce 2 -> force 1 moved\n- force 0\n");
}

} // namespace
} // namespace editing
