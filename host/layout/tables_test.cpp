#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "places/find.h"
#include "strips/stock.h"

#include <gtest/gtest.h>

#include <map>

namespace layout {

using paragraphs::fromPoints;
using paragraphs::NewBlock;
using paragraphs::paragraph;
using paragraphs::tableOf;
using places::findText;

namespace {

class TablesTest : public ::testing::Test {
protected:
    TablesTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
    }
    static model::Cell cell(const std::string& text, document::Span span = {}) {
        model::Cell made;
        made.blocks.push_back(paragraph(text));
        made.style.border.width = 1;
        made.span = span;
        return made;
    }
    Pages pages() const { return layOut(std::make_shared<model::Model>(model_), {}); }

    struct Line {
        std::size_t page = 0;
        QPointF at;
        bool isRepeated = false;
    };
    static std::multimap<std::string, Line> linesOf(const Pages& pages) {
        std::multimap<std::string, Line> lines;
        for (std::size_t i = 0; i < pages.pages.size(); ++i)
            for (const Piece& piece : pages.pages[i]->pieces)
                if (const auto* text = std::get_if<TextPiece>(&piece))
                    lines.emplace(text->paragraph->textOfLine(text->line).toStdString(),
                                  Line{i, text->at, text->isRepeated});
        return lines;
    }

    model::Model model_;
};

TEST_F(TablesTest, CellsReachOverColumnsAndRows) {
    model_.blocks.push_back(tableOf({{cell("a", {2, 1}), cell("b", {1, 2})},
                                     {cell("c"), cell("d")},
                                     {cell("e"), cell("f"), cell("g")}}));
    const Pages laid = pages();
    const auto lines = linesOf(laid);
    const auto at = [&](const std::string& text) { return lines.find(text)->second.at; };
    EXPECT_EQ(at("a").y(), at("b").y());
    EXPECT_EQ(at("c").y(), at("d").y());
    EXPECT_EQ(at("a").x(), at("c").x());
    EXPECT_EQ(at("b").x(), at("g").x());
    EXPECT_EQ(at("d").x(), at("f").x());
    // The frames: of b as high as two rows, of a as wide as two columns.
    std::vector<QRectF> frames;
    for (const Piece& piece : laid.pages.front()->pieces)
        if (const auto* frame = std::get_if<FramePiece>(&piece))
            frames.push_back(frame->rect);
    ASSERT_EQ(frames.size(), 7u);
    EXPECT_DOUBLE_EQ(frames[0].width(), frames[2].width() + frames[3].width());
    EXPECT_DOUBLE_EQ(frames[1].height(), frames[0].height() + frames[2].height());
}

// A cell that does not fit beside its rows makes the last one higher.
TEST_F(TablesTest, ATallCellMakesItsLastRowHigher) {
    std::string words;
    for (int i = 0; i < 200; ++i)
        words += "words ";
    model_.blocks.push_back(
        tableOf({{cell(words, {1, 2}), cell("b")}, {cell("c")}, {cell("d"), cell("e")}}));
    const auto lines = linesOf(pages());
    const double b = lines.find("b")->second.at.y(), c = lines.find("c")->second.at.y(),
                 d = lines.find("d")->second.at.y();
    EXPECT_GT(d - c, 3 * (c - b));
}

TEST_F(TablesTest, ATallBandIsDividedAndLosesNothing) {
    std::string words;
    for (int i = 0; i < 4000; ++i)
        words += "w" + std::to_string(i) + " ";
    std::vector<model::Row> rows{{cell(words, {1, 90}), cell("r0")}};
    for (int i = 1; i < 90; ++i)
        rows.push_back({cell("r" + std::to_string(i))});
    model_.blocks.push_back(tableOf(rows));
    const Pages laid = pages();
    EXPECT_GT(laid.pages.size(), 2u);
    const auto lines = linesOf(laid);
    for (int i = 0; i < 90; ++i)
        EXPECT_EQ(lines.count("r" + std::to_string(i)), 1u) << i;
    std::string all;
    for (const auto& page : laid.pages)
        for (const Piece& piece : page->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece)) {
                const std::string line = text->paragraph->textOfLine(text->line).toStdString();
                all += line.starts_with('w') ? line : "";
            }
    all.erase(std::remove(all.begin(), all.end(), ' '), all.end());
    words.erase(std::remove(words.begin(), words.end(), ' '), words.end());
    EXPECT_EQ(all, words);
    const double bottom = laid.size.height() - fromPoints(model_.page.marginBottom);
    for (const auto& [text, line] : lines)
        EXPECT_LT(line.at.y(), bottom) << text;
}

TEST_F(TablesTest, AHeaderStandsOnEachPageAndHasNoPlacesThere) {
    std::vector<model::Row> rows{{cell("Header")}};
    for (int i = 0; i < 150; ++i)
        rows.push_back({cell("r" + std::to_string(i))});
    const NewBlock table = tableOf(rows);
    table->headerRows = 1;
    model_.blocks.push_back(table);
    model_.blocks.push_back(paragraph("behind"));
    const Pages laid = pages();
    ASSERT_GT(laid.pages.size(), 2u);
    const auto lines = linesOf(laid);
    EXPECT_EQ(lines.count("Header"), laid.pages.size());
    int repeated = 0;
    for (auto [at, end] = lines.equal_range("Header"); at != end; ++at) {
        repeated += at->second.isRepeated ? 1 : 0;
        EXPECT_EQ(at->second.isRepeated, at->second.page > 0);
        EXPECT_DOUBLE_EQ(at->second.at.y(), fromPoints(model_.page.marginTop));
    }
    EXPECT_EQ(repeated, static_cast<int>(laid.pages.size()) - 1);
    EXPECT_EQ(findText(laid, "Header").size(), 1u);
    // Without room for what comes below it, it is not repeated.
    std::vector<model::Row> tall{{cell("Header")}};
    for (int i = 0; i < 40; ++i)
        tall.front().front().blocks.push_back(paragraph("more"));
    tall.push_back({cell("r")});
    model_.blocks = {tableOf(tall)};
    EXPECT_EQ(linesOf(pages()).count("Header"), 1u);
}

// One below the other stand the points of a column of numbers, those that have none as if they had
// one behind their last digit; a column with other text stays as its cells are aligned.
TEST_F(TablesTest, NumbersStandByTheirPoints) {
    const auto number = [](const std::string& text) {
        model::Cell made = cell(text);
        made.style.alignNumbers = true;
        return made;
    };
    model_.blocks.push_back(tableOf({{number("Mass"), number("Name")},
                                     {number("3.25"), number("1.5")},
                                     {number("120"), number("pendulum")},
                                     {number("\u2013"), number("22.5")},
                                     {number("0.0625"), number("7")}}));
    const Pages laid = pages();
    const auto pointOf = [&](const std::string& text, int point) {
        for (const Piece& piece : laid.pages.front()->pieces)
            if (const auto* line = std::get_if<TextPiece>(&piece);
                line != nullptr && line->paragraph->textOfLine(line->line).toStdString() == text)
                return line->at.x() + line->paragraph->leftOf(line->line, point);
        return -1.0;
    };
    const double point = pointOf("3.25", 1);
    EXPECT_NEAR(pointOf("120", 3), point, 1e-6);
    EXPECT_NEAR(pointOf("0.0625", 1), point, 1e-6);
    EXPECT_GT(pointOf("3.25", 0), pointOf("120", 0) + 1);
    EXPECT_EQ(pointOf("Mass", 0), pointOf("120", 0));
    EXPECT_EQ(pointOf("1.5", 0), pointOf("22.5", 0));
    EXPECT_EQ(pointOf("1.5", 0), pointOf("Name", 0));
}

// Values of figures are numbers, too, and stay in their places while they play.
TEST_F(TablesTest, ValuesStandByTheirPointsWhileTheyPlay) {
    const auto value = [](const std::string& text, const std::string& room) {
        model::Cell made = cell(room.empty() ? text : "\u2007" + text);
        made.style.alignNumbers = true;
        const auto block = std::make_shared<model::Block>(*made.blocks.front());
        block->runs.front().kind = model::RunKind::value;
        block->runs.front().value = std::make_shared<model::Value>(model::Value{.room = room});
        made.blocks.front() = block;
        return made;
    };
    const auto pointsOf = [&](const std::string& first, const std::string& room) {
        model_.blocks = {tableOf({{cell("Now")}, {value(first, room)}, {value("8.25", "")}})};
        std::vector<double> points;
        const Pages laid = pages();
        for (const Piece& piece : laid.pages.front()->pieces)
            if (const auto* line = std::get_if<TextPiece>(&piece)) {
                const auto point = line->paragraph->textOfLine(line->line).indexOf('.');
                if (point > 0)
                    points.push_back(line->at.x() +
                                     line->paragraph->leftOf(line->line, static_cast<int>(point)));
            }
        return points;
    };
    const std::vector<double> atRest = pointsOf("120.5", "");
    ASSERT_EQ(atRest.size(), 2u);
    EXPECT_NEAR(atRest[0], atRest[1], 1e-6);
    const std::vector<double> playing = pointsOf("9.5", "\u2212000.0");
    EXPECT_NEAR(playing[0], playing[1], 1);
    EXPECT_NEAR(pointsOf("\u2212111.1", "\u2212000.0")[0], playing[0], 1); // of 1/20 point
}

TEST_F(TablesTest, AuthorsSayHowWideColumnsAre) {
    const NewBlock table = tableOf({{cell("a"), cell("b"), cell("c")}});
    table->columnWidths = {100, 0, 50};
    model_.blocks = {table};
    const Pages laid = pages();
    ASSERT_EQ(laid.pages.front()->tables.size(), 1u);
    const std::vector<double>& widths = laid.pages.front()->tables.front().columns->widths;
    EXPECT_DOUBLE_EQ(widths[0], fromPoints(100));
    EXPECT_DOUBLE_EQ(widths[2], fromPoints(50));
    EXPECT_LT(widths[1], fromPoints(50));
    // Together they are no wider than the text.
    const NewBlock wide = tableOf({{cell("a"), cell("b")}});
    wide->columnWidths = {1000, 1000};
    model_.blocks = {wide};
    const std::vector<double> squeezed = pages().pages.front()->tables.front().columns->widths;
    EXPECT_DOUBLE_EQ(squeezed[0] + squeezed[1], fromPoints(595.276 - 144));
}

} // namespace
} // namespace layout
