// (text, gesture, text): what is put into a text, and what is taken out.
#include "editing/test_reading.h"
#include "element_edits/creation.h"
#include "element_edits/deletion.h"
#include "element_edits/preview.h"

namespace editing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string shapes = "shape_set s -desc {-sub {-sphere 1}}\n";

std::string withNew(const std::string& text, const NewElement& element) {
    const std::string after = text::applied(text, created(text, *readScene(text), {element}));
    (void)readScene(after);
    return after;
}

NewElement weightOn(const std::string& body, std::size_t index) {
    return {Kind::force, "", {"-body", body, "-gravitational", "{0 -1 0}"}, {{Kind::body, index}}};
}

TEST(Creation, PutsABodyBehindTheLastOneInTheAuthorsStyle) {
    const NewElement body{Kind::body, "b3", {"-init_pos", "{1 2 3}"}, {{Kind::shapeSet, 0}}, "s"};
    EXPECT_EQ(withNew(shapes + "body b1 s\nbody b2 s ;# two\n\n# forces\n", body),
              shapes + "body b1 s\nbody b2 s ;# two\nbody b3 s -init_pos {1 2 3}\n\n# forces\n");
    EXPECT_EQ(withNew(shapes + "  instance b1 \\\n    -shape s; # one", body),
              shapes + "  instance b1 \\\n    -shape s; # one\n"
                       "  instance b3 -shape s -init_pos {1 2 3}");
    EXPECT_EQ(withNew(shapes, body), shapes + "\nbody b3 s -init_pos {1 2 3}\n");
}

TEST(Creation, KeepsLineBreaksAsTheyAre) {
    const std::string text = "shape_set s -desc {-sub {-sphere 1}}\r\nbody b1 s\r\n";
    EXPECT_EQ(withNew(text, weightOn("b1", 0)),
              text + "\r\nforce -body b1 -gravitational {0 -1 0}\r\n");
}

TEST(Creation, GoesBehindWhatItNamesEvenWhenItsKindStandsBefore) {
    const std::string text = shapes + "body a s\nforce -body a -y 1\nbody b s\n# end\n";
    EXPECT_EQ(withNew(text, weightOn("b", 1)),
              shapes + "body a s\nforce -body a -y 1\nbody b s\n"
                       "force -body b -gravitational {0 -1 0}\n# end\n");
}

TEST(Creation, GoesBehindLoopsAndCallsOfProcedures) {
    const std::string loop = shapes + "foreach i {1 2} {\n  body b$i s\n}\nset x 1\n";
    EXPECT_EQ(withNew(loop, weightOn("b2", 1)),
              shapes + "foreach i {1 2} {\n  body b$i s\n}\n"
                       "force -body b2 -gravitational {0 -1 0}\nset x 1\n");
    const std::string procedure = shapes + "proc p {n} {body $n s}\n\np a\n";
    EXPECT_EQ(withNew(procedure, weightOn("a", 0)),
              procedure + "\nforce -body a -gravitational {0 -1 0}\n");
}

TEST(Creation, MindsContinuedLinesAndTheEndOfTheScript) {
    EXPECT_EQ(withNew(shapes + "body a s \\\n\nset x 1", weightOn("a", 0)),
              shapes + "body a s \\\n\nforce -body a -gravitational {0 -1 0}\nset x 1");
    EXPECT_EQ(withNew("# no\\", {Kind::parameter, "g", {"-value", "1"}, {}}),
              "# no\\\n\n\nparameter g -value 1");
    EXPECT_EQ(withNew(shapes + "return\nnonsense", {Kind::parameter, "g", {"-value", "1"}, {}}),
              shapes + "parameter g -value 1\nreturn\nnonsense");
}

TEST(Creation, PutsAJointBehindLinksAndBeforeConstraints) {
    const NewElement joint{
        Kind::joint, "hinge1", {"-type", "hinge", "-body1", "a"}, {{Kind::body, 0}}};
    EXPECT_EQ(
        withNew(shapes + "body a s\nlink -body1 a -x 0 -y 0 -z 0 -tightness 1\n\n# end\n", joint),
        shapes + "body a s\nlink -body1 a -x 0 -y 0 -z 0 -tightness 1\n\n"
                 "joint hinge1 -type hinge -body1 a\n\n# end\n");
    EXPECT_EQ(unusedName("", *readScene(shapes + "body hinge1 s\n"), Kind::joint, "hinge"),
              "hinge2");
}

TEST(Creation, EndsALineThatABackslashContinues) {
    for (const std::string end : {"\n", "\r\n"}) {
        const std::string text =
            "shape_set s -desc {-sub {-sphere 1}}" + end + "body b1 s -mass 2 \\" + end;
        const std::string after = withNew(text, weightOn("b1", 0));
        EXPECT_TRUE(after.starts_with(text)) << after;
        EXPECT_EQ(readScene(after)->forces.size(), 1U) << after;
        // The blank line that ends the body goes with it.
        const std::string two = text + end + "body b2 s" + end;
        const Element first{Kind::body, 0};
        const Deletion deletion = deletionOf(two, *readScene(two), {first});
        ASSERT_TRUE(deletion.possible());
        EXPECT_EQ(readScene(text::applied(two, deletion.edits))->bodies.size(), 1U);
        const std::string between = withNew(two, weightOn("b1", 0));
        EXPECT_EQ(readScene(between)->forces.size(), 1U) << between;
    }
}

TEST(Creation, GoesBeforeAReturnThatSharesItsLine) {
    EXPECT_EQ(withNew(shapes + "body b1 s; return\nnonsense", weightOn("b1", 0)),
              shapes + "body b1 s; \nforce -body b1 -gravitational {0 -1 0}\nreturn\nnonsense");
}

TEST(Creation, ANameIsFreeWhereNothingHasIt) {
    const auto scene = readScene(shapes + "body b1 s\nparameter g -value 1\n");
    for (const char* name : {"h", "_x", "b2", "g_1"})
        EXPECT_TRUE(isFreeName(*scene, name)) << name;
    for (const char* name : {"", "1a", "a b", "a.b", "b1", "g", "s", "t", "sin", "\xc3\xa4"})
        EXPECT_FALSE(isFreeName(*scene, name)) << name;
}

TEST(Creation, NamesAreLikeTheOthersAndNowhereElse) {
    const std::string text = shapes + "body b1 s\nbody b2 s\n# b3 was here\nset b4 1\n";
    EXPECT_EQ(unusedName(text, *readScene(text), Kind::body, "ball"), "b5");
    EXPECT_EQ(unusedName(shapes, *readScene(shapes), Kind::body, "ball", {"ball1"}), "ball2");
    // A row that is called after its shape is gone on with by bodies of that shape.
    const std::string rods = shapes + "shape_set rod -desc {-sub {-sphere 1}}\nbody rod1 rod\n";
    EXPECT_EQ(unusedName(rods, *readScene(rods), Kind::body, "rod"), "rod2");
    EXPECT_EQ(unusedName(rods, *readScene(rods), Kind::body, "s"), "s1");
}

struct Taken {
    const char* name;
    const char* before;
    const char* after;
};
class Deletions : public testing::TestWithParam<Taken> {};

// Body "a" is taken out, which is the first.
TEST_P(Deletions, TakeLinesAndWhatDependsOnThem) {
    const std::string text = shapes + GetParam().before;
    const Deletion deletion = deletionOf(text, *readScene(text), {{Kind::body, 0}});
    const std::string after =
        deletion.possible() ? text::applied(text, deletion.edits) : deletion.reason;
    EXPECT_EQ(after, deletion.possible() ? shapes + GetParam().after : GetParam().after);
    if (deletion.possible())
        (void)readScene(after);
}

INSTANTIATE_TEST_SUITE_P(
    All, Deletions,
    testing::Values(
        Taken{"Line", "# one\n  body a s ;# its\n\nbody b s\n", "# one\n\nbody b s\n"},
        Taken{
            "Forces",
            "body a s\nbody b s\nforce -body a -y 1\nforce -body b -y {a.x}\nforce -body b -y 2\n",
            "body b s\nforce -body b -y 2\n"},
        Taken{"Links", "body a s\nbody b s\nlink -body1 b -body2 a -tightness 1\n", "body b s\n"},
        Taken{"Joints",
              "body a s\nbody b s\njoint p -type ball -body1 b -body2 a\n"
              "joint q -type hinge -body1 b\njoint r -type hinge -body1 b -motor {a.x}\n"
              "gear g -joint1 q -joint2 r -ratio 2\nplot v -values {p.fx}\n",
              "body b s\njoint q -type hinge -body1 b\n"},
        Taken{"Plots", "body a s\nbody b s\nplot p -values {a.x b.x}\nplot q -values {b.x}\n",
              "body b s\nplot q -values {b.x}\n"},
        Taken{"LastOnALine", "set x 1; body a s", "set x 1; "},
        Taken{"AGroupOfItsOwn", "\nbody a s\n\nbody b s\n", "\nbody b s\n"},
        Taken{"TheLastGroup", "set x 1\r\n\r\nbody a s\r\nforce -body a -y 1\r\n", "set x 1\r\n"},
        Taken{"BehindAComment", "\n# a\nbody a s\n\nbody b s\n", "\n# a\n\nbody b s\n"},
        Taken{"TwoOnALine", "body a s; body b s; # both\n", "body b s; # both\n"},
        Taken{"Continued", "body a \\\n  s \\\n  -mass 1\nbody b s\n", "body b s\n"},
        Taken{"Braces", "if {1} {body a s}\nbody b s\n", "if {1} {}\nbody b s\n"},
        Taken{"InAScript", "if {1} {\n  body a s\n}\nbody b s\n", "if {1} {\n}\nbody b s\n"},
        Taken{"Loop", "foreach i {a b} {body $i s}\n", "Body \"a\" is one of 2 that line 2 makes."},
        Taken{"DependentsOfALoop", "body a s\nforeach i {1 2} {force -body a -y $i}\n",
              "The force of line 3 would have to go too, and is one of 2 that line 3 makes."},
        Taken{"Substituted", "set x [body a s]\n", "Body \"a\" is made within another command."}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Deletion, OfAShapeTakesItsBodiesAndTheirForces) {
    const std::string text = shapes + "body a s\nforce -body a -y 1\nsimulator -finish 1\n";
    const Deletion deletion = deletionOf(text, *readScene(text), {{Kind::shapeSet, 0}});
    EXPECT_THAT(deletion.along, ElementsAre(Element{Kind::body, 0}, Element{Kind::force, 0}));
    EXPECT_EQ(text::applied(text, deletion.edits), "simulator -finish 1\n");
}

TEST(Deletion, OfAJointTakesItsGearsAndWhatReadsIt) {
    const std::string text = shapes + "body a s\njoint p -type hinge -body1 a\n"
                                      "joint q -type hinge -body1 a -release {p.q > 1}\n"
                                      "gear g -joints {p q} -ratios {1 1}\nplot v -values {p.dq}\n";
    const Deletion deletion = deletionOf(text, *readScene(text), {{Kind::joint, 0}});
    EXPECT_THAT(deletion.along, ElementsAre(Element{Kind::gear, 0}, Element{Kind::joint, 1},
                                            Element{Kind::plot, 0}));
    EXPECT_EQ(text::applied(text, deletion.edits), shapes + "body a s\n");
}

TEST(Deletion, OfAParameterThatTheScriptReadsIsRefused) {
    const std::string text = "parameter h -value 1\n" + shapes + "body a s -init_pos \"0 $h 0\"\n";
    EXPECT_EQ(deletionOf(text, *readScene(text), {{Kind::parameter, 0}}).reason,
              "Parameter \"h\" is read as $h in line 3.");
}

// A group of its own is set off by an empty line, which does not stay behind.
TEST(Deletion, OfWhatWasMadeGivesTheTextOfBefore) {
    for (const std::string& text :
         {shapes + "body a s\n", shapes + "\nbody a s\n\n# end\n", shapes + "body a s\r\n"}) {
        const std::string made = withNew(text, weightOn("a", 0));
        const Deletion deletion = deletionOf(made, *readScene(made), {{Kind::force, 0}});
        EXPECT_EQ(text::applied(made, deletion.edits), text);
    }
}

TEST(Preview, ShowsTheLinesThatChange) {
    const std::string text = "one\n  two 2 #\nthree\n";
    const auto changed = changedLines(text, {{10, 11, "2.5"}});
    ASSERT_EQ(changed.size(), 1U);
    EXPECT_EQ(changed[0].line, 2);
    EXPECT_EQ(changed[0].before, "two 2 #");
    EXPECT_EQ(changed[0].after, "two 2.5 #");
    const auto added = changedLines(text, {{4, 4, "new\n"}});
    ASSERT_EQ(added.size(), 1U);
    EXPECT_EQ(added[0].before, "");
    EXPECT_EQ(added[0].after, "new");
}

} // namespace
} // namespace editing
