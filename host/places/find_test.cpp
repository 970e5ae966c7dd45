// Words are found on pages, and again on pages that change.
#include "document/document.h"
#include "model/model_builder.h"
#include "paragraphs/model_testing.h"
#include "places/find.h"

#include <gtest/gtest.h>

namespace places {

using layout::layOut;
using layout::Pages;
using layout::relaid;
using paragraphs::NewBlock;
using paragraphs::Objects;
using paragraphs::paragraph;

namespace {

class FindTest : public ::testing::Test {
protected:
    FindTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
        model_.page.width = 260;
        model_.page.height = 300;
        model_.page.marginLeft = model_.page.marginRight = 20;
        model_.page.marginTop = model_.page.marginBottom = 30;
    }
    void layOut() { pages_ = relaid(pages_, std::make_shared<model::Model>(model_), objects_); }
    void fill(int count) {
        for (int i = 0; i < count; ++i)
            model_.blocks.push_back(paragraph("The line " + std::to_string(i) + " and its theme"));
        layOut();
    }
    [[nodiscard]] std::size_t count(const Search& search) const {
        return findText(pages_, search).size();
    }

    model::Model model_;
    Objects objects_{[](document::SubdocumentId) { return QSizeF(); },
                     [](const std::string&) { return QSize(); }};
    Pages pages_;
};

TEST_F(FindTest, CaseAndWholeWordsCountWhereTheyAreAskedFor) {
    fill(10);
    EXPECT_EQ(count({"the", false, false}), 20u);
    EXPECT_EQ(count({"the", true, false}), 10u);
    EXPECT_EQ(count({"the", false, true}), 10u);
    EXPECT_EQ(count({"the", true, true}), 0u);
    EXPECT_EQ(count({"line 1", false, true}), 1u);
}

TEST_F(FindTest, PlainSignsFindTheTypographicOnes) {
    model_.blocks.push_back(paragraph("“don’t” \u2212 3\u00A0m \"don't\""));
    layOut();
    EXPECT_EQ(count({"\"don't\""}), 2u);
    EXPECT_EQ(count({"don’t"}), 1u);
    EXPECT_EQ(count({"3 m"}), 1u);
    EXPECT_EQ(count({"-"}), 1u);
}

TEST_F(FindTest, AWordOverTwoPagesIsFoundOnce) {
    std::string text;
    for (int i = 0; i < 2000; ++i)
        text += "again ";
    model_.blocks.push_back(paragraph(text));
    layOut();
    ASSERT_GT(pages_.pages.size(), 2u);
    const std::vector<Found> all = findText(pages_, "again again");
    EXPECT_LE(all.size(), 1000u);
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_LT(all[i - 1].from, all[i].from);
}

TEST_F(FindTest, PagesThatStayAreNotReadAgain) {
    fill(1000);
    const NewBlock broken = paragraph("The line on a new page");
    broken->style.pageBreakBefore = true;
    model_.blocks[600] = broken;
    layOut();
    Finder finder;
    finder.look({"line"}, pages_);
    EXPECT_EQ(finder.count(), 1000u);
    const std::size_t whole = finder.pagesRead();
    EXPECT_EQ(whole, pages_.pages.size());
    model_.blocks[500] = paragraph("Another");
    layOut();
    finder.follow(pages_);
    EXPECT_EQ(finder.count(), 999u);
    EXPECT_LE(finder.pagesRead(), whole + 2);

    // A page more, and those behind it move.
    model::Blocks fresh;
    for (int i = 0; i < 50; ++i)
        fresh.push_back(paragraph("A new line"));
    model_.blocks.insert(model_.blocks.begin() + 500, fresh.begin(), fresh.end());
    layOut();
    finder.follow(pages_);
    const std::vector<Found> anew = findText(pages_, "line");
    ASSERT_EQ(finder.count(), anew.size());
    for (std::size_t i = 0; i < anew.size(); ++i) {
        EXPECT_EQ(finder.at(i).page, anew[i].page);
        EXPECT_EQ(finder.at(i).from, anew[i].from);
    }
    EXPECT_LT(finder.pagesRead(), whole * 3 / 2);
    EXPECT_EQ(finder.firstFrom(0), 0u);
    EXPECT_EQ(finder.firstFrom(pages_.pages.size()), finder.count());
}

// --- places in the document -----------------------------------------------------------------

class FoundPlacesTest : public FindTest {
protected:
    [[nodiscard]] std::vector<std::string> placesOf(const std::string& body, const QString& words) {
        const document::Document document("DOCUMENT REPORT\n<REPORT>\n" + body + "</REPORT>\n");
        const schemas::Schemas schemas = schemas::Schemas::builtIn();
        const auto model = std::make_shared<model::Model>(
            model::buildModel(document, schemas.presentation("REPORT"), schemas));
        const Pages pages = layout::layOut(model, objects_);
        const model::RunPlaces places(document.tree());
        std::vector<std::string> result;
        for (const Found& one : findText(pages, words)) {
            const auto range = places::placesOf(one, places);
            result.push_back(range ? document.bytes().substr(range->from, range->size())
                                   : "generated");
        }
        return result;
    }
    using Spelled = std::vector<std::string>;
};

TEST_F(FoundPlacesTest, WhatIsFoundHasItsBytes) {
    EXPECT_EQ(placesOf("<PARAGRAPH>{one two \\{ three}</PARAGRAPH>\n", "two { t"),
              Spelled{"two \\{ t"});
    EXPECT_EQ(placesOf("<PARAGRAPH><TEXT>{a wo}</TEXT><EMPH>{rd b}</EMPH></PARAGRAPH>\n", "word"),
              Spelled{"wo}</TEXT><EMPH>{rd"});
    EXPECT_EQ(placesOf("<PARAGRAPH><TEXT>{a wo}</TEXT><EMPH>{rd b}</EMPH></PARAGRAPH>\n", "rd"),
              Spelled{"rd"});
}

TEST_F(FoundPlacesTest, WhatIsGeneratedHasNone) {
    const std::string section = "<SECTION><HEADING>{Start}</HEADING></SECTION>\n";
    EXPECT_EQ(placesOf(section, "1 "), Spelled{"generated"});
    EXPECT_EQ(placesOf(section, "Start"), Spelled{"Start"});
}

} // namespace
} // namespace places
