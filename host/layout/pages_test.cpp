#include "layout/measure.h"
#include "layout/paint.h"

#include <gmock/gmock.h>

#include <QGuiApplication>
#include <QPainter>

namespace layout {
namespace {

document::Block paragraph(const std::string& text) {
    document::Block block;
    document::Run run;
    run.text = text;
    block.runs.push_back(run);
    return block;
}

document::Block picture(document::SubdocumentId id) {
    document::Block block;
    block.kind = document::BlockKind::subdocument;
    block.subdocument = id;
    block.style.keepWithNext = true;
    return block;
}

class PagesTest : public ::testing::Test {
protected:
    PagesTest() {
        model_.textStyles.emplace_back();
        objects_.subdocumentSize = [this](document::SubdocumentId) { return size_; };
    }
    Pages pages() const { return layOut(model_, objects_); }
    double areaHeight() const {
        return fromPoints(model_.page.height - model_.page.marginTop - model_.page.marginBottom);
    }
    static std::string lastText(const Page& page) {
        for (auto piece = page.pieces.rbegin(); piece != page.pieces.rend(); ++piece)
            if (const auto* text = std::get_if<TextPiece>(&*piece))
                return text->paragraph->textOfLine(text->line).toStdString();
        return {};
    }

    document::Model model_;
    Objects objects_;
    QSizeF size_ = fromPixels({320, 240});
};

TEST_F(PagesTest, EveryLineIsOnExactlyOnePageAndInsideTheMargins) {
    for (int i = 0; i < 200; ++i)
        model_.blocks.push_back(paragraph("Paragraph " + std::to_string(i) +
                                          std::string(300, 'x').replace(150, 1, " ")));
    const Pages laid = pages();
    std::size_t lines = 0;
    for (const Page& page : laid.pages)
        for (const Piece& piece : page.pieces) {
            const auto& text = std::get<TextPiece>(piece);
            ++lines;
            EXPECT_GE(text.at.y(), fromPoints(72));
            const double height = text.paragraph->lines()[text.line].height;
            EXPECT_LE(text.at.y() + height, laid.size.height() - fromPoints(72) + 1e-6);
        }
    std::size_t expected = 0;
    const StripBuilder builder{model_, objects_, fromPoints(595.276 - 144), areaHeight()};
    expected = builder.strips(model_.blocks).size();
    EXPECT_EQ(lines, expected);
    EXPECT_GT(laid.pages.size(), 3u);
}

TEST_F(PagesTest, AHeadingIsNeverTheLastOfAPage) {
    for (int i = 0; i < 300; ++i) {
        model_.blocks.push_back(paragraph(i % 3 == 0 ? "Heading" : "Text"));
        model_.blocks.back().style.keepWithNext = i % 3 == 0;
    }
    const Pages laid = pages();
    ASSERT_GT(laid.pages.size(), 3u);
    for (const Page& page : laid.pages)
        EXPECT_EQ(lastText(page), "Text");
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
    ASSERT_EQ(laid.subdocuments.size(), 1u);
    EXPECT_EQ(laid.subdocuments[0].page, 1u);
    EXPECT_EQ(laid.subdocuments[0].rect.top(), fromPoints(72));
    EXPECT_EQ(lastText(laid.pages[0]), "After");
}

TEST_F(PagesTest, APictureLargerThanThePageIsMadeToFit) {
    size_ = QSizeF(fromPoints(5000), fromPoints(9000));
    model_.blocks.push_back(picture(1));
    const Pages laid = pages();
    ASSERT_EQ(laid.subdocuments.size(), 1u);
    const QRectF rect = laid.subdocuments[0].rect;
    EXPECT_LE(rect.bottom(), laid.size.height() - fromPoints(72));
    EXPECT_NEAR(rect.width() / rect.height(), 5.0 / 9.0, 1e-9);
}

TEST_F(PagesTest, AFootnoteStandsOnThePageOfItsMark) {
    for (int i = 0; i < 100; ++i) {
        model_.blocks.push_back(paragraph("Text"));
        if (i % 10 != 5)
            continue;
        document::Run mark;
        mark.kind = document::RunKind::footnote;
        mark.text = std::to_string(i);
        mark.footnote = model_.footnotes.size();
        model_.blocks.back().runs.push_back(mark);
        document::Footnote note;
        note.blocks.push_back(paragraph("Note " + std::to_string(i)));
        model_.footnotes.push_back(note);
    }
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
    document::Block block = paragraph("before ");
    document::Run object;
    object.kind = document::RunKind::subdocument;
    object.subdocument = 3;
    block.runs.push_back(object);
    document::Run after;
    after.text = " after";
    block.runs.push_back(after);
    model_.blocks.push_back(block);
    const Pages laid = pages();
    ASSERT_EQ(laid.subdocuments.size(), 1u);
    EXPECT_EQ(laid.subdocuments[0].rect.size(), size_);
    EXPECT_GE(laid.subdocuments[0].rect.top(), fromPoints(72) - 1e-6);
    EXPECT_GT(laid.subdocuments[0].rect.left(), fromPoints(72));
}

TEST_F(PagesTest, TablesFitTheirWidth) {
    document::Block table;
    table.kind = document::BlockKind::table;
    for (int r = 0; r < 3; ++r) {
        document::Row row(4);
        for (document::Cell& cell : row)
            cell.blocks.push_back(paragraph("several words that want much room in a cell"));
        table.rows.push_back(row);
    }
    model_.blocks.push_back(table);
    const Pages laid = pages();
    for (const Piece& piece : laid.pages[0].pieces) {
        const auto& text = std::get<TextPiece>(piece);
        EXPECT_LE(text.at.x() + text.paragraph->naturalWidth(), fromPoints(595.276 - 72) + 1);
    }
}

TEST_F(PagesTest, LettersArePaintedInTheirColour) {
    model_.textStyles[0].color = {200, 0, 0};
    model_.blocks.push_back(paragraph("MMMM"));
    const Pages laid = pages();
    QImage image(600, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(1 / twipsPerPixel, 1 / twipsPerPixel);
    paintPage(painter, laid.pages[0], {0, 0, 9000, 3000}, {});
    bool red = false;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            red |= image.pixelColor(x, y).green() < 60 && image.pixelColor(x, y).red() > 150;
    EXPECT_TRUE(red);
}

} // namespace
} // namespace layout

int main(int argc, char** argv) {
    QGuiApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
