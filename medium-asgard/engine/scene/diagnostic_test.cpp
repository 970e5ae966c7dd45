#include "scene/diagnostic.h"

#include <gtest/gtest.h>

namespace scene {
namespace {

Diagnostic at(int line, int column, int endColumn, const std::string& message,
              const std::string& suggestion = "") {
    Diagnostic d;
    d.line = d.endLine = line;
    d.column = column;
    d.endColumn = endColumn;
    d.message = message;
    d.suggestion = suggestion;
    return d;
}

TEST(Diagnostic, ShowsPlaceLineCaretAndSuggestion) {
    const std::string text = "simulator\nbody bob -shape spere -init_pos {1 0 0}\n";
    EXPECT_EQ(formatted(at(2, 17, 22, "body \"bob\": no shape set named \"spere\"",
                           "did you mean \"sphere\"? (shape sets here: rod, sphere)"),
                        "swing.al", text),
              "swing.al:2:17: error: body \"bob\": no shape set named \"spere\"\n"
              "    body bob -shape spere -init_pos {1 0 0}\n"
              "                    ^~~~~ did you mean \"sphere\"? (shape sets here: rod, sphere)");
}

TEST(Diagnostic, ColumnsAreCharactersAndNotBytes) {
    EXPECT_EQ(formatted(at(1, 6, 8, "m"), "f", "körp→ XY z"), "f:1:6: error: m\n"
                                                              "    körp→ XY z\n"
                                                              "         ^~");
}

TEST(Diagnostic, TabsBecomeBlanksInBothLines) {
    EXPECT_EQ(formatted(at(1, 2, 3, "m"), "f", "\tX"), "f:1:2: error: m\n"
                                                       "            X\n"
                                                       "            ^");
}

TEST(Diagnostic, OfALongLineShowsThePartAroundTheMark) {
    std::string text(1002, 'a');
    text.replace(500, 2, "XY");
    std::string line(100, 'a');
    line.replace(50, 2, "XY");
    std::string expected = "f:1:501: error: m\n    ...";
    expected += line;
    expected += "...\n";
    expected.append(57, ' ');
    expected += "^~";
    EXPECT_EQ(formatted(at(1, 501, 503, "m"), "f", text), expected);
}

TEST(Diagnostic, PastTheEndOfALineOrTextStillHasACaret) {
    EXPECT_EQ(formatted(at(1, 4, 4, "m"), "f", "abc\r\n"), "f:1:4: error: m\n    abc\n       ^");
    EXPECT_EQ(formatted(at(9, 1, 2, "m"), "f", "abc"), "f:9:1: error: m\n    \n    ^");
}

TEST(Diagnostic, ARangeOverSeveralLinesIsMarkedToTheEndOfItsFirst) {
    Diagnostic d = at(1, 3, 1, "m");
    d.endLine = 2;
    EXPECT_EQ(formatted(d, "f", "ab{d\n}"), "f:1:3: error: m\n    ab{d\n      ^~");
}

TEST(Diagnostic, ControlCharactersOfTheTextDoNotReachTheTerminal) {
    EXPECT_EQ(formatted(at(1, 1, 2, "m"), "f", "\x1b[31m"), "f:1:1: error: m\n    ?[31m\n    ^");
}

TEST(Diagnostic, WithoutAPlaceIsOneLine) {
    Diagnostic d;
    d.severity = Severity::warning;
    d.message = "the script ran for too long";
    EXPECT_EQ(formatted(d, "f", "text"), "f: warning: the script ran for too long");
}

TEST(Diagnostics, AreSortedByPlaceThoseWithoutOneLast) {
    std::vector<Diagnostic> all{at(0, 0, 0, "d"), at(3, 1, 2, "c"), at(1, 9, 10, "b"),
                                at(1, 2, 3, "a"), at(0, 0, 0, "e")};
    sortByPlace(all);
    std::string order;
    for (const Diagnostic& d : all)
        order += d.message;
    EXPECT_EQ(order, "abcde");
}

} // namespace
} // namespace scene
