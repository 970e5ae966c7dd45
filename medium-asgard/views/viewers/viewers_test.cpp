// Texts and drafts in their windows, and files.
#include "language/scene_editor.h"
#include "language/scintilla.h"
#include "viewers/editor.h"
#include "viewers/scene_files.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

namespace views {
namespace {

class ViewersTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }

    static QPushButton* button(QWidget& window, const QString& text) {
        for (auto* b : window.findChildren<QPushButton*>())
            if (b->text().remove('&') == text)
                return b;
        return nullptr;
    }
    static void type(LanguageViewer& viewer, const std::string& text) {
        viewer.editor().setText(QString::fromStdString(text));
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

TEST_F(ViewersTest, UpdateBringsAllViewsUpToDate) {
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    GraphicalViewer* picture = editor.openGraphicalViewer();
    type(*one, "simulator -finish 5\n" + ballScene.substr(20));
    EXPECT_TRUE(one->hasDraft());
    EXPECT_TRUE(one->isWindowModified());
    EXPECT_EQ(two->draft(), ballScene);
    button(*one, "Update")->click();
    EXPECT_FALSE(one->hasDraft());
    EXPECT_EQ(two->draft(), one->draft());
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(picture->playback().finish(), 5);
}

TEST_F(ViewersTest, ADraftIsKeptWhenAnotherViewUpdates) {
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    const std::string mine = ballScene + "# mine\n";
    type(*two, mine);
    type(*one, ballScene + "# theirs\n");
    one->updateDocument();
    EXPECT_EQ(two->draft(), mine);
    EXPECT_TRUE(two->hasDraft());
    button(*two, "Keep Mine")->click();
    two->updateDocument();
    EXPECT_EQ(one->draft(), mine);
    type(*one, "# dropped\n");
    one->dropDraft();
    EXPECT_EQ(one->draft(), mine);
    editor.document().undo();
    EXPECT_EQ(one->draft(), ballScene + "# theirs\n");
    EXPECT_EQ(two->draft(), ballScene + "# theirs\n");
}

TEST_F(ViewersTest, FaultsAreMarkedAtTheirWordsAndListed) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const std::string text = ballScene + "body b2 bal -init_pos {0 0 0}\n";
    type(*viewer, text);
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_EQ(viewer->messages().count(), 1);
    EXPECT_TRUE(viewer->messages().item(0)->text().startsWith("Line 4: "));
    EXPECT_TRUE(viewer->messages().isVisible());
    const auto marked = [&](std::size_t at) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 8UL,
                                              static_cast<long>(at)) != 0;
    };
    const std::size_t word = text.find("bal -init");
    EXPECT_TRUE(marked(word));
    EXPECT_FALSE(marked(word - 2));
    EXPECT_TRUE(viewer->editor().annotation(3).contains("ball"));
    // A click leads there.
    Q_EMIT viewer->messages().itemActivated(viewer->messages().item(0));
    EXPECT_EQ(viewer->editor().selectedText(), "bal");
    // Repaired, all is gone.
    type(*viewer, ballScene);
    viewer->updateDocument();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(viewer->messages().count(), 0);
    EXPECT_TRUE(viewer->editor().annotation(3).isEmpty());
}

TEST_F(ViewersTest, FaultyTextsOfAllKindsLeaveTheWindowsAlive) {
    GraphicalViewer* picture = editor.openGraphicalViewer();
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto middle = [picture] { // the picture without what is said above it
        const QRect all = picture->display().rect();
        return picture->display().grab(all.adjusted(100, 100, -100, -100)).toImage();
    };
    const QImage before = middle();
    for (const std::string& text :
         {std::string("{"), std::string("body"), std::string("error \xC3\xA4\xC3"),
          std::string("\0x", 2), std::string("while 1 {}"), std::string(5000, '[')}) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        EXPECT_TRUE(editor.document().hasErrors());
        EXPECT_GE(viewer->messages().count(), 1);
        EXPECT_EQ(middle(), before);
    }
}

TEST_F(ViewersTest, RevertGoesBackToWhatWasSaved) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_EQ(editor.document().savedText(), "");
    type(*viewer, "# something else\n");
    viewer->revert();
    EXPECT_EQ(viewer->draft(), "");
    EXPECT_EQ(editor.document().text(), "");
    editor.document().undo(); // a revert is a step like others
    EXPECT_EQ(viewer->draft(), ballScene);
}

TEST_F(ViewersTest, RevertAsksBeforeWhatWasTypedIsLost) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto revertChoosing = [&](QMessageBox::StandardButton choice) {
        bool isAsked = false;
        QTimer::singleShot(0, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            isAsked = box != nullptr;
            if (box)
                box->button(choice)->click();
        });
        button(*viewer, "Revert")->click();
        QCoreApplication::processEvents();
        return isAsked;
    };
    type(*viewer, "# something else\n");
    EXPECT_TRUE(revertChoosing(QMessageBox::No));
    EXPECT_EQ(viewer->draft(), "# something else\n");
    EXPECT_TRUE(revertChoosing(QMessageBox::Yes));
    EXPECT_EQ(viewer->draft(), "");
    editor.document().undo();
    EXPECT_FALSE(revertChoosing(QMessageBox::Yes)); // Undo brings it back
    EXPECT_EQ(editor.document().text(), "");
}

TEST_F(ViewersTest, UnderAHostRevertDropsTheDraftOnly) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, "# something else\n");
    viewer->revert();
    EXPECT_EQ(viewer->draft(), ballScene);
    EXPECT_FALSE(button(*viewer, "Save")->isVisible());
    editor.document().setTextFromHost("# from the host\n");
    EXPECT_EQ(viewer->draft(), "# from the host\n");
}

TEST_F(ViewersTest, WhatTheHostRefusesIsADraftAgain) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* one = editor.openLanguageViewer();
    LanguageViewer* two = editor.openLanguageViewer();
    const std::string mine = ballScene + "# mine\n", theirs = ballScene + "# theirs\n";
    type(*one, mine);
    one->updateDocument();
    EXPECT_EQ(two->draft(), mine); // shown at once
    editor.document().didRefuse(theirs, "the text is at revision 3");
    EXPECT_EQ(one->draft(), mine);
    EXPECT_TRUE(one->hasDraft());
    EXPECT_EQ(two->draft(), theirs);
    EXPECT_FALSE(two->hasDraft());
    const auto notice = [](LanguageViewer& viewer) {
        for (QLabel* label : viewer.findChildren<QLabel*>())
            if (label->accessibleName() == "Notice" && !label->isHidden())
                return label->text();
        return QString();
    };
    EXPECT_TRUE(notice(*one).contains("the text is at revision 3"));
    EXPECT_EQ(notice(*two), QString());
    button(*one, "Keep Mine")->click();
    one->updateDocument();
    editor.document().didAccept();
    EXPECT_EQ(notice(*one), QString());
    EXPECT_EQ(two->draft(), mine);
    // What was accepted is no draft any more, whatever is refused later.
    type(*two, ballScene);
    two->updateDocument();
    editor.document().didRefuse(mine, "no");
    EXPECT_FALSE(one->hasDraft());
    EXPECT_EQ(two->draft(), ballScene);
}

// What was typed after Update is a draft upon what the host refuses: all of it is kept.
TEST_F(ViewersTest, WhatGoesOnAfterAnUpdateKeepsWhatTheHostRefuses) {
    editor.document().setHostLink({[](const text::Edit&, const QString&) {}, [] {}, [] {}});
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, "# one\n" + ballScene);
    viewer->updateDocument();
    type(*viewer, "# one\n" + ballScene + "# two\n");
    const std::string theirs = "simulator -finish 3" + ballScene.substr(19);
    editor.document().didRefuse(theirs, "no");
    EXPECT_EQ(viewer->draft(), "# one\n" + theirs + "# two\n");
    EXPECT_TRUE(viewer->hasDraft());
    viewer->updateDocument();
    EXPECT_EQ(editor.document().text(), "# one\n" + theirs + "# two\n");
}

// A gesture that was given up leaves no dispute behind.
TEST_F(ViewersTest, WhatIsAsItWasIsNoConflict) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto with = [](const std::string& x) {
        return ballScene.substr(0, ballScene.find("{-1 0")) + "{" + x +
               ballScene.substr(ballScene.find(" 0 0} -init_dpos"));
    };
    type(*viewer, with("7"));
    const auto conflicts = [&] {
        return static_cast<SceneEditor&>(viewer->editor()).marks(Mark::conflict).size();
    };
    const int since = editor.document().revision();
    editor.document().preview(with("-1.5"), since);
    EXPECT_EQ(conflicts(), 1U);
    editor.document().preview(with("-1.25"), since);
    EXPECT_EQ(conflicts(), 1U);
    editor.document().finishPreview(ballScene, {}, since);
    EXPECT_EQ(conflicts(), 0U);
    EXPECT_EQ(viewer->draft(), with("7"));
}

TEST_F(ViewersTest, LinesAreBrokenAsTheTextBreaksThem) {
    editor.document().setText("# one\r\n# two\r\n", "Edit");
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_EQ(viewer->editor().eolMode(), QsciScintilla::EolWindows);
    editor.document().setText("# one\n", "Edit");
    EXPECT_EQ(viewer->editor().eolMode(), QsciScintilla::EolUnix);
}

TEST_F(ViewersTest, FindGoesFromPlaceToPlaceAndRoundAgain) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    EXPECT_TRUE(viewer->find("ball"));
    int line = 0, column = 0, toLine = 0, toColumn = 0;
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 1);
    EXPECT_TRUE(viewer->find("ball"));
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 2);
    EXPECT_TRUE(viewer->find("ball"));
    viewer->editor().getSelection(&line, &column, &toLine, &toColumn);
    EXPECT_EQ(line, 1);
    EXPECT_FALSE(viewer->find("not there"));
}

TEST_F(ViewersTest, ColoursFollowTheStructureOfTheText) {
    const std::string text = "# body\nforeach i {1 2} { body b$i ball -mass 3 }\nset s \"body\"\n";
    LanguageViewer* viewer = editor.openLanguageViewer();
    type(*viewer, text);
    viewer->editor().SendScintilla(QsciScintillaBase::SCI_COLOURISE, 0UL, -1L);
    const auto style = [&](const std::string& what, std::size_t from = 0) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT,
                                              text.find(what, from));
    };
    EXPECT_EQ(style("# body"), 1);
    EXPECT_EQ(style("body", 8), 2); // in the loop's body: a scene command
    EXPECT_EQ(style("foreach"), 3);
    EXPECT_EQ(style("-mass"), 4);
    EXPECT_EQ(style("3"), 5);
    EXPECT_EQ(style("$i"), 6);
    EXPECT_EQ(style("body\""), 7); // in quotes: only text
}

TEST_F(ViewersTest, LiteralPlacesThatViewsShareAreHighlighted) {
    LanguageViewer* viewer = editor.openLanguageViewer();
    const auto marked = [&](const std::string& what) {
        return viewer->editor().SendScintilla(QsciScintillaBase::SCI_INDICATORVALUEAT, 10UL,
                                              static_cast<long>(ballScene.find(what))) != 0;
    };
    EXPECT_TRUE(marked("{-1 0 0}"));
    EXPECT_TRUE(marked("{1 0 0}"));
    EXPECT_FALSE(marked("-init_pos"));
    EXPECT_FALSE(marked("{-sub"));
}

// --- files and windows --------------------------------------------------------------------------

// A draft belongs to the file that it is a draft of.
TEST_F(ViewersTest, AnotherFileIsOpenedWhenItsDraftsAreSettled) {
    QTemporaryDir home;
    const QString path = home.filePath("other.al");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("# other\n");
    file.close();
    ASSERT_EQ(editor.document().save(home.filePath("scene.al")).sentence, "");
    LanguageViewer* viewer = editor.openLanguageViewer();
    SceneFiles& files = editor.beginSession();
    const auto openChoosing = [&](const QString& choice) {
        type(*viewer, ballScene + "# mine\n");
        QTimer::singleShot(0, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_NE(box, nullptr);
            QPushButton* chosen = button(*box, choice);
            ASSERT_NE(chosen, nullptr);
            chosen->click();
        });
        files.open(path);
    };
    openChoosing("Cancel");
    EXPECT_EQ(editor.document().text(), ballScene);
    EXPECT_TRUE(viewer->hasDraft());
    openChoosing("Drop the Draft");
    EXPECT_EQ(editor.document().text(), "# other\n");
    EXPECT_EQ(viewer->draft(), "# other\n");
    EXPECT_FALSE(viewer->hasDraft());
    // Whoever opens it: no draft goes into another file.
    type(*viewer, "# mine\n");
    editor.document().reset();
    EXPECT_EQ(viewer->draft(), "");
    EXPECT_FALSE(viewer->hasDraft());
}

TEST_F(ViewersTest, AClosedViewerIsForgotten) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->close();
    ASSERT_TRUE(waitFor([&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return editor.graphicalViewers().isEmpty();
    }));
    editor.document().setText(ballScene + "# on\n", "Edit");
    EXPECT_TRUE(settle(editor.document()));
}

} // namespace
} // namespace views
