#include "sgml/braces.h"
#include "sgml/escape.h"
#include "sgml/random_document.h"

#include <gtest/gtest.h>

namespace sgml {

TEST(Escape, Spellings) {
    struct {
        std::string spelling, text;
    } cases[] = {
        {"\\{a\\}", "{a}"}, {"{a}", "{a}"},       {"a\\b", "a\\b"},
        {"a\\\\b", "a\\b"}, {"\\\\{x}", "\\{x}"}, {"\\\\\\{", "\\{"},
    };
    for (const auto& [spelling, text] : cases)
        EXPECT_EQ(Unescaped(spelling).text(), text) << spelling;
    EXPECT_EQ(escaped("{a\\}"), "\\{a\\\\\\}");
}

// An escaped character stands at its backslash; what comes after it has moved by one.
TEST(Escape, OffsetsGoBothWays) {
    const Unescaped unescaped("a\\{b\\}c", 100);
    EXPECT_EQ(unescaped.text(), "a{b}c");
    const std::size_t file[] = {100, 101, 103, 104, 106, 107};
    for (std::size_t offset = 0; offset <= 5; ++offset) {
        EXPECT_EQ(unescaped.fileOffset(offset), file[offset]);
        EXPECT_EQ(unescaped.textOffset(file[offset]), offset);
    }
    EXPECT_EQ(unescaped.textOffset(102), 1u); // the brace behind its backslash
    EXPECT_EQ(unescaped.textOffset(5), 0u);
    EXPECT_EQ(unescaped.textOffset(999), 5u);
}

TEST(Escape, RandomTextsSurviveAndTheirOffsetsAgree) {
    RandomDocument random(7);
    for (int i = 0; i < 2000; ++i) {
        const std::string text = random.text(20);
        const std::string spelling = escaped(text);
        const Unescaped unescaped(spelling, 10);
        ASSERT_EQ(unescaped.text(), text);
        for (std::size_t offset = 0; offset <= text.size(); ++offset)
            ASSERT_EQ(unescaped.textOffset(unescaped.fileOffset(offset)), offset) << spelling;
        ASSERT_EQ(closingBrace("{" + spelling + "}", 0), spelling.size() + 1) << spelling;
    }
}

TEST(Braces, OnePassAgreesWithTheSearchFromEachBrace) {
    RandomDocument random(8);
    for (int i = 0; i < 2000; ++i) {
        const std::string text = random.text(40);
        const std::vector<std::size_t> unclosed = unclosedBraces(text);
        const auto pairs = bracePairs(text);
        for (const auto& [brace, partner] : pairs)
            ASSERT_EQ(closingBrace(text, std::min(brace, partner)), std::max(brace, partner))
                << text;
        for (const std::size_t brace : unclosed)
            ASSERT_EQ(closingBrace(text, brace), std::string::npos) << text;
    }
}

} // namespace sgml
