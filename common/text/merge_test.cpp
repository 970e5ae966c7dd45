#include "text/merge.h"

#include <gtest/gtest.h>

#include <random>

namespace text {
namespace {

std::string show(const std::string& base, const std::string& mine, const std::string& theirs) {
    const Merge merge = merged(base, mine, theirs);
    std::string text = applied(mine, merge.edits);
    for (std::size_t i = merge.conflicts.size(); i-- > 0;) {
        text.insert(merge.conflicts[i].to, ">");
        text.insert(merge.conflicts[i].from, "<");
    }
    return text;
}

TEST(Merge, TakesWhatOthersDidElsewhere) {
    EXPECT_EQ(show("body b -init_pos {1 0 0}\n", "body b -init_pos {1 0 0} -mass 3\n",
                   "body b -init_pos {2 7 0}\n"),
              "body b -init_pos {2 7 0} -mass 3\n");
    EXPECT_EQ(show("a\nb\nc\n", "new\na\nb\nc\n", "a\nB\nc\n"), "new\na\nB\nc\n");
    EXPECT_EQ(show("a b c d e", "a c d e", "a b c d f"), "a c d f");
}

TEST(Merge, KeepsMineWhereBothDidSomething) {
    EXPECT_EQ(show("mass 1 x", "mass 2 x", "mass 3 x"), "mass <2> x");
    EXPECT_EQ(show("text\n", "text\n# mine\n", "text\n# theirs\n"), "text\n<# mine\n>");
    EXPECT_EQ(show("mass 1 x y", "mass 2 x y", "mass 3 x z"), "mass <2> x z");
    EXPECT_EQ(show("y mass 1 x", "y mass 2 x", "long z mass 3 x"), "long z mass <2> x");
    // The same done twice is no conflict.
    EXPECT_EQ(show("mass 1 x", "mass 2 x", "mass 2 x"), "mass 2 x");
}

// If nobody else did anything, mine stays; if I did nothing, theirs is taken.
TEST(Merge, OfOneSideIsThatSide) {
    std::mt19937 random(11);
    for (int i = 0; i < 1000; ++i) {
        std::string base, other;
        for (unsigned k = 0; k < 30; ++k) {
            base += "w" + std::to_string(random() % 5) + " ";
            other += "w" + std::to_string(random() % 5) + " ";
        }
        EXPECT_EQ(show(base, base, other), other);
        EXPECT_EQ(show(base, other, base), other);
        EXPECT_EQ(show(base, other, other), other);
    }
}

// Two who change other words make one text, whoever merges.
TEST(Merge, OfChangesApartIsBothEitherWay) {
    std::mt19937 random(13);
    for (int i = 0; i < 1000; ++i) {
        std::string base, mine, theirs, both;
        for (int k = 0; k < 40; ++k) {
            const std::string word = "w" + std::to_string(k) + " ";
            const std::string other =
                random() % 3 == 0 ? "" : "n" + std::to_string(random() % 1000) + "\n{} ";
            const unsigned who = k % 3 == 1 ? random() % 3 : 2; // every other third word stays
            base += word;
            mine += who == 0 ? other : word;
            theirs += who == 1 ? other : word;
            both += who < 2 ? other : word;
        }
        EXPECT_EQ(show(base, mine, theirs), both);
        EXPECT_EQ(show(base, theirs, mine), both);
    }
}

// For all edits the mark is on the text that I wrote in the place of some other, and mine is all
// there.
TEST(Merge, ConflictsAreMine) {
    std::mt19937 random(17);
    int conflicts = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string base, mine, theirs;
        for (int k = 0; k < 12; ++k) {
            const std::string word = "w" + std::to_string(k) + " ";
            base += word;
            mine += random() % 4 == 0 ? "m" + std::to_string(k) + " " : word;
            theirs += random() % 4 == 0 ? (random() % 2 == 0 ? "" : "t ") : word;
        }
        const Merge merge = merged(base, mine, theirs);
        const std::string text = applied(mine, merge.edits);
        for (const Range& range : merge.conflicts) {
            const std::string marked = text.substr(range.from, range.to - range.from);
            EXPECT_NE(mine.find(marked), std::string::npos) << base << mine << theirs;
            EXPECT_EQ(marked.front(), 'm') << marked << "\n" << base << mine << theirs;
            ++conflicts;
        }
        for (std::size_t at = mine.find('m'); at != std::string::npos; at = mine.find('m', at + 1))
            EXPECT_NE(text.find(mine.substr(at, mine.find(' ', at) - at + 1)), std::string::npos);
    }
    EXPECT_GT(conflicts, 1000);
}

} // namespace
} // namespace text
