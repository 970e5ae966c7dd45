#include "source/marks.h"

#include "plain/test_contrast.h"
#include "source/line_marks.h"

#include <gmock/gmock.h>

namespace source {
namespace {

using ::testing::ElementsAre;

bool isReport(std::string_view name) { return name == "REPORT"; }

// Each mark as "kind:bytes".
std::vector<std::string> marked(const std::string& bytes, text::Range range) {
    const char* const names[] = {"word", "tag", "attribute", "value", "scene", "stray", "comment"};
    const sgml::Tree tree = sgml::Tree::parse(bytes);
    std::vector<std::string> result;
    for (const Mark& mark : marksOf(tree, range, isReport))
        result.push_back(std::string(names[static_cast<std::size_t>(mark.kind)]) + ":" +
                         std::string(tree.text(mark.range)));
    return result;
}

const std::string report = "DOCUMENT REPORT\n<REPORT>\n<A ID=\"x\" B=\"\">{t}</A>\n"
                           "<DOCUMENT>DOCUMENT MOVIE\n<MOVIE><S>{body}</S></MOVIE></DOCUMENT>\n"
                           "</REPORT>";

TEST(Marks, SayWhatIsTagAttributeTextAndScene) {
    EXPECT_THAT(marked(report, {0, report.size()}),
                ElementsAre("word:DOCUMENT REPORT", "tag:<REPORT>", "tag:<A ",
                            "attribute:ID=", "value:\"x\"", "tag: ", "attribute:B=", "value:\"\"",
                            "tag:>", "tag:</A>", "tag:<DOCUMENT>", "word:DOCUMENT MOVIE",
                            "tag:<MOVIE>", "tag:<S>", "scene:{body}", "tag:</S>", "tag:</MOVIE>",
                            "tag:</DOCUMENT>", "tag:</REPORT>"));
}

// Those of a line are those of the whole that reach into it.
TEST(Marks, OfAPartAreThoseOfTheWhole) {
    const sgml::Tree tree = sgml::Tree::parse(report + "}<X Y Z=1 <{{");
    const std::size_t size = tree.bytes().size();
    const std::vector<Mark> all = marksOf(tree, {0, size}, isReport);
    for (std::size_t from = 0; from < size; ++from)
        for (std::size_t to = from + 1; to < std::min(size, from + 30); ++to) {
            std::vector<Mark> inside;
            for (const Mark& mark : all)
                if (mark.range.from < to && mark.range.to > from)
                    inside.push_back(mark);
            ASSERT_EQ(marksOf(tree, {from, to}, isReport), inside) << from << " " << to;
        }
}

TEST(Marks, OfLinesCountLetters) {
    const std::string bytes = "\xc3\xa4<A>\r\n<B>";
    const std::vector<Mark> marks{{{2, 5}, Kind::tag}, {{7, 10}, Kind::tag}};
    EXPECT_THAT(lineMarksOf(bytes, 0, 2, marks),
                ElementsAre(LineMarks{{1, 3, Kind::tag}}, LineMarks{{0, 3, Kind::tag}}));
}

TEST(Marks, CanBeRead) {
    for (const bool isDark : {false, true})
        for (const QColor& ground :
             {isDark ? QColor(30, 30, 30) : QColor(Qt::white),
              isDark ? QColor(53, 53, 53) : QColor(247, 247, 248), bandColor(isDark)}) {
            for (const Kind kind : {Kind::word, Kind::tag, Kind::attribute, Kind::value,
                                    Kind::scene, Kind::stray, Kind::comment})
                EXPECT_GE(plain::contrast(colorOf(kind, isDark).rgb(), ground.rgb()),
                          plain::leastContrast)
                    << isDark << " " << static_cast<int>(kind) << ground.name().toStdString();
            EXPECT_GE(plain::contrast(numberColor(isDark).rgb(), ground.rgb()),
                      plain::leastContrast);
        }
}

} // namespace
} // namespace source
