// Lines of paragraphs, as they are laid out: how wide they are, where they end, what is shown.
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "paragraphs/paragraph.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace paragraphs {
namespace {

class LinesOfTextTest : public testing::Test {
protected:
    LinesOfTextTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        schemas::TextStyle mono;
        mono.family = "mono";
        mono.size = 9;
        styles->numberOf(mono);
        schemas::TextStyle english;
        english.language = "en";
        styles->numberOf(english);
        materials_ = std::make_shared<Materials>(styles);
    }
    std::unique_ptr<Paragraph> laid(const NewBlock& block, double width = fromPoints(200)) {
        auto made = std::make_unique<Paragraph>(materials_, block, width);
        (void)made->makeLine(100'000);
        return made;
    }
    static NewBlock justified(const std::string& text) {
        NewBlock block = paragraph(text);
        block->style.align = schemas::Align::justify;
        return block;
    }
    static std::vector<std::string> textsOf(const Paragraph& of) {
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < of.lines().size(); ++i)
            lines.push_back(of.textOfLine(static_cast<int>(i)).trimmed().toStdString());
        return lines;
    }
    static double rightOf(const Paragraph& of, std::size_t line) {
        return of.leftOf(static_cast<int>(line), of.lines()[line].end);
    }

    std::shared_ptr<Materials> materials_;
};

const char* const prose =
    "There are nearly as many definitions of animation as there are people who have written about "
    "it, and none of them says what a reader of a report needs to know: when does it move, who "
    "drives it, and what may be changed while it runs? Two forces act on the bob of a pendulum, "
    "and one of them does no work.";

TEST_F(LinesOfTextTest, ALineStandsStillWhenItGetsItsFirstLetter) {
    const auto empty = laid(paragraph("")), typed = laid(paragraph("x"));
    EXPECT_EQ(empty->lines().front().baseline, typed->lines().front().baseline);
    EXPECT_EQ(empty->lines().front().height, typed->lines().front().height);
}

TEST_F(LinesOfTextTest, JustifiedLinesEndTogether) {
    for (const double width : {150, 200, 260, 330, 400}) {
        const auto of = laid(justified(prose), fromPoints(width));
        ASSERT_GT(of->lines().size(), 3U);
        for (std::size_t i = 0; i + 1 < of->lines().size(); ++i) {
            if (of->lines()[i].stretch < 2) { // beyond that a line stays short
                EXPECT_NEAR(rightOf(*of, i), fromPoints(width), 2) << width << " line " << i;
            }
        }
    }
}

TEST_F(LinesOfTextTest, WithLettersOfSeveralLooksToo) {
    NewBlock block = justified("Some words of the text, and then ");
    block->runs.emplace_back().text = "code of which the letters are others";
    block->runs.back().style = 1;
    block->runs.emplace_back().text = std::string(" come again ") + prose;
    const auto of = laid(block);
    for (std::size_t i = 0; i + 1 < of->lines().size(); ++i)
        EXPECT_NEAR(rightOf(*of, i), fromPoints(200), 2) << i;
}

// The hyphen is part of the line's width, and no letter.
TEST_F(LinesOfTextTest, DividedWordsReachTheEdgeWithTheirHyphen) {
    NewBlock block = justified(prose);
    block->runs.front().style = 2;
    int hyphens = 0;
    for (int width = 100; width < 240; width += 10) {
        const auto of = laid(block, fromPoints(width));
        QString together;
        for (std::size_t i = 0; i < of->lines().size(); ++i) {
            const Paragraph::Line& line = of->lines()[i];
            together += of->textOfLine(static_cast<int>(i));
            if (i + 1 == of->lines().size() || line.stretch >= 2)
                continue;
            const double hyphen = line.hyphen ? materials_->looks.hyphen(2) : 0;
            hyphens += line.hyphen ? 1 : 0;
            EXPECT_NEAR(rightOf(*of, i) + hyphen, fromPoints(width), 6) << width << " line " << i;
        }
        EXPECT_EQ(together, QString::fromUtf8(prose));
    }
    EXPECT_GT(hyphens, 5);
}

// A soft hyphen inside a line has no width, and the one at its end has that of a hyphen. Places in
// a line never lie beyond its edge, so what it needs is measured apart.
TEST_F(LinesOfTextTest, LinesWithSoftHyphensReachTheEdge) {
    std::string text;
    for (int i = 0; i < 12; ++i)
        text += "soft\u00ADhyphen\u00ADated words of an author who divides them her\u00ADself, ";
    int divided = 0;
    for (int width = 140; width < 240; width += 10) {
        const auto of = laid(justified(text), fromPoints(width));
        for (std::size_t i = 0; i + 1 < of->lines().size(); ++i) {
            const Paragraph::Line& line = of->lines()[i];
            if (line.apart != 0)
                continue;
            divided += line.hyphen ? 1 : 0;
            const QString shown = of->text(line.from, line.end - line.from);
            const QString seen = QString(shown).remove(QChar(QChar::SoftHyphen));
            const auto alone = laid(paragraph(seen.toStdString()), fromPoints(10'000));
            const double blanks = shown.count(' ') * materials_->looks.blank(0);
            const double hyphen = line.hyphen ? materials_->looks.hyphen(0) : 0;
            EXPECT_NEAR(alone->naturalWidth() + line.stretch * blanks + hyphen, fromPoints(width),
                        12)
                << width << " line " << i;
        }
    }
    EXPECT_GT(divided, 5);
}

TEST_F(LinesOfTextTest, RaggedLinesAreAsEvenAsTheyCanBe) {
    // As many words as fit would leave a hole in the second line.
    const auto of = laid(paragraph("aaaa bbbb cccc dddd extraordinarily incomprehensible"), 1700);
    EXPECT_EQ(of->lines().back().to, 52);
    for (const Paragraph::Line& line : of->lines())
        EXPECT_EQ(line.stretch, 0);
}

TEST_F(LinesOfTextTest, NoNumberIsTorn) {
    const std::string text = "It weighs 12 345.5 kg as Figure 3 says, on 12 March 2026.";
    for (int width = 60; width < 300; width += 7) {
        const auto of = laid(paragraph(text), fromPoints(width));
        for (const std::string& line : textsOf(*of))
            for (const char* const part : {"12 345.5 kg", "Figure 3", "12 March"}) {
                const std::string whole = part;
                const std::string head = whole.substr(0, whole.find(' '));
                const bool ends = line.ends_with(" " + head) || line == head;
                EXPECT_FALSE(ends && line.find(whole) == std::string::npos) << line;
            }
    }
}

TEST_F(LinesOfTextTest, BlanksAtTheEndAreNotShownButHaveTheirPlaces) {
    const auto of = laid(paragraph(prose));
    for (std::size_t i = 0; i + 1 < of->lines().size(); ++i) {
        const Paragraph::Line& line = of->lines()[i];
        EXPECT_EQ(line.end, line.to - 1);
        EXPECT_EQ(of->lines()[i + 1].from, line.to);
        EXPECT_EQ(of->placeBeside(line.end, Paragraph::Side::right), line.to);
        EXPECT_EQ(of->placeBeside(line.to, Paragraph::Side::left), line.end);
    }
}

TEST_F(LinesOfTextTest, WordsWiderThanALineAreTornAndNothingIsLost) {
    const auto of = laid(paragraph("so " + std::string(100, 'm') + " on"), fromPoints(100));
    std::string together;
    for (std::size_t i = 0; i < of->lines().size(); ++i) {
        together += of->textOfLine(static_cast<int>(i)).toStdString();
        EXPECT_LE(rightOf(*of, i), fromPoints(100) + 2);
    }
    EXPECT_EQ(together, "so " + std::string(100, 'm') + " on");
    EXPECT_LT(of->lines().size(), 16U);
}

// A word from right to left that a line's end divides goes on as it does in one line.
// Each of its lines is laid out anew; what it is made of is read once.
TEST_F(LinesOfTextTest, AVeryLongTextIsReadOnceForAllItsLines) {
    constexpr std::size_t length = 2 * Kept::most;
    const auto of = laid(paragraph(std::string(length, 'x')), fromPoints(2000));
    const auto header = laid(paragraph("A header"));
    const qsizetype before = RunLetters::lettersRead();
    QImage image(1, 1, QImage::Format_RGB32);
    QPainter painter(&image);
    for (int line = 0; line < static_cast<int>(of->lines().size()); ++line) {
        of->paintLine(painter, line, {});
        if (line % 40 == 0)
            header->paintLine(painter, 0, {});
    }
    EXPECT_GT(of->lines().size(), 100U);
    EXPECT_LE(RunLetters::lettersRead() - before, static_cast<qsizetype>(length + 100));
}

TEST_F(LinesOfTextTest, LettersGoAsTheyDoInTheParagraph) {
    std::string hebrew;
    for (int i = 0; i < 30; ++i)
        hebrew += "\u05D0\u05D1\u05D2, ";
    const auto of = laid(paragraph("abc " + hebrew + "end"));
    ASSERT_GT(of->lines().size(), 2U);
    // The comma behind the last word of a line stands on its left, as those inside do.
    const Paragraph::Line& line = of->lines()[1];
    const auto comma = of->edgesOf(1, line.end - 1), letter = of->edgesOf(1, line.end - 2);
    EXPECT_LT(comma.first, letter.first);
}

} // namespace
} // namespace paragraphs
