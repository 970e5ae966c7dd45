// The outline of a document, and that it follows edits at the cost of what they change.
#include "document/random_report.h"
#include "excerpts/outline.h"
#include "model/model_builder.h"

#include <gmock/gmock.h>

namespace model {
namespace {

using ::testing::ElementsAre;

const schemas::Schemas& builtIn() {
    static const schemas::Schemas all = schemas::Schemas::builtIn();
    return all;
}

std::string report(const std::string& body) {
    return "DOCUMENT REPORT\n<REPORT>\n<TITLE>{T}</TITLE>\n" + body + "</REPORT>\n";
}

std::string section(const std::string& heading, const std::string& inside = {}) {
    return "<SECTION>\n<HEADING>{" + heading + "}</HEADING>\n<PARAGRAPH>{text}</PARAGRAPH>\n" +
           inside + "</SECTION>\n";
}

// A document and the outline of its models.
class Outlined {
public:
    explicit Outlined(const std::string& bytes)
        : document(bytes), builder(document, builtIn().presentation("REPORT"), builtIn()) {
        QObject::connect(&document, &document::Document::edited, &document,
                         [this](const sgml::Change& change) { builder.follow(change); });
        follow();
    }
    bool follow() {
        while (builder.step(100))
            continue;
        return outline.follow(builder.model());
    }
    bool replace(const std::string& old, const std::string& now) {
        const std::size_t at = document.bytes().find(old);
        document.edit({{{at, at + old.size()}, now}}, "test");
        return follow();
    }
    [[nodiscard]] std::vector<std::string> listed() const {
        std::vector<std::string> result;
        for (const Outline::Entry& entry : outline.entries())
            result.push_back(std::string(static_cast<std::size_t>(entry.level), '#') + " " +
                             entry.text);
        return result;
    }

    document::Document document;
    ModelBuilder builder;
    Outline outline;
};

TEST(OutlineTest, HeadingsFiguresAndTablesAreListedInTheirOrder) {
    const std::string figure = "<FIGURE><IMAGE FILE=\"a.png\" ALT=\"A tree\"></IMAGE>"
                               "<CAPTION><TEXT>{A }</TEXT><EMPH>{big}</EMPH><TEXT>{ tree}</TEXT>"
                               "</CAPTION></FIGURE>\n"
                               "<FIGURE><IMAGE FILE=\"b.png\" ALT=\"A house\"></IMAGE></FIGURE>\n";
    const std::string table = "<TABLE><CAPTION>{Sizes}</CAPTION><ROW><CELL>{1}</CELL></ROW>"
                              "</TABLE>\n<TABLE><ROW><CELL>{1}</CELL></ROW></TABLE>\n";
    const Outlined all(report(section("One", figure + section("Inner")) + section("Two", table)));
    EXPECT_THAT(all.listed(),
                ElementsAre("# 1 One", "# Figure 1: A big tree", "# A house", "## 1.1 Inner",
                            "# 2 Two", "# Table 1: Sizes", "# Table"));
    const Outline::Entry& inner = all.outline.entries()[3];
    EXPECT_EQ(inner.kind, Outline::Kind::heading);
    EXPECT_EQ(all.document.tree().name(inner.element), "HEADING");
    EXPECT_EQ(all.document.tree().name(all.outline.entries()[5].element), "TABLE");
}

TEST(OutlineTest, ALetterOfALongReportReadsItsBlockAlone) {
    std::string body;
    for (int i = 0; i < 1000; ++i)
        body += section("Heading " + std::to_string(i));
    Outlined all(report(body));
    EXPECT_EQ(all.outline.entries().size(), 1000u);
    const std::size_t whole = all.outline.blocksRead();
    EXPECT_FALSE(all.replace("{text}", "{texts}"));
    EXPECT_LE(all.outline.blocksRead() - whole, 1u);
    EXPECT_TRUE(all.replace("{Heading 500}", "{Another}"));
    EXPECT_LE(all.outline.blocksRead() - whole, 2u);
    EXPECT_EQ(all.listed()[500], "# 501 Another");
}

TEST(OutlineTest, AnOutlineThatFollowedIsTheOneThatIsMadeAnew) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        document::Author author(seed);
        Outlined all(author.report(80));
        for (int i = 0; i < 40; ++i) {
            if (author.below(10) < 7)
                (void)all.document.edit(author.edit(all.document.tree()), "Edit");
            else
                all.document.undo();
            if (author.below(5) == 0)
                continue; // two changes at once
            all.follow();
            Outline anew;
            anew.follow(all.builder.model());
            ASSERT_EQ(all.outline.entries(), anew.entries()) << "seed " << seed << " edit " << i;
        }
    }
}

} // namespace
} // namespace model
