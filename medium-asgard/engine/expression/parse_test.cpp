#include "expression/chained_comparison.h"
#include "expression/parse.h"

#include "expression/testing.h"

#include <gtest/gtest.h>

namespace expression {
namespace {

using testing::parsed;

// The text with a caret line under the wrong bytes, then what is wrong with them.
std::string diagnosis(std::string_view text) {
    Graph graph;
    const auto result = parse(graph, text, testing::symbolOf);
    const auto* error = std::get_if<SyntaxError>(&result);
    if (!error)
        return "right";
    std::string wrong(text.substr(error->from, error->to - error->from));
    return "[" + wrong + "] " + error->message +
           (error->suggestion.empty() ? "" : " | " + error->suggestion);
}

TEST(Parse, FaultsNameTheTextAndSayWhatWasExpected) {
    const std::pair<const char*, const char*> rows[] = {
        {"", "[] expected a value, and the expression is empty"},
        {"1 +", "[+] expected a value, and the expression ends here"},
        {"1 + * 2", "[*] expected a value, not \"*\""},
        {"2 x", "[x] expected an operator before \"x\""},
        {"(1 + 2", "[(] \"(\" is never closed"},
        {"1 + 2)", "[)] \")\" has no \"(\" before it"},
        {"a ? b", "[b] expected \":\" and the value for when the condition is 0, and the "
                  "expression ends here"},
        {"a : b", "[:] \":\" has no \"?\" before it"},
        {"sin", "[sin] \"sin\" is a function | write sin(...)"},
        {"sin()", "[sin()] sin takes one argument, not no"},
        {"1 + sin(1, 2)", "[sin(1, 2)] sin takes one argument, not two"},
        {"atan2(1)", "[atan2(1)] atan2 takes two arguments, not one"},
        {"pow(1, 2, 3)", "[pow(1, 2, 3)] pow takes two arguments, not three"},
        {"min(1)", "[min(1)] min takes two or more arguments, not one"},
        {"sni(1)", "[sni] there is no function sni | did you mean \"sin\"?"},
        {"$h*2", "[$] \"$\" has no meaning in an expression | write a parameter's name without $"},
        {"a = b", "[=] \"=\" has no meaning in an expression | == compares"},
        {"a & b", "[&] \"&\" has no meaning in an expression | write &&"},
        {"0x10", "[0x10] \"0x10\" is not a decimal number"},
        {"3m", "[3m] \"3m\" is not a decimal number"},
        {"1e999", "[1e999] \"1e999\" is too large for a number"},
        {"1,2", "[,] \",\" has no function that it belongs to | numbers are written 1000.5, "
                "without commas"},
        {"a % 2", "[%] \"%\" has no meaning in an expression | the rest of a / b is "
                  "a - b*floor(a/b)"},
        {"mod(a, 2)", "[mod] there is no function mod | the rest of a / b is a - b*floor(a/b)"},
        {"sin(1 2)", "[2] expected an operator or \")\", not \"2\""},
    };
    for (const auto& [text, expected] : rows)
        EXPECT_EQ(diagnosis(text), expected) << text;
}

TEST(Parse, NumbersAreDecimalDoubles) {
    const std::pair<const char*, double> rows[] = {
        {"010", 10},   {".5", 0.5},        {"5.", 5},
        {"1e3", 1000}, {"1E-2", 0.01},     {"1e-999", 0},
        {"0.1", 0.1},  {"5e-324", 5e-324}, {"9007199254740993", 9007199254740992.0}};
    for (const auto& [text, value] : rows) {
        Graph graph;
        EXPECT_EQ(parsed(graph, text), graph.constant(value)) << text;
    }
}

TEST(Parse, OperatorsGroupAsInTclExceptThatPowerBindsTighterThanMinus) {
    const std::pair<const char*, const char*> rows[] = {
        {"a - b - c", "(a - b) - c"},
        {"a/b*c", "(a/b)*c"},
        {"a + b*c", "a + (b*c)"},
        {"-a^2", "-(a^2)"},
        {"a^b^c", "a^(b^c)"},
        {"a^-b", "a^(-b)"},
        {"a < b == c < d", "(a < b) == (c < d)"},
        {"a || b && c", "a || (b && c)"},
        {"a ? b : c ? d : e", "a ? b : (c ? d : e)"},
        {"!a*b", "(!a)*b"},
        {"a < b + c", "a < (b + c)"},
        {"a==b != c", "(a == b) != c"},
        {"- - a", "a"},
        {"+a", "a"},
        {"a\n + \t b", "a+b"},
        {"a ** b", "a ^ b"},
    };
    for (const auto& [text, same] : rows) {
        Graph graph;
        EXPECT_EQ(parsed(graph, text), parsed(graph, same)) << text;
    }
}

TEST(Parse, CallsThatAreNotBuiltInReachTheNamesWithTheirArguments) {
    Graph graph;
    std::string seen;
    const Names names = [&](Graph& g, std::string_view name, std::span<const Node> arguments,
                            bool isCall) -> Meaning {
        seen += std::string(name) + '/' + std::to_string(arguments.size()) + (isCall ? "() " : " ");
        return {g.symbol(name), "", ""};
    };
    EXPECT_TRUE(std::holds_alternative<Node>(parse(graph, "B.px(1, 2, t) + B.x", names)));
    EXPECT_EQ(seen, "t/0 B.px/3() B.x/0 ");
}

TEST(Parse, TwoComparisonsInARowAreDoubtedWhereTheyStand) {
    const auto doubted = [](std::string_view text) {
        const auto doubt = chainedComparison(text);
        return doubt ? text.substr(doubt->from, doubt->to - doubt->from) : "";
    };
    EXPECT_EQ(doubted("0 < x < 1"), "< x <");
    EXPECT_EQ(doubted("y + sin(0 <= x + (2 < 3) >= 1)"), "<= x + (2 < 3) >=");
    for (const char* clear : {"(0 < x) < 1", "0 < x && x < 1", "a < b == c < d",
                              "a < b ? c < d : e < f", "max(a < b, c < d)", "a < b", "$ < <"})
        EXPECT_EQ(doubted(clear), "") << clear;
}

std::string repeated(std::string_view text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i)
        all += text;
    return all;
}

TEST(Parse, NestingAndLengthHaveLimitsAndEndInAMessage) {
    const std::string tooDeep = "[(] the expression is nested more than 200 levels deep";
    EXPECT_EQ(diagnosis(repeated("(", 100'000)), tooDeep);
    EXPECT_EQ(diagnosis(repeated("-", 99'999)).substr(3), tooDeep.substr(3));
    EXPECT_NE(diagnosis(repeated("sin(", 20'000)).find("200 levels"), std::string::npos);
    EXPECT_NE(diagnosis(repeated("x^", 20'000)).find("200 levels"), std::string::npos);
    EXPECT_NE(diagnosis(repeated("1", 100'001)).find("100,000 bytes"), std::string::npos);
    EXPECT_EQ(diagnosis(repeated("(", 90) + "x" + repeated(")", 90)), "right");
    EXPECT_EQ(diagnosis(repeated("sin(x)*3+", 11'000) + "x"), "right");
}

// Whatever the bytes are, there is a node or a message with a range inside the text.
TEST(Parse, EveryTextHasAnAnswer) {
    const char letters[] = "x1.e+-*/^()?:<>=!&|, $sin\n";
    std::uint32_t state = 12345;
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (int j = 0; j < 12; ++j) {
            state = state * 1664525u + 1013904223u;
            text += letters[(state >> 16) % (sizeof letters - 1)];
        }
        Graph graph;
        const auto result = parse(graph, text, testing::symbolOf);
        if (const auto* error = std::get_if<SyntaxError>(&result)) {
            EXPECT_LE(error->from, error->to) << text;
            EXPECT_LE(error->to, text.size()) << text;
            EXPECT_FALSE(error->message.empty()) << text;
        }
    }
}

} // namespace
} // namespace expression
