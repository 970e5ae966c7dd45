// Documents that were quadratic, or could be: twice as much of them is twice the work, counted.
#include "document/faults.h"
#include "layout/pages.h"
#include "model/model.h"
#include "sgml/work.h"

#include <gmock/gmock.h>

namespace layout {

using paragraphs::Objects;

namespace {

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) {
        std::string one = text;
        for (std::size_t at = one.find('#'); at != std::string::npos; at = one.find('#', at))
            one.replace(at, 1, std::to_string(100'000 + i)); // as long as any other
        result += one;
    }
    return result;
}

std::string report(const std::string& inside) {
    return "DOCUMENT REPORT\n<REPORT>" + inside + "</REPORT>";
}

struct Shape {
    const char* name;
    std::string (*text)(int count);
};

const Shape shapes[] = {
    {"footnotes in a paragraph",
     [](int n) {
         return report("<PARAGRAPH>" + repeated("<TEXT>{t}</TEXT><FOOTNOTE>{n#}</FOOTNOTE>", n) +
                       "</PARAGRAPH>");
     }},
    {"a long footnote",
     [](int n) {
         return report("<PARAGRAPH><FOOTNOTE>{" + repeated("word ", 20 * n) +
                       "}</FOOTNOTE></PARAGRAPH>");
     }},
    {"stray end tags", [](int n) { return report(repeated("</X>", n)); }},
    {"stray text before the element",
     [](int n) { return "DOCUMENT REPORT\n" + repeated("x</X>", n) + "<REPORT></REPORT>"; }},
    {"stray text and no element", [](int n) { return repeated("x</X>", n); }},
    {"text without a blank",
     [](int n) { return report("<PARAGRAPH>{" + std::string(200U * n, 'x') + "}</PARAGRAPH>"); }},
    {"preformatted blocks", [](int n) { return report(repeated("<VERBATIM>{v#}</VERBATIM>", n)); }},
    {"a long preformatted block",
     [](int n) { return report("<VERBATIM>{" + repeated("line\n", 4 * n) + "}</VERBATIM>"); }},
    {"nested lists",
     [](int n) {
         return report(repeated("<LIST><ITEM><PARAGRAPH>{i}</PARAGRAPH>", n) +
                       repeated("</ITEM></LIST>", n));
     }},
    {"nested abstracts, each with a frame",
     [](int n) {
         return report(repeated("<ABSTRACT><PARAGRAPH>{i}</PARAGRAPH>", n) +
                       repeated("</ABSTRACT>", n));
     }},
    {"a wide table",
     [](int n) {
         return report("<TABLE><ROW>" + repeated("<CELL>{c#}</CELL>", n) + "</ROW></TABLE>");
     }},
    {"a long table",
     [](int n) {
         return report("<TABLE>" + repeated("<ROW><CELL>{a}</CELL><CELL>{b#}</CELL></ROW>", n) +
                       "</TABLE>");
     }},
    {"a tall row",
     [](int n) {
         return report("<TABLE><ROW><CELL>{" + repeated("word ", 20 * n) +
                       "}</CELL><CELL>{b}</CELL></ROW></TABLE>");
     }},
    {"figures with captions and references",
     [](int n) {
         return report(repeated("<FIGURE ID=\"f#\"><IMAGE FILE=\"a.png\"></IMAGE>"
                                "<CAPTION>{c}</CAPTION></FIGURE>"
                                "<PARAGRAPH><REF TO=\"f#\"></REF></PARAGRAPH>",
                                n));
     }},
    {"faults, one in each line",
     [](int n) {
         return report(repeated("<PARAGRAPH NO=\"x\"><REF TO=\"g#\"></REF></PARAGRAPH>\n", n));
     }},
};

struct Effort {
    std::size_t letters = 0, strips = 0, boxes = 0, placed = 0, siblings = 0;
};

Effort effortOf(const std::string& text) {
    const sgml::Work before = sgml::work();
    const std::size_t placed = text::bytesPlaced();
    const document::Document document(text);
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    (void)document::documentFaults(document, schemas, {});
    const auto model = std::make_shared<model::Model>(
        model::buildModel(document, schemas.presentation("REPORT"), schemas));
    Objects objects;
    objects.subdocumentSize = [](document::SubdocumentId) { return QSizeF(2000, 2000); };
    objects.imageSize = [](const std::string&) { return QSize(300, 300); };
    const Work work = layOut(model, objects).work;
    return {work.letters, work.strips, work.boxes, text::bytesPlaced() - placed,
            sgml::work().siblingsPassed - before.siblingsPassed};
}

TEST(Growth, TwiceTheDocumentIsTwiceTheWork) {
    for (const Shape& shape : shapes) {
        constexpr int n = 300;
        constexpr std::size_t slack = 2000;
        const Effort once = effortOf(shape.text(n)), twice = effortOf(shape.text(2 * n));
        EXPECT_LE(twice.letters, 2 * once.letters + once.letters / 4 + slack) << shape.name;
        EXPECT_LE(twice.strips, 2 * once.strips + once.strips / 4 + slack) << shape.name;
        EXPECT_LE(twice.boxes, 2 * once.boxes + once.boxes / 4 + slack) << shape.name;
        EXPECT_LE(twice.placed, 2 * once.placed + once.placed / 4 + 4 * slack) << shape.name;
        EXPECT_LE(twice.siblings, 2 * once.siblings + once.siblings / 4 + slack) << shape.name;
        RecordProperty(shape.name, static_cast<int>(once.letters + once.strips + once.boxes +
                                                    once.placed + once.siblings));
    }
}

// A medium's sentence about a text is placed by reading the text and the file once.
TEST(Growth, ManyFaultsOfASubdocumentArePlacedAtOnce) {
    const auto placed = [](int n) {
        const document::Document document(
            report("<PARAGRAPH><DOCUMENT>DOCUMENT MOVIE\n<MOVIE><SCRIPT>{" +
                   repeated("a \\{line\\} #\n", n) + "}</SCRIPT></MOVIE></DOCUMENT></PARAGRAPH>"));
        std::vector<text::Position> places;
        for (int i = n; i > 0; --i)
            places.push_back({i, 3});
        const std::size_t before = text::bytesPlaced();
        const std::vector<std::size_t> offsets =
            document.fileOffsets(document.subdocuments().front(), places);
        EXPECT_EQ(document.bytes().substr(offsets.back(), 6), "\\{line");
        EXPECT_GT(offsets.front(), offsets.back());
        return text::bytesPlaced() - before;
    };
    EXPECT_LE(placed(2000), 2 * placed(1000) + 100);
}

} // namespace
} // namespace layout
