// A model that followed edits is the model that is made anew, and following costs what the edit
// reaches.
#include "document/random_report.h"
#include "model/model_builder.h"
#include "model/same_blocks.h"

#include <gtest/gtest.h>

#include <set>

namespace model {

namespace {

// A document, and a model of it that follows.
class Followed {
public:
    Followed(const std::string& bytes, const QString& presentation, int spacing)
        : document(bytes), by_(schemas().presentation(document.className(), presentation)),
          styles_(std::make_shared<schemas::TextStyles>()),
          builder(document, by_, schemas(), styles_, spacing) {
        QObject::connect(&document, &document::Document::edited, &document,
                         [this](const sgml::Change& change) { builder.follow(change); });
        complete();
    }
    void complete() {
        while (builder.step(50))
            continue;
    }
    // The first thing that follows differently; "" when nothing does.
    std::string difference() {
        complete();
        ModelBuilder anew(document, by_, schemas(), styles_);
        while (anew.step(1000))
            continue;
        const Model& one = *builder.model();
        const Model& other = *anew.model();
        if (printed(one) != printed(other))
            return printed(one) + "\n--- but anew:\n" + printed(other);
        for (std::size_t i = 0; i < other.blocks.size(); ++i)
            if (!isEqual(*one.blocks[i], *other.blocks[i]))
                return "block " + std::to_string(i);
        for (std::size_t i = 0; i < other.boxes.size(); ++i)
            if (one.boxes[i].indentLeft != other.boxes[i].indentLeft ||
                one.boxes[i].padding != other.boxes[i].padding ||
                one.boxes[i].border != other.boxes[i].border)
                return "box " + std::to_string(i);
        std::size_t note = 0;
        for (const auto& block : one.blocks)
            for (const Run& run : block->runs)
                if (run.footnote) {
                    while (note < one.footnotes.size() && one.footnotes[note] != run.footnote)
                        ++note;
                    if (note == one.footnotes.size())
                        return "a footnote that is not in the list";
                }
        return {};
    }

    static const schemas::Schemas& schemas() {
        static const schemas::Schemas all = schemas::Schemas::builtIn();
        return all;
    }

    document::Document document;

private:
    const schemas::Presentation& by_;
    std::shared_ptr<schemas::TextStyles> styles_;

public:
    ModelBuilder builder;
};

} // namespace

TEST(ModelFollow, AfterEveryEditTheModelIsThatOfANewWalk) {
    std::size_t edits = 0, walked = 0, all = 0;
    for (std::uint64_t seed = 0; seed < 45; ++seed) {
        document::Author author(seed);
        const bool memo = seed % 3 == 0;
        const std::string text = memo ? author.memo(120) : author.report(120);
        const char* const presentations[] = {"", memo ? "slides" : "outline"};
        Followed followed(text, presentations[seed / 3 % 2], 1 + static_cast<int>(seed % 7));
        const std::size_t nodes = followed.builder.work().nodes;
        for (int i = 0; i < 60; ++i) {
            const std::size_t before = followed.builder.work().nodes;
            const std::size_t what = author.below(10);
            if (what < 7)
                (void)followed.document.edit(author.edit(followed.document.tree()), "Edit");
            else if (what < 9)
                followed.document.undo();
            else
                followed.document.redo();
            if (author.below(5) == 0)
                continue; // two changes at once
            if (author.below(5) == 0 && followed.builder.step(20))
                continue; // a change while it is being followed
            ASSERT_EQ(followed.difference(), "") << "seed " << seed << " edit " << i << "\n"
                                                 << followed.document.bytes();
            walked += followed.builder.work().nodes - before;
            all += nodes;
            ++edits;
        }
    }
    EXPECT_GT(edits, 1500u);
    EXPECT_LT(walked, all / 2);
}

namespace {

std::string longReport(int sections) {
    std::string text = "DOCUMENT REPORT\n<REPORT>\n<TITLE>{A long one}</TITLE>\n";
    for (int i = 0; i < sections; ++i) {
        const std::string number = std::to_string(i);
        text += "<SECTION ID=\"s" + number + "\"><HEADING>{Section " + number + "}</HEADING>\n";
        for (int k = 0; k < 10; ++k)
            text += "<PARAGRAPH><TEXT>{" + std::string(500, 'w') + number + "}</TEXT><REF TO=\"s" +
                    std::to_string((i * 7 + k) % sections) + "\"></REF></PARAGRAPH>\n";
        text += "<SECTION><HEADING>{Inner}</HEADING><LIST><ITEM>{a}</ITEM><ITEM>{b}</ITEM></LIST>"
                "</SECTION></SECTION>\n";
    }
    return text + "</REPORT>";
}

// An edit in the middle of a document of so many sections: the nodes that following it walks over,
// and the blocks that are new.
ModelBuilder::Work workOf(int sections, const std::string& before, const std::string& inserted) {
    Followed followed(longReport(sections), "", 100);
    const std::shared_ptr<const Model> old = followed.builder.model();
    const ModelBuilder::Work work = followed.builder.work();
    const std::string& bytes = followed.document.bytes();
    const std::size_t at = bytes.find(before, bytes.size() / 2);
    (void)followed.document.edit({{{at, at}, inserted}}, "Edit");
    followed.complete();
    const std::set<std::shared_ptr<const Block>> known(old->blocks.begin(), old->blocks.end());
    std::size_t others = 0;
    for (const auto& block : followed.builder.model()->blocks)
        others += known.contains(block) ? 0 : 1;
    const ModelBuilder::Work now = followed.builder.work();
    EXPECT_EQ(now.blocks - work.blocks, others);
    EXPECT_EQ(followed.difference(), "");
    return {.nodes = now.nodes - work.nodes, .blocks = others};
}

} // namespace

TEST(ModelFollow, WhatAnEditCostsDoesNotGrowWithTheDocument) {
    for (const int sections : {20, 200}) {
        const ModelBuilder::Work letter = workOf(sections, "wwww", "x");
        EXPECT_LE(letter.nodes, 200u) << sections;
        EXPECT_EQ(letter.blocks, 1u) << sections;
        const ModelBuilder::Work enter =
            workOf(sections, "wwww", "}</TEXT></PARAGRAPH>\n<PARAGRAPH><TEXT>{");
        EXPECT_LE(enter.nodes, 210u) << sections;
        EXPECT_LE(enter.blocks, 2u) << sections;
        // The number of the inner section behind it changes, and no other.
        const ModelBuilder::Work inner = workOf(sections, "<SECTION><HEADING>{Inner}",
                                                "<SECTION><HEADING>{New}</HEADING></SECTION>");
        EXPECT_LE(inner.nodes, 210u) << sections;
        EXPECT_EQ(inner.blocks, 2u) << sections;
    }
}

// A block that changed holds the same blocks as before in its other cells and footnotes.
TEST(ModelFollow, ALetterLeavesOtherCellsAndFootnotesAsTheyAre) {
    Followed followed(
        "DOCUMENT REPORT\n<REPORT><TABLE><ROW><CELL>{one}</CELL><CELL>{two}</CELL></ROW>"
        "<ROW><CELL>{three}</CELL><CELL>{four}</CELL></ROW></TABLE>\n"
        "<PARAGRAPH><TEXT>{words}</TEXT><FOOTNOTE>{note}</FOOTNOTE></PARAGRAPH>"
        "</REPORT>",
        "", 100);
    const std::shared_ptr<const Model> old = followed.builder.model();
    for (const std::string word : {"three", "words"}) {
        const std::size_t at = followed.document.bytes().find(word);
        (void)followed.document.edit({{{at, at}, "x"}}, "Typing");
    }
    EXPECT_EQ(followed.difference(), "");
    const Model& now = *followed.builder.model();
    ASSERT_EQ(now.blocks.size(), 2u);
    const auto cell = [](const Model& model, std::size_t row, std::size_t column) {
        return model.blocks[0]->rows[row][column].blocks[0];
    };
    EXPECT_NE(now.blocks[0], old->blocks[0]);
    EXPECT_EQ(cell(now, 0, 0), cell(*old, 0, 0));
    EXPECT_EQ(cell(now, 1, 1), cell(*old, 1, 1));
    EXPECT_NE(cell(now, 1, 0), cell(*old, 1, 0));
    EXPECT_NE(now.blocks[1], old->blocks[1]);
    EXPECT_EQ(now.footnotes.at(0), old->footnotes.at(0));
    EXPECT_EQ(now.blocks[1]->runs.at(1).footnote, old->footnotes.at(0));
}

// The entries of a table of contents follow the headings, and a letter elsewhere leaves them as
// they are.
TEST(ModelFollow, ContentsFollowTheirHeadingsAndCaptions) {
    Followed followed("DOCUMENT REPORT\n<REPORT><CONTENTS></CONTENTS><CONTENTS OF=\"tables\">"
                      "</CONTENTS><SECTION><HEADING>{One}</HEADING><PARAGRAPH>{words}</PARAGRAPH>"
                      "<SECTION><HEADING>{Two}</HEADING><TABLE><ROW><CELL>{a}</CELL></ROW>"
                      "<CAPTION>{Masses}</CAPTION></TABLE></SECTION></SECTION></REPORT>",
                      "", 1);
    const auto contents = [&](std::size_t which) {
        for (const auto& block : followed.builder.model()->blocks)
            if (block->kind == BlockKind::contents && which-- == 0)
                return block;
        return std::shared_ptr<const Block>();
    };
    const auto entries = [&](std::size_t which) {
        std::string all;
        for (const auto& entry : contents(which)->entries)
            all += entry->runs.front().text + "|" + std::to_string(entry->style.indentLeft)[0];
        return all;
    };
    EXPECT_EQ(entries(0), "1  One|01.1  Two|1");
    EXPECT_EQ(entries(1), "Table 1: Masses|0");
    const auto before = contents(0);
    const auto edit = [&](const std::string& at, const std::string& put) {
        const std::size_t place = followed.document.bytes().find(at);
        (void)followed.document.edit({{{place, place}, put}}, "Typing");
        EXPECT_EQ(followed.difference(), "");
    };
    edit("words", "x");
    EXPECT_EQ(contents(0), before);
    edit("Two}", "x");
    EXPECT_NE(contents(0), before);
    EXPECT_EQ(contents(0)->entries[0], before->entries[0]);
    EXPECT_EQ(entries(0), "1  One|01.1  xTwo|1");
    edit("<SECTION><HEADING>{One", "<SECTION><HEADING>{New}</HEADING></SECTION>");
    EXPECT_EQ(entries(0), "1  New|02  One|02.1  xTwo|1");
}

// A section before it that is entered by a checkpoint already counts from then on, too.
TEST(ModelFollow, AHeadingThatGetsItsFirstLetterBeginsToCount) {
    Followed followed(
        "DOCUMENT REPORT\n<REPORT><SECTION><HEADING>{}</HEADING><SECTION><HEADING>{}"
        "</HEADING><PARAGRAPH>{a}</PARAGRAPH></SECTION></SECTION><SECTION><HEADING>{b}"
        "</HEADING></SECTION></REPORT>",
        "", 1);
    const auto type = [&](std::size_t at, std::string_view text, std::size_t erased) {
        (void)followed.document.edit({{{at, at + erased}, std::string(text)}}, "Edit");
        return followed.difference();
    };
    const auto lastMarker = [&] { return followed.builder.model()->blocks.back()->marker; };
    const std::size_t first = followed.document.bytes().find("{}") + 1;
    const std::size_t second = followed.document.bytes().find("{}", first) + 1;
    EXPECT_EQ(lastMarker(), "1  ");
    EXPECT_EQ(type(second, "x", 0), "");
    EXPECT_EQ(lastMarker(), "2  ");
    EXPECT_EQ(type(first, "y", 0), "");
    EXPECT_EQ(lastMarker(), "2  ");
    EXPECT_EQ(followed.builder.model()->blocks[1]->marker, "1.1  ");
    EXPECT_EQ(type(second + 1, "", 1), "");
    EXPECT_EQ(followed.builder.model()->blocks[1]->marker, "");
}

// The numbers of all sections behind it change, and what refers to these wherever it stands.
TEST(ModelFollow, AReferenceFollowsTheWordsOfItsHeadingAndTellsThatTheyAreGone) {
    Followed followed("DOCUMENT CMEMO\n<CMEMO><SUBJECT>{S}</SUBJECT><BODY><PARAGRAPH>"
                      "<REF TO=\"s\"></REF></PARAGRAPH><SECTION ID=\"s\"><HEADING>{One}</HEADING>"
                      "<PARAGRAPH>{a}</PARAGRAPH></SECTION></BODY></CMEMO>",
                      "", 1);
    const auto reference = [&] { return followed.builder.model()->blocks[2]->runs.front(); };
    EXPECT_EQ(followed.difference(), "");
    ASSERT_EQ(reference().text, "One");
    const std::uint32_t usual = reference().style;
    const auto edit = [&](const std::string& words, const std::string& with) {
        const std::size_t at = followed.document.bytes().find(words);
        (void)followed.document.edit({{{at, at + words.size()}, with}}, "Edit");
        return followed.difference();
    };
    EXPECT_EQ(edit("One", "Two"), "");
    EXPECT_EQ(reference().text, "Two");
    EXPECT_EQ(edit("ID=\"s\"", ""), "");
    EXPECT_EQ(reference().text, "(missing)");
    EXPECT_NE(reference().style, usual);
    followed.document.undo();
    EXPECT_EQ(followed.difference(), "");
    EXPECT_EQ(reference().text, "Two");
    EXPECT_EQ(reference().style, usual);
}

TEST(ModelFollow, AHeadingNumbersWhatFollowsAndNothingElse) {
    const ModelBuilder::Work work =
        workOf(200, "<SECTION ID", "<SECTION><HEADING>{New}</HEADING></SECTION>");
    EXPECT_LE(work.nodes, 6000u); // of 10,203
    const std::size_t headings = 1 + 2 * 100, references = 200 * 10 / 2;
    EXPECT_LE(work.blocks, headings + references + 20);
    EXPECT_GE(work.blocks, headings + references - 20);
}

} // namespace model
