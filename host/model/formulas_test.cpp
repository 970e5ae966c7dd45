// Formulas in a model: in the line, alone, with numbers; as text and as HTML.
#include "document/faults.h"
#include "document/uses.h"
#include "exports/copy_export.h"
#include "exports/text_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace model {

using exports::exportText, exports::copiedHtml;
namespace {

using testing::HasSubstr;

class FormulasInModelTest : public testing::Test {
protected:
    Model modelOf(const std::string& inside) {
        document_ = std::make_unique<document::Document>("DOCUMENT CMEMO\n<CMEMO><BODY>" + inside +
                                                         "</BODY></CMEMO>");
        return buildModel(*document_, schemas_.presentation("CMEMO"), schemas_);
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    std::unique_ptr<document::Document> document_;
};

constexpr const char* paragraphWithDisplay =
    "<PARAGRAPH><TEXT>{As }</TEXT><FORMULA>{E = mc^2}</FORMULA><TEXT>{ and}</TEXT>"
    "<FORMULA KIND=\"numbered\" ID=\"f\">{\\frac{a}{b}}</FORMULA><TEXT>{by }</TEXT>"
    "<REF TO=\"f\"></REF></PARAGRAPH><FORMULA KIND=\"display\">{x}</FORMULA>"
    "<FORMULA KIND=\"numbered\">{y}</FORMULA>";

TEST_F(FormulasInModelTest, StandInTheLineOrAlone) {
    const Model model = modelOf(paragraphWithDisplay);
    ASSERT_GE(model.blocks.size(), 6U);
    const auto first = model.blocks.end() - 5;
    const Block& text = *first[0];
    EXPECT_EQ(text.kind, BlockKind::text);
    EXPECT_TRUE(text.style.keepWithNext); // the display is on its page
    ASSERT_EQ(text.runs.size(), 3U);
    EXPECT_EQ(text.runs[1].kind, RunKind::formula);
    EXPECT_EQ(text.runs[1].text, "E = mc²");
    EXPECT_EQ(text.runs[1].formula->spoken, "E equals m c squared");
    EXPECT_FALSE(text.runs[1].formula->isAlone);
    const Block& display = *first[1];
    EXPECT_EQ(display.kind, BlockKind::formula);
    EXPECT_EQ(display.marker, "(1)");
    EXPECT_EQ(display.anchors, std::vector<std::string>{"f"});
    ASSERT_EQ(display.runs.size(), 1U);
    EXPECT_TRUE(display.runs[0].formula->isAlone);
    EXPECT_EQ(first[2]->runs[1].text, "Equation\u00A01"); // by the reference
    EXPECT_EQ(first[3]->marker, "");
    EXPECT_EQ(first[4]->marker, "(2)");
}

// The heading waits for its letters, and borrows no number; the equation has one of its own.
TEST_F(FormulasInModelTest, ANumberedDisplayUnderAnEmptyHeadingShowsItsNumber) {
    const Model model = modelOf("<SECTION><HEADING>{}</HEADING>"
                                "<FORMULA KIND=\"numbered\">{x}</FORMULA></SECTION>");
    EXPECT_EQ(model.blocks.back()->kind, BlockKind::formula);
    EXPECT_EQ(model.blocks.back()->marker, "(1)");
}

TEST_F(FormulasInModelTest, AreTextForWhoCopiesAndWhoExports) {
    const Model model = modelOf(paragraphWithDisplay);
    const std::string text = exportText(*document_, model);
    EXPECT_THAT(text, HasSubstr("As E = mc² and\n"));
    EXPECT_THAT(text, HasSubstr(" a/b "));
    EXPECT_THAT(text, HasSubstr(" (1)\n"));
    EXPECT_THAT(
        copiedHtml(*document_, model),
        HasSubstr("<span role=\"math\" aria-label=\"E equals m c squared\">E = mc²</span>"));
}

TEST_F(FormulasInModelTest, LinesOfADisplayAreLinesOfText) {
    const Model model = modelOf("<FORMULA KIND=\"numbered\">{\\begin{aligned} a &= b \\cr "
                                "&= c \\end{aligned}}</FORMULA>");
    const std::string text = exportText(*document_, model, 20);
    EXPECT_THAT(text, HasSubstr("       a = b\n         = c     (1)\n"));
}

TEST_F(FormulasInModelTest, SchemasAllowThemWhereTextAndBlocksStand) {
    (void)modelOf(paragraphWithDisplay);
    EXPECT_TRUE(document::documentFaults(*document_, schemas_, {}).empty());
    const std::vector<sgml::NodeId> uses = document::Uses(*document_, schemas_).formulas();
    ASSERT_EQ(uses.size(), 4U);
    EXPECT_EQ(document_->tree().unescaped(uses[1]).text(), "\\frac{a}{b}");
}

} // namespace
} // namespace model
