// Cells that are numbers, and where their points stand.
#include "typography/numbers.h"

#include <gtest/gtest.h>

namespace typography {
namespace {

// The part before the point, or "no".
std::string whole(const QString& text, const QString& language = "en") {
    const auto place = pointOf(text, language);
    return place ? text.first(*place).toStdString() : "no";
}

TEST(NumbersTest, HaveAPointOrItsPlace) {
    EXPECT_EQ(whole("3.25"), "3");
    EXPECT_EQ(whole("-12"), "-12");
    EXPECT_EQ(whole(".5"), "");
    EXPECT_EQ(whole("1 000.5 kg"), "1 000");
    EXPECT_EQ(whole("1,234,567.8"), "1,234,567");
    EXPECT_EQ(whole("3.5e-4"), "3");
    EXPECT_EQ(whole("6.02×10²³ mol"), "6");
    EXPECT_EQ(whole("< 5 %"), "< 5");
    EXPECT_EQ(whole("9.81 m/s²"), "9");
}

TEST(NumbersTest, HaveACommaInOtherLanguages) {
    EXPECT_EQ(whole("3,25", "de"), "3");
    EXPECT_EQ(whole("1.234,5", "de"), "1.234");
    EXPECT_EQ(whole("3,25", "en"), "3"); // no group of three
    EXPECT_EQ(whole("3.25", "de"), "3");
    EXPECT_EQ(whole("2.006", "he"), "2"); // a language that has a point, as English does
    EXPECT_EQ(whole("2.006", "de"), "2.006");
}

TEST(NumbersTest, AreNotTexts) {
    for (const char* text : {"", "Figure 3", "5 bodies", "2026-11-23", "1.2.3", "m", "10:30"})
        EXPECT_EQ(whole(text), "no") << text;
    EXPECT_TRUE(isNoNumber(u""));
    EXPECT_TRUE(isNoNumber(u"–"));
    EXPECT_FALSE(isNoNumber(u"n.a."));
}

} // namespace
} // namespace typography
