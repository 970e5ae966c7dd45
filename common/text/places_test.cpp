#include "text/places.h"

#include "text/characters.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace text {

TEST(Places, CountLinesOfEveryKindAndColumnsInCharacters) {
    const std::string text = "a\nb\r\nc\rd\xC3\xA9"
                             "e";
    const Places places(text);
    EXPECT_EQ(places.at(0), (Position{1, 1}));
    EXPECT_EQ(places.at(1), (Position{1, 2}));
    EXPECT_EQ(places.at(2), (Position{2, 1}));
    EXPECT_EQ(places.at(4), (Position{2, 3})); // between CR and LF
    EXPECT_EQ(places.at(5), (Position{3, 1}));
    EXPECT_EQ(places.at(7), (Position{4, 1}));
    EXPECT_EQ(places.at(8), (Position{4, 2}));
    EXPECT_EQ(places.at(9), (Position{4, 2})); // within a character
    EXPECT_EQ(places.at(10), (Position{4, 3}));
    EXPECT_EQ(places.at(11), (Position{4, 4}));
    EXPECT_EQ(places.at(999), (Position{4, 4}));
    EXPECT_EQ(Places("").at(0), (Position{1, 1}));
}

TEST(Places, AByteOrderMarkTakesNoColumn) {
    const Places places("\xEF\xBB\xBF"
                        "ab");
    EXPECT_EQ(places.at(0), (Position{1, 1}));
    EXPECT_EQ(places.at(3), (Position{1, 1}));
    EXPECT_EQ(places.at(4), (Position{1, 2}));
    EXPECT_EQ(places.offset({1, 1}), 3U);
}

TEST(Places, AreFoundAgainAndStayOnTheirLine) {
    const std::string text = "a\nb\xE2\x82\xAC"
                             "c\r\nd";
    const Places places(text);
    for (const std::size_t offset : {0, 1, 2, 3, 6, 7, 9, 10})
        EXPECT_EQ(places.offset(places.at(offset)), offset) << offset;
    EXPECT_EQ(places.offset({1, 99}), 1u);
    EXPECT_EQ(places.offset({2, 99}), 7u);
    EXPECT_EQ(places.offset({99, 1}), text.size());
    EXPECT_EQ(places.offset({0, 0}), 0u);
}

// The slow way checks the quick one, over the bounds of blocks and with bytes that are no UTF-8.
TEST(Places, AreThoseOfOneWhoWalksThroughTheText) {
    std::mt19937 random(5);
    for (int round = 0; round < 50; ++round) {
        std::string text;
        for (std::size_t length = random() % 1200; text.size() < length;)
            text += std::vector<std::string>{"a",    "b",        "\n",
                                             "\r\n", "\xC3\xA4", "\xF0\x9F\x8E\xB2",
                                             "\x80", "\xFF"}[random() % 8];
        const Places places(text);
        Position walked{1, 0};
        for (std::size_t at = 0; at < text.size(); ++at) {
            walked.column += isContinuation(text[at]) ? 0 : 1;
            const Position expected{walked.line, std::max(walked.column, 1)};
            ASSERT_EQ(places.at(at), expected) << at;
            const bool isInLineEnd = text[at] == '\n' && at > 0 && text[at - 1] == '\r';
            if (!isInLineEnd) {
                ASSERT_EQ(places.at(places.offset(expected)), expected) << at;
            }
            if (text[at] == '\n')
                walked = {walked.line + 1, 0};
        }
    }
}

} // namespace text
