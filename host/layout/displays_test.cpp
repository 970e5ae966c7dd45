// Displayed formulas on pages: their numbers, and the sentence before them.
#include "formulas/font.h"
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"

#include <gtest/gtest.h>

namespace layout {

using paragraphs::display;
using paragraphs::fromPoints;
using paragraphs::paragraph;

namespace {

class DisplayedFormulasTest : public testing::Test {
protected:
    DisplayedFormulasTest() { styles_->numberOf({}); }
    void SetUp() override { ASSERT_NE(formulas::Font::standard(), nullptr); }

    std::shared_ptr<schemas::TextStyles> styles_ = std::make_shared<schemas::TextStyles>();
};

TEST_F(DisplayedFormulasTest, TheNumberStandsAtTheRightOnTheSameBaseLine) {
    model::Model model;
    model.textStyles = styles_;
    model.blocks.push_back(display("\\frac{a}{b}", "(7)"));
    const Pages pages = layOut(std::make_shared<model::Model>(model), {});
    const auto& pieces = pages.pages.at(0)->pieces;
    ASSERT_EQ(pieces.size(), 2U);
    const auto& formula = std::get<TextPiece>(pieces[0]);
    const auto& number = std::get<TextPiece>(pieces[1]);
    EXPECT_EQ(number.paragraph->textOfLine(0), "(7)");
    const auto baseline = [](const TextPiece& piece) {
        return piece.at.y() + piece.paragraph->lines()[0].baseline;
    };
    EXPECT_NEAR(baseline(formula), baseline(number), 1e-6);
    const double right = pages.size.width() - fromPoints(model.page.marginRight);
    EXPECT_NEAR(number.at.x() + number.paragraph->leftOf(0, 3), right, 2);
}

// Wherever a page ends, and however the display came there.
TEST_F(DisplayedFormulasTest, ADisplayStandsOnThePageOfTheSentenceBeforeIt) {
    for (int lines = 30; lines < 50; ++lines) {
        model::Model model;
        model.textStyles = styles_;
        for (int i = 0; i < lines; ++i)
            model.blocks.push_back(paragraph("line"));
        model.blocks.push_back(paragraph("Sentence:"));
        const auto plain = std::make_shared<model::Model>(model);
        model.blocks.push_back(display("\\frac{a}{b}"));
        const auto whole = std::make_shared<model::Model>(model);
        const std::string fresh = printed(layOut(whole, {}));
        const std::size_t sentence = fresh.find("Sentence");
        ASSERT_NE(sentence, std::string::npos);
        EXPECT_EQ(fresh.find("\npage", sentence), std::string::npos) << lines;
        EXPECT_EQ(printed(relaid(layOut(plain, {}), whole, {})), fresh) << lines;
    }
}

} // namespace
} // namespace layout
