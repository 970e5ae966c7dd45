#include "document/faults.h"
#include "document/random_report.h"
#include "document/uses.h"
#include "sgml/faults_testing.h"

#include <gtest/gtest.h>

namespace document {

namespace {

// From the file's own document, whose class a seed may change.
text::Edits classEdit(Author& author, const std::string& bytes) {
    const std::size_t at = bytes.find("DOCUMENT ") + 9, end = bytes.find('\n', at);
    constexpr const char* classes[] = {"REPORT", "CMEMO", "MOVIE"};
    if (at < 9 || end == std::string::npos)
        return {};
    return {{{at, end}, classes[author.below(std::size(classes))]}};
}

std::string printed(const Uses& uses) {
    std::string lines;
    for (const ImageUse& use : uses.images())
        lines += std::to_string(use.range.from) + " " + use.source + "\n";
    for (const SliderUse& use : uses.sliders())
        lines += std::to_string(use.range.from) + " " + std::to_string(use.subdocument) + " " +
                 use.parameter + "\n";
    return lines;
}

} // namespace

TEST(Faults, ListsEverythingInOrderOfPlace) {
    const Document document(
        "DOCUMENT REPORT\n"
        "<REPORT><TITLE>{x}</TITLE>\n"
        "<SECTION ID=\"a\"><PARAGRAPH>{x}</PARAGRAPH></SECTION>\n"
        "<SECTION ID=\"a\"><HEADING>{x}</HEADING><PARAGRAPH><REF TO=\"b\"></REF></PARAGRAPH>\n"
        "<DOCUMENT>DOCUMENT MOVIE\n<MOVIE WIDTH=\"-1\" ALIGN=\"top\"></MOVIE></DOCUMENT>\n"
        "<PARAGRAPH><VALUE OF=\"c\"></VALUE></PARAGRAPH>\n"
        "</SECTION>stray</REPORT>\n");
    EXPECT_EQ(
        sgml::formatted(documentFaults(document, schemas::Schemas::builtIn(), {"ANIMATION"}),
                        "r.ens"),
        "r.ens:3:17: warning: <PARAGRAPH> does not belong here in <SECTION>; expected HEADING\n"
        "r.ens:4:1: warning: the ID a is given twice; the first counts\n"
        "r.ens:4:50: warning: nothing has the ID b that this refers to\n"
        "r.ens:6:1: warning: no medium is known for class MOVIE; it is kept as it is\n"
        "r.ens:6:8: warning: WIDTH wants a number from 1 to 20000 (1/96 inch)\n"
        "r.ens:6:19: warning: ALIGN wants left, center, right or inline\n"
        "r.ens:7:12: warning: no subdocument has the ID c\n"
        "r.ens:8:11: error: text outside braces: \"stray\"\n");
}

// A list that followed thousands of edits is the one that the whole document gives.
TEST(Faults, AfterEveryEditAreThoseOfANewLook) {
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    std::size_t edits = 0, found = 0, looked = 0, all = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Author author(seed);
        Document document(seed % 3 == 0 ? author.memo(60) : author.report(60));
        Faults faults(document, schemas, {"ANIMATION"});
        Uses uses(document, schemas);
        QObject::connect(&document, &Document::edited, &document, [&](const sgml::Change& change) {
            faults.follow(change);
            uses.follow(change);
        });
        const std::size_t first = faults.looked();
        for (int i = 0; i < 60; ++i) {
            const std::size_t what = author.below(20), before = faults.looked();
            if (what == 0)
                (void)document.edit(classEdit(author, document.bytes()), "Class");
            else if (what < 15)
                (void)document.edit(author.edit(document.tree()), "Edit");
            else if (what < 18)
                document.undo();
            else
                document.redo();
            const std::vector<sgml::Fault> now = faults.list();
            looked += faults.looked() - before;
            all += first;
            ASSERT_EQ(sgml::formatted(now, "f"),
                      sgml::formatted(documentFaults(document, schemas, {"ANIMATION"}), "f"))
                << "seed " << seed << " edit " << i << "\n"
                << document.bytes();
            ASSERT_EQ(printed(uses), printed(Uses(document, schemas)));
            found += now.size();
            ++edits;
        }
    }
    EXPECT_GT(edits, 3000u);
    EXPECT_GT(found, edits);
    EXPECT_LT(looked, all / 4);
}

// A letter changes no element. Enter changes the section, and a paragraph comes.
TEST(Faults, WhatAnEditCostsDoesNotGrowWithTheDocument) {
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    for (const int sections : {10, 200}) {
        std::string text = "DOCUMENT REPORT\n<REPORT>\n";
        for (int i = 0; i < sections; ++i)
            text += "<SECTION><HEADING>{h}</HEADING><PARAGRAPH WRONG=\"x\">{word}</PARAGRAPH>\n"
                    "<FIGURE><IMAGE FILE=\"a.png\"></IMAGE></FIGURE></SECTION>\n";
        Document document(text + "stray</REPORT>");
        Faults faults(document, schemas, {});
        QObject::connect(&document, &Document::edited, &document,
                         [&](const sgml::Change& change) { faults.follow(change); });
        EXPECT_EQ(faults.list().size(), 1U + static_cast<std::size_t>(sections));
        const std::size_t middle = document.bytes().find("word", document.bytes().size() / 2) + 2;
        const auto costOf = [&](const std::string& typed) {
            const std::size_t before = faults.looked(), placed = text::bytesPlaced();
            (void)document.edit({{{middle, middle}, typed}}, "Typing");
            EXPECT_LE(text::bytesPlaced() - placed, 300u);
            return faults.looked() - before;
        };
        EXPECT_EQ(costOf("x"), 0u);
        EXPECT_EQ(costOf("}</PARAGRAPH>\n<PARAGRAPH>{"), 2u);
    }
}

} // namespace document
