#include "document/value_use.h"

#include <gmock/gmock.h>

namespace document {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

ValueUse valueIn(const std::string& attributes) {
    const sgml::Tree tree =
        sgml::Tree::parse("DOCUMENT A\n<A>\n<VALUE " + attributes + "></VALUE>\n</A>\n");
    return valueUse(tree, tree.childElement(tree.classElement(tree.root()), "VALUE"));
}

TEST(ValueUse, AnElementSaysWhichValueAndHowItIsWritten) {
    const ValueUse use =
        valueIn(R"(OF="swing" EXPRESSION=" bob.y " FORMAT="2 decimals" TIME="1.5 s")");
    EXPECT_EQ(use,
              (ValueUse{.of = "swing", .expression = "bob.y", .time = 1.5, .digits = {2, true}}));
    EXPECT_EQ(valueIn(R"(OF="a" EXPRESSION="b" FORMAT="1 digit" TIME="-2")"),
              (ValueUse{.of = "a", .expression = "b", .time = -2.0, .digits = {1, false}}));
    EXPECT_EQ(valueIn(R"(OF="a" EXPRESSION="b")"), (ValueUse{.of = "a", .expression = "b"}));
}

TEST(ValueUse, WhatCannotBeMeantIsAFault) {
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" FORMAT="0.00")").fault, HasSubstr("FORMAT"));
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" FORMAT="0 digits")").fault, HasSubstr("FORMAT"));
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" FORMAT="13 decimals")").fault,
                HasSubstr("FORMAT"));
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" FORMAT="1.5 digits")").fault, HasSubstr("FORMAT"));
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" TIME="soon")").fault, HasSubstr("TIME"));
    EXPECT_THAT(valueIn(R"(OF="a" EXPRESSION="b" TIME="nan")").fault, HasSubstr("TIME"));
    EXPECT_THAT(valueIn(R"(OF="a")").fault, HasSubstr("expression"));
    EXPECT_THAT(valueIn(R"(EXPRESSION="b")").fault, HasSubstr("ID"));
}

TEST(ValueUse, AFormulaSpellsItsOptionsInOneText) {
    EXPECT_EQ(valueUse("a", "b", " 2 decimals, at 1.5 s "),
              (ValueUse{.of = "a", .expression = "b", .time = 1.5, .digits = {2, true}}));
    EXPECT_EQ(valueUse("a", "b", ""), (ValueUse{.of = "a", .expression = "b"}));
    EXPECT_THAT(valueUse("a", "b", "2 apples").fault, HasSubstr("\"2 apples\""));
    for (const char* options : {"", "2 decimals", "at 0.25 s", "1 digit, at -3 s"}) {
        EXPECT_EQ(spelledOptions(valueUse("a", "b", options)), options);
        EXPECT_THAT(valueUse("a", "b", options).fault, IsEmpty());
    }
}

} // namespace
} // namespace document
