// The parts of a document for those who hear it, and that it follows edits.
#include "document/random_report.h"
#include "model/model_builder.h"
#include "reading/block_text.h"
#include "reading/reading_tree.h"

#include <gmock/gmock.h>

namespace reading {

using model::ModelBuilder;
namespace {

using ::testing::ElementsAre;

// A report and the tree of its models, with what was told of each.
class Heard {
public:
    explicit Heard(const std::string& bytes)
        : document(bytes), schemas(schemas::Schemas::builtIn()),
          builder(document, schemas.presentation("REPORT"), schemas), tree(document) {
        QObject::connect(&document, &document::Document::edited, &document,
                         [this](const sgml::Change& change) { builder.follow(change); });
        follow();
    }
    void follow() {
        while (builder.step(100))
            continue;
        tree.follow(builder.model(),
                    {[this](Part& part) { told.push_back("came " + nameOf(part)); },
                     [this](Part& part) { told.push_back("left " + nameOf(part)); },
                     [this](Part& part, const auto&) { told.push_back("new " + nameOf(part)); }});
    }
    void replace(const std::string& old, const std::string& now) {
        told.clear();
        const std::size_t at = document.bytes().find(old);
        ASSERT_NE(at, std::string::npos) << old;
        document.edit({{{at, at + old.size()}, now}}, "test");
        follow();
    }
    [[nodiscard]] std::string nameOf(const Part& part) const {
        static const char* const kinds[] = {"document", "container", "text", "contents",
                                            "formula",  "figure",    "line", "table",
                                            "cell",     "note",      "link"};
        static const char* const roles[] = {"",       "section", "list",    "item",
                                            "figure", "table",   "caption", "quote"};
        std::string name = kinds[static_cast<std::size_t>(part.kind)];
        if (part.role != schemas::ContainerRole::none)
            name += std::string(":") + roles[static_cast<std::size_t>(part.role)];
        if (part.kind == Part::Kind::text)
            name += " " + BlockText(document, part.block).text().toStdString();
        if (part.runs > 0)
            name += " " + wordsFor(document, part.block->runs[part.run]).toStdString();
        return name;
    }
    // All of a tree, a line each.
    static void print(const Heard& heard, ReadingTree& of, Part& part, const std::string& indent,
                      std::string& out) {
        for (const std::unique_ptr<Part>& inside : of.partsOf(part)) {
            EXPECT_EQ(inside->parent, &part);
            out += indent + heard.nameOf(*inside) + "\n";
            print(heard, of, *inside, indent + "  ", out);
        }
    }
    [[nodiscard]] std::string printed(ReadingTree& of) const {
        std::string out;
        print(*this, of, of.root(), "", out);
        return out;
    }
    [[nodiscard]] std::string printed() { return printed(tree); }
    [[nodiscard]] std::string anew() const {
        ReadingTree fresh(document);
        fresh.follow(builder.model(), {});
        return printed(fresh);
    }

    document::Document document;
    schemas::Schemas schemas;
    ModelBuilder builder;
    ReadingTree tree;
    std::vector<std::string> told;
};

std::string reportOf(const std::string& inside) {
    return "DOCUMENT REPORT\n<REPORT>" + inside + "</REPORT>";
}

TEST(ReadingTreeTest, EachPartOfADocumentSaysWhatItIs) {
    Heard heard(reportOf(
        "<SECTION><HEADING>{One}</HEADING>"
        "<PARAGRAPH><TEXT>{See }</TEXT><LINK TO=\"http://a\">{there}</LINK>"
        "<FORMULA>{x^2}</FORMULA><FOOTNOTE>{a note}</FOOTNOTE></PARAGRAPH>"
        "<LIST><ITEM>{first}</ITEM><ITEM><PARAGRAPH>{a}</PARAGRAPH><PARAGRAPH>{b}</PARAGRAPH>"
        "</ITEM></LIST>"
        "<FIGURE><IMAGE FILE=\"a.png\" ALT=\"A tree\"></IMAGE><CAPTION>{Tree}</CAPTION></FIGURE>"
        "<TABLE><CAPTION>{Sizes}</CAPTION><ROW><CELL>{1}</CELL><CELL>{2}</CELL></ROW></TABLE>"
        "</SECTION>"));
    EXPECT_EQ(heard.printed(), "container:section\n"
                               "  text 1 One\n"
                               "  text See therex squared1\n"
                               "    link there\n"
                               "    formula x squared\n"
                               "  container:list\n"
                               "    text:item \u2022 first\n"
                               "    container:item\n"
                               "      text \u2022 a\n"
                               "      text b\n"
                               "  container:figure\n"
                               "    figure\n"
                               "    text:caption Figure 1: Tree\n"
                               "  container:table\n"
                               "    text:caption Table 1: Sizes\n"
                               "    table\n"
                               "      cell\n"
                               "        text 1\n"
                               "      cell\n"
                               "        text 2\n"
                               "note\n"
                               "  text 1 a note\n");
    for (const char* words : {"One", "See ", "first", "b}", "Tree", "Sizes", "Sizes}", "a note"}) {
        const Part* part = heard.tree.partAt(heard.document.bytes().find(words));
        ASSERT_TRUE(part && part->kind == Part::Kind::text) << words;
        EXPECT_THAT(heard.nameOf(*part), ::testing::HasSubstr(std::string(words).substr(0, 1)));
    }
}

TEST(ReadingTreeTest, ALetterIsToldOfItsParagraphAndCostsNothingElse) {
    std::string body;
    for (int i = 0; i < 2000; ++i)
        body += "<PARAGRAPH>{Words of paragraph " + std::to_string(i) + "}</PARAGRAPH>";
    Heard heard(reportOf(body));
    (void)heard.printed();
    const Part* part = heard.tree.partAt(heard.document.bytes().find("paragraph 1000}"));
    const std::size_t before = heard.tree.work(), letters = BlockText::letters;
    heard.replace("of paragraph 1000}", "of the paragraph 1000}");
    EXPECT_THAT(heard.told, ElementsAre("new text Words of the paragraph 1000"));
    EXPECT_EQ(heard.tree.partAt(heard.document.bytes().find("the paragraph")), part);
    EXPECT_LE(heard.tree.work() - before, 1u);
    EXPECT_LE(BlockText::letters - letters, 100u); // by what is printed here
    heard.replace("the paragraph 1000}", "the}</PARAGRAPH><PARAGRAPH>{paragraph 1000}");
    EXPECT_THAT(heard.told, ElementsAre("new text Words of the", "came text paragraph 1000"));
    EXPECT_LE(heard.tree.work() - before, 6u);
}

TEST(ReadingTreeTest, ATreeThatFollowedIsTheOneThatIsMadeAnew) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        document::Author author(seed);
        Heard heard(author.report(60));
        for (int i = 0; i < 40; ++i) {
            if (author.below(3) == 0)
                (void)heard.printed(); // all parts are there, else some
            if (author.below(10) < 7)
                (void)heard.document.edit(author.edit(heard.document.tree()), "Edit");
            else
                heard.document.undo();
            if (author.below(5) == 0)
                continue; // two changes at once
            heard.follow();
            if (author.below(2) == 0) {
                ASSERT_EQ(heard.printed(), heard.anew()) << "seed " << seed << " edit " << i;
            }
        }
    }
}

} // namespace
} // namespace reading
