// What a language viewer does with text, beside what viewers_test.cpp has of it.
#include "language/element_marks.h"
#include "language/scene_lexer.h"
#include "views/test_language_viewer.h"

#include "text/difference.h"

#include <gmock/gmock.h>

#include <QInputMethodEvent>
#include <QLineEdit>
#include <QListWidget>

namespace views {
namespace {

using editing::Kind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// --- points that are not shown ----------------------------------------------------------------

const std::string path = "trajectory path -points {{0 0 0 0} {1 1 0 0} {2 2 1 0} {3 3 0 0}}\n";
const std::string longPath = "trajectory path -points {\n    {0 0 0 0}\n    {1 1 0 0}\n"
                             "    {2 2 1 0}\n    {3 3 0 0}\n}\n# after\n";

class ElisionTest : public LanguageViewerTest {
protected:
    bool hidden(std::size_t byte) {
        return text().SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT, byte) == SceneLexer::hidden;
    }
};

TEST_F(ElisionTest, LongListsOfPointsAreAMarkAndStayInTheText) {
    open(ballScene + path);
    EXPECT_EQ(viewer->draft(), ballScene + path);
    EXPECT_FALSE(viewer->hasDraft());
    EXPECT_TRUE(hidden(place("{3 3 0 0}")));
    EXPECT_FALSE(hidden(place("-points")));
    EXPECT_FALSE(hidden(place("{-1 0 0}"))); // short
    // What follows on the line comes closer: the list takes little room.
    EXPECT_LT(text().rectOf(viewer->draft().size() - 1).left(),
              text().rectOf(place("{{0 0")).left() + 200);
}

TEST_F(ElisionTest, AKeyShowsThemOnABackgroundOfTheirOwnAndHidesThemAgain) {
    open(ballScene + path);
    caretAt(place("{{0 0"));
    act("Show or Hide the Points Here");
    EXPECT_FALSE(hidden(place("{3 3 0 0}")));
    EXPECT_TRUE(text().isMarked(Mark::opened, place("{3 3 0 0}")));
    // They stay open when the scene changes elsewhere.
    editor.document().setText(ballScene + "# new\n" + path, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(hidden(place("{3 3 0 0}")));
    caretAt(place("{2 2"));
    act("Show or Hide the Points Here");
    EXPECT_TRUE(hidden(place("{3 3 0 0}")));
    EXPECT_FALSE(text().isMarked(Mark::opened, place("{3 3 0 0}")));
}

TEST_F(ElisionTest, TheRightButtonDoesTheSame) {
    open(ballScene + path);
    const QPoint mark = text().rectOf(place("{{0 0")).center() + QPoint(12, 0);
    QTest::mouseClick(text().viewport(), Qt::RightButton, {}, mark);
    EXPECT_FALSE(hidden(place("{3 3 0 0}")));
    const QPoint inside = text().rectOf(place("{2 2 1 0}")).center() + QPoint(3, 0);
    QTest::mouseClick(text().viewport(), Qt::RightButton, {}, inside);
    EXPECT_TRUE(hidden(place("{3 3 0 0}")));
}

TEST_F(ElisionTest, LinesThatHaveNothingElseAreNotThere) {
    open(ballScene + longPath);
    const int first = text().lineOf(place("trajectory")), after = text().lineOf(place("# after"));
    const auto visible = [&](int line) {
        return text().SendScintilla(QsciScintillaBase::SCI_GETLINEVISIBLE,
                                    static_cast<unsigned long>(line)) != 0;
    };
    EXPECT_TRUE(visible(first));
    for (int line = first + 1; line < after; ++line)
        EXPECT_FALSE(visible(line)) << line;
    EXPECT_TRUE(visible(after));
    act("Show All Points");
    for (int line = first; line <= after; ++line)
        EXPECT_TRUE(visible(line));
    act("Hide All Points");
    EXPECT_FALSE(visible(first + 1));
}

TEST_F(ElisionTest, TheCaretJumpsOverThemAndBackspaceSelectsThemFirst) {
    open(ballScene + path);
    const std::size_t from = place("{{0 0"), to = viewer->draft().size() - 1;
    caretAt(from);
    key(Qt::Key_Right);
    QCoreApplication::processEvents();
    EXPECT_EQ(text().caret(), to);
    key(Qt::Key_Backspace);
    EXPECT_EQ(viewer->draft(), ballScene + path);
    EXPECT_EQ(text().selection(), (scene::Range{from, to}));
    key(Qt::Key_Backspace);
    EXPECT_EQ(viewer->draft(), ballScene + "trajectory path -points \n");
}

TEST_F(ElisionTest, WhatIsTakenOutOrComposedOverThemIsSeenFirst) {
    open(ballScene + path);
    const std::size_t from = place("{{0 0"), to = viewer->draft().size() - 1;
    const auto hideAgain = [&] {
        viewer->dropDraft();
        caretAt(0);
        act("Hide All Points");
        ASSERT_TRUE(hidden(place("{3 3 0 0}")));
    };
    caretAt(to);
    key(Qt::Key_Backspace, Qt::ControlModifier);
    EXPECT_LT(viewer->draft().size(), to + 1); // a word of it
    hideAgain();
    caretAt(from);
    key(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(viewer->draft(), ballScene + "trajectory path -points \n");
    hideAgain();
    caretAt(from);
    key(Qt::Key_L, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(viewer->draft(), ballScene);
    hideAgain();
    text().select({from, to});
    QInputMethodEvent composed;
    composed.setCommitString(QString::fromUtf8("\xc3\xb6"));
    QApplication::sendEvent(&text(), &composed);
    EXPECT_EQ(viewer->draft(), ballScene + "trajectory path -points \xc3\xb6\n");
}

TEST_F(ElisionTest, WhatIsTypedOrLookedForIsSeen) {
    open(ballScene);
    type(*viewer, ballScene + path);
    EXPECT_FALSE(hidden(place("{3 3 0 0}")));
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    caretAt(0);
    act("Hide All Points");
    ASSERT_TRUE(hidden(place("{3 3 0 0}")));
    EXPECT_TRUE(viewer->find("2 2 1"));
    EXPECT_FALSE(hidden(place("{3 3 0 0}")));
}

// --- faults -------------------------------------------------------------------------------------

TEST_F(LanguageViewerTest, AllFaultsAreMarkedAndKeysGoFromOneToTheNext) {
    open(ballScene);
    text().append("body b2 bal -init_pos {0 0 0}\nbody b3 ball -mas 2\n"
                  "force -body b9 -y 1\n");
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(viewer->messages().count(), 3);
    const auto marks = text().marks(Mark::error);
    ASSERT_EQ(marks.size(), 3U);
    EXPECT_EQ(text().word(marks[0]), "bal");
    EXPECT_EQ(text().word(marks[1]), "-mas");
    EXPECT_EQ(text().word(marks[2]), "b9");
    for (int line : {3, 4, 5})
        EXPECT_FALSE(text().annotation(line).isEmpty()) << line;
    caretAt(0);
    for (const char* word : {"bal", "-mas", "b9", "bal"}) {
        act("Next Message");
        EXPECT_EQ(text().selectedText(), word);
    }
    act("Previous Message");
    EXPECT_EQ(text().selectedText(), "b9");
    // The last good scene's colours are where they were.
    EXPECT_TRUE(text().isMarked(Mark::argument, place("{-1 0 0}")));
}

TEST_F(LanguageViewerTest, AFaultWithoutAPlaceIsListed) {
    open(ballScene);
    type(*viewer, "while 1 {}\n");
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_GE(viewer->messages().count(), 1);
    EXPECT_TRUE(viewer->messages().isVisible());
}

// --- elements ------------------------------------------------------------------------------------

TEST_F(LanguageViewerTest, ArgumentsHaveTheColoursOfTheirHandles) {
    open(ballScene + "force -body b1 -x 0 -y {-10 * b1.mass} -z 0\n"
                     "link -body1 b1 -offset1 {0 0 1} -x 0 -y 0 -z 0 -tightness 10\n");
    const auto color = [&](const std::string& what) {
        const long value = text().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT,
                                                static_cast<unsigned long>(Mark::argument),
                                                static_cast<long>(place(what)));
        return static_cast<int>(value & 0xFFFFFF);
    };
    const auto handle = [](render::HandleKind kind) {
        const scene::Color c = render::colorOf(kind);
        const auto byte = [](double part) { return static_cast<int>(std::lround(part * 255)); };
        return byte(c.red) | (byte(c.green) << 8) | (byte(c.blue) << 16);
    };
    EXPECT_EQ(color("{-1 0 0}"), handle(render::HandleKind::position));
    EXPECT_EQ(color("{1 0 0}"), handle(render::HandleKind::velocity));
    EXPECT_EQ(color("-10 * b1"), handle(render::HandleKind::forceHead));
    EXPECT_EQ(color("{0 0 1}"), handle(render::HandleKind::linkEnd));
    EXPECT_EQ(color("* b1.mass"), 0);
    EXPECT_EQ(color("-tightness"), 0);
}

TEST_F(LanguageViewerTest, TheCaretSelectsTheElementsOfItsCommand) {
    open(ballScene + "force -body b1 -y 1\nforeach i {1 2} { force -body b1 -x $i }\n");
    caretAt(place("-init_pos"));
    EXPECT_THAT(editor.document().selected(), ElementsAre(editing::Element{Kind::body, 0}));
    caretAt(place("-body b1 -x"));
    EXPECT_THAT(editor.document().selected(),
                ElementsAre(editing::Element{Kind::force, 1}, editing::Element{Kind::force, 2}));
    key(Qt::Key_Escape);
    EXPECT_THAT(editor.document().selected(), IsEmpty());
}

TEST_F(LanguageViewerTest, WhatIsSelectedElsewhereIsMarkedAndFollowsItsCommand) {
    open(ballScene + "force -body b1 -y 1\n");
    const auto marked = [&](const std::string& what) {
        return (text().markersAtLine(text().lineOf(place(what))) & (1U << 3)) != 0;
    };
    editor.document().select({{Kind::force, 0}});
    EXPECT_TRUE(marked("force"));
    EXPECT_FALSE(marked("body b1 ball"));
    // Another force comes before it: it stays the one that is selected.
    editor.document().setText(ballScene + "force -body b1 -z 2\nforce -body b1 -y 1\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(editor.document().selected(), ElementsAre(editing::Element{Kind::force, 1}));
    EXPECT_TRUE(marked("-y 1"));
    EXPECT_FALSE(marked("-z 2"));
    // Removed, it is not selected any more.
    editor.document().setText(ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(editor.document().selected(), IsEmpty());
}

// --- numbers
// ---------------------------------------------------------------------------------------

TEST_F(LanguageViewerTest, KeysCountANumberInOneStepOfUndo) {
    open(ballScene);
    caretAt(place("-1 0 0") + 1);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_NE(scene().find("{-0.7 0 0}"), std::string::npos) << scene(); // at once
    QTest::keyRelease(&text(), Qt::Key_Alt);
    EXPECT_FALSE(viewer->hasDraft());
    EXPECT_EQ(viewer->draft(), scene());
    editor.document().undo();
    EXPECT_EQ(scene(), ballScene);
}

TEST_F(LanguageViewerTest, ThePointerDragsANumber) {
    open(ballScene);
    const QPoint at = text().rectOf(place("{1 0 0}") + 1).center() + QPoint(3, 0);
    QTest::mousePress(text().viewport(), Qt::LeftButton, Qt::AltModifier, at);
    const auto moveTo = [&](QPoint to) {
        QMouseEvent move(QEvent::MouseMove, to, text().viewport()->mapToGlobal(to), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(text().viewport(), &move);
    };
    moveTo(at + QPoint(10, 0));
    EXPECT_NE(scene().find("-init_dpos {1.5 0 0}"), std::string::npos) << scene();
    moveTo(at + QPoint(30, 2));
    QTest::mouseRelease(text().viewport(), Qt::LeftButton, {}, at + QPoint(30, 2));
    EXPECT_NE(scene().find("-init_dpos {2.5 0 0}"), std::string::npos) << scene();
    editor.document().undo();
    EXPECT_EQ(scene(), ballScene);
    // Escape brings it back while it lasts.
    QTest::mousePress(text().viewport(), Qt::LeftButton, Qt::AltModifier, at);
    moveTo(at + QPoint(40, 0));
    key(Qt::Key_Escape);
    EXPECT_EQ(scene(), ballScene);
    QTest::mouseRelease(text().viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(scene(), ballScene);
}

TEST_F(LanguageViewerTest, InADraftANumberIsTyping) {
    open(ballScene);
    type(*viewer, ballScene + "# mine\n");
    caretAt(place("finish 2") + 7);
    QTest::keyPress(&text(), Qt::Key_Down, Qt::AltModifier);
    QTest::keyRelease(&text(), Qt::Key_Alt);
    EXPECT_NE(viewer->draft().find("-finish 1.9"), std::string::npos);
    EXPECT_EQ(scene(), ballScene);
    act("Undo");
    EXPECT_EQ(viewer->draft(), ballScene + "# mine\n");
}

TEST_F(LanguageViewerTest, WholeQuantitiesStayWhole) {
    open(ballScene + "body b2 ball -init_pos {9 0 0} -ct 3\n");
    caretAt(place("-ct 3") + 4);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    QTest::keyRelease(&text(), Qt::Key_Alt);
    EXPECT_NE(scene().find("-ct 4"), std::string::npos);
}

TEST_F(LanguageViewerTest, WhatALoopCountsByStaysWhole) {
    open(ballScene + "for {set i 3} {$i < 5} {incr i 1} {set h 2}\n");
    const auto count = [&](const std::string& what, std::size_t offset) {
        caretAt(place(what) + offset);
        QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
        QTest::keyRelease(&text(), Qt::Key_Alt);
    };
    count("set i 3", 6);
    count("< 5", 2);
    count("incr i 1", 7);
    count("set h 2", 6); // a length, or whatever it is
    EXPECT_NE(scene().find("for {set i 4} {$i < 6} {incr i 2} {set h 2.1}"), std::string::npos)
        << scene();
}

// --- completion, find and replace
// --------------------------------------------------------------------

// What a key makes: the text's structure once, that of the begun command to complete it, and what
// differs from the scene's text once, however much asks for them.
TEST_F(LanguageViewerTest, AKeyGoesThroughTheTextOnce) {
    open(ballScene + path);
    editor.document().select({{Kind::body, 0}});
    type(*viewer, ballScene + path + "# mine\n");
    caretAt(viewer->draft().size());
    QTest::keyClicks(&text(), "fo");
    const std::size_t structures = script::structuresMade();
    const std::size_t differences = text::differencesSought();
    QTest::keyClicks(&text(), "r");
    EXPECT_TRUE(text().isListActive());
    viewer->repaint();
    QCoreApplication::processEvents();
    EXPECT_LE(script::structuresMade() - structures, 2U);
    EXPECT_LE(text::differencesSought() - differences, 1U);
}

TEST_F(LanguageViewerTest, WhatIsBegunIsCompleted) {
    open(ballScene);
    caretAt(viewer->draft().size());
    QTest::keyClicks(&text(), "forc");
    EXPECT_TRUE(text().isListActive());
    key(Qt::Key_Return);
    EXPECT_EQ(viewer->draft(), ballScene + "force");
    QTest::keyClicks(&text(), " -bod");
    EXPECT_TRUE(text().isListActive());
    key(Qt::Key_Tab);
    QTest::keyClicks(&text(), " ");
    act("Complete");
    EXPECT_TRUE(text().isListActive());
    key(Qt::Key_Return);
    EXPECT_EQ(viewer->draft(), ballScene + "force -body b1");
}

TEST_F(LanguageViewerTest, ReplaceAllIsOneStepAndMarksGo) {
    open(ballScene);
    act("Find and Replace…");
    auto* what = [&]() -> QLineEdit* {
        for (auto* line : viewer->findChildren<QLineEdit*>())
            if (line->accessibleName() == "Find")
                return line;
        return nullptr;
    }();
    auto* with = [&]() -> QLineEdit* {
        for (auto* line : viewer->findChildren<QLineEdit*>())
            if (line->accessibleName() == "Replace with")
                return line;
        return nullptr;
    }();
    ASSERT_TRUE(what && with);
    what->setText("ball");
    EXPECT_EQ(text().marks(Mark::found).size(), 2U);
    with->setText("marble");
    with->setFocus();
    QTest::keyClick(with, Qt::Key_Return); // selects the first
    QTest::keyClick(with, Qt::Key_Return);
    EXPECT_NE(viewer->draft().find("shape_set marble"), std::string::npos);
    EXPECT_NE(viewer->draft().find("b1 ball"), std::string::npos);
    what->setText("0 0");
    button("Replace All")->click();
    EXPECT_EQ(viewer->draft().find("0 0"), std::string::npos);
    act("Undo");
    EXPECT_NE(viewer->draft().find("{1 0 0}"), std::string::npos);
    EXPECT_EQ(scene(), ballScene); // only a draft
    QTest::keyClick(what, Qt::Key_Escape);
    EXPECT_TRUE(text().marks(Mark::found).empty());
}

// --- all of it
// ---------------------------------------------------------------------------------------

TEST_F(LanguageViewerTest, EverythingHasANameThatCanBeReadAloud) {
    open(ballScene);
    act("Find and Replace…");
    EXPECT_FALSE(text().accessibleName().isEmpty());
    EXPECT_FALSE(viewer->messages().accessibleName().isEmpty());
    for (auto* line : viewer->findChildren<QLineEdit*>())
        EXPECT_FALSE(line->accessibleName().isEmpty() && line->isVisible());
    for (auto* one : viewer->findChildren<QPushButton*>())
        EXPECT_FALSE(one->text().isEmpty());
}

TEST_F(LanguageViewerTest, AnyTextCanBeTyped) {
    open(ballScene + longPath);
    for (const std::string& part :
         {std::string("{"), std::string("\""), std::string("trajectory p -points {{1 2"),
          std::string("\xC3\xA4 -points {}"), std::string("[[["), std::string("$")}) {
        for (std::size_t at : {std::size_t{0}, place("-points"), viewer->draft().size()}) {
            caretAt(at);
            text().insert(QString::fromStdString(part));
            act("Complete");
            key(Qt::Key_Escape);
        }
    }
    const std::string typed = viewer->draft();
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(scene(), typed);
    EXPECT_TRUE(editor.document().hasErrors());
}

} // namespace
} // namespace views
