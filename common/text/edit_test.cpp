#include "text/edit.h"

#include <gtest/gtest.h>

#include <random>

namespace text {
namespace {

TEST(Edits, InverseAndMovedBytes) {
    const std::string text = "0123456789";
    const Edits edits = {{{2, 4}, "abc"}, {{6, 6}, "--"}};
    ASSERT_TRUE(areOrdered(edits, text.size()));
    EXPECT_EQ(applied(text, edits), "01abc45--6789");
    EXPECT_EQ(applied(applied(text, edits), inverse(text, edits)), text);
    EXPECT_EQ(movedByte(1, edits), 1u);
    EXPECT_EQ(movedByte(2, edits), std::nullopt);
    EXPECT_EQ(movedByte(5, edits), 6u);
    EXPECT_EQ(movedByte(6, edits), 9u);
}

TEST(Edits, ThatAreNotInOrderAndApartChangeNothing) {
    EXPECT_EQ(applied("abcdef", {{{1, 2}, "X"}, {{2, 2}, "+"}, {{4, 6}, ""}}), "aX+cd");
    for (const Edits& wrong :
         {Edits{{{4, 6}, ""}, {{1, 2}, "X"}}, Edits{{{1, 3}, "X"}, {{2, 4}, "Y"}},
          Edits{{{5, 7}, "X"}}, Edits{{{3, 2}, "X"}}, Edits{{{7, 7}, "X"}}}) {
        EXPECT_FALSE(areOrdered(wrong, 6));
        EXPECT_EQ(applied("abcdef", wrong), "abcdef");
    }
    Edits mixed = {{{3, 4}, "D"}, {{3, 3}, "1"}, {{0, 1}, "A"}, {{3, 3}, "2"}};
    putInOrder(mixed);
    EXPECT_EQ(applied("abcdef", mixed), "Abc12Def");
}

TEST(Edits, AreJoinedOnceAndNeverOverlap) {
    Edits edits;
    EXPECT_TRUE(join(edits, {{3, 5}, "a"}));
    EXPECT_TRUE(join(edits, {{3, 5}, "a"}));
    EXPECT_EQ(edits.size(), 1u);
    EXPECT_FALSE(join(edits, {{3, 5}, "b"}));
    EXPECT_FALSE(join(edits, {{4, 4}, "b"}));
    EXPECT_FALSE(join(edits, {{4, 7}, "b"}));
    EXPECT_TRUE(join(edits, {{5, 5}, "c"}));
    EXPECT_TRUE(join(edits, {{5, 7}, "d"}));
    EXPECT_EQ(edits.size(), 3u);
}

TEST(Edits, MoveAPlaceByItsGravity) {
    const Edits edits = {{{2, 2}, "ab"}, {{4, 7}, "x"}, {{8, 9}, ""}};
    const auto before = [&](std::size_t place) { return moved(place, edits, Gravity::before); };
    const auto behind = [&](std::size_t place) { return moved(place, edits, Gravity::behind); };
    EXPECT_EQ(before(1), 1u);
    EXPECT_EQ(before(2), 2u); // text comes in here
    EXPECT_EQ(behind(2), 4u);
    EXPECT_EQ(before(4), 6u); // the ends of what is replaced stay its ends
    EXPECT_EQ(behind(4), 6u);
    EXPECT_EQ(before(5), 6u); // inside: the end that the gravity names
    EXPECT_EQ(behind(5), 7u);
    EXPECT_EQ(before(7), 7u);
    EXPECT_EQ(behind(7), 7u);
    EXPECT_EQ(before(8), 8u);
    EXPECT_EQ(behind(9), 8u);
    EXPECT_EQ(before(12), 11u);
}

// Bytes that stood before a place still stand before it, and those behind it, behind it.
TEST(Edits, MovedPlacesKeepTheirOrderAndTheirNeighbours) {
    std::mt19937 random(3);
    for (int round = 0; round < 2000; ++round) {
        const std::string text = "0123456789abcdef";
        Edits edits;
        for (std::size_t at = random() % 4; at < text.size(); at += 1 + random() % 4) {
            const std::size_t to = std::min(at + random() % 4, text.size());
            edits.push_back({{at, to}, std::string(random() % 3, '#')});
            at = to;
        }
        ASSERT_TRUE(areOrdered(edits, text.size()));
        const std::string after = applied(text, edits);
        for (const Gravity gravity : {Gravity::before, Gravity::behind}) {
            std::size_t last = 0;
            for (std::size_t place = 0; place <= text.size(); ++place) {
                const std::size_t now = moved(place, edits, gravity);
                ASSERT_LE(now, after.size());
                ASSERT_GE(now, last);
                last = now;
                const auto next = place < text.size() ? movedByte(place, edits) : std::nullopt;
                const auto previous = place > 0 ? movedByte(place - 1, edits) : std::nullopt;
                ASSERT_LE(now, next.value_or(now));
                ASSERT_TRUE(!next || after[*next] == text[place]);
                ASSERT_TRUE(!previous || *previous < now);
            }
        }
    }
}

} // namespace
} // namespace text
