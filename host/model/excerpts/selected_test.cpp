// Parts of documents between two places, and how they are copied.
#include "excerpts/selected.h"
#include "exports/copy_export.h"
#include "schemas/schemas.h"

#include <gtest/gtest.h>

namespace model {

using exports::copiedText, exports::copiedHtml;
namespace {

class SelectedTest : public ::testing::Test {
protected:
    // Bars stand at the ends of what is selected.
    void select(std::string body) {
        body = "DOCUMENT REPORT\n<REPORT><SECTION>" + body + "</SECTION></REPORT>";
        const std::size_t from = body.find('|'), to = body.find('|', from + 1) - 1;
        std::erase(body, '|');
        document_ = std::make_unique<document::Document>(body);
        const schemas::Schemas schemas = schemas::Schemas::builtIn();
        const Model model = buildModel(*document_, schemas.presentation("REPORT", {}), schemas);
        part_ = excerpt(document_->tree(), model, {from, to});
    }
    std::string text() const { return copiedText(*document_, part_); }
    std::string html() const {
        const std::string all = copiedHtml(*document_, part_);
        const std::size_t from = all.find("<body>\n") + 7;
        return all.substr(from, all.find("</body>") - from);
    }

    std::unique_ptr<document::Document> document_;
    Model part_;
};

TEST_F(SelectedTest, TextIsCutWhereTheSelectionEnds) {
    select("<PARAGRAPH><TEXT>{o|ne \\{tw\u00F6\\} }</TEXT><EMPH>{th|ree}</EMPH></PARAGRAPH>");
    EXPECT_EQ(text(), "ne {tw\u00F6} th");
    EXPECT_EQ(html(), "<p>ne {tw\u00F6} <em>th</em></p>\n");
}

TEST_F(SelectedTest, ParagraphsAreApartByABlankLineAndItemsByALineEnd) {
    select("<PARAGRAPH><TEXT>{Out |in}</TEXT></PARAGRAPH><LIST KIND=\"number\">"
           "<ITEM><TEXT>{First}</TEXT></ITEM><ITEM><TEXT>{Second}</TEXT></ITEM></LIST>"
           "<PARAGRAPH><TEXT>{Last| one}</TEXT></PARAGRAPH>");
    EXPECT_EQ(text(), "in\n\n1. First\n2. Second\n\nLast");
    EXPECT_EQ(html(), "<p>in</p>\n<ol><li>First</li>\n<li>Second</li>\n</ol>\n<p>Last</p>\n");
}

TEST_F(SelectedTest, AMarkerComesWithTheBeginningOfItsItem) {
    select("<LIST KIND=\"number\"><ITEM><TEXT>{Fi|rst}</TEXT></ITEM>"
           "<ITEM><TEXT>{Second|}</TEXT></ITEM></LIST>");
    EXPECT_EQ(text(), "rst\n2. Second");
}

TEST_F(SelectedTest, HeadingsKeepTheirNumbersAndRanks) {
    select(
        "<HEADING><TEXT>{|Beginning}</TEXT></HEADING><PARAGRAPH><TEXT>{a < b|}</TEXT></PARAGRAPH>");
    EXPECT_TRUE(text().ends_with("Beginning\n\na < b")) << text();
    EXPECT_EQ(html().substr(0, 3), "<h1");
    EXPECT_NE(html().find("a &lt; b"), std::string::npos);
}

TEST_F(SelectedTest, ATableHasTabsBetweenItsCells) {
    const auto cell = [](const std::string& text) {
        return "<CELL><TEXT>{" + text + "}</TEXT></CELL>";
    };
    select("<TABLE><ROW>" + cell("|a") + cell("b") + "</ROW><ROW>" + cell("c") + cell("d|") +
           "</ROW><ROW>" + cell("e") + cell("f") + "</ROW></TABLE>");
    EXPECT_EQ(text(), "a\tb\nc\td");
    EXPECT_EQ(html(), "<table>\n<tr><td><p>a</p>\n</td><td><p>b</p>\n</td></tr>\n"
                      "<tr><td><p>c</p>\n</td><td><p>d</p>\n</td></tr>\n</table>\n");
}

TEST_F(SelectedTest, AFootnoteComesWithItsMarkAndAlone) {
    select("<PARAGRAPH><TEXT>{S|ee}</TEXT><FOOTNOTE><TEXT>{A note}</TEXT></FOOTNOTE>"
           "<TEXT>{ her|e}</TEXT></PARAGRAPH>");
    EXPECT_EQ(text().substr(0, 2), "ee");
    EXPECT_TRUE(text().ends_with("A note")) << text();
    select("<PARAGRAPH><TEXT>{See}</TEXT><FOOTNOTE><TEXT>{A |note|}</TEXT></FOOTNOTE>"
           "<TEXT>{ here}</TEXT></PARAGRAPH>");
    EXPECT_EQ(text(), "note");
}

TEST_F(SelectedTest, LinesThatAreKeptAndLinksGoAlong) {
    select("<VERBATIM>{x |= 1\ny = 2\nz| = 3}</VERBATIM>");
    EXPECT_EQ(text(), "= 1\ny = 2\nz");
    EXPECT_EQ(html(), "<pre>= 1\ny = 2\nz</pre>\n");
    select(
        "<PARAGRAPH><TEXT>{|a }</TEXT><LINK TO=\"https://e.org/?a&b\">{link|}</LINK></PARAGRAPH>");
    EXPECT_EQ(html(), "<p>a <a href=\"https://e.org/?a&amp;b\">link</a></p>\n");
}

} // namespace
} // namespace model
