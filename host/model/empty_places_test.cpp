// Places that wait for text, and models without them.
#include "model/empty_places.h"
#include "model/model_builder.h"

#include <gmock/gmock.h>

namespace model {
namespace {

using ::testing::ElementsAre;

const schemas::Schemas& schemasWithHints() {
    static const schemas::Schemas all = schemas::Schemas::builtIn();
    return all;
}

Model formOf(const std::string& className, const std::string& inside) {
    const document::Document document("DOCUMENT " + className + "\n<" + className + ">" + inside +
                                      "</" + className + ">\n");
    return buildModel(document, schemasWithHints().presentation(className), schemasWithHints());
}

std::vector<std::string> shownLines(const Model& model) {
    std::vector<std::string> result;
    for (const auto& block : model.blocks)
        result.push_back(block->marker + (block->runs.empty() ? "" : block->runs.front().text));
    return result;
}

TEST(EmptyPlacesTest, WhatATemplateHasAndNobodyFilledIsNotOnPaper) {
    const Model model =
        formOf("REPORT", "<TITLE>{T}</TITLE><AUTHOR>{}</AUTHOR><ABSTRACT><PARAGRAPH><TEXT>{}</TEXT>"
                         "</PARAGRAPH></ABSTRACT><SECTION><HEADING>{One}</HEADING>"
                         "<PARAGRAPH>{text}</PARAGRAPH><PARAGRAPH></PARAGRAPH></SECTION>"
                         "<SECTION><HEADING>{}</HEADING><PARAGRAPH></PARAGRAPH></SECTION>");
    EXPECT_EQ(model.blocks[1]->style.hint, "Author");
    EXPECT_TRUE(isEmptyPlace(*model.blocks[1]));
    EXPECT_FALSE(isEmptyPlace(*model.blocks[0]));
    const auto onPaper = withoutEmptyPlaces(model);
    ASSERT_TRUE(onPaper);
    // A paragraph that somebody left empty stays.
    EXPECT_THAT(shownLines(*onPaper), ElementsAre("T", "1  One", "text", ""));
    EXPECT_TRUE(onPaper->boxes.empty()); // the abstract's
    EXPECT_EQ(model.boxes.size(), 1U);
}

TEST(EmptyPlacesTest, AMemoLosesItsEmptyHeadAndAFilledOneIsItself) {
    const std::string head = "<TO>{}</TO><FROM>{Me}</FROM><SUBJECT>{}</SUBJECT>";
    const Model model = formOf("CMEMO", head + "<BODY><PARAGRAPH>{x}</PARAGRAPH></BODY>");
    const auto onPaper = withoutEmptyPlaces(model);
    ASSERT_TRUE(onPaper);
    EXPECT_THAT(shownLines(*onPaper), ElementsAre("Memorandum", "FromMe", "x"));
    const Model filled = formOf("CMEMO", "<TO>{You}</TO><BODY><PARAGRAPH>{x}</PARAGRAPH></BODY>");
    EXPECT_EQ(withoutEmptyPlaces(filled), nullptr);
}

// On the screen as on paper; what is said of it there by its ID is said by the ID itself.
TEST(EmptyPlacesTest, ASectionCountsFromTheFirstLetterOfItsHeadingOn) {
    const Model model =
        formOf("REPORT", "<CONTENTS></CONTENTS><SECTION ID=\"a\"><HEADING><TEXT>{}</TEXT></HEADING>"
                         "<SECTION><HEADING>{Within}</HEADING></SECTION></SECTION>"
                         "<SECTION><HEADING>{Behind}</HEADING>"
                         "<SECTION><HEADING>{}</HEADING></SECTION>"
                         "<SECTION><HEADING><FORMULA>{x}</FORMULA></HEADING></SECTION></SECTION>"
                         "<PARAGRAPH><REF TO=\"a\"></REF></PARAGRAPH>"
                         "<FIGURE><VERBATIM>{v}</VERBATIM><CAPTION>{}</CAPTION></FIGURE>"
                         "<CONTENTS OF=\"figures\"></CONTENTS>");
    EXPECT_THAT(shownLines(model),
                ElementsAre("Contents", "There is no heading yet.", "", "1  Within", "2  Behind",
                            "", "2.1  x", "a", "v", "Figure 1:", "Figures",
                            "There is no figure with a caption yet."));
    std::vector<std::string> listed;
    for (const auto& block : model.blocks)
        for (const auto& entry : block->entries)
            listed.push_back(entry->runs.front().text);
    EXPECT_THAT(listed, ElementsAre("1  Within", "2  Behind", "2.1  x"));
}

} // namespace
} // namespace model
