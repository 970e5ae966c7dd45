// (text, gesture, text): what a gesture makes of a text, and what it refuses to touch.
#include "editing/number_text.h"
#include "editing/test_reading.h"
#include "editing/value_edit.h"

#include <gmock/gmock.h>

namespace editing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Mapped {
    std::string text;
    std::shared_ptr<const scene::Scene> scene;
    Mapper mapper;
    explicit Mapped(const std::string& source)
        : text(source), scene(read(source)), mapper(text, scene, [](const std::string& name) {
              return name == "b.mass" ? std::optional(2.0) : std::nullopt;
          }) {}
    static std::shared_ptr<const scene::Scene> read(const std::string& text) {
        const auto result = reader().read(text);
        EXPECT_TRUE(result.usable)
            << (result.diagnostics.empty() ? text : result.diagnostics.front().message);
        return std::make_shared<const scene::Scene>(result.scene);
    }
    // The text after the wish, or its reason.
    std::string after(const Wish& wish) const {
        const Answer answer = mapper.answer(wish);
        return answer.possible() ? text::applied(text, answer.edits) : answer.reason;
    }
};

Wish move(std::size_t body, std::vector<double> to, double resolution = 0.01) {
    return {.element = {Kind::body, body},
            .option = "-init_pos",
            .path = {},
            .values = std::move(to),
            .resolution = resolution,
            .absent = {0, 0, 0}};
}

Wish push(std::string component, double value) {
    return {.element = {Kind::force, 0},
            .option = std::move(component),
            .path = {},
            .values = {value},
            .resolution = 0.01};
}

struct Case {
    const char* name;
    const char* before;
    std::vector<double> to;
    const char* after;
};

class Moves : public testing::TestWithParam<Case> {};

TEST_P(Moves, RewriteTheNumbersWhereTheyStand) {
    const Mapped scene(ballShape + GetParam().before);
    const std::string after = scene.after(move(0, GetParam().to));
    EXPECT_EQ(after, ballShape + GetParam().after);
    // What is written means what was wished.
    const auto moved = Mapped::read(after);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(moved->bodies[0].initialPosition[i], GetParam().to[static_cast<std::size_t>(i)],
                    0.0051);
}

INSTANTIATE_TEST_SUITE_P(
    All, Moves,
    testing::Values(
        Case{"Braces",
             "body b s -init_pos {-5 0 0}  ;# here",
             {-4.371, 0, 2},
             "body b s -init_pos {-4.37 0 2}  ;# here"},
        Case{"OnlyWhatChanges",
             "body b s -init_pos {  1.50   2e0 +3 }",
             {2, 2, 3},
             "body b s -init_pos {  2.00   2e0 +3 }"},
        Case{"Quotes", "body b s -init_pos \"1 2 3\"", {1, 2, 4}, "body b s -init_pos \"1 2 4\""},
        Case{"Absent",
             "body b s -mass 2; # heavy",
             {1, 0, -0.5},
             "body b s -mass 2 -init_pos {1 0 -0.5}; # heavy"},
        Case{"AbsentAndStill", "body b s", {0, 0, 0.001}, "body b s"},
        Case{"Lines",
             "body b s \\\n  -init_pos {1 2 3} \\\n  -mass 1",
             {9, 2, 3},
             "body b s \\\n  -init_pos {9 2 3} \\\n  -mass 1"},
        Case{"ListCommand",
             "body b s -init_pos [list 1 2 3]",
             {1, 7, 3},
             "body b s -init_pos [list 1 7 3]"},
        Case{"Variable",
             "set x 4\nbody b s -init_pos \"$x 0 0\"",
             {5, 0, 1},
             "set x 5\nbody b s -init_pos \"$x 0 1\""},
        Case{"WholeVariable",
             "set p {1 2 3}\nbody b s -init_pos $p",
             {1, 2, 3.25},
             "set p {1 2 3.25}\nbody b s -init_pos $p"},
        Case{"Parameter",
             "parameter d -value 2 -min 0\nbody b s -init_pos \"0 $d 0\"",
             {0, 2.5, 0},
             "parameter d -value 2.5 -min 0\nbody b s -init_pos \"0 $d 0\""},
        Case{"InAnIf",
             "if {1} {body b s -init_pos {1 2 3}}",
             {3, 2, 1},
             "if {1} {body b s -init_pos {3 2 1}}"},
        Case{"LoopOfOne",
             "foreach i {1} {body b s -init_pos {1 2 3}}",
             {3, 2, 1},
             "foreach i {1} {body b s -init_pos {3 2 1}}"},
        Case{"OtherAlphabets",
             "# \xc3\xa4\xe2\x82\xac\nbody b s -init_pos {1 2 3}",
             {3, 2, 1},
             "# \xc3\xa4\xe2\x82\xac\nbody b s -init_pos {3 2 1}"}),
    [](const auto& one) { return std::string(one.param.name); });

struct Refused {
    const char* name;
    const char* before;
    const char* reason;
};

class Refusals : public testing::TestWithParam<Refused> {};

TEST_P(Refusals, SayWhatMakesTheValueAndWhere) {
    const Mapped scene(ballShape + GetParam().before);
    const Answer answer = scene.mapper.answer(move(0, {7, 8, 9}));
    EXPECT_THAT(answer.reason, HasSubstr(GetParam().reason));
    EXPECT_THAT(answer.edits, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, Refusals,
    testing::Values(
        Refused{"Expr", "body b s -init_pos [list [expr {1 + 1}] 0 0]",
                "-init_pos of body \"b\" is computed by [expr {1 + 1}]."},
        Refused{
            "Loop", "foreach i {1 2} {\n  body b$i s -init_pos \"$i 0 0\"\n}",
            "-init_pos of body \"b1\" is one of 2 that line 3 makes, in the foreach of line 2."},
        Refused{"Procedure", "proc p {n} {body $n s -init_pos {1 2 3}}\np a\np b",
                "is one of 2 that line 2 makes, in the procedure of line 2."},
        Refused{"Argument", "proc p {x} {body a s -init_pos \"$x 0 0\"}\np 3",
                "comes from $x, which is given to the procedure of line 2."},
        Refused{"SetTwice", "set x 1\nset x 2\nbody b s -init_pos \"$x 0 0\"",
                "comes from $x, which is set in line 2 and again in line 3."},
        Refused{"Incremented", "set x 1\nincr x\nbody b s -init_pos \"$x 0 0\"",
                "comes from $x, which the incr of line 3 changes."},
        Refused{"ComputedVariable", "set x [expr {1 + 2}]\nbody b s -init_pos \"$x 0 0\"",
                "comes from $x, which is computed in line 2."},
        Refused{"OneNumberTwice", "set x 1\nbody b s -init_pos \"$x $x 0\"",
                "has one number of the text, $x, in two places"},
        Refused{"Eval", "eval \"body b s -init_pos {1 2 3}\"",
                "does not stand in the text: the command of line 2"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Offers, OfALoopAreThisOneAndAll) {
    const Mapped scene(ballShape +
                       "foreach i {1 2 3} {\n  body b$i s -init_pos \"$i 0 0\" ;# row\n}\n");
    const Answer answer = scene.mapper.answer(move(1, {2, 1.5, 0}));
    ASSERT_EQ(answer.offers.size(), 2u);
    EXPECT_EQ(answer.offers[0].label, "Only b2");
    const auto one = Mapped::read(text::applied(scene.text, answer.offers[0].edits));
    EXPECT_EQ(one->bodies[1].initialPosition, geometry::Vector(2, 1.5, 0));
    EXPECT_EQ(one->bodies[0].initialPosition, geometry::Vector(1, 0, 0));
    EXPECT_EQ(one->bodies[2].initialPosition, geometry::Vector(3, 0, 0));
    EXPECT_EQ(answer.offers[1].label, "All 3");
    const auto all = Mapped::read(text::applied(scene.text, answer.offers[1].edits));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(all->bodies[static_cast<std::size_t>(i)].initialPosition,
                  geometry::Vector(i + 1, 1.5, 0));
}

TEST(Offers, ForAnOptionThatIsNotThereStartFromWhatItWas) {
    const Mapped scene(ballShape + "foreach i {1 2} {body b$i s}\n");
    const Answer answer = scene.mapper.answer(move(0, {4, 5, 6}));
    ASSERT_EQ(answer.offers.size(), 1u);
    const auto one = Mapped::read(text::applied(scene.text, answer.offers[0].edits));
    EXPECT_EQ(one->bodies[0].initialPosition, geometry::Vector(4, 5, 6));
    EXPECT_EQ(one->bodies[1].initialPosition, geometry::Vector(0, 0, 0));
}

// "All 2" would have to make two numbers of one: it is not offered.
TEST(Offers, DoNotChangeOneNumberTwice) {
    const Mapped scene(ballShape +
                       "set x 1\nforeach i {1 2} {body b$i s -init_pos \"$x $x $i\"}\n");
    const Answer apart = scene.mapper.answer(move(0, {2, 3, 1}));
    ASSERT_FALSE(apart.possible());
    for (const Offer& offer : apart.offers)
        EXPECT_NE(offer.label, "All 2");
    const Answer same = scene.mapper.answer(move(0, {2, 2, 1}));
    const auto all = std::ranges::find(same.offers, "All 2", &Offer::label);
    ASSERT_NE(all, same.offers.end());
    EXPECT_EQ(text::applied(scene.text, all->edits),
              ballShape + "set x 2\nforeach i {1 2} {body b$i s -init_pos \"$x $x $i\"}\n");
}

TEST(Offers, OfSeveralOptionsDoNotChangeOneNumberTwice) {
    const auto offered = [&](const std::string& second, double x, double y) {
        const Mapped scene(ballShape +
                           "set v 1; set w 1\nforeach i {1 2} {body b$i s\n"
                           "force -body b$i -x $v -y $" +
                           second + " -z 0}\n");
        const Answer answer = scene.mapper.answer(std::vector<Wish>{push("-x", x), push("-y", y)});
        EXPECT_FALSE(answer.possible());
        const auto all = std::ranges::find(answer.offers, "All 2", &Offer::label);
        return all == answer.offers.end() ? "" : text::applied(scene.text, all->edits);
    };
    EXPECT_EQ(offered("v", 2, 3), "");
    EXPECT_EQ(offered("v", 2, 1), "");
    EXPECT_THAT(offered("w", 2, 3), HasSubstr("set v 2; set w 3\nforeach"));
}

TEST(Forces, AreDraggedByTheFactorOfTheirExpression) {
    const std::string head = ballShape + "body b s -mass 2\n";
    EXPECT_EQ(Mapped(head + "force -body b -x 0 -y {-10 * b.mass} -z 0").after(push("-y", -25)),
              head + "force -body b -x 0 -y {-12.5 * b.mass} -z 0");
    EXPECT_EQ(Mapped(head + "force -body b -x 0 -y {b.mass*3} -z 0").after(push("-y", 5)),
              head + "force -body b -x 0 -y {b.mass*2.5} -z 0");
    EXPECT_EQ(Mapped(head + "force -body b -x 0 -y {0} -z 0").after(push("-y", 5)),
              head + "force -body b -x 0 -y {5} -z 0");
    EXPECT_EQ(
        Mapped(head + "parameter g -value 3\nforce -body b -x 0 -y {g} -z 0").after(push("-y", 5)),
        head + "parameter g -value 5\nforce -body b -x 0 -y {g} -z 0");
    EXPECT_EQ(
        Mapped(head + "force -body b -x 0 -y {-10 * b.mass * t} -z 0").after(push("-y", 5)),
        "-y of the force of line 3 is the expression {-10 * b.mass * t}, which stays as it is.");
    EXPECT_EQ(Mapped(head + "force -body b -x 0 -y {sin(t)} -z 0").after(push("-y", 5)),
              "-y of the force of line 3 is the expression {sin(t)}, which stays as it is.");
}

TEST(Trajectories, ChangeOneNumberOfOnePoint) {
    const Mapped scene("trajectory T -points {\n  {0 1 2 3}\n  {1 4 5 6}\n}\n");
    Wish wish{.element = {Kind::trajectory, 0},
              .option = "-points",
              .path = {1},
              .values = {1, 4, 5.5, 6},
              .resolution = 0.1};
    EXPECT_EQ(scene.after(wish), "trajectory T -points {\n  {0 1 2 3}\n  {1 4 5.5 6}\n}\n");
    wish.path = {2};
    EXPECT_THAT(scene.after(wish), HasSubstr("is not written as 4 numbers"));
}

TEST(NumberText, HasTheDigitsOfTheGestureAndTheAuthor) {
    EXPECT_EQ(numberText(-4.3712, 0.01, "-5"), "-4.37");
    EXPECT_EQ(numberText(2, 0.01, "1.50"), "2.00");
    EXPECT_EQ(numberText(-0.001, 0.01), "0");
    EXPECT_EQ(numberText(0.1, 0), "0.1");
    EXPECT_EQ(numberText(0.1 + 0.2, 0), "0.3");
    EXPECT_EQ(numberText(3.14159265358979, 0), "3.14159265358979"); // as it was typed
    EXPECT_EQ(numberText(3.040000000001, 1e-11), "3.04");
    EXPECT_EQ(numberText(0.333333, 0.07), "0.3");
    EXPECT_EQ(numberText(1234567, 100), "1234567");
    EXPECT_EQ(numberText(1e-9, 1e-12), "1e-09");
    EXPECT_EQ(numberText(12.5, 0.001, "3e2"), "12.5");
}

} // namespace
} // namespace editing
