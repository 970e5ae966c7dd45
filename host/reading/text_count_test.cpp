// Words and characters of a document and of a part of it.
#include "excerpts/selected.h"
#include "reading/text_count.h"

#include "document/document.h"
#include "schemas/schemas.h"

#include <gtest/gtest.h>

namespace reading {

using model::buildModel, model::excerpt;
namespace {

class TextCountTest : public ::testing::Test {
protected:
    void read(const std::string& body) {
        document_ = std::make_unique<document::Document>("DOCUMENT REPORT\n<REPORT>\n" + body +
                                                         "</REPORT>\n");
        model_ = buildModel(*document_, schemas_.presentation("REPORT"), schemas_);
    }
    [[nodiscard]] TextCount counted(const std::string& from, const std::string& to) const {
        const std::string& bytes = document_->bytes();
        return countText(
            excerpt(document_->tree(), model_, {bytes.find(from), bytes.find(to) + to.size()}));
    }

    schemas::Schemas schemas_ = schemas::Schemas::builtIn();
    std::unique_ptr<document::Document> document_;
    Model model_;
};

TEST_F(TextCountTest, WhatWasWrittenCountsAndWhatIsGeneratedDoesNot) {
    read("<SECTION ID=\"a\"><HEADING>{Start now}</HEADING>\n"
         "<PARAGRAPH><TEXT>{One t}</TEXT><EMPH>{w}</EMPH><TEXT>{o, see }</TEXT><REF TO=\"a\"></REF>"
         "<TEXT>{.}</TEXT><FOOTNOTE>{A note.}</FOOTNOTE></PARAGRAPH>\n"
         "<TABLE><ROW><CELL>{3}</CELL><CELL>{4 m}</CELL></ROW></TABLE></SECTION>\n");
    const TextCount count = countText(model_);
    EXPECT_EQ(count.words, 2u + 3 + 2 + 3);
    EXPECT_EQ(count.characters, 9u + 14 + 7 + 4);
    EXPECT_EQ(count.notBlank, 8u + 11 + 6 + 3);
}

TEST_F(TextCountTest, LettersWithAccentsAreOneEach) {
    read("<PARAGRAPH>{na\u00EFve e\u0301te\u0301 don't}</PARAGRAPH>\n");
    EXPECT_EQ(countText(model_), (TextCount{3, 15, 13}));
}

TEST_F(TextCountTest, APartCountsAlone) {
    read("<PARAGRAPH>{One two three}</PARAGRAPH>\n<PARAGRAPH>{four five}</PARAGRAPH>\n");
    EXPECT_EQ(counted("two", "four").words, 3u);
    EXPECT_EQ(counted("wo", "thr").words, 2u);
}

} // namespace
} // namespace reading
