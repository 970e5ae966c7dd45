// Images in the lines of a text.
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"

#include <gtest/gtest.h>

namespace layout {

using paragraphs::fromPixels;
using paragraphs::fromPoints;
using paragraphs::NewBlock;
using paragraphs::Objects;
using paragraphs::Paragraph;
using paragraphs::paragraph;
using paragraphs::tableOf;

namespace {

class PicturesInLinesTest : public testing::Test {
protected:
    PicturesInLinesTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
        objects_.imageSize = [this](const std::string& source) {
            return source == "wide"   ? QSize(4000, 400)
                   : source == "tall" ? QSize(100, 9000)
                                      : size_;
        };
    }
    static NewBlock around(const std::string& source, const std::string& words = "words") {
        NewBlock block = paragraph(words + " before ");
        model::Run& run = block->runs.emplace_back();
        run.kind = model::RunKind::image;
        run.element = 7;
        run.picture = std::make_shared<model::Picture>(
            model::Picture{.source = source, .alternative = "A sign"});
        block->runs.emplace_back().text = " behind";
        return block;
    }
    Pages laid(const NewBlock& block) {
        model_.blocks = {first_, block};
        return pages_ = relaid(pages_, std::make_shared<model::Model>(model_), objects_);
    }
    static const PlacedObject& imageOn(const Pages& pages) {
        return pages.pages.front()->objects.at(0);
    }
    // The line that the image stands in.
    static const TextPiece& lineOf(const Pages& pages) {
        const QRectF rect = imageOn(pages).rect;
        for (const Piece& piece : pages.pages.front()->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece))
                if (rect.center().y() > text->at.y() &&
                    rect.center().y() < text->at.y() + text->letters().height)
                    return *text;
        throw std::logic_error("no line");
    }

    const NewBlock first_ = paragraph("A line of words");
    model::Model model_;
    QSize size_{16, 12};
    Objects objects_;
    Pages pages_;
};

TEST_F(PicturesInLinesTest, StandOnTheBaseLineBetweenTheWords) {
    const Pages pages = laid(around("small"));
    const TextPiece& line = lineOf(pages);
    const PlacedObject& image = imageOn(pages);
    EXPECT_EQ(image.image, "small");
    EXPECT_EQ(image.element, 7U);
    EXPECT_NEAR(image.rect.bottom(), line.at.y() + line.letters().baseline, 1e-6);
    EXPECT_EQ(image.rect.size(), fromPixels(QSizeF(16, 12)));
    const Paragraph& of = *line.paragraph;
    EXPECT_NEAR(line.at.x() + of.leftOf(0, of.startOfRun(1)), image.rect.left(), 1e-6);
    EXPECT_NEAR(line.at.x() + of.leftOf(0, of.startOfRun(2)), image.rect.right(), 2);
}

TEST_F(PicturesInLinesTest, MoveLinesApartOnlyWhereTheyAreHigh) {
    const double plain = lineOf(laid(around("small"))).letters().height;
    EXPECT_EQ(plain, std::get<TextPiece>(pages_.pages[0]->pieces[0]).letters().height);
    size_ = {16, 100};
    const Pages pages = laid(around("high"));
    const TextPiece& line = lineOf(pages);
    EXPECT_GT(line.letters().height, fromPixels(QSizeF(0, 100)).height());
    EXPECT_GE(imageOn(pages).rect.top(), line.at.y());
    EXPECT_LE(imageOn(pages).rect.bottom(), line.at.y() + line.letters().height);
}

TEST_F(PicturesInLinesTest, AreNoWiderThanALineAndNoHigherThanAPage) {
    const double width = textAreaOf(model_.page).width;
    const QRectF wide = imageOn(laid(around("wide"))).rect;
    EXPECT_NEAR(wide.width(), width, 1e-6);
    EXPECT_NEAR(wide.height(), width / 10, 1e-6);
    const QRectF tall = imageOn(laid(around("tall"))).rect;
    EXPECT_LT(tall.bottom(), textAreaOf(model_.page).bottom);
    EXPECT_NEAR(tall.width(), tall.height() / 90, 1e-6);
}

// The file has another picture now.
TEST_F(PicturesInLinesTest, FollowTheirFiles) {
    const NewBlock block = around("small");
    const double before = imageOn(laid(block)).rect.width();
    size_ = {32, 24};
    EXPECT_DOUBLE_EQ(imageOn(laid(block)).rect.width(), 2 * before);
    EXPECT_EQ(pages_.work.paragraphs, 1U);
}

TEST_F(PicturesInLinesTest, LeaveOtherColumnsOfATableTheirRoom) {
    NewBlock cell = std::make_shared<model::Block>();
    cell->runs.push_back(around("wide")->runs[1]);
    const double width = textAreaOf(model_.page).width;
    model::Row row(2);
    row[0].blocks = {cell};
    row[1].blocks = {paragraph("Some more words")};
    const Pages pages = laid(tableOf({row}));
    EXPECT_LE(imageOn(pages).rect.width(), width / 3 + fromPoints(1));
    EXPECT_GT(imageOn(pages).rect.width(), width / 4);
}

} // namespace
} // namespace layout
