// The lines of the sample documents, and of tables full of numbers, as they come onto paper.
#include "document/document.h"
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "schemas/schemas.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace layout {

using paragraphs::fromPixels;
using paragraphs::NewBlock;
using paragraphs::Objects;
using paragraphs::Paragraph;
using paragraphs::paragraph;
using paragraphs::tableOf;

namespace {

Pages pagesOf(const std::string& bytes, const std::string& presentation) {
    const document::Document document(bytes);
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const auto model = std::make_shared<model::Model>(model::buildModel(
        document, schemas.presentation(document.className(), QString::fromStdString(presentation)),
        schemas));
    Objects objects;
    objects.subdocumentSize = [](document::SubdocumentId) { return fromPixels({480, 270}); };
    return layOut(model, objects);
}

// A blank is at most half as wide again as its font has it, and never less than two thirds.
TEST(SamplesTest, NoLineHasHolesBetweenItsWords) {
    int lines = 0, justified = 0;
    for (const auto& file : std::filesystem::directory_iterator(SOURCE_DIR "/samples")) {
        if (file.path().extension() != ".ens")
            continue;
        std::ifstream stream(file.path());
        std::stringstream bytes;
        bytes << stream.rdbuf();
        for (const std::string presentation : {"default", "slides", "outline"}) {
            const Pages pages = pagesOf(bytes.str(), presentation);
            for (const auto& page : pages.pages)
                for (const Piece& piece : page->pieces)
                    if (const auto* text = std::get_if<TextPiece>(&piece)) {
                        ++lines;
                        justified += text->letters().stretch != 0 ? 1 : 0;
                        EXPECT_LE(text->letters().stretch, 0.5)
                            << file.path() << ": "
                            << text->paragraph->textOfLine(text->line).toStdString();
                        EXPECT_GE(text->letters().stretch, -1.0 / 3 - 1e-9);
                    }
        }
    }
    EXPECT_GT(lines, 300);
    EXPECT_GT(justified, 30);
}

class RandomTables {
public:
    explicit RandomTables(unsigned seed) : random_(seed) {}

    NewBlock next() {
        const unsigned columns = 2 + below(4); // whose numbers have room side by side
        std::vector<unsigned> kinds(columns);
        for (unsigned& kind : kinds)
            kind = below(5);
        std::vector<model::Row> rows(2 + below(3), model::Row(columns));
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (unsigned c = 0; c < columns; ++c) {
                model::Cell& cell = rows[r][c];
                cell.style.padding = 4;
                cell.style.alignNumbers = below(2) == 0;
                cell.blocks.push_back(paragraph(r == 0 ? words(1 + below(3)) : content(kinds[c])));
            }
        return tableOf(std::move(rows));
    }

private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
    std::string digits(unsigned count) {
        std::string result;
        for (unsigned i = 0; i < count; ++i)
            result += static_cast<char>('0' + below(10));
        return result;
    }
    std::string words(unsigned count) {
        std::string result;
        for (unsigned i = 0; i < count; ++i)
            result += (i == 0 ? "" : " ") +
                      std::string(1 + below(i == 1 ? 18 : 9), static_cast<char>('a' + below(26)));
        return result;
    }
    std::string number() {
        switch (below(6)) {
        case 0:
            return std::to_string(1 + below(999)) + " " + digits(3) + " " + digits(3);
        case 1:
            return "-" + digits(1) + "." + digits(4) + "e-" + digits(2);
        case 2:
            return std::to_string(1 + below(99)) + "." + digits(1 + below(5)) + " kg";
        case 3:
            return "20" + digits(2) + "-11-23";
        default:
            return std::to_string(below(100'000)) + "." + digits(below(4));
        }
    }
    std::string content(unsigned kind) {
        switch (kind) {
        case 0:
            return words(1 + below(12));
        case 1:
            return words(1 + below(3)) + " " + number() + " " + words(1 + below(3));
        default:
            return number();
        }
    }

    std::mt19937 random_;
};

// As the words of a paragraph are, in the document's language; those of a header stay whole.
TEST(TablesOfWordsTest, CellsOfANarrowColumnAreHyphenatedAndItsHeaderIsNot) {
    for (const std::string className : {"CMEMO", "REPORT"}) {
        const std::string cell =
            "<CELL>{It is an extraordinary thing}</CELL><CELL>{x}</CELL></ROW>";
        const Pages pages =
            pagesOf("DOCUMENT " + className + "\n<" + className +
                        "><BODY><TABLE WIDTHS=\"27mm auto\"><ROW KIND=\"header\">" + cell +
                        "<ROW>" + cell + "</TABLE></BODY></" + className + ">",
                    "default");
        std::array<int, 2> hyphens{};
        const Paragraph* first = nullptr;
        for (const Piece& piece : pages.pages.front()->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece);
                text != nullptr && text->paragraph->text(0, 6) == "It is ") {
                first = first == nullptr ? text->paragraph.get() : first;
                hyphens.at(text->paragraph.get() == first ? 0 : 1) += text->letters().hyphen;
            }
        EXPECT_EQ(hyphens[0], 0) << className;
        EXPECT_GT(hyphens[1], 0) << className;
    }
}

bool isOfNumber(QChar sign) { return sign.isDigit() || QStringView(u".,-+e").contains(sign); }

// Neither a digit is torn off its number nor a group of digits or a unit.
TEST(TablesOfNumbersTest, NoNumberIsTornInAThousandTables) {
    constexpr int tables = 1000;
    RandomTables random(17);
    int numbers = 0;
    for (int i = 0; i < tables; ++i) {
        model::Model model;
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model.textStyles = styles;
        model.blocks.push_back(random.next());
        const Pages pages = layOut(std::make_shared<model::Model>(model), {});
        for (const auto& page : pages.pages)
            for (const Piece& piece : page->pieces) {
                const auto* text = std::get_if<TextPiece>(&piece);
                if (text == nullptr)
                    continue;
                const Paragraph& of = *text->paragraph;
                const Paragraph::Line& line = text->letters();
                const QString around = of.text(0, line.to + 20);
                numbers += std::ranges::any_of(of.textOfLine(text->line),
                                               [](QChar sign) { return sign.isDigit(); });
                if (line.to >= of.lines().back().to || line.end == 0)
                    continue;
                const QChar last = around[line.end - 1], next = around[line.to];
                const bool torn = isOfNumber(last) && isOfNumber(next) &&
                                  (last.isDigit() || next.isDigit()) && line.end == line.to;
                const bool parted = last.isDigit() && line.end < line.to &&
                                    (next.isDigit() || around.mid(line.to, 2) == "kg");
                EXPECT_FALSE(torn || parted) << around.toStdString();
            }
    }
    EXPECT_GT(numbers, 5 * tables);
}

} // namespace
} // namespace layout
