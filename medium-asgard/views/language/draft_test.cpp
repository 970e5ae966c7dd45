// What a language viewer makes of typing while others change the text too.
#include "views/test_language_viewer.h"

#include <QLabel>
#include <QTemporaryDir>

namespace views {
namespace {

class DraftTest : public LanguageViewerTest {
protected:
    QString notice() {
        for (QLabel* label : viewer->findChildren<QLabel*>())
            if (label->accessibleName() == "Notice")
                return label->text();
        return {};
    }
    void replace(const std::string& what, const std::string& with) {
        const std::size_t at = place(what);
        ASSERT_NE(at, std::string::npos);
        text().replace({at, at + what.size()}, with);
    }
    void elsewhere(const std::string& what, const std::string& with) {
        std::string all = scene();
        all.replace(all.find(what), what.size(), with);
        editor.document().setText(all, "Move b1");
    }
};

TEST_F(DraftTest, TakesWhatOthersChangeElsewhereAndStaysADraft) {
    open(ballScene);
    replace("-init_dpos {1 0 0}", "-init_dpos {1 0 0} -mass 3");
    EXPECT_TRUE(viewer->hasDraft());
    elsewhere("{-1 0 0}", "{-4.37 0 2}");
    EXPECT_TRUE(viewer->hasDraft());
    EXPECT_NE(viewer->draft().find("-init_pos {-4.37 0 2} -init_dpos {1 0 0} -mass 3"),
              std::string::npos);
    EXPECT_EQ(scene().find("-mass"), std::string::npos); // on Update only
    EXPECT_EQ(notice(), "");
    const std::string mine = viewer->draft();
    viewer->updateDocument();
    EXPECT_EQ(scene(), mine);
}

TEST_F(DraftTest, AfterUpdateTheKeyboardIsTheTexts) {
    open(ballScene);
    replace("{-1 0 0}", "{-2 0 0}");
    auto* update = viewer->findChild<QPushButton*>("update");
    update->setFocus();
    ASSERT_EQ(viewer->focusWidget(), update);
    update->click();
    EXPECT_FALSE(update->isEnabled());
    EXPECT_EQ(viewer->focusWidget(), &text());
}

TEST_F(DraftTest, ShowsWhatBothChangedAndSettlesItEitherWay) {
    open(ballScene);
    replace("{-1 0 0}", "{-2 0 0}");
    elsewhere("{-1 0 0}", "{-3 0 0}");
    EXPECT_NE(viewer->draft().find("{-2 0 0}"), std::string::npos);
    EXPECT_TRUE(text().isMarked(Mark::conflict, place("2 0 0")));
    EXPECT_TRUE(notice().contains("“2”"));
    EXPECT_TRUE(notice().contains("“3”"));
    button("Take the Scene's")->click();
    EXPECT_EQ(viewer->draft(), scene());
    EXPECT_FALSE(viewer->hasDraft());
    EXPECT_EQ(notice(), "");

    replace("{-3 0 0}", "{-5 0 0}");
    elsewhere("{-3 0 0}", "{-6 0 0}");
    button("Keep Mine")->click();
    EXPECT_EQ(notice(), "");
    EXPECT_NE(viewer->draft().find("{-5 0 0}"), std::string::npos);
    viewer->updateDocument();
    EXPECT_NE(scene().find("{-5 0 0}"), std::string::npos);
}

TEST_F(DraftTest, SeveralConflictsAreGoneThroughOneByOne) {
    open(ballScene);
    replace("-finish 2", "-finish 3");
    replace("{-1 0 0}", "{-2 0 0}");
    std::string all = scene();
    all.replace(all.find("-finish 2"), 9, "-finish 4");
    all.replace(all.find("{-1 0 0}"), 8, "{-9 0 0}");
    editor.document().setText(all, "Edit");
    EXPECT_EQ(text().marks(Mark::conflict).size(), 2U);
    EXPECT_TRUE(notice().startsWith("2 places"));
    act("Next");
    EXPECT_EQ(text().selection().from, place("3\n"));
    act("Take the Scene's");
    EXPECT_EQ(text().marks(Mark::conflict).size(), 1U);
    act("Keep Mine");
    EXPECT_NE(viewer->draft().find("-finish 4"), std::string::npos);
    EXPECT_NE(viewer->draft().find("{-2 0 0}"), std::string::npos);
}

TEST_F(DraftTest, TypingBackToTheSceneIsNoDraft) {
    open(ballScene);
    replace("-finish 2", "-finish 25");
    EXPECT_TRUE(viewer->hasDraft());
    EXPECT_TRUE(viewer->isWindowModified());
    replace("-finish 25", "-finish 2");
    EXPECT_FALSE(viewer->hasDraft());
}

TEST_F(DraftTest, RevertGoesBackToTheFileAndSaysSoInTheTitle) {
    QTemporaryDir folder;
    const QString file = folder.filePath("swing.al");
    open(ballScene);
    ASSERT_EQ(editor.document().save(file).sentence, "");
    EXPECT_EQ(viewer->windowTitle(), "swing.al[*] – Language Viewer");
    LanguageViewer* two = editor.openLanguageViewer();
    EXPECT_EQ(two->windowTitle(), "swing.al[*] – Language Viewer 2");
    EXPECT_FALSE(viewer->isWindowModified());
    elsewhere("{-1 0 0}", "{-3 0 0}");
    replace("-finish 2", "-finish 3");
    viewer->revert();
    EXPECT_EQ(viewer->draft(), ballScene);
    EXPECT_EQ(scene(), ballScene);
    EXPECT_FALSE(viewer->isWindowModified());
}

TEST_F(DraftTest, UpdateWaitsUntilWhatBothChangedIsChosen) {
    open(ballScene);
    replace("{-1 0 0}", "{-2 0 0}");
    elsewhere("{-1 0 0}", "{-3 0 0}");
    const std::string before = scene();
    EXPECT_FALSE(button("Update")->isEnabled());
    EXPECT_FALSE(viewer->updateDocument());
    act("Update");
    EXPECT_EQ(scene(), before);
    EXPECT_TRUE(notice().startsWith("Not updated: choose first."));
    EXPECT_EQ(text().selection().from, place("2 0 0"));
    button("Keep Mine")->click();
    EXPECT_TRUE(button("Update")->isEnabled());
    EXPECT_TRUE(viewer->updateDocument());
    EXPECT_NE(scene().find("{-2 0 0}"), std::string::npos);
}

// The bar takes room from the text, at its foot.
TEST_F(DraftTest, TheLineThatOneWritesIsSeenWhenTheBarAppears) {
    std::string all = ballScene;
    for (int i = 0; i < 80; ++i)
        all += "# line " + std::to_string(i) + "\n";
    open(all);
    const auto first =
        static_cast<int>(text().SendScintilla(QsciScintillaBase::SCI_GETFIRSTVISIBLELINE));
    const auto shown = static_cast<int>(text().SendScintilla(QsciScintillaBase::SCI_LINESONSCREEN));
    const std::string last = "# line " + std::to_string(first + shown - 4) + "\n";
    ASSERT_GT(text().rectOf(place(last)).bottom(), text().viewport()->height() * 3 / 4);
    caretAt(place(last));
    replace(last, "# mine\n");
    elsewhere(last, "# theirs\n");
    ASSERT_FALSE(notice().isEmpty());
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    EXPECT_TRUE(text().viewport()->rect().contains(text().rectOf(place("# mine"))));
}

// --- numbers that are dragged while others change the text -----------------------------------

TEST_F(DraftTest, ANumberOfADraftIsLetGoWhenOthersChangeTheText) {
    open(ballScene);
    replace("-finish 2", "-finish 2 ;# mine");
    caretAt(place("{1 0 0}") + 1);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    elsewhere("simulator", "# much before it\nsimulator");
    EXPECT_FALSE(viewer->numbers().active());
    const std::string merged = "# much before it\n" + ballScene;
    std::string mine = merged;
    mine.replace(mine.find("-finish 2"), 9, "-finish 2 ;# mine");
    mine.replace(mine.find("{1 0 0}"), 7, "{1.1 0 0}");
    EXPECT_EQ(viewer->draft(), mine);
    QTest::keyRelease(&text(), Qt::Key_Alt);
    EXPECT_EQ(viewer->draft(), mine);
    EXPECT_EQ(scene(), merged);
}

TEST_F(DraftTest, ANumberOfTheSceneIsLetGoWhenOthersChangeTheText) {
    open(ballScene);
    caretAt(place("{1 0 0}") + 1);
    QTest::keyPress(&text(), Qt::Key_Up, Qt::AltModifier);
    ASSERT_NE(scene().find("{1.1 0 0}"), std::string::npos);
    elsewhere("simulator", "# before\nsimulator");
    EXPECT_FALSE(viewer->numbers().active());
    std::string both = "# before\n" + ballScene;
    both.replace(both.find("{1 0 0}"), 7, "{1.1 0 0}");
    EXPECT_EQ(scene(), both);
    QTest::keyRelease(&text(), Qt::Key_Alt);
    EXPECT_EQ(scene(), both);
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(scene(), ballScene);
}

} // namespace
} // namespace views
