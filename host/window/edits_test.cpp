// Changes that come from a medium: steps of undo, drafts in its windows, commands while it changes.
#include "onpage/shown.h"
#include "window/window_testing.h"

namespace window {
namespace {

using ::testing::HasSubstr;

TEST_F(WindowTest, AChangeByAMediumIsAStepOfUndoInAllWindows) {
    DocumentWindow* window = open(memo(scripted("colour 102030\nchange Z")));
    const std::string before = window->document().document().bytes();
    ASSERT_TRUE(waitFor([&] { return window->document().document().canUndo(); }));
    EXPECT_NE(window->document().document().bytes(), before);
    window->document().document().undo();
    EXPECT_EQ(window->document().document().bytes(), before);
}

// Presses a button of the message that a call opens, and tells the message's text.
QString answered(QMessageBox::StandardButton button, const std::function<void()>& call) {
    QString said;
    QTimer::singleShot(0, qApp, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            said = box->text();
            box->button(button)->click();
        }
    });
    call();
    return said;
}

TEST_F(WindowTest, WhatIsTypedInAMediumsWindowIsNotLostUnasked) {
    DocumentWindow* window = open(memo(scripted("colour 102030\nwindows 1 1")));
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).windows().drafts; }));
    const QString said = answered(QMessageBox::Cancel, [&] { EXPECT_FALSE(window->close()); });
    EXPECT_THAT(said.toStdString(), HasSubstr("not yet in the document"));
    answered(QMessageBox::Discard, [&] { EXPECT_TRUE(window->close()); });
}

TEST_F(WindowTest, TheQuestionOfAClosedWindowNamesItsDocumentAndItsButtonsHaveKeys) {
    DocumentWindow* window = open(memo(paragraph("one")));
    ASSERT_TRUE(waitFor([&] { return window->view().isLaidOut(); }));
    document::Document& document = window->document().document();
    const std::size_t at = document.bytes().find("one");
    document.edit({{{at, at}, "x"}}, "Type");
    QStringList keys;
    QTimer::singleShot(0, qApp, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box);
        EXPECT_EQ(box->text(), "Test (1.ens) has changes that are not saved.");
        for (const auto button : {QMessageBox::Save, QMessageBox::Discard, QMessageBox::Cancel})
            keys << QKeySequence::mnemonic(box->button(button)->text()).toString();
        box->button(QMessageBox::Cancel)->click();
    });
    EXPECT_FALSE(window->close());
    EXPECT_FALSE(keys.contains(QString())) << keys.join(' ').toStdString();
    EXPECT_EQ(QSet<QString>(keys.begin(), keys.end()).size(), 3);
}

TEST_F(WindowTest, WhatIsTypedInAMediumsWindowIsTakenIn) {
    DocumentWindow* window = open(memo(scripted("colour 102030\ndraft  #typed")));
    const std::string typed = "#typed";
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).takesDrafts(); }));
    const auto text = [&] { return live(*window, 0).text().toStdString(); };
    const std::size_t before = text().size();
    answered(QMessageBox::Cancel, [&] { EXPECT_FALSE(window->save()); });
    EXPECT_EQ(text().size(), before);
    const QString said = answered(QMessageBox::Apply, [&] { EXPECT_FALSE(window->save()); });
    EXPECT_THAT(said.toStdString(), HasSubstr("not yet in the document"));
    ASSERT_TRUE(waitFor([&] { return text().size() == before + typed.size(); }));
    ASSERT_TRUE(waitFor([&] { return !window->document().document().isModified(); })); // saved
    QFile file(window->document().document().fileName());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_THAT(file.readAll().toStdString(), HasSubstr("#typed#typed"));
    EXPECT_TRUE(window->save()); // nobody is asked any more
}

TEST_F(WindowTest, TheVersionBeforeTheLastSaveComesBack) {
    DocumentWindow* window = open(memo(paragraph("one")));
    document::Document& document = window->document().document();
    QAction* backup = window->findChild<QAction*>("backup");
    auto* menu = qobject_cast<QMenu*>(backup->parent());
    const auto isOffered = [&] {
        Q_EMIT menu->aboutToShow();
        return backup->isEnabled();
    };
    EXPECT_FALSE(isOffered());
    const std::string first = document.bytes();
    const std::size_t at = first.find("one");
    ASSERT_EQ(document.edit({{{at, at + 3}, "two"}}, "Edit"), document::EditResult::applied);
    const std::string second = document.bytes();
    EXPECT_TRUE(window->save());
    EXPECT_TRUE(isOffered());
    backup->trigger();
    EXPECT_EQ(document.bytes(), first);
    EXPECT_TRUE(document.isModified());
    document.undo();
    EXPECT_EQ(document.bytes(), second);
    EXPECT_FALSE(document.isModified());
}

TEST_F(WindowTest, ClosingMayTakeInWhatWasTyped) {
    QPointer<DocumentWindow> window = open(memo(scripted("colour 102030\ndraft #typed")));
    const std::shared_ptr<session::OpenDocument> kept = window->shared();
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).takesDrafts(); }));
    QTimer saving; // then it asks about the change
    QObject::connect(&saving, &QTimer::timeout, [] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
            if (QAbstractButton* save = box->button(QMessageBox::Save))
                save->click();
    });
    saving.start(20);
    answered(QMessageBox::Apply, [&] { EXPECT_FALSE(window->close()); });
    EXPECT_TRUE(waitFor([&] { return !window; }));
    EXPECT_FALSE(kept->document().isModified());
    EXPECT_TRUE(kept->document().canUndo());
}

// A wish that comes while a process takes the place of another is done by that one.
TEST_F(WindowTest, ACommandThatComesWhileTheMediumChangesIsKept) {
    DocumentWindow* window = open(memo(scripted("colour 102030")));
    ASSERT_TRUE(waitFor([&] { return !live(*window, 0).menus().empty(); }));
    live(*window, 0).invoke("editor", nullptr);
    live(*window, 0).invoke("editor", nullptr);
    EXPECT_TRUE(waitFor([&] { return live(*window, 0).windows().open == 2; }));
    live(*window, 0).makeStill();
    live(*window, 0).invoke("editor", nullptr);
    live(*window, 0).invoke("editor", nullptr);
    EXPECT_TRUE(waitFor([&] { return live(*window, 0).windows().open == 2; }));
}

TEST_F(WindowTest, APressBeforeTheMediumIsThereIsNotLost) {
    DocumentWindow* window = open(memo(scripted("colour 102030")));
    const QPoint at =
        (window->view().placeOf(nth(*window, 0)).topLeft() + QPointF(60, 60)).toPoint();
    ASSERT_FALSE(hasPicture(*window, 0));
    QTest::mousePress(window->view().viewport(), Qt::LeftButton, {}, at);
    EXPECT_TRUE(waitFor([&] { return colourShown(*window, 0) == QColor(0xFF, 0, 0xFF); }));
    QTest::mouseRelease(window->view().viewport(), Qt::LeftButton, {}, at);
}

TEST_F(WindowTest, HelpSaysWhatKeysAndButtonsDo) {
    DocumentWindow* window = open(memo(scripted("colour 102030")));
    QAction* help = nullptr;
    for (QAction* one : window->findChildren<QAction*>())
        if (one->shortcut() == QKeySequence(Qt::Key_F1))
            help = one;
    ASSERT_TRUE(help);
    help->trigger();
    auto* text = window->findChild<QTextBrowser*>("manual");
    ASSERT_TRUE(text);
    EXPECT_THAT(text->toPlainText().toStdString(), HasSubstr("Space plays"));
    text->window()->close();
}

TEST_F(WindowTest, AMediumWithWindowsOfItsOwnIsNotEndedToMakeRoom) {
    QByteArray many = scripted("colour 102030\nwindows 1 0");
    for (int i = 0; i < 40; ++i)
        many += scripted("colour 302010");
    DocumentWindow* window = open(memo(many), {900, 3000});
    ASSERT_TRUE(waitFor([&] { return live(*window, 0).windows().open == 1; }));
    window->view().verticalScrollBar()->setValue(window->view().verticalScrollBar()->maximum());
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 40); }));
    EXPECT_TRUE(live(*window, 0).hasProcess());
    EXPECT_EQ(live(*window, 0).windows().open, 1);
}

TEST_F(WindowTest, UndoReachesTheMedium) {
    DocumentWindow* window = open(memo(scripted("colour 102030")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    document::Document& of = window->document().document();
    const int revision = of.subdocument(nth(*window, 0))->revision;
    of.editText(nth(*window, 0), revision, {{{7, 13}, "FF8000"}}, "Colour");
    EXPECT_TRUE(waitFor([&] { return colourShown(*window, 0) == QColor(0xFF, 0x80, 0); }));
    EXPECT_TRUE(window->isWindowModified());
    of.undo();
    EXPECT_TRUE(waitFor([&] { return colourShown(*window, 0) == QColor(0x10, 0x20, 0x30); }));
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(WindowTest, WindowsOfADeadMediumAreOpenAgainAndThePictureSaysWhy) {
    DocumentWindow* window = open(memo(scripted("colour 3060A0\nkeep NEWS")));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window, 0); }));
    media::LiveSubdocument& it = live(*window, 0);
    it.invoke("editor", nullptr);
    ASSERT_TRUE(waitFor([&] { return it.keptState() == "NEWS"; }));
    it.invoke("crash", nullptr);
    ASSERT_TRUE(waitFor([&] { return it.condition() == media::Condition::failed; }));
    EXPECT_EQ(window->document().drafts(), QStringList("Scripted")); // closing asks about them
    click(*window, 0);
    ASSERT_TRUE(waitFor([&] { return it.takesDrafts(); }));
    view::Shown shown;
    shown.id = nth(*window, 0);
    shown.rendition = it.createRendition();
    shown.rendition->setShown(true);
    ASSERT_TRUE(waitFor([&] { return !shown.rendition->picture().isNull(); }));
    EXPECT_EQ(view::noticeOf(window->document(), shown).title,
              "Scripted was ended by signal 11 (Segmentation fault). Its windows are open again "
              "with what was typed.");
    click(*window, 0);
    EXPECT_EQ(view::noticeOf(window->document(), shown).kind, view::Notice::Kind::none);
    it.takeDrafts();
    EXPECT_TRUE(waitFor([&] {
        return window->document().document().bytes().find("NEWSNEWS") != std::string::npos;
    }));
}

} // namespace
} // namespace window
