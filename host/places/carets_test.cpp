// Carets on the pages of small documents, and the places in the documents' bytes.
#include "places/carets.h"

#include "document/document.h"
#include "paragraphs/measure.h"
#include "schemas/schemas.h"

#include <gmock/gmock.h>

#include <set>

namespace places {

using layout::layOut;
using layout::Pages;
using paragraphs::fromPixels;

namespace {

class CaretsTest : public ::testing::Test {
protected:
    // A report with that body.
    void open(const std::string& body) {
        document_ = std::make_unique<document::Document>("DOCUMENT REPORT\n<REPORT><SECTION>" +
                                                         body + "</SECTION></REPORT>");
        const schemas::Schemas schemas = schemas::Schemas::builtIn();
        const auto model = std::make_shared<model::Model>(
            model::buildModel(*document_, schemas.presentation("REPORT", {}), schemas));
        pages_ = layOut(model, {[](document::SubdocumentId) { return fromPixels({40, 30}); }, {}});
    }
    static std::string paragraph(const std::string& text) {
        return "<PARAGRAPH><TEXT>{" + text + "}</TEXT></PARAGRAPH>";
    }
    Carets carets() const { return Carets(pages_, document_->tree()); }
    std::size_t placeBefore(const std::string& words) const {
        return document_->bytes().find(words);
    }
    Caret caretBefore(const std::string& words) const {
        return carets().of(placeBefore(words), 0).value();
    }
    // The document's bytes behind a caret, so many of them.
    std::string behind(const Caret& caret, std::size_t count) const {
        return document_->bytes().substr(carets().placeOf(caret), count);
    }
    std::string movedTo(const std::string& words, Move move, std::size_t count = 4) const {
        const Carets all = carets();
        const Caret from = caretBefore(words);
        return behind(all.moved(from, move, all.rectOf(from).x()), count);
    }
    // From the first place on, as often as the caret goes on.
    std::vector<std::size_t> walk(Move move, Move toStart) const {
        const Carets all = carets();
        Caret caret = all.moved(all.at(0, {0, 0}).value(), toStart);
        std::vector<std::size_t> places{all.placeOf(caret)};
        for (Caret next = all.moved(caret, move); !(next == caret);
             caret = next, next = all.moved(caret, move)) {
            places.push_back(all.placeOf(next));
            if (places.size() > 10'000)
                break;
        }
        return places;
    }

    std::unique_ptr<document::Document> document_;
    Pages pages_;
};

TEST_F(CaretsTest, ALineBeginsBeforeAndEndsBehindTheUnitsInIt) {
    const std::string note = "<FOOTNOTE>{A note}</FOOTNOTE>",
                      formula = "<FORMULA>{E = m}</FORMULA>", reference = "<REF TO=\"x\"></REF>";
    for (const std::string& unit : {note, formula, reference}) {
        open("<PARAGRAPH>" + unit + "<TEXT>{see}</TEXT>" + unit + "</PARAGRAPH>");
        const std::size_t first = placeBefore("<PARAGRAPH>") + 11,
                          last = placeBefore("</PARAGRAPH>");
        const Carets all = carets();
        for (const Move move : {Move::lineStart, Move::documentStart})
            EXPECT_EQ(all.placeOf(all.moved(caretBefore("see"), move)), first) << unit;
        for (const Move move : {Move::lineEnd, Move::documentEnd})
            EXPECT_EQ(all.placeOf(all.moved(caretBefore("see"), move)), last) << unit;
        for (const std::size_t place : {first, last})
            EXPECT_EQ(all.placeOf(all.of(place, 0).value()), place) << unit;
        EXPECT_LT(all.rectOf(all.of(first, 0).value()).x(), all.rectOf(caretBefore("see")).x());
        EXPECT_GT(all.rectOf(all.of(last, 0).value()).x(),
                  all.rectOf(caretBefore("}</TEXT>" + unit)).x());
    }
}

TEST_F(CaretsTest, UnitsWithoutTextAroundHaveACaretOnEachSide) {
    open("<PARAGRAPH><FORMULA>{a}</FORMULA><FORMULA>{b}</FORMULA></PARAGRAPH>");
    const std::size_t first = placeBefore("<FORMULA>"), between = placeBefore("<FORMULA>{b"),
                      last = placeBefore("</PARAGRAPH>");
    EXPECT_EQ(walk(Move::right, Move::documentStart),
              (std::vector<std::size_t>{first, between, last}));
    EXPECT_EQ(walk(Move::left, Move::documentEnd),
              (std::vector<std::size_t>{last, between, first}));
    EXPECT_EQ(carets().selected(0, {first, last}).size(), 1U);
    EXPECT_EQ(carets().selected(0, {first, between}).size(), 1U);
    // With an empty text behind, as documents may have it.
    open("<PARAGRAPH><TEXT>{See }</TEXT><FORMULA>{E = m}</FORMULA><TEXT>{}</TEXT></PARAGRAPH>");
    EXPECT_EQ(movedTo("See", Move::lineEnd, 6), "}</TEX");
}

TEST_F(CaretsTest, EveryPlaceOfATextHasItsCaretWhateverTheBytesOfALetter) {
    open(paragraph("a\\{b\u00E4\u20AC\U0001F600c\\\\d"));
    const std::size_t first = placeBefore("a\\{b");
    // a, \{, b, two bytes, three, four, c, two backslashes, d
    for (const std::size_t at : {0, 1, 3, 4, 6, 9, 13, 14, 16, 17}) {
        const std::optional<Caret> caret = carets().of(first + at, 0);
        ASSERT_TRUE(caret) << at;
        EXPECT_EQ(carets().placeOf(*caret), first + at);
    }
}

TEST_F(CaretsTest, AWalkComesToEachLetterOnceAndBackTheSameWay) {
    open(paragraph("one two") + paragraph("") + paragraph("e\u0301 end"));
    std::vector<std::size_t> there = walk(Move::right, Move::documentStart);
    // 8 places of the first, 1 of the empty one, 6 of the last: the accent belongs to its letter.
    EXPECT_EQ(there.size(), 8U + 1 + 6);
    EXPECT_TRUE(std::ranges::is_sorted(there));
    std::vector<std::size_t> back = walk(Move::left, Move::documentEnd);
    std::ranges::reverse(back);
    EXPECT_EQ(there, back);
}

TEST_F(CaretsTest, LettersFromRightToLeftGoTheOtherWay) {
    const std::string hebrew = "\u05D0\u05D1\u05D2\u05D3";
    open(paragraph(hebrew));
    const std::size_t first = placeBefore(hebrew);
    const Carets all = carets();
    const Caret begin = all.of(first, 0).value();
    const Caret left = all.moved(begin, Move::left);
    EXPECT_EQ(all.placeOf(left), first + 2);
    EXPECT_LT(all.rectOf(left).x(), all.rectOf(begin).x());
    EXPECT_EQ(all.moved(left, Move::right), begin);
}

TEST_F(CaretsTest, AWordFromRightToLeftInALineIsCrossedBothWays) {
    const std::string hebrew = "\u05D0\u05D1\u05D2";
    open(paragraph("ab " + hebrew + " cd"));
    EXPECT_EQ(walk(Move::right, Move::documentStart).size(), 10U);
    EXPECT_EQ(walk(Move::left, Move::documentEnd).size(), 10U);
}

TEST_F(CaretsTest, WhatIsGeneratedHasNoPlaceOfItsOwn) {
    open("<LIST KIND=\"number\"><ITEM><TEXT>{First}</TEXT></ITEM></LIST>"
         "<PARAGRAPH><TEXT>{See }</TEXT><REF TO=\"x\"></REF><TEXT>{ there}</TEXT>"
         "<FOOTNOTE><TEXT>{A note}</TEXT></FOOTNOTE><TEXT>{, and on}</TEXT></PARAGRAPH>");
    const std::vector<std::size_t> all = walk(Move::right, Move::documentStart);
    // First 6, "See " 5, " there" 7, ", and on" 9, the note 7.
    EXPECT_EQ(all.size(), 6U + 5 + 7 + 9 + 7);
    for (const std::size_t place : all)
        EXPECT_EQ(carets().placeOf(carets().of(place, 0).value()), place);
}

TEST_F(CaretsTest, WhereTwoTextsMeetIsOnePlace) {
    open("<PARAGRAPH><TEXT>{ab}</TEXT><EMPH>{cd}</EMPH></PARAGRAPH>");
    EXPECT_EQ(walk(Move::right, Move::documentStart).size(), 5U);
    EXPECT_EQ(behind(caretBefore("cd}"), 2), "}<"); // the end of the first
    EXPECT_EQ(movedTo("b}", Move::right, 2), "}<");
}

TEST_F(CaretsTest, APlaceBetweenElementsHasTheNearestCaret) {
    open(paragraph("near") + "\n\n" + paragraph("far away from it"));
    EXPECT_EQ(behind(carets().of(placeBefore("\n\n"), 0).value(), 1), "}");
    EXPECT_EQ(behind(carets().of(0, 0).value(), 4), "near");
}

TEST_F(CaretsTest, BlanksThatAreShownAsOneAreOne) {
    open(paragraph("one\n     two"));
    EXPECT_EQ(walk(Move::right, Move::documentStart).size(), 8U);
    EXPECT_EQ(movedTo("\n     two", Move::right, 3), "two");
}

TEST_F(CaretsTest, UpAndDownKeepTheColumn) {
    std::string text;
    for (int i = 0; i < 60; ++i)
        text += "word" + std::to_string(100 + i) + " ";
    open(paragraph(text) + paragraph("short") + paragraph(text));
    const Carets all = carets();
    const Caret from = caretBefore("word105");
    const double x = all.rectOf(from).x();
    Caret caret = from;
    for (int i = 0; i < 12; ++i)
        caret = all.moved(caret, Move::down, x);
    EXPECT_GT(all.placeOf(caret), placeBefore("short"));
    EXPECT_NEAR(all.rectOf(caret).x(), x, 200);
    for (int i = 0; i < 12; ++i)
        caret = all.moved(caret, Move::up, x);
    EXPECT_EQ(caret, from);
}

TEST_F(CaretsTest, TheEndOfABrokenLineStaysOnIt) {
    std::string text;
    for (int i = 0; i < 60; ++i)
        text += "word" + std::to_string(100 + i) + " ";
    open(paragraph(text));
    const Carets all = carets();
    const Caret first = caretBefore("word100");
    const Caret end = all.moved(first, Move::lineEnd);
    EXPECT_EQ(all.rectOf(end).y(), all.rectOf(first).y());
    EXPECT_GT(all.rectOf(end).x(), all.rectOf(first).x());
    EXPECT_EQ(all.moved(end, Move::lineStart), first);
    EXPECT_GT(all.rectOf(all.moved(end, Move::right)).y(), all.rectOf(end).y());
}

TEST_F(CaretsTest, CellsOfATableAreLeftBelowInTheirColumn) {
    const auto cell = [](const std::string& text) {
        return "<CELL><TEXT>{" + text + "}</TEXT></CELL>";
    };
    open("<TABLE><ROW>" + cell("upper one") + cell("upper two") + "</ROW><ROW>" +
         cell("lower one") + cell("lower two") +
         "</ROW><CAPTION><TEXT>{Caption}</TEXT></CAPTION></TABLE>");
    EXPECT_EQ(movedTo("upper two", Move::down, 9), "lower two");
    EXPECT_EQ(movedTo("lower one", Move::up, 9), "upper one");
    EXPECT_EQ(movedTo("}</TEXT></CELL><CELL><TEXT>{upper two", Move::right, 9), "upper two");
    EXPECT_EQ(behind(caretBefore("Caption"), 7), "Caption");
}

// The footnotes of a page are beside its text, not in it.
TEST_F(CaretsTest, DownPassesTheFootnotesOfThePage) {
    const std::string table = "<TABLE><ROW><CELL><TEXT>{cell}</TEXT></CELL></ROW></TABLE>";
    open("<PARAGRAPH><TEXT>{above}</TEXT><FOOTNOTE>{note one}</FOOTNOTE></PARAGRAPH>" + table +
         "<PAGEBREAK></PAGEBREAK>" + paragraph("next page") + table);
    ASSERT_EQ(pages_.pages.size(), 2u);
    const auto comesTo = [&](const std::string& from, Move move, const std::string& to) {
        const Carets all = carets();
        const Caret moved = all.moved(caretBefore(from), move, 0), wanted = caretBefore(to);
        return moved.page == wanted.page && moved.piece == wanted.piece;
    };
    EXPECT_TRUE(comesTo("cell", Move::down, "next page"));
    EXPECT_TRUE(comesTo("next page", Move::up, "cell"));
    EXPECT_TRUE(comesTo("note one", Move::up, "cell"));
    EXPECT_TRUE(comesTo("note one", Move::down, "next page"));
}

TEST_F(CaretsTest, WordsAndParagraphsAreAroundAPlace) {
    open(paragraph("The quick, brown fox") + paragraph("Other"));
    const Carets all = carets();
    const auto word = all.wordAt(caretBefore("ick, br"));
    EXPECT_EQ(behind(word.first, 6), "quick,");
    EXPECT_EQ(behind(word.second, 1), ",");
    const auto whole = all.paragraphAt(word.first);
    EXPECT_EQ(behind(whole.first, 3), "The");
    EXPECT_EQ(behind(whole.second, 3), "}</");
    EXPECT_EQ(movedTo("quick", Move::wordRight, 1), ",");
    EXPECT_EQ(movedTo("brown", Move::wordLeft, 1), ",");
    EXPECT_EQ(movedTo("The", Move::wordRight, 5), "quick");
}

TEST_F(CaretsTest, APointHasTheNearestPlace) {
    open(paragraph("first line") + paragraph("second line"));
    const Carets all = carets();
    const QRectF second = all.rectOf(caretBefore("second"));
    EXPECT_EQ(behind(all.at(0, second.center() + QPointF(3, 0)).value(), 6), "second");
    EXPECT_EQ(behind(all.at(0, {1, second.center().y()}).value(), 6), "second");
    EXPECT_EQ(behind(all.at(0, {1e5, second.center().y()}).value(), 2), "}<");
    EXPECT_EQ(behind(all.at(0, {second.x(), 1e5}).value(), 6), "second");
}

TEST_F(CaretsTest, ASelectionIsOneRectangleInEachLine) {
    open(paragraph("one two three") + paragraph("") + paragraph("four five"));
    const Carets all = carets();
    const auto two = all.selected(0, {placeBefore("two"), placeBefore(" three")});
    ASSERT_EQ(two.size(), 1U);
    EXPECT_NEAR(two[0].left(), all.rectOf(caretBefore("two")).x(), 1);
    EXPECT_NEAR(two[0].right(), all.rectOf(caretBefore(" three")).x(), 1);
    // The end of the first paragraph, the empty one, the beginning of the last.
    EXPECT_EQ(all.selected(0, {placeBefore("three"), placeBefore(" five")}).size(), 2U + 1 + 1);
    EXPECT_TRUE(all.selected(0, {placeBefore("two"), placeBefore("two")}).empty());
}

TEST_F(CaretsTest, ASelectionInLettersOfBothDirectionsHasAsManyPartsAsItLooks) {
    const std::string hebrew = "\u05D0\u05D1\u05D2\u05D3";
    open(paragraph("ab " + hebrew + " cd"));
    // "b " and the first two of the Hebrew letters, which stand at the right of that word.
    const auto parts = carets().selected(0, {placeBefore("b " + hebrew), placeBefore(hebrew) + 4});
    EXPECT_EQ(parts.size(), 2U);
}

TEST_F(CaretsTest, NumbersAndMarksAreSelectedWithTheTextAroundThem) {
    open("<PARAGRAPH><TEXT>{before }</TEXT><REF TO=\"x\"></REF><TEXT>{ behind}</TEXT></PARAGRAPH>");
    EXPECT_EQ(carets().selected(0, {placeBefore("fore"), placeBefore("hind")}).size(), 1U);
    const Carets all = carets();
    const auto part = all.selected(0, {placeBefore("fore"), placeBefore("}</TEXT><REF")});
    ASSERT_EQ(part.size(), 1U);
    EXPECT_NEAR(part[0].right(), all.rectOf(caretBefore("}</TEXT><REF")).x(), 1);
}

TEST_F(CaretsTest, AFormulaIsOneSignThatIsSelectedAsAWhole) {
    open("<PARAGRAPH><TEXT>{ab }</TEXT><FORMULA>{a^2 + b^2 = c^2}</FORMULA>"
         "<TEXT>{ cd efgh ijkl}</TEXT></PARAGRAPH>");
    EXPECT_EQ(walk(Move::right, Move::documentStart).size(), 4U + 14);
    const Carets all = carets();
    const auto part = all.selected(0, {placeBefore("ab "), placeBefore(" efgh")});
    ASSERT_EQ(part.size(), 1U);
    EXPECT_NEAR(part[0].right(), all.rectOf(caretBefore(" efgh")).x(), 1);
}

TEST_F(CaretsTest, PagesFarAwayAreFound) {
    std::string body;
    for (int i = 0; i < 400; ++i)
        body += paragraph("Paragraph " + std::to_string(1000 + i));
    open(body);
    ASSERT_GT(pages_.pages.size(), 5U);
    const Caret caret = caretBefore("Paragraph 1399");
    EXPECT_EQ(caret.page, pages_.pages.size() - 1);
    EXPECT_EQ(walk(Move::down, Move::documentStart).size(), 400U);
    EXPECT_EQ(walk(Move::up, Move::documentEnd).size(), 400U);
}

} // namespace
} // namespace places
