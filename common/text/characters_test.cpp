#include "text/characters.h"

#include <gtest/gtest.h>

namespace text {

TEST(Characters, FindWhatIsIllFormed) {
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

TEST(Characters, AreNotCut) {
    const std::string text = "a\xE2\x82\xAC";
    EXPECT_FALSE(isInsideCharacter(text, 1));
    EXPECT_TRUE(isInsideCharacter(text, 2));
    EXPECT_FALSE(isInsideCharacter(text, 4));
    EXPECT_EQ(characterStart(text, 3), 1U);
    EXPECT_EQ(characterStart(text, 4), 4U);
}

TEST(Characters, ThatAreNoneBecomeASign) {
    EXPECT_EQ(asUtf8("a\xFF\xC3z\xC3\xA4"), "a??z\xC3\xA4");
}

} // namespace text
