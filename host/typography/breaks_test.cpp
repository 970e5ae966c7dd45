// Places where a reader would stumble over the end of a line, and places where none would.
#include "typography/breaks.h"

#include <gtest/gtest.h>

#include <QString>

namespace typography {
namespace {

// The text with its places marked: `|` where a line may end, `~` where none does. Only blanks and
// the places behind hyphens, dashes and slashes are asked about.
std::string marked(const QString& text) {
    QString result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isPlace = i > 0 && !text[i].isSpace() &&
                             (text[i - 1].isSpace() || QStringView(u"-–—/").contains(text[i - 1]));
        if (isPlace)
            result += costOfBreak(text, i) >= never ? '~' : '|';
        if (!text[i].isSpace())
            result += text[i];
    }
    return result.toStdString();
}

TEST(BreaksTest, NumbersStayWhole) {
    EXPECT_EQ(marked("about 3.5e-4 of"), "about|3.5e-~4|of");
    EXPECT_EQ(marked("is 1 000 or 12 345 678.5 now"), "is|1~000|or|12~345~678.5|now");
    EXPECT_EQ(marked("-5 or –5 or +49-30-12"), "-~5|or|–~5|or|+49-~30-~12");
    EXPECT_EQ(marked("1/2 and 10–20"), "1/~2|and|10–~20");
    EXPECT_EQ(marked("in 2026 100 people"), "in|2026|100|people");
}

TEST(BreaksTest, NumbersStayWithTheirUnits) {
    EXPECT_EQ(marked("a mass of 5 kg, at 3.5 m/s or"), "a|mass|of|5~kg,|at|3.5~m/~s|or");
    EXPECT_EQ(marked("20 °C, 10 % of 9.81 m/s² here"), "20~°C,|10~%|of|9.81~m/~s²|here");
    EXPECT_EQ(marked("the 5 bodies in 3 steps"), "the|5|bodies|in|3|steps");
    EXPECT_EQ(marked("km/h and and/or"), "km/~h|and|and/|or");
}

TEST(BreaksTest, DatesAndNamesStayTogether) {
    EXPECT_EQ(marked("on 12 March 2026 and March 12, then"), "on|12~March|2026|and|March~12,|then");
    EXPECT_EQ(marked("am 12. März um 2026-11-23"), "am|12.~März|um|2026-~11-~23");
    EXPECT_EQ(marked("see Figure 3 and (Eq. 12) or p. 7 of"),
              "see|Figure~3|and|(Eq.~12)|or|p.~7|of");
    EXPECT_EQ(marked("Appendix A of Dr. Baraff, z. B. hier"),
              "Appendix~A|of|Dr.~Baraff,|z.~B.|hier");
    EXPECT_EQ(marked("as in [12, 13] or"), "as|in|[12,~13]|or");
}

TEST(BreaksTest, DashesAndBracketsBelongToTheWordBesideThem) {
    EXPECT_EQ(marked("one – two — three - four"), "one~–|two~—|three~-|four");
    EXPECT_EQ(marked("x-axis of a well-known 3-D thing"), "x-~axis|of|a|well-|known|3-~D|thing");
    EXPECT_EQ(marked("say « oui » !"), "say|«~oui~»~!");
    EXPECT_EQ(marked("if a = b + c then"), "if|a~=|b~+|c|then");
    EXPECT_GE(costOfBreak(u"a—b", 1), never);
    EXPECT_LT(costOfBreak(u"a—b", 2), never);
}

TEST(BreaksTest, AHyphenCostsMoreThanABlank) {
    EXPECT_EQ(costOfBreak(u"well known", 5), 0);
    EXPECT_EQ(costOfBreak(u"well-known", 5), atHyphen);
    EXPECT_GT(costOfBreak(u"a = b", 4), atHyphen);
}

} // namespace
} // namespace typography
