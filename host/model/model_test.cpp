#include "document/document.h"
#include "document/faults.h"
#include "exports/text_export.h"
#include "model/model.h"
#include "sgml/faults_testing.h"
#include "sgml/random_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace model {

using exports::exportText;

namespace {

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

std::string modelOf(const std::string& bytes, const QString& presentation = {}) {
    const document::Document document(bytes);
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    return printed(
        buildModel(document, schemas.presentation(document.className(), presentation), schemas));
}

std::string body(const std::string& inside) {
    return "DOCUMENT CMEMO\n<CMEMO><BODY>" + inside + "</BODY></CMEMO>";
}

// Without the lines that every memo has: the title and the word Memorandum; without boxes and
// containers.
std::string blocksOf(const std::string& inside) {
    std::istringstream lines(modelOf(body(inside)));
    std::string result, line;
    for (int i = 0; std::getline(lines, line); ++i)
        if (i >= 2 && !line.starts_with("box") && !line.starts_with("in "))
            result += line + "\n";
    return result;
}

// With UPDATE_GOLDEN set the file is written anew: look at the difference before committing it.
void expectGolden(const std::string& name, const std::string& text) {
    const std::string path = SOURCE_DIR "/host/model/golden/" + name;
    if (std::getenv("UPDATE_GOLDEN") != nullptr)
        std::ofstream(path, std::ios::binary) << text;
    EXPECT_EQ(text, contentOf(path)) << name;
}

std::string textOf(const std::string& sample, const QString& presentation = {}) {
    const document::Document document(contentOf(SOURCE_DIR "/samples/" + sample));
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    return exportText(
        document,
        buildModel(document, schemas.presentation(document.className(), presentation), schemas));
}

} // namespace

TEST(Model, FlowingTextJoinsLinesAndKeepsItsPlaces) {
    const document::Document document(
        body("<PARAGRAPH><TEXT>{\n  one\n   two three }</TEXT><EMPH>{four}</EMPH></PARAGRAPH>"));
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const Model model = buildModel(document, schemas.presentation("CMEMO"), schemas);
    const Block& block = *model.blocks.back();
    ASSERT_EQ(block.runs.size(), 3u);
    std::string all;
    for (const model::Run& run : block.runs) {
        all += run.text;
        std::string source =
            document.tree().unescaped(run.content).text().substr(run.offset, run.text.size());
        for (char& c : source)
            c = c == '\n' ? ' ' : c;
        EXPECT_EQ(source, run.text) << "a run's letters are the bytes from its offset on";
    }
    EXPECT_EQ(all, "one two three four");
}

TEST(Model, BlocksOfEveryKind) {
    struct {
        std::string inside, blocks;
    } cases[] = {
        {"<PARAGRAPH></PARAGRAPH>", "text left 11pt after 24\n"},
        {"<PARAGRAPH>{a}</PARAGRAPH><PARAGRAPH>{b}</PARAGRAPH>",
         "text left 11pt after 24 [a]\ntext left 11pt after 7 [b]\n"},
        {"<LIST><ITEM>{a}</ITEM><ITEM><PARAGRAPH>{b}</PARAGRAPH><LIST><ITEM>{c}</ITEM></LIST></"
         "ITEM></LIST>",
         "text left 11pt in 18 after 24 (•) [a]\ntext left 11pt in 18 after 5 (•) [b]\ntext left "
         "11pt in 36 after 7 (–) [c]\n"},
        {"<LIST KIND=\"number\"><ITEM>{a}</ITEM><ITEM>{b}</ITEM></LIST><LIST "
         "KIND=\"number\"><ITEM>{c}</ITEM></LIST>",
         "text left 11pt in 22 after 24 (1.) [a]\ntext left 11pt in 22 after 3 (2.) [b]\ntext left "
         "11pt in 22 after 6 (1.) [c]\n"},
        {"<VERBATIM>{\r\na\r\n  b\n}</VERBATIM>",
         "verbatim left 9pt in 6 after 30 [m|a\\n][m|  b]\n"},
        {"<PARAGRAPH>{a}</PARAGRAPH><PAGEBREAK></PAGEBREAK><RULE></RULE>",
         "text left 11pt after 24 [a]\npage-break left 11pt after 7\nrule left 11pt after 8\n"},
        {"<FIGURE><IMAGE FILE=\"x.png\"></IMAGE><CAPTION>{c}</CAPTION></FIGURE>",
         "image center 11pt after 24 keep x.png\ntext center 9.9pt after 8 (Figure 1:) [i|c]\n"},
        {"<PARAGRAPH><TEXT>{a}</TEXT><IMAGE FILE=\"x.png\"></IMAGE><TEXT>{b}</TEXT></PARAGRAPH>"
         "<LIST><ITEM><EMPH><IMAGE FILE=\"y.png\"></IMAGE></EMPH></ITEM></LIST>",
         "text left 11pt after 24 [a][image:x.png][b]\n"
         "text left 11pt in 18 after 7 (•) [i|image:y.png]\n"},
        {"<TABLE "
         "ID=\"t\"><CAPTION>{c}</CAPTION><ROW><CELL>{a}</CELL>{b}</ROW></TABLE><PARAGRAPH><REF "
         "TO=\"t\"></REF></PARAGRAPH>",
         "text left 9.9pt after 24 keep #t (Table 1:) [i|c]\ntable left 11pt after 4\n  row\n   "
         " cell\n      text left 11pt "
         "[a]\n    cell\n      text left 11pt [b]\ntext left 11pt after 10 [Table\u00A01>#t]\n"},
        {"<PARAGRAPH><TEXT>{a}</TEXT><FOOTNOTE>{n}</FOOTNOTE><TEXT>{b}</TEXT></PARAGRAPH>",
         "text left 11pt after 24 [a][note:1][b]\nfootnote 1\n  text left 9pt in 14 (1) [n]\n"},
        {"<PARAGRAPH><LINK TO=\"http://x\">{l}</LINK><CODE>{c}</CODE><REF "
         "TO=\"none\"></REF></PARAGRAPH>",
         "text left 11pt after 24 [l>http://x][m|c][(missing)>#none]\n"},
        {"<PARAGRAPH><SLIDER OF=\"a\" NAME=\"g\" VALUE=\"3\"></SLIDER><VALUE "
         "EXPRESSION=\"b.x\"></VALUE></PARAGRAPH><CHART "
         "VALUES=\"b.x\"></CHART>",
         "text left 11pt after 24 [slider:g = 3][value:[b.x]]\nchart center 11pt after 8 [Chart of "
         "b.x]\n"},
        {"<PARAGRAPH><TEXT>{a}</TEXT><NEW X=\"1\">{b}</NEW></PARAGRAPH>",
         "text left 11pt after 24 [a][m|<NEW X=\"1\">][m|b][m|</NEW>]\n"},
        {"<NEW><PARAGRAPH>{b}</PARAGRAPH></NEW>",
         "text left 11pt after 24 [m|<NEW>]\ntext left 11pt after 5 [m|b]\n"},
        {"<PARAGRAPH>stray</PARAGRAPH>", "text left 11pt after 24 [m|stray]\n"},
        {"<DOCUMENT>DOCUMENT "
         "REPORT\n<REPORT><SECTION><HEADING>{h}</HEADING></SECTION></REPORT></DOCUMENT>",
         "text left 15pt after 30 level 1 keep (1  ) [b|h]\n"},
    };
    for (const auto& [inside, blocks] : cases)
        EXPECT_EQ(blocksOf(inside), blocks) << inside;
}

TEST(Model, InlineSubdocumentsAreRunsOthersAreBlocks) {
    const std::string text = "<PARAGRAPH><TEXT>{a}</TEXT><DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION "
                             "ALIGN=\"inline\"></ANIMATION></DOCUMENT>"
                             "<TEXT>{b}</TEXT><DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION "
                             "ALIGN=\"right\"></ANIMATION></DOCUMENT></PARAGRAPH>";
    EXPECT_EQ(blocksOf(text),
              "text left 11pt after 24 [a][subdocument:][b]\nsubdocument right 11pt after 8\n");
}

// The author aligns the subdocument, and its caption goes with it.
TEST(Model, ACaptionIsAlignedAsItsFigure) {
    const auto figure = [](const std::string& align) {
        return "<FIGURE><DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION" + align +
               "></ANIMATION></DOCUMENT><CAPTION>{c}</CAPTION></FIGURE>";
    };
    const auto shown = [](const std::string& align) {
        return "subdocument " + align + " 11pt after 24 keep\ntext " + align +
               " 9.9pt after 8 (Figure 1:) [i|c]\n";
    };
    EXPECT_EQ(blocksOf(figure("")), shown("center"));
    EXPECT_EQ(blocksOf(figure(" ALIGN=\"left\"")), shown("left"));
    EXPECT_EQ(blocksOf(figure(" ALIGN=\"right\"")), shown("right"));
    const auto inReport = [&](const std::string& align) {
        return modelOf("DOCUMENT REPORT\n<REPORT>" + figure(align) + "</REPORT>");
    };
    EXPECT_NE(inReport("").find("9pt in 24 after"), std::string::npos);
    EXPECT_NE(inReport(" ALIGN=\"left\"").find("text left 9pt after"), std::string::npos);
}

TEST(Model, ASecondPresentationShowsTheSameDocumentOtherwise) {
    const std::string text = "DOCUMENT "
                             "REPORT\n<REPORT><TITLE>{T}</TITLE><SECTION><HEADING>{a}</"
                             "HEADING><PARAGRAPH>{x}</PARAGRAPH>"
                             "<SECTION><HEADING>{b}</HEADING></SECTION></"
                             "SECTION><SECTION><HEADING>{c}</HEADING></SECTION></REPORT>";
    EXPECT_EQ(modelOf(text, "outline"), "title T\n"
                                        "text left 18pt [b|T]\n"
                                        "text left 12pt after 10 level 1 keep (1  ) [b|a]\n"
                                        "text left 11pt in 18 after 3 level 2 keep (1.1  ) [b]\n"
                                        "text left 12pt after 8 level 1 keep (2  ) [b|c]\n"
                                        "in section 1: 1..2\nin section 2: 2..2\n"
                                        "in section 1: 3..3\n");
}

TEST(Model, ContainersKeepTheirRoles) {
    const std::string text =
        "<PARAGRAPH>{p}</PARAGRAPH><LIST><ITEM>{a}</ITEM><ITEM>{b}<LIST><ITEM>{c}"
        "</ITEM></LIST></ITEM></LIST><FIGURE><IMAGE></IMAGE><CAPTION>{d}</CAPTION></FIGURE>"
        "<TABLE><ROW><CELL><PARAGRAPH>{e}</PARAGRAPH><LIST><ITEM>{f}</ITEM></LIST></CELL></ROW>"
        "</TABLE><PARAGRAPH><FOOTNOTE><TEXT>{f}</TEXT><LIST><ITEM>{g}</ITEM></LIST></FOOTNOTE></"
        "PARAGRAPH>";
    std::istringstream lines(modelOf(body(text)));
    std::string found;
    for (std::string line; std::getline(lines, line);)
        if (line.substr(line.find_first_not_of(' '), 3) == "in ")
            found += line + "\n";
    EXPECT_EQ(found, "      in list 1: 1..1\n      in item 1: 1..1\n" // in the cell
                     "in list 1: 2..4\nin item 1: 2..2\nin item 1: 3..4\n"
                     "in list 2: 4..4\nin item 2: 4..4\n"
                     "in figure 1: 5..6\nin caption 1: 6..6\nin table 1: 7..7\n"
                     "  in list 1: 1..1\n  in item 1: 1..1\n"); // in the footnote
}

TEST(Model, AClassWithoutAPresentationIsShownAsWhatItIs) {
    EXPECT_EQ(modelOf("DOCUMENT LETTER\n<LETTER><DEAR>{Sir}</DEAR></LETTER>"),
              "title \ntext left 11pt [m|<LETTER>]\ntext left 11pt [m|<DEAR>][m|Sir][m|</DEAR>]\n");
}

TEST(Model, DeepNestingEndsInASentenceNotInACrash) {
    for (const std::string unit :
         {"SECTION", "LIST", "TABLE", "EMPH", "FOOTNOTE", "NEW", "DOCUMENT"}) {
        std::string text = "DOCUMENT REPORT\n<REPORT>";
        for (int i = 0; i < 19'990; ++i)
            text += unit == "TABLE" && i % 3 == 1   ? "<ROW>"
                    : unit == "TABLE" && i % 3 == 2 ? "<CELL>"
                                                    : "<" + unit + ">";
        const document::Document document(text);
        const schemas::Schemas schemas = schemas::Schemas::builtIn();
        const Model model = buildModel(document, schemas.presentation("REPORT"), schemas);
        EXPECT_LE(model.footnotes.size(), 20'000u) << unit;
    }
}

TEST(Model, FootnotesInFootnotesEndSomewhereAndLoseNoText) {
    std::string text;
    for (int i = 0; i < 20; ++i)
        text += "<FOOTNOTE><TEXT>{n" + std::to_string(i) + "}</TEXT>";
    const std::string model = modelOf(body("<PARAGRAPH>" + text));
    EXPECT_NE(model.find("footnote 8\n"), std::string::npos);
    EXPECT_EQ(model.find("footnote 9\n"), std::string::npos);
    EXPECT_NE(model.find("[n19]"), std::string::npos);
}

// A case that nobody thought of is at least shown and survived.
TEST(Model, CellsAreAlignedAsTheySay) {
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const document::Document document(
        body("<TABLE><ROW><CELL>{1}</CELL><CELL ALIGN=\"center\">{2}</CELL>"
             "<CELL ALIGN=\"right\"><PARAGRAPH>{3}</PARAGRAPH></CELL></ROW></TABLE>"));
    const Model model = buildModel(document, schemas.presentation("CMEMO"), schemas);
    const auto table = std::ranges::find(model.blocks, BlockKind::table,
                                         [](const auto& block) { return block->kind; });
    ASSERT_NE(table, model.blocks.end());
    const Row& row = (*table)->rows.front();
    EXPECT_TRUE(row[0].style.alignNumbers);
    EXPECT_EQ(row[1].style.align, schemas::Align::center);
    EXPECT_FALSE(row[1].style.alignNumbers);
    EXPECT_EQ(row[2].blocks.front()->style.align, schemas::Align::right);
    EXPECT_EQ(sgml::formatted(document::documentFaults(document, schemas, {}), "m"), "");
}

// A memo of two pages has headings.
TEST(Model, AMemoHasSections) {
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const document::Document document(
        "DOCUMENT CMEMO\n<CMEMO><SUBJECT>{S}</SUBJECT><BODY><SECTION><HEADING>{One}</HEADING>"
        "<SECTION><HEADING>{Two}</HEADING><PARAGRAPH>{x}</PARAGRAPH></SECTION></SECTION></BODY>"
        "</CMEMO>");
    for (const QString name : {"default", "slides", "print", "handout"}) {
        const Model model = buildModel(document, schemas.presentation("CMEMO", name), schemas);
        std::vector<int> levels;
        for (const auto& block : model.blocks)
            if (block->runs.size() == 1 &&
                (block->runs.front().text == "One" || block->runs.front().text == "Two"))
                levels.push_back(block->headingLevel);
        ASSERT_EQ(levels.size(), 2U);
        EXPECT_GT(levels[0], 0);
        EXPECT_EQ(levels[1], levels[0] + 1);
    }
    EXPECT_EQ(sgml::formatted(document::documentFaults(document, schemas, {}), "m"), "");
}

// The headings of a memo have no numbers, and those of a report have.
TEST(Model, ReferencesToSectionsSayWhatTheirHeadingsShow) {
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    const auto referring = [&](const std::string& name, const std::string& heading) {
        const bool isMemo = name == "CMEMO";
        const document::Document document(
            "DOCUMENT " + name + "\n<" + name + (isMemo ? "><SUBJECT>{S}</SUBJECT><BODY>" : ">") +
            "<SECTION ID=\"s\"><HEADING>" + heading +
            "</HEADING><PARAGRAPH><REF TO=\"s\"></REF></PARAGRAPH></SECTION>" +
            (isMemo ? "</BODY></" : "</") + name + ">");
        const Model model = buildModel(document, schemas.presentation(name), schemas);
        return model.blocks.back()->runs.front().text;
    };
    EXPECT_EQ(referring("REPORT", "{Masses}"), "Section\u00A01");
    EXPECT_EQ(referring("CMEMO", "<TEXT>{The\nlong }</TEXT><EMPH>{rod}</EMPH><FOOTNOTE>{n}"
                                 "</FOOTNOTE><TEXT>{ }</TEXT>"),
              "The long rod");
    EXPECT_EQ(referring("CMEMO", "{" + std::string(79, 'x') + "\u00E4\u00E4}"),
              std::string(79, 'x') + "\u2026");
}

TEST(Model, RandomDocumentsAreShown) {
    sgml::RandomDocument random(50);
    const schemas::Schemas schemas = schemas::Schemas::builtIn();
    std::size_t blocks = 0;
    for (int i = 0; i < 800; ++i) {
        std::string text = random.sound();
        if (i % 2 == 1)
            text = random.mutated(text);
        const document::Document document(text);
        for (const char* name : {"CMEMO", "REPORT"}) {
            const Model model = buildModel(document, schemas.presentation(name), schemas);
            blocks += model.blocks.size();
            for (const Box& box : model.boxes) {
                ASSERT_LE(box.first, box.last);
                ASSERT_LT(box.last, model.blocks.size());
            }
            (void)exportText(document, model);
        }
        (void)document::documentFaults(document, schemas, {});
    }
    EXPECT_GT(blocks, 1000u);
}

TEST(TextExport, SamplesAreAsCommitted) {
    expectGolden("memo.txt", textOf("memo.ens"));
    expectGolden("report.txt", textOf("report.ens"));
    expectGolden("report.outline.txt", textOf("report.ens", "outline"));
}

TEST(Samples, HaveNoFaultsAndNoWarnings) {
    for (const std::string name : {"memo.ens", "report.ens"}) {
        const document::Document document(contentOf(SOURCE_DIR "/samples/" + name));
        EXPECT_EQ(sgml::formatted(document::documentFaults(document, schemas::Schemas::builtIn(),
                                                           {"ANIMATION"}),
                                  name),
                  "");
    }
}

} // namespace model
