// Sections that are moved by their headings, and text that is replaced at many places.
#include "authoring/authoring.h"
#include "authoring/authoring_testing.h"
#include "document/faults.h"

#include <gmock/gmock.h>

#include <functional>

namespace authoring {
namespace {

const std::string head = "DOCUMENT REPORT\n<REPORT>\n<TITLE>{T}</TITLE>\n";
const std::string tail = "\n</REPORT>\n";

// The body of a report after a command that may look for its headings; "refused: " and why.
class Report {
public:
    explicit Report(const std::string& body) : document_(renamed(head + body + tail, false)) {}

    [[nodiscard]] sgml::NodeId heading(const std::string& text) const {
        const std::size_t at = document_.bytes().find("{" + text + "}");
        return document_.tree().node(document_.tree().innermostAt(at)).parent;
    }
    [[nodiscard]] Manuscript manuscript() const { return {document_, testGrammars()}; }
    std::string apply(const Result& result) {
        if (const auto* refusal = std::get_if<Refusal>(&result))
            return "refused: " + refusal->why.toStdString();
        const auto& step = std::get<Step>(result);
        const std::size_t faults = this->faults();
        EXPECT_EQ(document_.edit(step.edits, step.label), document::EditResult::applied);
        EXPECT_EQ(this->faults(), faults) << document_.bytes();
        return body();
    }
    [[nodiscard]] std::string body() const {
        const std::string all = renamed(document_.bytes(), true);
        return all.substr(head.size(), all.size() - head.size() - tail.size());
    }
    void undo() { document_.undo(); }
    [[nodiscard]] std::vector<text::Range> placesOf(const std::string& words) const {
        std::vector<text::Range> result;
        const std::string& bytes = document_.bytes();
        for (std::size_t at = bytes.find(words); at != std::string::npos;
             at = bytes.find(words, at + words.size()))
            result.push_back({at, at + words.size()});
        return result;
    }

private:
    [[nodiscard]] std::size_t faults() const {
        return document::documentFaults(document_, testSchemas(), {}).size();
    }
    document::Document document_;
};

std::string section(const std::string& name, const std::string& inside = {}) {
    return "<S><H>{" + name + "}</H><P>{" + name + " text}</P>" + inside + "</S>";
}

// The headings in their order, each with its depth.
std::string outline(const std::string& body) {
    std::string result;
    int depth = 0;
    for (std::size_t at = 0; at < body.size(); ++at) {
        const std::string_view rest = std::string_view(body).substr(at);
        depth += rest.starts_with("<S>") ? 1 : rest.starts_with("</S>") ? -1 : 0;
        if (rest.starts_with("<H>{"))
            result += std::string(static_cast<std::size_t>(depth), '#') +
                      std::string(rest.substr(4, rest.find('}') - 4)) + " ";
    }
    return result;
}

const std::string four =
    section("A", section("A1") + section("A2")) + "\n" + section("B", section("B1"));

std::string moved(const std::string& name, Direction direction) {
    Report report(four);
    const std::string after =
        report.apply(moveSection(report.manuscript(), report.heading(name), direction));
    if (after.starts_with("refused"))
        return after;
    report.undo();
    EXPECT_EQ(report.body(), four);
    return outline(after);
}

TEST(Sections, GoUpAndDownWithAllInThem) {
    EXPECT_EQ(outline(four), "#A ##A1 ##A2 #B ##B1 ");
    EXPECT_EQ(moved("A", Direction::forward), "#B ##B1 #A ##A1 ##A2 ");
    EXPECT_EQ(moved("A2", Direction::backward), "#A ##A2 ##A1 #B ##B1 ");
    EXPECT_EQ(moved("A2", Direction::forward), "#A ##A1 #B ##A2 ##B1 ");
    EXPECT_EQ(moved("B1", Direction::backward), "#A ##A1 ##A2 ##B1 #B ");
    EXPECT_EQ(moved("A", Direction::backward), "refused: This is the first section already.");
    EXPECT_EQ(moved("B1", Direction::forward), "refused: This is the last section already.");
}

TEST(Sections, GoBesideAndIntoAnotherOne) {
    const auto moved = [](const std::string& name, const std::string& other, Beside where) {
        Report report(four);
        return report.apply(
            moveSection(report.manuscript(), report.heading(name), report.heading(other), where));
    };
    EXPECT_EQ(outline(moved("B", "A2", Beside::before)), "#A ##A1 ##B ###B1 ##A2 ");
    EXPECT_EQ(outline(moved("A1", "B", Beside::behind)), "#A ##A2 #B ##B1 #A1 ");
    EXPECT_EQ(outline(moved("A1", "B", Beside::inside)), "#A ##A2 #B ##B1 ##A1 ");
    EXPECT_EQ(moved("A", "A1", Beside::inside), "refused: An element cannot be moved into itself.");
}

TEST(Sections, GoALevelInAndOut) {
    const auto changed = [](const std::string& name, int by) {
        Report report(four);
        return outline(report.apply(changeLevel(report.manuscript(), report.heading(name), by)));
    };
    EXPECT_EQ(changed("A2", -1), "#A ##A1 #A2 #B ##B1 ");
    EXPECT_EQ(changed("B", 1), "#A ##A1 ##A2 ##B ###B1 ");
    Report report(four);
    EXPECT_THAT(report.apply(changeLevel(report.manuscript(), report.heading("A"), -1)),
                ::testing::StartsWith("refused: This section is at the outermost"));
}

// --- replacing ------------------------------------------------------------------------------

TEST(ReplaceAll, IsOneStepAndKeepsTheStructure) {
    Report report("<P>{one two one}</P>\n<P><T>{o}</T><E>{ne on}</E><T>{e x}</T></P>");
    std::vector<text::Range> places = report.placesOf("one");
    const std::string& bytes = report.manuscript().document.bytes();
    const std::size_t over = bytes.find("{o}</TEXT>") + 1;
    places.push_back({over, bytes.find("ne on") + 2});
    const Replacement all = replaceAll(report.manuscript(), places, "1 {");
    EXPECT_EQ(all.replaced, 3u);
    EXPECT_EQ(all.left, 0u);
    const std::string after = report.apply(all.result);
    EXPECT_THAT(after, ::testing::StartsWith("<P>{1 \\{ two 1 \\{}</P>\n<P><T>{1 \\{}</T>"));
    EXPECT_THAT(after, ::testing::HasSubstr("<E>{ on}</E><T>{e x}</T></P>"));
    report.undo();
    EXPECT_THAT(report.body(), ::testing::StartsWith("<P>{one two one}"));
}

TEST(ReplaceAll, NothingTakesElementsAwayThatWouldBeEmpty) {
    Report report("<P><T>{a }</T><E>{one}</E><T>{ b one}</T></P>");
    const Replacement all = replaceAll(report.manuscript(), report.placesOf("one"), "");
    EXPECT_EQ(all.replaced, 2u);
    EXPECT_THAT(report.apply(all.result), ::testing::Not(::testing::HasSubstr("<E>")));
}

TEST(ReplaceAll, NoPlaceIsRefused) {
    Report report("<P>{a}</P>");
    EXPECT_EQ(report.apply(replaceAll(report.manuscript(), {}, "x").result),
              "refused: There is nothing to replace.");
}

} // namespace
} // namespace authoring
