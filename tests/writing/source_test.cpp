// The source beside the pages: in step both ways, written in, and never in the way.
#include "source/find_line.h"
#include "source/source_pane.h"
#include "writing/writing_testing.h"

#include <QTextBlock>
#include <QTreeWidget>

namespace writing {
namespace {

QByteArray numbered(int count) {
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += paragraph("line " + QByteArray::number(i) + ".");
    return text;
}

class SourceTest : public WritingTest {
protected:
    void TearDown() override { QSettings().remove("source"); }
    void showSource(const QByteArray& body) {
        write(body);
        action("showSource")->trigger();
        ASSERT_TRUE(waitFor([&] { return pane().mirror().isComplete() && edit().hasFocus(); }));
    }
    source::SourcePane& pane() const { return *window_->findChild<source::SourcePane*>(); }
    source::SourceEdit& edit() const { return pane().edit(); }
    std::size_t caretInSource() const { return pane().mirror().selection().caret; }
    std::size_t caretInPages() const { return view().text().cursor().selection()->caret; }
    std::size_t placeOf(const std::string& words) const { return document().bytes().find(words); }
    void goInSource(const std::string& words) const {
        QTextCursor cursor(edit().document());
        cursor.setPosition(pane().mirror().positionOf(placeOf(words)));
        edit().setTextCursor(cursor);
    }
    void typeInSource(const char* keys) const { QTest::keyClicks(&edit(), keys); }
    std::size_t bandAt() const {
        return pane().mirror().offsetOf(edit().document()->findBlock(edit().band()).position());
    }
};

TEST_F(SourceTest, ThePagesShowThePlaceOfTheSourcesCaret) {
    showSource(numbered(200));
    const int before = view().verticalScrollBar()->value();
    goInSource("line 180.");
    ASSERT_TRUE(waitFor([&] { return caretInPages() == placeOf("line 180."); }));
    EXPECT_GT(view().verticalScrollBar()->value(), before);
    const QRectF seen = view().viewport()->rect();
    EXPECT_TRUE(seen.contains(view().text().caretRect()->center()));
    const text::Range marked = pane().steps().marked();
    EXPECT_EQ(document().bytes().substr(marked.from, marked.size()), "{line 180.}");
    // A tag marks its element; two clicks select a word in both.
    goInSource("TEXT>{line 20.");
    ASSERT_TRUE(
        waitFor([&] { return pane().steps().marked().from == placeOf("<TEXT>{line 20."); }));
    goInSource("line 21.");
    const QPoint at = edit().cursorRect().center() + QPoint(4, 0);
    QTest::mouseDClick(edit().viewport(), Qt::LeftButton, {}, at);
    ASSERT_TRUE(waitFor([&] { return view().text().cursor().selects(); }));
    const text::Range selected = view().text().cursor().interval();
    EXPECT_EQ(document().bytes().substr(selected.from, selected.size()), "line");
}

TEST_F(SourceTest, TheSourceBeginsWhereThePagesAre) {
    write(numbered(300));
    view().goTo(placeOf("line 250."));
    action("showSource")->trigger();
    ASSERT_TRUE(waitFor([&] { return caretInSource() == placeOf("line 250."); }));
    EXPECT_TRUE(edit().hasFocus());
}

TEST_F(SourceTest, TheSourceShowsThePlaceInThePages) {
    showSource(numbered(300));
    view().setFocus();
    ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    const std::size_t at = placeOf("line 250.") + 2;
    view().goTo(at);
    ASSERT_TRUE(waitFor([&] { return caretInSource() == at; }));
    EXPECT_TRUE(edit().viewport()->rect().contains(edit().cursorRect().center()));
    // If only the view is scrolled, the line that one reads is the one.
    view().verticalScrollBar()->setValue(0);
    ASSERT_TRUE(waitFor([&] { return bandAt() < placeOf("line 10."); }));
    EXPECT_EQ(caretInSource(), at);
}

TEST_F(SourceTest, WhatIsTypedThereIsInTheDocumentAtOnceAndUndoneThere) {
    showSource(numbered(3));
    const std::string before = document().bytes();
    goInSource("line 1.");
    typeInSource("new ");
    EXPECT_NE(placeOf("{new line 1.}"), std::string::npos);
    ASSERT_TRUE(waitFor([&] { return shown().find("new line 1.") != std::string::npos; }));
    EXPECT_TRUE(window_->isWindowModified());
    action("undo")->trigger();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_EQ(edit().toPlainText().toStdString(), before);
    EXPECT_EQ(caretInSource(), placeOf("line 1."));
    EXPECT_FALSE(document().canUndo());
}

TEST_F(SourceTest, WhatIsWrittenInThePagesComesIntoTheSource) {
    showSource(numbered(200));
    view().setFocus();
    goTo("line 150.");
    view().text().showCaret();
    type("x ");
    EXPECT_EQ(edit().toPlainText().toStdString(), document().bytes());
    ASSERT_TRUE(waitFor([&] { return caretInSource() == caretInPages(); }));
    const int scrolled = edit().verticalScrollBar()->value();
    type("y");
    QCoreApplication::processEvents();
    EXPECT_EQ(edit().verticalScrollBar()->value(), scrolled);
    EXPECT_EQ(edit().toPlainText().toStdString(), document().bytes());
}

// A tag that is being typed is a fault for a while: it is underlined, and nothing else happens.
// The same keys as in the pages: they are for the text that has the keyboard.
TEST_F(SourceTest, FindLooksInTheSourceWhereTheKeyboardIsThere) {
    showSource(numbered(30));
    auto* line = pane().findChild<source::FindLine*>();
    const auto selected = [this] { return edit().textCursor().selectedText().toStdString(); };
    const auto at = [this] { return edit().textCursor().block().text().toStdString(); };
    goInSource("line 5.");
    action("find")->trigger();
    ASSERT_TRUE(waitFor([&] { return line->isVisible() && line->field().hasFocus(); }));
    EXPECT_FALSE(window_->findChild<panes::FindBar*>()->isVisible());
    QTest::keyClicks(&line->field(), "LINE 2"); // its case is nobody's
    EXPECT_EQ(selected(), "line 2");
    EXPECT_THAT(at(), ::testing::HasSubstr("line 20."));
    action("findNext")->trigger();
    EXPECT_THAT(at(), ::testing::HasSubstr("line 21."));
    action("findPrevious")->trigger();
    action("findPrevious")->trigger();
    EXPECT_THAT(at(), ::testing::HasSubstr("line 2."));
    QTest::keyClick(&line->field(), Qt::Key_Return, Qt::ShiftModifier); // around the beginning
    EXPECT_THAT(at(), ::testing::HasSubstr("line 29."));
    QTest::keyClicks(&line->field(), "x");
    EXPECT_EQ(line->says(), "Not found");
    EXPECT_THAT(at(), ::testing::HasSubstr("line 29."));
    EXPECT_EQ(document().steps(), 0U);
    // The found text can be typed over at once.
    line->field().setText("<TEXT>{line 7");
    QTest::keyClick(&line->field(), Qt::Key_Escape);
    EXPECT_TRUE(edit().hasFocus());
    EXPECT_FALSE(line->isVisible());
    typeInSource("<TEXT>{seven");
    EXPECT_THAT(body(), ::testing::HasSubstr("<TEXT>{seven.}"));
}

TEST_F(SourceTest, ATagThatIsBeingTypedMovesNothing) {
    showSource(numbered(100));
    goInSource("<PARAGRAPH><TEXT>{line 50.");
    ASSERT_TRUE(waitFor([&] { return view().verticalScrollBar()->value() > 0; }));
    QCoreApplication::processEvents();
    const int scrolled = view().verticalScrollBar()->value();
    typeInSource("<PARAGRAPH>{so");
    ASSERT_TRUE(document().isBroken());
    const int line = edit().textCursor().blockNumber();
    ASSERT_TRUE(waitFor([&] { return !edit().faultOf(line).isEmpty(); }));
    EXPECT_TRUE(window_->findChild<QLabel*>("banner")->isHidden());
    EXPECT_TRUE(window_->findChild<panes::FaultsPane*>()->isHidden());
    EXPECT_NE(window_->findChild<QLabel*>("sourcePlace")->text().indexOf(edit().faultOf(line)), -1);
    typeInSource("}</PARAGRAPH>");
    EXPECT_FALSE(document().isBroken());
    ASSERT_TRUE(waitFor([&] { return edit().faultOf(line).isEmpty() && view().isLaidOut(); }));
    EXPECT_EQ(view().verticalScrollBar()->value(), scrolled);
}

TEST_F(SourceTest, AReadingViewsSourceIsNotWrittenAndSaysWhy) {
    showSource(numbered(3));
    action("write")->trigger();
    ASSERT_FALSE(view().isWriting());
    edit().setFocus();
    const std::string before = document().bytes();
    goInSource("line 1.");
    typeInSource("x");
    QTest::keyClick(&edit(), Qt::Key_Backspace);
    EXPECT_EQ(document().bytes(), before);
    EXPECT_EQ(edit().toPlainText().toStdString(), before);
    EXPECT_NE(window_->statusBar()->currentMessage().indexOf("Ctrl+E"), -1);
    action("write")->trigger();
    typeInSource("x");
    EXPECT_NE(placeOf("{xline 1."), std::string::npos);
}

TEST_F(SourceTest, AFaultOfTheListLeadsToItsPlace) {
    showSource(numbered(50) + "<WRONG></WRONG>\n");
    auto* faults = window_->findChild<panes::FaultsPane*>();
    ASSERT_TRUE(waitFor([&] { return faults->count() > 0; }));
    auto* list = faults->findChild<QTreeWidget*>();
    Q_EMIT list->itemActivated(list->topLevelItem(0), 0);
    EXPECT_EQ(caretInSource(), placeOf("<WRONG>"));
}

TEST_F(SourceTest, EscapeGoesOnInThePagesAndThePaneIsRemembered) {
    showSource(numbered(30));
    goInSource("line 20.");
    ASSERT_TRUE(waitFor([&] { return caretInPages() == placeOf("line 20."); }));
    QTest::keyClick(&edit(), Qt::Key_Escape);
    EXPECT_TRUE(view().hasFocus());
    type("z");
    EXPECT_NE(placeOf("{zline 20."), std::string::npos);
    DocumentWindow* other = application_.addWindow(window_->shared());
    EXPECT_TRUE(other->findChild<source::SourcePane*>()->isVisible());
    action("showSource")->trigger();
    EXPECT_TRUE(pane().isHidden());
    EXPECT_FALSE(
        application_.addWindow(window_->shared())->findChild<source::SourcePane*>()->isVisible());
}

// A brace that makes all behind it something else costs what is seen.
TEST_F(SourceTest, AKeyMarksTheLinesThatAreSeen) {
    showSource(numbered(3000));
    goInSource("line 5.");
    edit().repaint();
    const std::size_t before = edit().linesMarked();
    typeInSource("{");
    edit().repaint();
    constexpr std::size_t most = 500; // of 3,000: what the pane shows, painted some times
    EXPECT_LT(edit().linesMarked() - before, most);
    EXPECT_GT(edit().linesMarked(), before);
}

} // namespace
} // namespace writing
