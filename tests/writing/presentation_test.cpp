// A presentation that is edited beside the pages: they follow, and nothing is saved unasked.
#include "source/presentation_pane.h"
#include "writing/writing_testing.h"

#include <QFile>

namespace writing {
namespace {

class PresentationTest : public WritingTest {
protected:
    void SetUp() override { qputenv("XDG_DATA_HOME", data_.path().toUtf8()); }
    void TearDown() override { qputenv("XDG_DATA_HOME", before_); }
    void edit(int paragraphs = 60) {
        QByteArray body;
        for (int i = 0; i < paragraphs; ++i)
            body += paragraph("line " + QByteArray::number(i) + ".");
        window_ = open(memo(body));
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        action("editPresentation")->trigger();
        ASSERT_TRUE(pane().isVisible());
        pages_ = view().pages().pages.size();
    }
    source::PresentationPane& pane() const {
        return *window_->findChild<source::PresentationPane*>();
    }
    void typeAtEnd(const char* keys) const {
        pane().edit().moveCursor(QTextCursor::End);
        pane().edit().insertPlainText(keys);
    }
    bool waitForPages(bool more) const {
        return waitFor([this, more] {
            return view().isLaidOut() && (view().pages().pages.size() > pages_) == more;
        });
    }
    [[nodiscard]] QString own() const {
        return data_.filePath("ensemble/schemas/CMEMO.default.presentation");
    }
    // Answers the question that comes.
    void answering(QMessageBox::StandardButton with, const std::function<void()>& act) const {
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
                box->button(with)->click();
        });
        timer.start(5);
        act();
    }

    QTemporaryDir data_;
    QByteArray before_ = qgetenv("XDG_DATA_HOME");
    std::size_t pages_ = 0;
};

// Slides are wider than a sheet: they fill the view without a scroll bar below, from their top.
TEST_F(PresentationTest, AnotherPresentationFitsTheViewAndBeginsAtItsTop) {
    window_ = open(memo(paragraph("One") + paragraph("Two")));
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    for (int width = 900; width < 960; width += 3) {
        window_->resize(width, 700);
        QApplication::processEvents();
        for (const char* name : {"slides", "default"}) {
            view().setPresentation(name);
            ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
            EXPECT_EQ(view().horizontalScrollBar()->maximum(), 0) << name << width;
            EXPECT_EQ(view().verticalScrollBar()->value(), 0) << name << width;
        }
    }
}

TEST_F(PresentationTest, ThePagesFollowWhatIsTypedAndUndoIsTheTextsOwn) {
    edit();
    DocumentWindow* other = application_.addWindow(window_->shared());
    typeAtEnd("\nPARAGRAPH { font: 40pt }");
    ASSERT_TRUE(waitForPages(true));
    EXPECT_GT(other->view().pages().pages.size(), pages_);
    EXPECT_FALSE(document().canUndo());
    EXPECT_TRUE(pane().edit().document()->isModified());
    for (int i = 0; i < 30; ++i)
        QTest::keySequence(&pane().edit(), QKeySequence::Undo);
    EXPECT_FALSE(pane().edit().document()->isModified());
    ASSERT_TRUE(waitForPages(false));
    EXPECT_FALSE(QFile::exists(own()));
}

TEST_F(PresentationTest, AFaultIsUnderlinedAndTheRestCounts) {
    edit();
    typeAtEnd("\nPARAGRAPH { font: 40pt; colour: red }");
    const int line = pane().edit().textCursor().blockNumber();
    EXPECT_NE(pane().edit().faultOf(line).indexOf("colour"), -1);
    ASSERT_TRUE(waitForPages(true));
    bool isListed = false;
    for (const session::ListedFault& fault : window_->document().faults())
        isListed |= fault.message.contains("colour") && fault.position.line == line + 1;
    EXPECT_TRUE(isListed);
}

TEST_F(PresentationTest, SavingWritesTheUsersOwnFile) {
    edit();
    typeAtEnd("\nPARAGRAPH { font: 40pt }");
    auto* whose = window_->findChild<QLabel*>("presentationWhose");
    EXPECT_NE(whose->text().indexOf(own()), -1);
    QTest::keySequence(&pane().edit(), QKeySequence::Save);
    ASSERT_TRUE(QFile::exists(own()));
    QFile file(own());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().endsWith("PARAGRAPH { font: 40pt }"));
    EXPECT_FALSE(pane().edit().document()->isModified());
    EXPECT_EQ(window_->document().schemas().fileOf("CMEMO", {}).path, own());
    const auto loaded = schemas::Schemas::load(schemas::Schemas::standardFolders());
    EXPECT_EQ(loaded.fileOf("CMEMO", {}).path, own());
    EXPECT_FALSE(window_->isWindowModified()); // the document is as it was
}

TEST_F(PresentationTest, TheSuppliedOneCountsAgainAndTheUsersOwnIsKept) {
    edit();
    auto* menu = window_->findChild<QMenu*>("presentations");
    ASSERT_TRUE(menu);
    Q_EMIT menu->aboutToShow();
    EXPECT_FALSE(action("suppliedPresentation")->isEnabled());
    typeAtEnd("\nPARAGRAPH { font: 40pt }");
    ASSERT_TRUE(pane().save());
    ASSERT_TRUE(waitForPages(true));
    Q_EMIT menu->aboutToShow();
    ASSERT_TRUE(action("suppliedPresentation")->isEnabled());
    action("suppliedPresentation")->trigger();
    ASSERT_TRUE(waitForPages(false));
    EXPECT_FALSE(QFile::exists(own()));
    EXPECT_TRUE(QFile::exists(own() + '~'));
    EXPECT_EQ(pane().edit().toPlainText().indexOf("40pt"), -1);
    EXPECT_NE(window_->document().schemas().fileOf("CMEMO", {}).path, own());
}

TEST_F(PresentationTest, TheMenuSavesAndFindsWhereTheKeyboardIs) {
    edit();
    typeAtEnd("\nPARAGRAPH { font: 40pt }");
    pane().edit().setFocus();
    ASSERT_TRUE(waitFor([&] { return pane().edit().hasFocus(); }));
    auto* file = qobject_cast<QMenu*>(action("save")->associatedObjects().value(0));
    Q_EMIT file->aboutToShow();
    EXPECT_NE(action("save")->text().indexOf("CMEMO.default.presentation"), -1);
    action("save")->trigger();
    EXPECT_TRUE(QFile::exists(own()));
    action("find")->trigger();
    auto* line = pane().findChild<QLineEdit*>("findInText");
    ASSERT_TRUE(line && line->isVisible());
    EXPECT_TRUE(window_->findChild<panes::FindBar*>()->isHidden());
    QTest::keyClicks(line, "SUBJECT");
    EXPECT_EQ(pane().edit().textCursor().selectedText(), "SUBJECT");
    const int first = pane().edit().textCursor().position();
    action("findNext")->trigger();
    EXPECT_NE(pane().edit().textCursor().position(), first);
    QTest::keyClick(line, Qt::Key_Escape);
    EXPECT_TRUE(pane().edit().hasFocus());
    view().setFocus();
    ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    Q_EMIT file->aboutToShow();
    EXPECT_EQ(action("save")->text(), "&Save");
    action("find")->trigger();
    EXPECT_TRUE(window_->findChild<panes::FindBar*>()->isVisible());
}

TEST_F(PresentationTest, WhatIsNotSavedIsAskedAboutAndGivenUp) {
    edit();
    typeAtEnd("\nPARAGRAPH { font: 40pt }");
    ASSERT_TRUE(waitForPages(true));
    answering(QMessageBox::Cancel, [&] { window_->close(); });
    EXPECT_TRUE(window_->isVisible());
    answering(QMessageBox::Discard, [&] { pane().close(); });
    EXPECT_FALSE(pane().isVisible());
    ASSERT_TRUE(waitForPages(false));
    EXPECT_FALSE(QFile::exists(own()));
}

} // namespace
} // namespace writing
