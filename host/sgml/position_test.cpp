#include "sgml/position.h"
#include "sgml/utf8.h"

#include <gtest/gtest.h>

namespace sgml {

TEST(Position, CountsLinesOfEveryKindAndColumnsInCharacters) {
    const std::string text = "a\nb\r\nc\rd\xC3\xA9"
                             "e";
    EXPECT_EQ(positionOf(text, 0), (Position{1, 1}));
    EXPECT_EQ(positionOf(text, 1), (Position{1, 2}));
    EXPECT_EQ(positionOf(text, 2), (Position{2, 1}));
    EXPECT_EQ(positionOf(text, 5), (Position{3, 1}));
    EXPECT_EQ(positionOf(text, 7), (Position{4, 1}));
    EXPECT_EQ(positionOf(text, 8), (Position{4, 2}));
    EXPECT_EQ(positionOf(text, 10), (Position{4, 3}));
    EXPECT_EQ(positionOf(text, 11), (Position{4, 4}));
    EXPECT_EQ(positionOf(text, 999), (Position{4, 4}));
}

TEST(Position, AByteOrderMarkTakesNoColumn) {
    EXPECT_EQ(positionOf("\xEF\xBB\xBF"
                         "ab",
                         3),
              (Position{1, 1}));
    EXPECT_EQ(positionOf("\xEF\xBB\xBF"
                         "ab",
                         4),
              (Position{1, 2}));
}

TEST(Position, OffsetOfIsTheInverseAndStaysOnItsLine) {
    const std::string text = "a\nb\xE2\x82\xAC"
                             "c\r\nd";
    for (const std::size_t offset : {0, 1, 2, 3, 6, 7, 9, 10})
        EXPECT_EQ(offsetOf(text, positionOf(text, offset)), offset) << offset;
    EXPECT_EQ(offsetOf(text, {1, 99}), 1u);
    EXPECT_EQ(offsetOf(text, {2, 99}), 7u);
    EXPECT_EQ(offsetOf(text, {99, 1}), text.size());
}

TEST(Utf8, FindsWhatIsIllFormed) {
    struct {
        std::string text;
        Range bad;
    } cases[] = {
        {"abc", {3, 3}},
        {"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x8E\xB2", {9, 9}},
        {"a\xFF"
         "b",
         {1, 2}},
        {"a\xC3", {1, 2}},
        {"\xC0\x80", {0, 2}},
        {"\xED\xA0\x80", {0, 3}},
        {"\xF4\x90\x80\x80z", {0, 4}},
        {"\xE0\x80\x80", {0, 3}},
    };
    for (const auto& [text, bad] : cases)
        EXPECT_EQ(illFormed(text), bad) << text;
}

} // namespace sgml
