// The blocks under a heading, and models without what is folded.
#include "excerpts/folding.h"
#include "model/model_builder.h"

#include <gmock/gmock.h>

namespace model {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const schemas::Schemas& schemasOfTheProgram() {
    static const schemas::Schemas all = schemas::Schemas::builtIn();
    return all;
}

std::string named(const std::string& name, const std::string& inside) {
    return "<SECTION ID=\"" + name + "\"><HEADING>{" + name + "}</HEADING>" + inside +
           "</SECTION>\n";
}

std::string paragraph(const std::string& text) { return "<PARAGRAPH>{" + text + "}</PARAGRAPH>\n"; }

Model reportOf(const std::string& body) {
    const document::Document document("DOCUMENT REPORT\n<REPORT>\n" + body + "</REPORT>\n");
    return buildModel(document, schemasOfTheProgram().presentation("REPORT"),
                      schemasOfTheProgram());
}

std::vector<std::string> texts(const Model& model) {
    std::vector<std::string> result;
    for (const auto& block : model.blocks)
        result.push_back(block->marker + (block->runs.empty() ? "" : block->runs.front().text));
    return result;
}

const std::string sample =
    paragraph("0") + named("a", paragraph("1") + named("b", paragraph("2")) + named("c", "")) +
    named("d", paragraph("3")) + paragraph("4");

TEST(FoldingTest, ASectionGoesToTheNextHeadingOfItsLevelAndNoFurtherThanItsElement) {
    const Model model = reportOf(sample);
    ASSERT_THAT(texts(model),
                ElementsAre("0", "1  a", "1", "1.1  b", "2", "1.2  c", "2  d", "3", "4"));
    EXPECT_THAT(sectionsOf(model),
                ElementsAre(Section{1, 5}, Section{3, 4}, Section{5, 5}, Section{6, 7}));
}

// As in classes whose headings stand between paragraphs.
TEST(FoldingTest, WithoutElementsAroundThemLevelsAlonePartSections) {
    Model model;
    for (const int level : {0, 1, 0, 2, 0, 2, 1, 0}) {
        auto block = std::make_shared<Block>();
        block->headingLevel = level;
        model.blocks.push_back(block);
    }
    EXPECT_THAT(sectionsOf(model),
                ElementsAre(Section{1, 5}, Section{3, 4}, Section{5, 5}, Section{6, 7}));
}

TEST(FoldingTest, WhatIsFoldedIsLeftOutAndAllElseIsTheSame) {
    const Model whole = reportOf(sample);
    Folding folding;
    const auto folded = folding.folded(whole, {{1, 5}});
    EXPECT_THAT(texts(*folded), ElementsAre("0", "1  a", "2  d", "3", "4"));
    EXPECT_EQ(folded->blocks[0], whole.blocks[0]);
    EXPECT_NE(folded->blocks[1], whole.blocks[1]);
    EXPECT_EQ(folded->blocks[2], whole.blocks[6]);
    EXPECT_THAT(folded->blocks[1]->anchors, ::testing::IsSupersetOf({"a", "b", "c"}));
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for (const Container& container : folded->containers)
        ranges.emplace_back(container.first, container.last);
    EXPECT_THAT(ranges, ElementsAre(std::pair(1u, 1u), std::pair(2u, 3u)));
    // Until something of it changes, a heading is the same block again.
    EXPECT_EQ(folding.folded(whole, {{1, 5}})->blocks[1], folded->blocks[1]);
}

TEST(FoldingTest, AFoldInAFoldIsHiddenWithIt) {
    const Model whole = reportOf(sample);
    Folding folding;
    EXPECT_THAT(texts(*folding.folded(whole, {{1, 5}, {3, 4}, {6, 7}})),
                ElementsAre("0", "1  a", "2  d", "4"));
    EXPECT_THAT(texts(*folding.folded(whole, {{3, 4}})),
                ElementsAre("0", "1  a", "1", "1.1  b", "1.2  c", "2  d", "3", "4"));
}

TEST(FoldingTest, AFrameGoesWithWhatIsInItAndEndsWhereTheRestEnds) {
    Model whole = reportOf(sample);
    whole.boxes = {{.first = 0, .last = 2}, {.first = 2, .last = 4}, {.first = 5, .last = 7}};
    Folding folding;
    const auto folded = folding.folded(whole, {{1, 5}});
    ASSERT_EQ(folded->boxes.size(), 2u);
    EXPECT_EQ(folded->boxes[0].last, 1u);
    EXPECT_EQ(folded->boxes[1].first, 2u);
    EXPECT_EQ(folded->boxes[1].last, 3u);
}

TEST(FoldingTest, WhatIsHiddenIsCounted) {
    const Model model = reportOf(
        named("a", paragraph("1") +
                       "<FIGURE><IMAGE FILE=\"a.png\"></IMAGE><CAPTION>{c}</CAPTION></FIGURE>" +
                       named("b", paragraph("2") + "<TABLE><ROW><CELL>{x}</CELL></ROW></TABLE>")));
    const std::vector<Section> sections = sectionsOf(model);
    ASSERT_EQ(sections.size(), 2u);
    const SectionCounts counts = countsOf(model, sections[0]);
    EXPECT_EQ(counts.sections, 1u);
    EXPECT_EQ(counts.figures, 1u);
    EXPECT_EQ(counts.tables, 1u);
    EXPECT_EQ(counts.paragraphs, 2u); // without the caption
}

TEST(FoldingTest, ATextWithoutHeadingsHasNoSections) {
    EXPECT_THAT(sectionsOf(reportOf(paragraph("1"))), IsEmpty());
    EXPECT_THAT(sectionsOf(reportOf("")), IsEmpty());
}

} // namespace
} // namespace model
