// Words and where they are divided, by the patterns that the system has.
#include "typography/hyphenation.h"
#include "typography/patterns.h"

#include <gtest/gtest.h>

namespace typography {
namespace {

std::string divided(const QString& text, const QString& language) {
    QString result = text;
    const std::vector<int> places = placesInWords(text, language);
    for (auto place = places.rbegin(); place != places.rend(); ++place)
        result.insert(*place, '-');
    return result.toStdString();
}

TEST(HyphenationTest, EnglishAndGermanWordsAreDividedByTheirRules) {
    ASSERT_FALSE(patternsOf("en").isEmpty()) << "packaging/packages.txt: hyphen-en-us";
    ASSERT_FALSE(patternsOf("de").isEmpty()) << "packaging/packages.txt: hyphen-de";
    EXPECT_EQ(divided("hyphenation of an animation", "en"), "hy-phen-ation of an an-i-ma-tion");
    EXPECT_EQ(divided("Schwingungen (Pendeluhr)", "de"), "Schwin-gun-gen (Pen-del-uhr)");
    EXPECT_EQ(divided("Größenänderung", "de-AT"), "Grö-ßen-än-de-rung");
    EXPECT_EQ(divided("développement", "fr"), "dé-ve-lop-pe-ment");
}

TEST(HyphenationTest, AllPatternsOfAFileAreRead) {
    EXPECT_GT(Patterns(patternsOf("de")).count(), 50'000U);
    EXPECT_EQ(Patterns("/nowhere").count(), 0U);
}

TEST(HyphenationTest, WhatIsNoWordStaysWhole) {
    EXPECT_EQ(divided("NASA pend2dulum init_pos example.org/animation five", "en"),
              "NASA pend2dulum init_pos example.org/animation five");
    EXPECT_EQ(divided("animation", "xx"), "animation"); // nobody has its patterns
    EXPECT_EQ(divided("animation", ""), "animation");
}

TEST(HyphenationTest, ACountryWithoutPatternsHasThoseOfItsLanguage) {
    EXPECT_EQ(patternsOf("en-XX"), patternsOf("en-US"));
    EXPECT_EQ(patternsOf("de_XX"), patternsOf("de"));
}

} // namespace
} // namespace typography
