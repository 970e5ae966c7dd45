#include "text/difference.h"

#include <gtest/gtest.h>

#include <random>

namespace text {
namespace {

TEST(Difference, IsTheSmallestAndKeepsCharactersWhole) {
    EXPECT_EQ(difference("abc", "abc"), (Edit{{3, 3}, ""}));
    EXPECT_EQ(difference("abc", "abXc"), (Edit{{2, 2}, "X"}));
    EXPECT_EQ(difference("aaa", "aa"), (Edit{{2, 3}, ""}));
    EXPECT_EQ(difference("", "new"), (Edit{{0, 0}, "new"}));
    // a-umlaut (C3 A4) to o-umlaut (C3 B6): the common first byte belongs to the character.
    EXPECT_EQ(difference("x\xC3\xA4y", "x\xC3\xB6y"), (Edit{{1, 3}, "\xC3\xB6"}));
    // ... and a common last byte too (C3 A4 to C2 A4).
    EXPECT_EQ(difference("x\xC3\xA4y", "x\xC2\xA4y"), (Edit{{1, 3}, "\xC2\xA4"}));
}

TEST(Difference, AppliedGivesTheOtherText) {
    std::mt19937 random(6);
    const auto text = [&] {
        std::string s;
        for (unsigned i = random() % 12; i > 0; --i)
            s += std::string(random() % 3 == 0 ? "\xC3\xA4" : random() % 2 == 0 ? "a" : "b");
        return s;
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string before = text(), after = text();
        ASSERT_EQ(applied(before, {difference(before, after)}), after);
    }
}

TEST(Differences, AreTheWordsThatDiffer) {
    using Hunks = std::vector<Hunk>;
    EXPECT_EQ(differences("a b c", "a b c"), Hunks{});
    EXPECT_EQ(differences("pos {1 0 0}", "pos {2 0 5}"),
              (Hunks{{{5, 6}, {5, 6}}, {{9, 10}, {9, 10}}}));
    EXPECT_EQ(differences("", "new"), (Hunks{{{0, 0}, {0, 3}}}));
    EXPECT_EQ(differences("old", ""), (Hunks{{{0, 3}, {0, 0}}}));
    EXPECT_EQ(differences("-4.37", "-4.38"), (Hunks{{{1, 5}, {1, 5}}}));
    // The common ends of two texts may end within a word, or between blanks.
    EXPECT_EQ(differences("ab cd", "abx xcd"), (Hunks{{{0, 2}, {0, 3}}, {{3, 5}, {4, 7}}}));
    EXPECT_EQ(differences("a  b", "a   b"), (Hunks{{{1, 3}, {1, 4}}}));
}

// For all texts the stretches make the one of the other, and what is between them is equal.
TEST(Differences, MakeOneTextOfTheOther) {
    std::mt19937 random(7);
    const auto textOf = [&](std::size_t length) {
        std::string text;
        for (std::size_t i = 0; i < length; ++i)
            text += "ab \n{}1"[random() % 7];
        return text;
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string a = textOf(random() % 40), b = textOf(random() % 40);
        EXPECT_EQ(applied(a, editsBetween(a, b)), b);
    }
    // More differences than are looked for.
    std::string a, b;
    for (int i = 0; i < 2000; ++i) {
        a += "a" + std::to_string(i) + " ";
        b += "b" + std::to_string(i) + "\n";
    }
    EXPECT_EQ(differences(a, b).size(), 1U);
}

// Equal lines stay apart from others even if too many words differ.
TEST(Differences, OfManyWordsGoLineByLine) {
    std::string a, b;
    for (int i = 0; i < 100; ++i) {
        a += "line " + std::to_string(i) + " of one\n";
        b += "line " + std::to_string(i) + (i % 2 == 0 ? " of one\n" : " a b c d e f g h\n");
    }
    const std::vector<Hunk> hunks = differences(a, b);
    EXPECT_GE(hunks.size(), 50U);
    EXPECT_EQ(applied(a, editsBetween(a, b)), b);
    for (const Hunk& hunk : hunks)
        EXPECT_LE(hunk.before.size(), 20U);
}

} // namespace
} // namespace text
