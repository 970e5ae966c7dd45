#include "batch/input.h"
#include "batch/table.h"
#include "physics/assembly.h"

#include <gmock/gmock.h>

namespace batch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> at(const std::string& range) {
    const auto times = timesAt(range);
    return std::holds_alternative<Refusal>(times) ? std::vector<double>{-1}
                                                  : std::get<std::vector<double>>(times);
}

TEST(Times, ARangeEndsWithItsLastTimeExactly) {
    EXPECT_THAT(at("0:0.1:0.3"), ElementsAre(0, 0.1, 0.2, 0.3)); // not 0.30000000000000004
    EXPECT_THAT(at("0:0.25:0.6"), ElementsAre(0, 0.25, 0.5));
    EXPECT_THAT(at("2:1:2"), ElementsAre(2));
    EXPECT_EQ(at("0:0.001:10").size(), 10001u);
    EXPECT_EQ(at("0:0.001:10").back(), 10);
    for (const char* wrong :
         {"", "0:1", "0:0:1", "0:-1:1", "1:0.1:0", "0:1:x", "0:1e-30:1", "nan:1:2", "0:1:inf"})
        EXPECT_THAT(at(wrong), ElementsAre(-1)) << wrong;
}

TEST(Times, AFileHoldsThemInAnyOrder) {
    const auto times = timesIn("1\n0.5, 2e-1 # three\n\n 4\n", "f.times");
    EXPECT_THAT(std::get<std::vector<double>>(times), ElementsAre(1, 0.5, 0.2, 4));
    EXPECT_THAT(std::get<Refusal>(timesIn("1\nx\n", "f.times")).message,
                HasSubstr("f.times:2: error: \"x\""));
}

TEST(Times, UsualOnesAreAHundredAndOne) {
    const auto times = usualTimes(0.1, 0.7);
    EXPECT_EQ(times.size(), 101u);
    EXPECT_EQ(times.front(), 0.1);
    EXPECT_EQ(times.back(), 0.7);
}

TEST(Faults, NameTheCommandThatClosesAJoint) {
    SceneText scene{"swing.al", "", {}};
    scene::Diagnostic said;
    said.message =
        "joint \"pin\": its bodies miss each other by 0.5 at the start; " + physics::closeAdvice();
    EXPECT_THAT(placed(scene, said), HasSubstr("or let \"asgard assemble SCENE\" place them"));
    EXPECT_THAT(said.message, HasSubstr("Close It"));
    EXPECT_THAT(said.message, testing::Not(HasSubstr("asgard"))); // in a window
}

TEST(Quantities, AreSplitAtCommasOutsideParentheses) {
    EXPECT_THAT(quantitiesIn("b.x, max(a.x,b.x) ,b.px(1,(2),3)"),
                ElementsAre("b.x", "max(a.x,b.x)", "b.px(1,(2),3)"));
    EXPECT_THAT(quantitiesIn("t"), ElementsAre("t"));
}

TEST(Settings, WantANameAndANumber) {
    const auto values = std::get<0>(settings({"a=1", "b=-2e3", "a=3"}));
    EXPECT_EQ(values, (std::map<std::string, double>{{"a", 3}, {"b", -2000}}));
    for (const char* wrong : {"a", "=1", "a=", "a=x", "a=1x", "a=inf", "a=nan"})
        EXPECT_EQ(std::get<Refusal>(settings({wrong})).exitCode, 2) << wrong;
}

TEST(Settings, KeepToTheBoundsOfTheirParameter) {
    scene::Scene scene;
    scene.parameters.push_back({"k", 1, 0.5, 2, "", "", {}});
    EXPECT_FALSE(outOfBounds(scene, {{"k", 0.5}}));
    EXPECT_THAT(outOfBounds(scene, {{"k", 0.4}})->message, HasSubstr("under its minimum 0.5"));
    EXPECT_THAT(outOfBounds(scene, {{"k", 3}})->message, HasSubstr("over its maximum 2"));
}

TEST(Table, CellsAreQuotedWhereTheyMustBeAndNumbersReadBackTheSame) {
    EXPECT_EQ(cell("max(a,b)"), "\"max(a,b)\"");
    EXPECT_EQ(cell("a\"b"), "\"a\"\"b\"");
    EXPECT_EQ(cell("b.x"), "b.x");
    EXPECT_EQ(std::stod(cell(0.1)), 0.1);
    EXPECT_EQ(cell(std::nan("")), "");
}

} // namespace
} // namespace batch
