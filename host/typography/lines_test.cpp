// The best lines of paragraphs of words whose widths are told.
#include "typography/lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace typography {
namespace {

// Words of these widths with blanks of width 3 between them.
std::vector<Break> wordsOf(const std::vector<double>& widths) {
    std::vector<Break> result;
    double x = 0, blanks = 0;
    for (const double width : widths) {
        Break one;
        x += width;
        one.end = x;
        one.blanksAtEnd = blanks;
        x += 3;
        blanks += 3;
        one.begin = x;
        one.blanksAtBegin = blanks;
        one.next = static_cast<int>(result.size()) + 1;
        result.push_back(one);
    }
    return result;
}

using Ends = std::vector<std::size_t>;

TEST(LinesTest, AreTheBestTogetherNotTheLongest) {
    // The longest first line would leave a second one that is far too loose.
    const auto words = wordsOf({10, 10, 10, 10, 30, 20});
    const Column column{.firstWidth = 49, .width = 49, .ragged = true};
    EXPECT_EQ(bestLines(words, column, anything), (Ends{2, 4, 5}));
}

TEST(LinesTest, JustifiedLinesAreStretchedOrShrunk) {
    const auto words = wordsOf({20, 20, 20, 20, 20, 20});
    EXPECT_EQ(bestLines(words, {.firstWidth = 64, .width = 64}, fine), (Ends{2, 5})); // 66, shrunk
    EXPECT_EQ(bestLines(words, {.firstWidth = 68, .width = 68}, fine), (Ends{2, 5}));
    EXPECT_EQ(bestLines(words, {.firstWidth = 76, .width = 76}, fine), std::nullopt);
    EXPECT_EQ(bestLines(words, {.firstWidth = 76, .width = 76}, anything), (Ends{2, 5}));
    EXPECT_DOUBLE_EQ(stretchOf(66, 6, 69), 0.5);
    EXPECT_DOUBLE_EQ(stretchOf(66, 6, 60), -1.0 / 3);
}

TEST(LinesTest, ALineEndsWhereItMustAndNeverWhereItCannot) {
    auto words = wordsOf({10, 10, 10, 10});
    words[0].forced = true;
    EXPECT_EQ(bestLines(words, {.firstWidth = 100, .width = 100}, fine), (Ends{0, 3}));
    // Wider than any line: it stands alone, too long.
    EXPECT_EQ(bestLines(wordsOf({10, 90, 10}), {.firstWidth = 30, .width = 30}, anything),
              (Ends{0, 1, 2}));
}

TEST(LinesTest, TheLastLineIsNoShortSyllable) {
    const auto words = wordsOf(std::vector<double>(25, 5));
    Column column{.firstWidth = 100, .width = 100, .ragged = true};
    EXPECT_EQ(bestLines(words, column, anything), (Ends{11, 23, 24}));
    column.leastOfLast = 10;
    EXPECT_EQ(bestLines(words, column, anything), (Ends{11, 22, 24}));
    column.leastOfLast = 60; // other lines would be too short for it
    EXPECT_EQ(bestLines(words, column, fine), std::nullopt);
}

TEST(LinesTest, TwoHyphensInARowAreAvoided) {
    auto words = wordsOf(std::vector<double>(39, 5));
    for (const std::size_t at : {12U, 25U}) { // parts of words
        words[at].hyphen = 2;
        words[at].cost = atHyphen;
    }
    for (const int at : {26, 24, 13, 11}) // no lines end beside them
        words.erase(words.begin() + at);
    const auto ends = bestLines(words, {.firstWidth = 100, .width = 100}, anything);
    ASSERT_TRUE(ends);
    const auto hasHyphen = [&](std::size_t end) { return words[end].hyphen > 0; };
    EXPECT_LT(std::ranges::count_if(*ends, hasHyphen), 2);
}

TEST(LinesTest, EvenLinesShareTheirWords) {
    const auto words = wordsOf({20, 20, 20, 20, 20});
    const Column column{.firstWidth = 89, .width = 89, .ragged = true, .even = true};
    EXPECT_EQ(bestLines(words, column, anything), (Ends{2, 4})); // not 3 and 1
}

TEST(LinesTest, TheWorkGrowsWithTheLength) {
    std::mt19937 random(1);
    const auto workFor = [&](std::size_t count, double most) {
        std::vector<double> widths(count);
        for (double& width : widths)
            width = 5 + static_cast<double>(random() % 10);
        const std::size_t before = comparisons();
        (void)bestLines(wordsOf(widths), {.firstWidth = 500, .width = 500}, most);
        return comparisons() - before;
    };
    for (const double most : {fine, anything}) {
        const std::size_t once = workFor(2000, most), twice = workFor(4000, most);
        EXPECT_LE(twice, 2 * once + once / 4);
        EXPECT_LT(once, 2000U * 150);
    }
}

// Against all ways there are.
TEST(LinesTest, NoOtherLinesAreMoreEven) {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        std::vector<double> widths(10);
        for (double& width : widths)
            width = 5 + static_cast<double>(random() % 20);
        const auto words = wordsOf(widths);
        constexpr double column = 50;
        const auto raggedness = [&](const Ends& ends) {
            double sum = 0, begin = 0;
            for (const std::size_t end : ends) {
                const double free = column - (words[end].end - begin);
                if (free < 0)
                    return 1e18;
                const double badness =
                    end + 1 == words.size() ? 0 : 100 * std::pow(free / (0.2 * column), 3);
                sum += (10 + badness) * (10 + badness);
                begin = words[end].begin;
            }
            return sum;
        };
        double least = 1e18;
        for (unsigned way = 0; way < 1U << 9; ++way) {
            Ends ends;
            for (std::size_t i = 0; i < 9; ++i)
                if (way >> i & 1U)
                    ends.push_back(i);
            ends.push_back(9);
            least = std::min(least, raggedness(ends));
        }
        const auto found =
            bestLines(words, {.firstWidth = column, .width = column, .ragged = true}, anything);
        ASSERT_TRUE(found);
        EXPECT_DOUBLE_EQ(raggedness(*found), least);
    }
}

} // namespace
} // namespace typography
