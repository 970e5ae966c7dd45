// A language viewer where its window, its text or its lists end.
#include "views/test_language_viewer.h"

#include <QScreen>

namespace views {
namespace {

std::string manyLines(int count) {
    std::string text = ballScene;
    for (int i = 0; i < count; ++i)
        text += "# line " + std::to_string(i) + "\n";
    return text;
}

class LanguageEdgesTest : public LanguageViewerTest {
protected:
    void moveOffTheScreen() {
        const QRect screen = viewer->screen()->geometry();
        viewer->move(screen.left() - viewer->width() - 400, screen.bottom() + 400);
        ASSERT_TRUE(waitFor([&] { return !text().isOnScreen(text().caret()); }));
    }
    bool isShown(std::size_t byte) {
        return text().viewport()->rect().contains(text().rectOf(byte).center());
    }
    void end() { key(Qt::Key_End, Qt::ControlModifier); }
};

// --- off the screen -------------------------------------------------------------------------

TEST_F(LanguageEdgesTest, OneTypesWhereNoScreenIs) {
    open(ballScene);
    moveOffTheScreen();
    end();
    QTest::keyClicks(&text(), "forc -bo.");
    act("Complete");
    EXPECT_FALSE(text().isListActive()); // there is no place for it
    EXPECT_EQ(viewer->draft(), ballScene + "forc -bo.");
}

TEST_F(LanguageEdgesTest, AHintOffTheScreenIsLeftOut) {
    open(ballScene + "body b2 ball -mass ");
    moveOffTheScreen();
    end();
    act("Complete");
    EXPECT_FALSE(text().isCallTipActive());
}

// --- the end of the text --------------------------------------------------------------------

TEST_F(LanguageEdgesTest, TheEndOfAScrolledTextIsTakenOutByKeys) {
    const std::string all = manyLines(200);
    open(all);
    end();
    ASSERT_GT(text().firstVisibleLine(), 0);
    for (int i = 0; i < 12; ++i)
        key(Qt::Key_Backspace);
    EXPECT_EQ(viewer->draft(), all.substr(0, all.size() - 12));
    key(Qt::Key_Home, Qt::ControlModifier | Qt::ShiftModifier);
    key(Qt::Key_Delete);
    EXPECT_EQ(viewer->draft(), "");
    act("Undo");
    EXPECT_EQ(viewer->draft(), all.substr(0, all.size() - 12));
}

TEST_F(LanguageEdgesTest, TheEndOfAScrolledTextIsTakenOutByOthers) {
    const std::string all = manyLines(200);
    open(all);
    end();
    ASSERT_GT(text().firstVisibleLine(), 0);
    editor.document().setText(ballScene, "Delete");
    EXPECT_EQ(viewer->draft(), ballScene);
    EXPECT_EQ(text().structure().commands.size(), 3U);
    editor.document().undo();
    EXPECT_EQ(viewer->draft(), all);
}

// --- the list of completions ----------------------------------------------------------------

TEST_F(LanguageEdgesTest, ReturnAfterAWholeWordMakesALine) {
    open(ballScene);
    for (const char* word : {"for", "force"}) { // "for" begins "force" and "foreach", too
        viewer->dropDraft();
        end();
        QTest::keyClicks(&text(), word);
        key(Qt::Key_Return);
        EXPECT_EQ(viewer->draft(), ballScene + word + "\n");
        EXPECT_FALSE(text().isListActive());
    }
}

TEST_F(LanguageEdgesTest, OfWordsThatBeginAlikeALongerOneCanBeChosen) {
    open(ballScene);
    end();
    QTest::keyClicks(&text(), "for");
    ASSERT_TRUE(text().isListActive());
    key(Qt::Key_Down);
    key(Qt::Key_Return);
    EXPECT_EQ(viewer->draft(), ballScene + "force");
}

// --- faults ---------------------------------------------------------------------------------

TEST_F(LanguageEdgesTest, WhatIsFaultyAfterAnUpdateIsScrolledIntoView) {
    open(manyLines(200));
    caretAt(0);
    text().insert("body b9 nothing\n");
    end();
    ASSERT_FALSE(isShown(0));
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(waitFor([&] { return isShown(5); }));
    EXPECT_EQ(text().caret(), viewer->draft().size()); // where one writes
    // The note below the last line that is seen is shown, too.
    viewer->dropDraft();
    caretAt(0);
    type(*viewer, manyLines(200) + "body b9 nothing\n");
    ASSERT_FALSE(isShown(place("b9")));
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(waitFor([&] { return isShown(place("b9")); }));
    EXPECT_EQ(text().SendScintilla(QsciScintillaBase::SCI_GETFIRSTVISIBLELINE),
              text().SendScintilla(QsciScintillaBase::SCI_GETLINECOUNT) +
                  text().SendScintilla(QsciScintillaBase::SCI_ANNOTATIONGETLINES,
                                       static_cast<unsigned long>(text().lineOf(place("b9")))) -
                  text().SendScintilla(QsciScintillaBase::SCI_LINESONSCREEN) - 1);
}

TEST_F(LanguageEdgesTest, WhatIsFaultyWhenItIsOpenedIsScrolledIntoView) {
    open(manyLines(200) + "body b9 nothing\n");
    EXPECT_TRUE(waitFor([&] { return isShown(place("b9")); }));
    // What becomes faulty elsewhere does not take the text away from under one's eyes.
    editor.document().setText(manyLines(200), "Edit");
    ASSERT_TRUE(settle(editor.document()));
    caretAt(0);
    editor.document().setText(manyLines(200) + "body b9 nothing\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    QCoreApplication::processEvents();
    EXPECT_FALSE(isShown(place("b9")));
}

} // namespace
} // namespace views
