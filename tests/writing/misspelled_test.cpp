// Words that are not spelled right, in a writing view.
#include "panes/spelling_commands.h"
#include "places/carets.h"
#include "view/text_hand.h"
#include "view/writing.h"
#include "window/edit_menu.h"
#include "writing/writing_testing.h"

#include <QMenu>

namespace writing {
namespace {

class MisspelledTest : public WindowTest {
protected:
    MisspelledTest() {
        const auto write = [&](const char* name, const QByteArray& bytes) {
            QFile file(folder_.filePath(name));
            EXPECT_TRUE(file.open(QIODevice::WriteOnly));
            file.write(bytes);
        };
        write("en_US.aff", "SET UTF-8\nTRY esianrtolcdugmphbyfvkwz\n");
        write("en_US.dic", "5\nthe\nmotion\nof\na\nball\n");
        qputenv("DICPATH", folder_.path().toUtf8());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
    }
    ~MisspelledTest() override {
        qunsetenv("DICPATH");
        qunsetenv("XDG_DATA_HOME");
    }
    void write(const QByteArray& body) {
        window_ = open("DOCUMENT REPORT\n<REPORT LANG=\"en-US\">\n" + body + "</REPORT>\n");
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        window_->activateWindow();
        view().setFocus();
        ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
        action("write")->trigger();
    }
    view::DocumentView& view() const { return window_->view(); }
    document::Document& document() const { return window_->document().document(); }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    std::size_t count() const {
        return window_->findChild<panes::SpellingCommands*>()->marks().count();
    }
    QMenu* menuAt(const std::string& words) const {
        const places::Carets carets(view().pages(), document().tree());
        const places::Caret caret = carets.of(document().bytes().find(words) + 1, 0).value();
        const QPointF at = view().inViewport(caret.page, carets.rectOf(caret)).center();
        window_->findChild<EditMenu*>()->showAt(view().viewport()->mapToGlobal(at.toPoint()));
        return window_->findChild<QMenu*>("textMenu");
    }

    DocumentWindow* window_ = nullptr;
};

TEST_F(MisspelledTest, AreMarkedWhereOneWritesAndMended) {
    write(paragraph("The motoin of a ball") +
          "<PARAGRAPH><CODE>{xyzzy}</CODE><TEXT>{ of the b}</TEXT><EMPH>{all}</EMPH></PARAGRAPH>");
    ASSERT_TRUE(waitFor([&] { return count() == 1; }));
    QMenu* menu = menuAt("motoin");
    ASSERT_TRUE(menu);
    ASSERT_EQ(menu->actions().first()->text(), "motion");
    menu->actions().first()->trigger();
    EXPECT_NE(document().bytes().find("The motion of"), std::string::npos);
    EXPECT_EQ(document().steps(), 1u);
    EXPECT_TRUE(waitFor([&] { return count() == 0; }));
    const auto* language = window_->findChild<QLabel*>("spellingLanguage");
    EXPECT_TRUE(language->isVisible());
    EXPECT_EQ(language->text(), "Spelling: American English");
    EXPECT_EQ(action("spelling")->text(), "&Spelling (American English)");
    action("write")->trigger();
    EXPECT_EQ(count(), 0u);
    EXPECT_FALSE(language->isVisible());
}

TEST_F(MisspelledTest, AreRightOnceTheyAreAdded) {
    write(paragraph("The motoin of Asgard"));
    ASSERT_TRUE(waitFor([&] { return count() == 2; }));
    QMenu* menu = menuAt("Asgard");
    menu->findChild<QAction*>("addWord")->trigger();
    delete menu;
    EXPECT_TRUE(waitFor([&] { return count() == 1; }));
    menuAt("motoin")->findChild<QAction*>("ignoreWord")->trigger();
    EXPECT_TRUE(waitFor([&] { return count() == 0; }));
    QFile own(folder_.filePath("ensemble/words"));
    ASSERT_TRUE(own.open(QIODevice::ReadOnly));
    EXPECT_EQ(own.readAll(), "Asgard\n");
}

TEST_F(MisspelledTest, ALetterChecksItsOwnParagraphAlone) {
    QByteArray body;
    for (int i = 0; i < 20; ++i)
        body += paragraph("The motion of a ball");
    write(body + paragraph("motoin"));
    ASSERT_TRUE(waitFor([&] { return count() == 1; }));
    const auto* speller = window_->findChild<panes::SpellingCommands*>()->marks().speller();
    const int lookedUp = speller->lookedUp();
    const std::size_t at = document().bytes().find("of a");
    view().text().cursor().set({at, at});
    QTest::keyClicks(&view(), "ballx ");
    ASSERT_TRUE(waitFor([&] { return count() == 2; }));
    EXPECT_EQ(speller->lookedUp(), lookedUp + 1);
}

TEST_F(MisspelledTest, WithoutADictionaryTheSwitchSaysWhy) {
    window_ = open("DOCUMENT REPORT\n<REPORT LANG=\"xx\">\n</REPORT>\n");
    EXPECT_FALSE(action("spelling")->isEnabled());
    EXPECT_FALSE(action("spelling")->isChecked());
    EXPECT_TRUE(action("spelling")->toolTip().contains("hunspell-xx"));
}

TEST_F(MisspelledTest, WordsOfAnotherLanguageAreNotCheckedAndTheDocumentsMayChange) {
    write("<PARAGRAPH><TEXT>{The motoin }</TEXT><TEXT LANG=\"de\">{Bewegunk}</TEXT></PARAGRAPH>");
    ASSERT_TRUE(waitFor([&] { return count() == 1; }));
    const std::size_t at = document().bytes().find("The");
    view().text().cursor().set({at, at});
    action("documentLanguage-sv")->trigger();
    EXPECT_TRUE(waitFor([&] { return !action("spelling")->isEnabled(); }));
    EXPECT_EQ(count(), 0u);
    document().undo();
    EXPECT_TRUE(waitFor([&] { return action("spelling")->isChecked() && count() == 1; }));
}

} // namespace
} // namespace writing
