// (text, gesture, offered texts) where loops and procedures make elements.
#include "editing/loop_values.h"
#include "editing/tcl_expression.h"
#include "editing/test_reading.h"

#include <gmock/gmock.h>

namespace editing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct LoopCase {
    const char* name;
    const char* text;
    std::size_t body;
    std::vector<double> to;
    const char* label;
    const char* after;
};

std::vector<std::string> namesOf(const scene::Scene& scene) {
    std::vector<std::string> names;
    for (const scene::Body& body : scene.bodies)
        names.push_back(body.name);
    return names;
}

class LoopOffers : public testing::TestWithParam<LoopCase> {};

TEST_P(LoopOffers, MakeTheValueWhatItIsToBe) {
    const LoopCase& one = GetParam();
    const std::string text = ballShape + one.text;
    const auto before = reader().read(text);
    ASSERT_TRUE(before.usable);
    const Mapper mapper(text, std::make_shared<const scene::Scene>(before.scene));
    const Answer answer = mapper.answer({.element = {Kind::body, one.body},
                                         .option = "-init_pos",
                                         .path = {},
                                         .values = one.to,
                                         .resolution = 0.01});
    std::string labels;
    for (const Offer& offer : answer.offers) {
        labels += offer.label + "\n";
        if (offer.label != one.label)
            continue;
        EXPECT_EQ(text::applied(text, offer.edits), ballShape + one.after);
        const auto after = reader().read(text::applied(text, offer.edits));
        ASSERT_TRUE(after.usable);
        EXPECT_EQ(namesOf(after.scene), namesOf(before.scene));
        const auto& place = after.scene.bodies[one.body].initialPosition;
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(place[i], one.to[static_cast<std::size_t>(i)], 0.011);
        return;
    }
    FAIL() << "offered: " << labels;
}

// Numbers are worked out by approximation: its rounding is nothing to write down.
TEST(LoopOffer, IsTheShortestNumberThatMeansTheSame) {
    const std::string text = ballShape + "for {set i 0} {$i < 4} {incr i} {\n"
                                         "  body b$i s -init_pos \"[expr {$i * 0.19 - 2}] 0 0\"\n}";
    const auto read = reader().read(text);
    ASSERT_TRUE(read.usable);
    const Mapper mapper(text, std::make_shared<const scene::Scene>(read.scene));
    const Answer answer = mapper.answer({.element = {Kind::body, 3},
                                         .option = "-init_pos",
                                         .path = {},
                                         .values = {7.12, 0, 0},
                                         .resolution = 0});
    std::string labels;
    for (const Offer& offer : answer.offers)
        labels += offer.label + "\n";
    EXPECT_NE(labels.find("The step: 0.19 becomes 3.04\n"), std::string::npos) << labels;
}

INSTANTIATE_TEST_SUITE_P(
    All, LoopOffers,
    testing::Values(
        LoopCase{
            "Factor",
            "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos \"[expr {$i * 2}] 0 0\"}",
            3,
            {7.5, 0, 0},
            "The step: 2 becomes 2.5",
            "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos \"[expr {$i * 2.5}] 0 0\"}"},
        LoopCase{
            "Divisor",
            "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos [list [expr {$i / 2.0}] 0 0]}",
            2,
            {2, 0, 0},
            "The step: 2.0 becomes 1.0",
            "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos [list [expr {$i / 1.0}] 0 0]}"},
        LoopCase{"Offset",
                 "foreach i {1 2 3} {\n  body b$i s -init_pos \"[expr {0.5 + $i}] 0 0\"\n}",
                 1,
                 {3.25, 0, 0},
                 "All 3, by as much",
                 "foreach i {1 2 3} {\n  body b$i s -init_pos \"[expr {1.25 + $i}] 0 0\"\n}"},
        LoopCase{"Element",
                 "foreach x {-1  2.50 4} {body b[incr n] s -init_pos \"$x 0 0\"} ;# row",
                 1,
                 {3, 0, 0},
                 "Only b2, in the list of line 2",
                 "foreach x {-1  3.00 4} {body b[incr n] s -init_pos \"$x 0 0\"} ;# row"},
        LoopCase{"Pairs",
                 "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x [expr {2 * $x}] 0\"}",
                 1,
                 {3, 6, 0},
                 "Only b, in the list of line 2",
                 "foreach {n x} {a 1 b 3} {body $n s -init_pos \"$x [expr {2 * $x}] 0\"}"},
        LoopCase{"Call",
                 "proc put {n x} {body $n s -init_pos \"$x 0 0\"}\nput a 1\nput b 2 ;# here\n",
                 1,
                 {-3, 0, 0},
                 "Only b, in its call in line 4",
                 "proc put {n x} {body $n s -init_pos \"$x 0 0\"}\nput a 1\nput b -3 ;# here\n"},
        LoopCase{"StepOfTheLoop",
                 "for {set x 0} {$x < 4} {incr x 2} {body b[incr n] s -init_pos \"$x 0 0\"}",
                 1,
                 {3, 0, 0},
                 "The step of the loop: 2 becomes 3",
                 "for {set x 0} {$x < 4} {incr x 3} {body b[incr n] s -init_pos \"$x 0 0\"}"},
        LoopCase{"ListOfItsOwn",
                 "set xs {1 2}\nforeach x $xs {body b[incr n] s -init_pos \"$x 0 0\"}",
                 1,
                 {5, 0, 0},
                 "Only b2, in the list of line 2",
                 "set xs {1 5}\nforeach x $xs {body b[incr n] s -init_pos \"$x 0 0\"}"},
        LoopCase{"NameThatAnotherLoopHasToo",
                 "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x 0 0\"}\n"
                 "foreach x {8 9} {body c$x s -init_pos \"$x 5 0\"}",
                 1,
                 {5, 0, 0},
                 "Only b, in the list of line 2",
                 "foreach {n x} {a 1 b 5} {body $n s -init_pos \"$x 0 0\"}\n"
                 "foreach x {8 9} {body c$x s -init_pos \"$x 5 0\"}"},
        LoopCase{"PlainWithItsSign",
                 "foreach x {1 2} {body b$x s -init_pos \"[expr {$x + 1}] -5 0\"}",
                 1,
                 {4, 3, 0},
                 "All 2, by as much",
                 "foreach x {1 2} {body b$x s -init_pos \"[expr {$x + 2}] 3 0\"}"}),
    [](const auto& one) { return std::string(one.param.name); });

std::vector<std::string> labels(const std::string& text, std::size_t body, std::vector<double> to) {
    const auto result = reader().read(ballShape + text);
    EXPECT_TRUE(result.usable);
    const Mapper mapper(ballShape + text, std::make_shared<const scene::Scene>(result.scene));
    std::vector<std::string> all;
    for (const Offer& offer : mapper
                                  .answer({.element = {Kind::body, body},
                            .option = "-init_pos",
                            .path = {},
                            .values = std::move(to),
                            .resolution = 0.01})
                                  .offers)
        all.push_back(offer.label);
    return all;
}

TEST(LoopOffer, WritesNoRounding) {
    const std::string text =
        ballShape +
        "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos \"[expr {$i * 0.8 - 1}] 0 0\"}";
    const auto result = reader().read(text);
    ASSERT_TRUE(result.usable);
    const Mapper mapper(text, std::make_shared<const scene::Scene>(result.scene));
    const Answer answer = mapper.answer(
        {.element = {Kind::body, 2}, .option = "-init_pos", .path = {}, .values = {1.6, 0, 0}});
    const auto shift = std::ranges::find(answer.offers, "All 4, by as much", &Offer::label);
    ASSERT_NE(shift, answer.offers.end());
    EXPECT_EQ(shift->edits.front().text, "0");
}

TEST(LoopOffer, IsNotMadeWhereItIsNotUnderstood) {
    // A condition within: who knows which round made which body.
    EXPECT_THAT(labels("foreach x {1 2 3} {if {$x != 2} {body b$x s -init_pos \"$x 0 0\"}}\n", 1,
                       {7, 0, 0}),
                ElementsAre("Only b3"));
    // The list is computed.
    EXPECT_THAT(labels("foreach x [list 1 2] {body b$x s -init_pos \"$x 0 0\"}\n", 1, {7, 0, 0}),
                ElementsAre("Only b2"));
    // y stands there for all: not to be changed for one alone.
    EXPECT_THAT(labels("foreach x {1 2} {body b$x s -init_pos \"$x 0 0\"}\n", 1, {7, 1, 0}),
                ElementsAre("Only b2", "All 2, only the numbers in common"));
}

struct Trap {
    const char* name;
    const char* text;
    std::size_t body;
    std::vector<double> to;
    std::vector<std::string> labels; // of those that are what they say
};

class LoopTraps : public testing::TestWithParam<Trap> {};

// What would give another value, other elements or other names is not offered; what is offered is
// evaluated, and is what it says.
TEST_P(LoopTraps, OfferOnlyWhatTheTextThenGives) {
    const Trap& one = GetParam();
    EXPECT_EQ(labels(one.text, one.body, one.to), one.labels);
    const std::string text = ballShape + one.text;
    const auto before = readScene(text);
    const Mapper mapper(text, before);
    const Answer answer = mapper.answer({.element = {Kind::body, one.body},
                                         .option = "-init_pos",
                                         .path = {},
                                         .values = one.to,
                                         .resolution = 0.01});
    for (const Offer& offer : answer.offers) {
        SCOPED_TRACE(offer.label);
        const auto after = readScene(text::applied(text, offer.edits));
        ASSERT_EQ(namesOf(*after), namesOf(*before));
        for (std::size_t i = 0; i < after->bodies.size(); ++i) {
            const auto& is = after->bodies[i].initialPosition;
            if (i == one.body) {
                EXPECT_LT((is - geometry::Vector(one.to[0], one.to[1], one.to[2])).norm(), 0.02);
            } else if (offer.label.starts_with("Only")) {
                EXPECT_EQ(is, before->bodies[i].initialPosition) << after->bodies[i].name;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, LoopTraps,
    testing::Values(
        // The variable is not what the loop gives it.
        Trap{"SetInside",
             "foreach x {1 2} {set x [expr {$x*2}]; body b[incr n] s -init_pos \"$x 0 0\"}",
             0,
             {5, 0, 0},
             {}},
        Trap{"SetInsideToTheSame",
             "foreach x {0 2} {set x [expr {$x*2}]; body b$x s -init_pos \"$x 0 0\"}",
             0,
             {5, 0, 0},
             {"Only b0"}},
        Trap{"CountedInside",
             "for {set i 0} {$i < 6} {incr i 2} {incr i; body b$i s -init_pos \"[expr {$i * 2}] 0 "
             "0\"}",
             0,
             {5, 0, 0},
             {"Only b1"}},
        Trap{"SetInAProcedure",
             "proc put {n x} {set x [expr {$x + 1}]; body $n s -init_pos \"$x 0 0\"}\n"
             "put a 1\nput b 2\n",
             1,
             {7, 0, 0},
             {"Only b"}},
        // The number makes the name too, or how many there are.
        Trap{"NameFromAList",
             "foreach x {1 2 3} {body b$x s -init_pos \"$x 0 0\"}",
             1,
             {7.25, 0, 0},
             {"Only b2"}},
        Trap{"NameFromTheStep",
             "for {set x 0} {$x < 9} {incr x 2} {body b$x s -init_pos \"$x 0 0\"}",
             2,
             {6, 0, 0},
             {"Only b4"}},
        Trap{"CountFromTheStep",
             "for {set x 0} {$x < 9} {incr x 2} {body b[incr n] s -init_pos \"$x 0 0\"}",
             2,
             {6, 0, 0},
             {}},
        Trap{"StepThatWouldNotEnd",
             "for {set x 0} {$x < 4} {incr x 2} {body b[incr n] s -init_pos \"$x 0 0\"}",
             1,
             {0.1, 0, 0},
             {}},
        // It is read elsewhere.
        Trap{"ListOfTwoLoops",
             "set xs {1 2}\nforeach x $xs {body a[incr n] s -init_pos \"$x 0 0\"}\n"
             "foreach x $xs {body c[incr m] s -init_pos \"$x 5 0\"}",
             1,
             {5, 0, 0},
             {}},
        Trap{"AnotherOptionToo",
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x 0 0\" -mass $x}",
             1,
             {5, 0, 0},
             {"Only b"}},
        Trap{"AnotherElementToo",
             "proc put {n x} {body $n s -init_pos \"$x 0 0\"; force -body $n -y $x}\n"
             "put a 1\nput b 2\n",
             1,
             {5, 0, 0},
             {"Only b"}},
        Trap{"AnotherNumberToo",
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x [expr {2 * $x}] 0\"}",
             1,
             {3, 4, 0},
             {"Only b"}},
        Trap{"ReadBehindTheLoop",
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x 0 0\"}\n"
             "body last s -init_pos \"0 $x 5\"",
             1,
             {5, 0, 0},
             {"Only b"}},
        Trap{"ReadByAProcedure",
             "proc last {} {global x; body last s -init_pos \"0 $x 5\"}\n"
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x 0 0\"}\nlast",
             1,
             {5, 0, 0},
             {"Only b"}},
        Trap{"CommonNumberOfOthersToo",
             "set h 1\nforeach {n x} {a 1 b 2} {body $n s -init_pos \"$x $h 0\"}\n"
             "body c s -init_pos \"0 $h 9\"",
             1,
             {2, 4, 0},
             {"Only b"}},
        Trap{"CommonParameterWithinItsBounds",
             "parameter h -value 1 -min 0 -max 3\n"
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x $h 0\"}",
             1,
             {2, 4, 0},
             {"Only b"}},
        // Put together as text, not worked out.
        Trap{"SignBeforeAVariable",
             "foreach x {1 2} {body b[incr n] s -init_pos \"-$x 0 0\"}",
             1,
             {3, 0, 0},
             {}},
        // Asked for twice it would be another name, or another number for the next.
        Trap{"NameThatCounts",
             "set n 0\nforeach x [list 1 2] {body b[incr n] s -init_pos \"$x 0 0\"}",
             1,
             {5, 0, 0},
             {}},
        Trap{"ValueThatCounts",
             "set n 0\nforeach x {1 2 3} {body b$x s -init_pos \"[incr n] 0 0\"}",
             1,
             {5, 0, 0},
             {}},
        Trap{"ValueOfAProcedure",
             "proc place {i} {set k [expr {$i * 2}]; return \"$k 0 0\"}\n"
             "foreach x {1 2 3} {body b$x s -init_pos [place $x]}",
             1,
             {5, 0, 0},
             {"Only b2"}},
        Trap{"ValueOfAProcedureThatCounts",
             "set k 0\nproc place {} {global k; incr k; return \"$k 0 0\"}\n"
             "foreach x {1 2 3} {body b$x s -init_pos [place]}",
             1,
             {5, 0, 0},
             {}}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(TclValue, IsWhatTclSays) {
    const auto value = [](const std::string& text) {
        const TclNames names{
            [](std::string_view name) {
                return name == "i" ? std::optional(TclNumber{7, true}) : std::nullopt;
            },
            {}};
        const auto result = tclValue(text, {0, text.size()}, names);
        return result ? std::to_string(result->value) + (result->integer ? " int" : "")
                      : std::string("none");
    };
    EXPECT_EQ(value("$i / 2"), "3.000000 int");
    EXPECT_EQ(value("-$i / 2"), "-4.000000 int");
    EXPECT_EQ(value("-7 % 3"), "2.000000 int");
    EXPECT_EQ(value("${i} / 2."), "3.500000");
    EXPECT_EQ(value("2 ** 3 * ($i - 5)"), "16.000000 int");
    EXPECT_EQ(value("-2 ** 2"), "4.000000 int"); // the sign binds first
    EXPECT_EQ(value("2 ** -1"), "0.000000 int");
    EXPECT_EQ(value("(-1) ** -3"), "-1.000000 int");
    EXPECT_EQ(value("2.0 ** -1"), "0.500000");
    EXPECT_EQ(value("0.25 + 0"), "0.250000");
    EXPECT_EQ(value("1 - -1.5e-1 + sqrt(4)"), "3.150000");
    for (const char* what : {"", "$j", "1 +", "rand()", "$i > 2 ? 1 : 0", "[llength $x]", "1 / 0",
                             "0 ** -1", "010", "08 + 1"}) // 010 is 8
        EXPECT_EQ(value(what), "none") << what;
}

TEST(TclValue, EndsHoweverDeepTheTextIs) {
    const std::string deep(100'000, '('), minus(100'000, '-');
    for (const std::string& text : {deep, minus})
        EXPECT_FALSE(tclValue(text, {0, text.size()},
                              {[](std::string_view) { return std::optional<TclNumber>(); }, {}}));
}

} // namespace
} // namespace editing
