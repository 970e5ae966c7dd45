// (text, gesture, offered texts) where loops and procedures make elements.
#include "editing/loop_values.h"
#include "editing/tcl_expression.h"
#include "editing/test_reading.h"

#include <gmock/gmock.h>

namespace editing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string ball = "shape_set s -desc {-sub {-sphere 1}}\n";

struct Case {
    const char* name;
    const char* text;
    std::size_t body;
    std::vector<double> to;
    const char* label;
    const char* after;
};

class LoopOffers : public testing::TestWithParam<Case> {};

TEST_P(LoopOffers, MakeTheValueWhatItIsToBe) {
    const Case& one = GetParam();
    const std::string text = ball + one.text;
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
        EXPECT_EQ(applied(text, offer.edits), ball + one.after);
        const auto after = reader().read(applied(text, offer.edits));
        ASSERT_TRUE(after.usable);
        const auto& place = after.scene.bodies[one.body].initialPosition;
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(place[i], one.to[static_cast<std::size_t>(i)], 0.011);
        return;
    }
    FAIL() << "offered: " << labels;
}

INSTANTIATE_TEST_SUITE_P(
    All, LoopOffers,
    testing::Values(
        Case{"Factor",
             "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos \"[expr {$i * 2}] 0 0\"}",
             3,
             {7.5, 0, 0},
             "The step: 2 becomes 2.5",
             "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos \"[expr {$i * 2.5}] 0 0\"}"},
        Case{"Divisor",
             "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos [list [expr {$i / 2.0}] 0 0]}",
             2,
             {2, 0, 0},
             "The step: 2.0 becomes 1.0",
             "for {set i 0} {$i < 4} {incr i} {body b$i s -init_pos [list [expr {$i / 1.0}] 0 0]}"},
        Case{"Offset",
             "foreach i {1 2 3} {\n  body b$i s -init_pos \"[expr {0.5 + $i}] 0 0\"\n}",
             1,
             {3.25, 0, 0},
             "All 3, by as much",
             "foreach i {1 2 3} {\n  body b$i s -init_pos \"[expr {1.25 + $i}] 0 0\"\n}"},
        Case{"Element",
             "foreach x {-1  2.50 4} {body b[incr n] s -init_pos \"$x 0 0\"} ;# row",
             1,
             {3, 0, 0},
             "Only b2, in the list of line 2",
             "foreach x {-1  3.00 4} {body b[incr n] s -init_pos \"$x 0 0\"} ;# row"},
        Case{"Pairs",
             "foreach {n x} {a 1 b 2} {body $n s -init_pos \"$x [expr {2 * $x}] 0\"}",
             1,
             {3, 6, 0},
             "Only b, in the list of line 2",
             "foreach {n x} {a 1 b 3} {body $n s -init_pos \"$x [expr {2 * $x}] 0\"}"},
        Case{"Call",
             "proc put {n x} {body $n s -init_pos \"$x 0 0\"}\nput a 1\nput b 2 ;# here\n",
             1,
             {-3, 0, 0},
             "Only b, in its call in line 4",
             "proc put {n x} {body $n s -init_pos \"$x 0 0\"}\nput a 1\nput b -3 ;# here\n"},
        Case{"StepOfTheLoop",
             "for {set x 0} {$x < 9} {incr x 2} {body b$x s -init_pos \"$x 0 0\"}",
             2,
             {6, 0, 0},
             "The step of the loop: 2 becomes 3",
             "for {set x 0} {$x < 9} {incr x 3} {body b$x s -init_pos \"$x 0 0\"}"}),
    [](const auto& one) { return std::string(one.param.name); });

std::vector<std::string> labels(const std::string& text, std::size_t body, std::vector<double> to) {
    const auto result = reader().read(ball + text);
    EXPECT_TRUE(result.usable);
    const Mapper mapper(ball + text, std::make_shared<const scene::Scene>(result.scene));
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
        ball +
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
                ElementsAre("Only b2", "All 2"));
}

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
    EXPECT_EQ(value("1 - -1.5e-1 + sqrt(4)"), "3.150000");
    for (const char* what : {"", "$j", "1 +", "rand()", "$i > 2 ? 1 : 0", "[llength $x]", "1 / 0"})
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
