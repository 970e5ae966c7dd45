// Formulas among the words of a line, and alone.
#include "formulas/typeset.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "paragraphs/paragraph.h"

#include <gtest/gtest.h>

#include <QPainter>

namespace paragraphs {
namespace {

class FormulasInLinesTest : public testing::Test {
protected:
    FormulasInLinesTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        materials_ = std::make_shared<Materials>(styles);
    }
    void SetUp() override { ASSERT_NE(formulas::Font::standard(), nullptr); }

    std::unique_ptr<Paragraph> laid(const NewBlock& block, double width = fromPoints(400)) {
        auto made = std::make_unique<Paragraph>(materials_, block, width);
        (void)made->makeLine(1000);
        return made;
    }
    static NewBlock around(const std::string& source) {
        NewBlock block = paragraph("As ");
        block->runs.push_back(formulaRun(source));
        block->runs.emplace_back().text = ", so.";
        return block;
    }

    std::shared_ptr<Materials> materials_;
};

TEST_F(FormulasInLinesTest, StandOnTheBaseLineBetweenTheWords) {
    const auto of = laid(around("x_1"));
    ASSERT_EQ(of->lines().size(), 1U);
    ASSERT_EQ(of->objectsOf(0).size(), 1U);
    const InlineObject& object = of->objectsOf(0)[0];
    EXPECT_GT(object.depth, 0); // the subscript is below the base line
    const QRectF rect = of->objectRect(0, object);
    EXPECT_NEAR(rect.bottom(), of->lines()[0].baseline + object.depth, 1e-6);
    EXPECT_NEAR(of->leftOf(0, of->startOfRun(2)) - rect.left(), rect.width(), 2); // twips
    EXPECT_EQ(of->lines()[0].height, laid(paragraph("As, so."))->lines()[0].height);
}

// Neither a digit of another width nor one more or less moves the words behind a number that plays.
TEST_F(FormulasInLinesTest, ANumberThatPlaysKeepsItsRoomInTextAndInAFormula) {
    const auto endOfText = [this](const std::string& number) {
        NewBlock block = paragraph("At ");
        model::Run& run = block->runs.emplace_back();
        run.kind = model::RunKind::value;
        run.text = "\u2007" + number;
        run.value = std::make_shared<model::Value>(model::Value{.room = "\u22120.00"});
        block->runs.emplace_back().text = " s, so.";
        const auto of = laid(block);
        return of->leftOf(0, of->startOfRun(2) + 1);
    };
    const double wide = endOfText("\u22124.00");
    for (const char* number : {"4.44", "1.11", "\u22121.11", "\u22129.99"})
        EXPECT_NEAR(endOfText(number), wide, 1) << number; // of 1/20 point
    const auto widthOf = [](const std::string& number, const std::string& room) {
        const auto supply = [&](const formulas::ValueCall&) {
            return formulas::SuppliedValue{.source = number, .room = room};
        };
        return formulas::typeset(formulas::read("E = \\value{a}{E}", supply), formulas::Style::text,
                                 200, *formulas::Font::standard())
            .width;
    };
    EXPECT_NEAR(widthOf("1.0", "-0.0"), widthOf("-0.0", ""), 1e-6);
    EXPECT_NEAR(widthOf("100.0", "-0.0"), widthOf("100.0", ""), 1e-6); // none is torn
}

// The rest of the room comes to it, and no more.
TEST_F(FormulasInLinesTest, TheBlankBeforeANumberThatPlaysIsThatOfOtherWords) {
    const auto gap = [this](const std::string& room, const std::string& number) {
        NewBlock block = paragraph("At ");
        model::Run& run = block->runs.emplace_back();
        run.kind = model::RunKind::value;
        run.text = (room.empty() ? "" : "\u2007") + number;
        run.value = std::make_shared<model::Value>(model::Value{.room = room});
        const auto of = laid(block);
        return of->leftOf(0, of->startOfRun(1) + (room.empty() ? 0 : 1)) -
               of->leftOf(0, of->startOfRun(1) - 1);
    };
    const double usual = gap("", "4.44");
    EXPECT_GT(usual, 40); // twips
    EXPECT_NEAR(gap("0.00", "4.44"), usual, 1);
    EXPECT_NEAR(gap("\u22120.00", "\u22124.44"), usual, 1);
    EXPECT_NEAR(gap("0.00", "\u22124.44"), usual, 1); // wider than its room: none is lost
    EXPECT_GT(gap("\u22120.00", "4.44"), usual + 50);
}

TEST_F(FormulasInLinesTest, AloneInACellHaveTheBaseLineOfAWord) {
    auto block = std::make_shared<model::Block>();
    block->runs.push_back(formulaRun("r"));
    EXPECT_NEAR(laid(block)->lines()[0].baseline, laid(paragraph("r"))->lines()[0].baseline, 2);
}

TEST_F(FormulasInLinesTest, MoveLinesApartOnlyWhereTheyAreHigh) {
    const double plain = laid(paragraph("As, so."))->lines()[0].height;
    EXPECT_EQ(laid(around("x^2"))->lines()[0].height, plain);
    const auto of = laid(around("\\dfrac{\\dfrac{a}{b}}{\\dfrac{c}{d}}"));
    const Paragraph::Line& line = of->lines()[0];
    const QRectF rect = of->objectRect(0, of->objectsOf(0)[0]);
    EXPECT_GT(line.height, plain);
    EXPECT_GE(rect.top(), 0);
    EXPECT_LE(rect.bottom(), line.height);
}

TEST_F(FormulasInLinesTest, AreBrokenBehindRelationsAndOperators) {
    std::string sum = "a_0";
    for (int i = 1; i < 30; ++i)
        sum += " + a_{" + std::to_string(i) + "}";
    const double width = fromPoints(150);
    const auto of = laid(around(sum), width);
    EXPECT_GT(of->lines().size(), 3U);
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < of->lines().size(); ++i)
        for (const InlineObject& object : of->objectsOf(static_cast<int>(i))) {
            EXPECT_EQ(object.piece, pieces++); // in their order
            EXPECT_LE(object.left + object.size.width(), width + 1);
        }
    EXPECT_EQ(pieces, 30U);
    EXPECT_EQ(laid(around("g = 9.81"))->objectsOf(0).size(), 1U); // short ones stay whole
}

TEST_F(FormulasInLinesTest, ReadAgainHaveTheSamePlaces) {
    const auto of = laid(around("a+b=c"), fromPoints(90));
    const double before = of->leftOf(0, of->endOfRun(2));
    // Lines kept of others drive out those kept of this one.
    for (std::size_t i = 0; i <= Kept::fewest; ++i) {
        const auto other = laid(paragraph(std::string(Kept::most, 'x')));
        EXPECT_GT(other->leftOf(0, 1), 0);
    }
    EXPECT_EQ(of->leftOf(0, of->endOfRun(2)), before);
    EXPECT_EQ(of->objectsOf(0).size(), 3U);
}

TEST_F(FormulasInLinesTest, ADisplayIsCentredAndFitsBesideItsNumber) {
    const double width = fromPoints(300);
    const auto small = laid(display("E=mc^2"), width);
    const InlineObject& object = small->objectsOf(0)[0];
    EXPECT_NEAR(object.left + object.size.width() / 2, width / 2, 2);
    std::string wide = "a";
    for (int i = 0; i < 60; ++i)
        wide += "+b";
    const auto large = laid(display(wide, "(1)"), width);
    ASSERT_EQ(large->lines().size(), 1U);
    EXPECT_LE(large->objectsOf(0)[0].size.width(), 0.81 * width);
    EXPECT_GT(large->objectsOf(0)[0].size.width(), 0.75 * width);
}

TEST_F(FormulasInLinesTest, ArePaintedInTheColourOfTheText) {
    const auto styles = std::make_shared<schemas::TextStyles>();
    schemas::TextStyle blue;
    blue.color = {0, 0, 255};
    styles->numberOf(blue);
    materials_ = std::make_shared<Materials>(styles);
    const auto of = laid(display("\\frac{1}{2}"), 2000);
    QImage image(400, 160, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(0.25, 0.25);
    of->paintLine(painter, 0, {0, 50});
    painter.end();
    int blues = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            blues += image.pixel(x, y) == qRgb(0, 0, 255) ? 1 : 0;
    EXPECT_GT(blues, 20);
}

} // namespace
} // namespace paragraphs
