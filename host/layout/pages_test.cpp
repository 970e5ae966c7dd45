#include "layout/paint.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "places/find.h"
#include "strips/flow.h"

#include <gmock/gmock.h>

#include <QPainter>

#include <iterator>
#include <set>
#include <sstream>

namespace layout {

using paragraphs::fromPixels;
using paragraphs::fromPoints;
using paragraphs::Materials;
using paragraphs::noted;
using paragraphs::Objects;
using paragraphs::Paragraph;
using paragraphs::paragraph;
using paragraphs::picture;
using paragraphs::tableOf;
using paragraphs::twipsPerPixel;
using places::findText;
using places::Found;

namespace {

class PagesTest : public ::testing::Test {
protected:
    PagesTest() {
        setStyle({});
        objects_.subdocumentSize = [this](document::SubdocumentId) { return size_; };
    }
    ModelPointer model() const { return std::make_shared<model::Model>(model_); }
    Pages pages() const { return layOut(model(), objects_); }
    void setStyle(const schemas::TextStyle& style) {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf(style);
        model_.textStyles = styles;
    }
    double areaHeight() const {
        return fromPoints(model_.page.height - model_.page.marginTop - model_.page.marginBottom);
    }
    static std::string lastText(const Page& page) {
        for (auto piece = page.pieces.rbegin(); piece != page.pieces.rend(); ++piece)
            if (const auto* text = std::get_if<TextPiece>(&*piece))
                return text->paragraph->textOfLine(text->line).toStdString();
        return {};
    }

    model::Model model_;
    Objects objects_;
    QSizeF size_ = fromPixels({320, 240});
};

TEST_F(PagesTest, EveryLineIsOnExactlyOnePageAndInsideTheMargins) {
    for (int i = 0; i < 200; ++i)
        model_.blocks.push_back(paragraph("Paragraph " + std::to_string(i) +
                                          std::string(300, 'x').replace(150, 1, " ")));
    const Pages laid = pages();
    std::size_t lines = 0;
    for (const auto& page : laid.pages)
        for (const Piece& piece : page->pieces) {
            const auto& text = std::get<TextPiece>(piece);
            ++lines;
            EXPECT_GE(text.at.y(), fromPoints(72));
            const double height = text.paragraph->lines()[text.line].height;
            EXPECT_LE(text.at.y() + height, laid.size.height() - fromPoints(72) + 1e-6);
        }
    std::size_t expected = 0;
    Work work;
    Stock stock(model_.textStyles);
    stock.sizes().follow(objects_);
    const Surroundings in{stock, work, fromPoints(595.276 - 144), areaHeight(), areaHeight()};
    Flow flow(in, model_.blocks);
    for (Strip strip; flow.next(strip) == Made::strip; strip = {})
        ++expected;
    EXPECT_EQ(lines, expected);
    EXPECT_GT(laid.pages.size(), 3u);
}

// Contents over several pages: each entry has the number of the page that it leads to, at the right
// edge of the text, below the ones before.
TEST_F(PagesTest, EntriesOfContentsTellThePagesThatTheyLeadTo) {
    auto contents = std::make_shared<model::Block>();
    contents->kind = model::BlockKind::contents;
    constexpr int count = 80;
    for (int i = 0; i < count; ++i) {
        const auto entry = paragraph(std::string(i % 7 == 0 ? 200 : 10, 'w').replace(5, 1, " "));
        entry->runs.front().target = "#h" + std::to_string(i);
        contents->entries.push_back(entry);
    }
    model_.blocks.push_back(contents);
    for (int i = 0; i < count; ++i) {
        const auto heading = paragraph("Heading");
        heading->anchors = {"h" + std::to_string(i)};
        heading->style.pageBreakBefore = i % 2 == 0;
        model_.blocks.push_back(heading);
    }
    const Pages laid = pages();
    int entry = 0;
    for (std::size_t page = 0; page < laid.pages.size(); ++page)
        for (const Piece& piece : laid.pages[page]->pieces)
            if (const auto* number = std::get_if<PageNumberPiece>(&piece)) {
                EXPECT_EQ(number->target, "h" + std::to_string(entry));
                EXPECT_NEAR(number->rect.right(), laid.size.width() - fromPoints(72), 1e-6);
                EXPECT_GT(number->rect.width(), fromPoints(10));
                EXPECT_TRUE(laid.pages[page]->hasPageNumbers);
                ++entry;
            }
    EXPECT_EQ(entry, count);
    const std::size_t pagesOfContents = laid.pages.size() - count / 2;
    EXPECT_GT(pagesOfContents, 1u);
    EXPECT_EQ(laid.anchor("h20")->first, pagesOfContents + 10);
}

TEST_F(PagesTest, AHeadingIsNeverTheLastOfAPage) {
    for (int i = 0; i < 300; ++i) {
        const auto block = paragraph(i % 3 == 0 ? "Heading" : "Text");
        block->style.keepWithNext = i % 3 == 0;
        model_.blocks.push_back(block);
    }
    const Pages laid = pages();
    ASSERT_GT(laid.pages.size(), 3u);
    for (const auto& page : laid.pages)
        EXPECT_EQ(lastText(*page), "Text");
}

TEST_F(PagesTest, AFigureWithoutRoomMovesToTheNextPageAndTextFillsTheGap) {
    size_ = QSizeF(fromPoints(300), areaHeight() * 0.6);
    for (int i = 0; i < 25; ++i)
        model_.blocks.push_back(paragraph("Before"));
    model_.blocks.push_back(picture(7));
    model_.blocks.push_back(paragraph("Caption"));
    for (int i = 0; i < 25; ++i)
        model_.blocks.push_back(paragraph("After"));
    const Pages laid = pages();
    ASSERT_EQ(laid.subdocuments().size(), 1u);
    EXPECT_EQ(laid.subdocuments()[0].page, 1u);
    EXPECT_EQ(laid.subdocuments()[0].rect.top(), fromPoints(72));
    EXPECT_EQ(lastText(*laid.pages[0]), "After");
}

TEST_F(PagesTest, AFigureThatDoesNotFloatKeepsItsPlaceInTheText) {
    size_ = QSizeF(fromPoints(300), areaHeight() * 0.6);
    for (int i = 0; i < 25; ++i)
        model_.blocks.push_back(paragraph("Before"));
    const auto fixed = picture(7);
    fixed->style.mayFloat = false;
    model_.blocks.push_back(fixed);
    model_.blocks.push_back(paragraph("Caption"));
    model_.blocks.push_back(paragraph("After"));
    const Pages laid = pages();
    ASSERT_EQ(laid.pages.size(), 2U);
    EXPECT_EQ(lastText(*laid.pages[0]), "Before");
    EXPECT_EQ(laid.subdocuments()[0].page, 1U);
    EXPECT_EQ(lastText(*laid.pages[1]), "After");
}

TEST_F(PagesTest, AFigureThatMovedStandsBeforeTheNextForcedBreak) {
    size_ = QSizeF(fromPoints(300), areaHeight() * 0.6);
    for (int i = 0; i < 25; ++i)
        model_.blocks.push_back(paragraph("Before"));
    model_.blocks.push_back(picture(7));
    model_.blocks.push_back(paragraph("Caption"));
    const auto heading = paragraph("Heading");
    heading->style.pageBreakBefore = true;
    model_.blocks.push_back(heading);
    const Pages laid = pages();
    ASSERT_EQ(laid.pages.size(), 3u);
    EXPECT_EQ(laid.subdocuments()[0].page, 1u);
    EXPECT_EQ(lastText(*laid.pages[1]), "Caption");
    EXPECT_EQ(lastText(*laid.pages[2]), "Heading");
}

TEST_F(PagesTest, APictureLargerThanThePageIsMadeToFit) {
    size_ = QSizeF(fromPoints(5000), fromPoints(9000));
    model_.blocks.push_back(picture(1));
    const Pages laid = pages();
    ASSERT_EQ(laid.subdocuments().size(), 1u);
    const QRectF rect = laid.subdocuments()[0].rect;
    EXPECT_LE(rect.bottom(), laid.size.height() - fromPoints(72));
    EXPECT_NEAR(rect.width() / rect.height(), 5.0 / 9.0, 1e-9);
}

TEST_F(PagesTest, AFootnoteStandsOnThePageOfItsMark) {
    for (int i = 0; i < 100; ++i)
        model_.blocks.push_back(i % 10 == 5
                                    ? noted("Text", std::to_string(i), "Note " + std::to_string(i))
                                    : paragraph("Text"));
    const std::string all = printed(pages());
    std::size_t page = 0;
    for (int i = 5; i < 100; i += 10) {
        const std::size_t mark = all.find("Text" + std::to_string(i) + "\n");
        const std::size_t note = all.find("Note " + std::to_string(i) + "\n");
        ASSERT_NE(mark, std::string::npos);
        page = all.find("page ", mark);
        EXPECT_LT(mark, note);
        EXPECT_LT(note, page);
    }
}

TEST_F(PagesTest, InlineSubdocumentsStandInTheirLine) {
    size_ = fromPixels({40, 60});
    const auto block = paragraph("before ");
    model::Run object;
    object.kind = model::RunKind::subdocument;
    object.subdocument = 3;
    block->runs.push_back(object);
    model::Run after;
    after.text = " after";
    block->runs.push_back(after);
    model_.blocks.push_back(block);
    const Pages laid = pages();
    ASSERT_EQ(laid.subdocuments().size(), 1u);
    EXPECT_EQ(laid.subdocuments()[0].rect.size(), size_);
    EXPECT_GE(laid.subdocuments()[0].rect.top(), fromPoints(72) - 1e-6);
    EXPECT_GT(laid.subdocuments()[0].rect.left(), fromPoints(72));
}

TEST_F(PagesTest, TablesFitTheirWidth) {
    std::vector<model::Row> rows(3, model::Row(4));
    for (model::Row& row : rows)
        for (model::Cell& cell : row)
            cell.blocks.push_back(paragraph("several words that want much room in a cell"));
    model_.blocks.push_back(tableOf(rows));
    const Pages laid = pages();
    for (const Piece& piece : laid.pages[0]->pieces) {
        const auto& text = std::get<TextPiece>(piece);
        EXPECT_LE(text.at.x() + text.paragraph->naturalWidth(), fromPoints(595.276 - 72) + 1);
    }
}

std::string words(int count, const std::string& name) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += (i == 0 ? "" : " ") + name + std::to_string(i);
    return text;
}

// The words on all pages, none of which stands outside the margins.
std::multiset<std::string> wordsOn(const Pages& laid, double bottom) {
    std::multiset<std::string> found;
    for (const auto& page : laid.pages)
        for (const Piece& piece : page->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece)) {
                const double height = text->letters().height;
                EXPECT_LE(text->at.y() + height, bottom + 1e-6);
                std::istringstream line(text->paragraph->textOfLine(text->line).toStdString());
                for (std::string word; line >> word;)
                    found.insert(word);
            }
    return found;
}

std::multiset<std::string> split(const std::string& text) {
    std::istringstream line(text);
    return {std::istream_iterator<std::string>(line), {}};
}

TEST_F(PagesTest, ARowTallerThanAPageGoesOnOnTheNextPages) {
    std::vector<model::Row> rows;
    std::multiset<std::string> all;
    for (const int count : {5, 3000, 8, 2000}) {
        model::Row row(2);
        const std::string left = words(count, "left" + std::to_string(count) + "-"),
                          right = words(count / 2, "right" + std::to_string(count) + "-");
        row[0].blocks.push_back(paragraph(left));
        row[1].blocks.push_back(paragraph(right));
        row[1].style.border.width = 1;
        row[1].style.padding = 4;
        all.merge(split(left));
        all.merge(split(right));
        rows.push_back(row);
    }
    const auto table = tableOf(rows);
    table->style.keepTogether = true;
    for (int i = 0; i < 20; ++i) {
        model_.blocks.push_back(paragraph("before"));
        all.insert("before");
    }
    model_.blocks.push_back(table);
    const Pages laid = pages();
    EXPECT_EQ(wordsOn(laid, laid.size.height() - fromPoints(72)), all);
    EXPECT_GT(laid.pages.size(), 5u);
    // A block that is too tall for any page begins where it stands.
    EXPECT_EQ(printed(laid).find("left5-0"), printed(laid).find("left5-"));
    EXPECT_LT(printed(laid).find("left3000-0"), printed(laid).find("page 2"));
}

TEST_F(PagesTest, ARowInARowIsDividedToo) {
    const std::string text = words(3000, "w");
    const auto inner = tableOf({model::Row(1)}), outer = tableOf({model::Row(1)});
    inner->rows[0][0].blocks.push_back(paragraph(text));
    outer->rows[0][0].blocks = {paragraph("above"), inner, paragraph("below")};
    model_.blocks.push_back(outer);
    const Pages laid = pages();
    EXPECT_EQ(wordsOn(laid, laid.size.height() - fromPoints(72)), split("above below " + text));
}

TEST_F(PagesTest, ALongFootnoteGoesOnAtTheFootOfTheNextPages) {
    std::multiset<std::string> all;
    for (int i = 0; i < 60; ++i) {
        const std::string number = std::to_string(i);
        if (i != 10 && i != 11) {
            model_.blocks.push_back(paragraph("text" + number));
            all.insert("text" + number);
            continue;
        }
        const std::string text = words(i == 10 ? 3000 : 30, "note" + number + "-");
        model_.blocks.push_back(noted("text" + number, "*", text));
        all.insert("text" + number + "*");
        all.merge(split(text));
    }
    const Pages laid = pages();
    EXPECT_EQ(wordsOn(laid, laid.size.height() - fromPoints(72)), all);
    const std::string first = printed(laid).substr(0, printed(laid).find("page 2"));
    EXPECT_NE(first.find("text10*"), std::string::npos); // its mark stays where it was
    EXPECT_NE(first.find("note10-0"), std::string::npos);
    EXPECT_EQ(first.find("note10-2999"), std::string::npos);
}

TEST_F(PagesTest, APageWithoutRoomForTextHasSomeAllTheSame) {
    model_.page.marginTop = 500;
    model_.page.marginBottom = 500;
    const auto table = tableOf({model::Row(1)});
    table->rows[0][0].blocks.push_back(paragraph(words(100, "w")));
    model_.blocks = {paragraph(words(100, "v")), table};
    EXPECT_EQ(wordsOn(pages(), 1e9).size(), 200u);
}

// A box inside boxes: one frame for each on each page, outer ones first, however they begin and
// end.
TEST_F(PagesTest, FramesLieInEachOther) {
    for (int i = 0; i < 120; ++i)
        model_.blocks.push_back(paragraph("line"));
    model::Box box;
    box.padding = 5;
    box.background = schemas::Color{1, 1, 1};
    box.border.width = 1;
    model_.boxes = {box, box, box};
    model_.boxes[0].first = model_.boxes[1].first = 2;
    model_.boxes[0].last = model_.boxes[1].last = 100;
    model_.boxes[2].first = 50;
    model_.boxes[2].last = 51;
    model_.boxes[1].indentLeft = 5;
    const Pages laid = pages();
    const auto framesOf = [](const Page& page) {
        std::vector<FramePiece> frames;
        for (const Piece& piece : page.pieces)
            if (const auto* frame = std::get_if<FramePiece>(&piece))
                frames.push_back(*frame);
        return frames;
    };
    const std::vector<FramePiece> first = framesOf(*laid.pages[0]),
                                  second = framesOf(*laid.pages[1]);
    ASSERT_GE(first.size(), 2u);
    EXPECT_LT(first[0].rect.left(), first[1].rect.left());
    EXPECT_EQ(first[1].rect.top() - first[0].rect.top(), fromPoints(5));
    EXPECT_TRUE(first[0].border.top && !first[0].border.bottom);
    EXPECT_FALSE(second[0].border.top);
}

TEST_F(PagesTest, WordsAreFoundInLongTextsToo) {
    model_.blocks.push_back(paragraph(words(30'000, "w") + " needle in hay"));
    const Pages laid = pages();
    EXPECT_EQ(findText(laid, "w29999").size(), 1u);
    const std::vector<Found> found = findText(laid, "needle in hay");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].page, laid.pages.size() - 1);
}

// Lines are the same whether a text is laid out in one piece or in several.
TEST_F(PagesTest, SegmentsLeaveNoTrace) {
    const std::string text = words(5000, "some");
    const auto block = paragraph(text);
    block->style.align = schemas::Align::justify;
    Paragraph whole(std::make_shared<Materials>(model_.textStyles), block, 8000);
    std::string together;
    for (std::size_t i = 0; whole.makeLine(i); ++i) {
        together += whole.textOfLine(static_cast<int>(i)).toStdString();
        const auto [from, to] = whole.rangeOfLine(static_cast<int>(i));
        // No line but the last leaves room for the first word of the next.
        EXPECT_TRUE(to - from > 50 || !whole.makeLine(i + 1)) << i;
    }
    EXPECT_EQ(together, text);
    EXPECT_LT(whole.lettersShaped(), text.size() * 11 / 10);
}

TEST_F(PagesTest, PagesComeOneAfterTheOther) {
    for (int i = 0; i < 2000; ++i)
        model_.blocks.push_back(paragraph("line"));
    Pagination pagination(model(), objects_);
    while (pagination.count() < 3)
        ASSERT_TRUE(pagination.step());
    EXPECT_LT(pagination.pages().work.strips, 500u); // no more is made than what is shown
    while (pagination.step())
        continue;
    EXPECT_EQ(printed(pagination.take()), printed(pages()));
}

TEST_F(PagesTest, LettersArePaintedInTheirColour) {
    schemas::TextStyle red200;
    red200.color = {200, 0, 0};
    setStyle(red200);
    model_.blocks.push_back(paragraph("MMMM"));
    const Pages laid = pages();
    QImage image(600, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(1 / twipsPerPixel, 1 / twipsPerPixel);
    paintPage(painter, laid, 0, {0, 0, 9000, 3000}, {});
    bool red = false;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            red |= image.pixelColor(x, y).green() < 60 && image.pixelColor(x, y).red() > 150;
    EXPECT_TRUE(red);
}

} // namespace
} // namespace layout
