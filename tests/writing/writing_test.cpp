// Writing in a document, as with the keyboard.
#include "filing/templates.h"
#include "paper/paper.h"
#include "places/carets.h"
#include "writing/writing_testing.h"

#include <QClipboard>
#include <QMimeData>
#include <QStatusBar>
#include <set>

namespace writing {
namespace {

using ::testing::HasSubstr;

TEST_F(WritingTest, TypedLettersAreInTheDocumentAndOnThePage) {
    write(paragraph("One two"));
    goTo(" two");
    type("st {");
    EXPECT_EQ(body(), paragraph("Onest \\{ two").toStdString());
    EXPECT_TRUE(waitFor([&] { return shown().find("Onest { two") != std::string::npos; }));
    press(Qt::Key_Backspace);
    press(Qt::Key_Backspace, Qt::ControlModifier);
    press(Qt::Key_Delete);
    EXPECT_EQ(body(), paragraph("two").toStdString());
}

TEST_F(WritingTest, AParagraphIsWrittenAndTakenBack) {
    write(paragraph("One"));
    const std::string before = document().bytes();
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    press(Qt::Key_Return);
    type("Two");
    press(Qt::Key_Left, Qt::ShiftModifier);
    type("e");
    EXPECT_THAT(body(), HasSubstr("{One}"));
    EXPECT_THAT(body(), HasSubstr("{Twe}"));
    EXPECT_TRUE(waitFor([&] { return shown().find("One\nTwe\n") != std::string::npos; }));
    const std::string written = document().bytes();
    while (document().canUndo())
        document().undo();
    EXPECT_EQ(document().bytes(), before);
    const auto selection = view().text().cursor().selection();
    ASSERT_TRUE(selection);
    EXPECT_EQ(before.substr(selection->caret, 3), "}</");
    while (document().canRedo())
        document().redo();
    EXPECT_EQ(document().bytes(), written);
}

TEST_F(WritingTest, WordsTypedWithoutAPauseAreOneStep) {
    write(paragraph("One"));
    goTo("One");
    type("abc");
    EXPECT_EQ(document().steps(), 1U);
    document().undo();
    EXPECT_EQ(body(), paragraph("One").toStdString());
}

TEST_F(WritingTest, AReadingViewTakesNoLetters) {
    write(paragraph("One"));
    action("write")->trigger();
    EXPECT_FALSE(view().isWriting());
    EXPECT_FALSE(action("paste")->isEnabled());
    goTo("One");
    type("abc");
    press(Qt::Key_Backspace);
    EXPECT_EQ(body(), paragraph("One").toStdString());
    EXPECT_FALSE(document().isModified());
}

TEST_F(WritingTest, WhatIsCutIsPasted) {
    write(paragraph("One two") + paragraph("Three"));
    goTo("One");
    press(Qt::Key_Right, Qt::ShiftModifier | Qt::ControlModifier);
    action("cut")->trigger();
    EXPECT_EQ(body(), (paragraph("two") + paragraph("Three")).toStdString());
    goTo("Three");
    action("paste")->trigger();
    EXPECT_EQ(body(), (paragraph("two") + paragraph("One Three")).toStdString());
}

TEST_F(WritingTest, PastedParagraphsAreParagraphsAndOneStep) {
    write(paragraph("One"));
    QApplication::clipboard()->setText("first\nline\n\nsecond");
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    action("paste")->trigger();
    EXPECT_THAT(body(), HasSubstr("second}"));
    EXPECT_TRUE(waitFor([&] { return shown().find("Onefirst line\nsecond") != std::string::npos; }))
        << body();
    EXPECT_EQ(document().steps(), 1U);
}

TEST_F(WritingTest, AnInputMethodComposesAtTheCaret) {
    write(paragraph("One"));
    goTo("One");
    QInputMethodEvent composing(QStringLiteral("ni"), {});
    QApplication::sendEvent(&view(), &composing);
    EXPECT_EQ(body(), paragraph("One").toStdString());
    QInputMethodEvent typed;
    typed.setCommitString(QStringLiteral("\u4F60"));
    QApplication::sendEvent(&view(), &typed);
    EXPECT_EQ(body(), paragraph("\u4F60One").toStdString());
    EXPECT_TRUE(asWidget().inputMethodQuery(Qt::ImEnabled).toBool());
    EXPECT_GT(asWidget().inputMethodQuery(Qt::ImCursorRectangle).toRectF().height(), 5);
}

// As when a word is converted again, and as Japanese is typed over a selection.
TEST_F(WritingTest, AnInputMethodReplacesWhatIsSelectedAndWhatIsBesideTheCaret) {
    write("<PARAGRAPH><TEXT>{Say }</TEXT><EMPH>{h\xC3\xA4"
          "el}</EMPH><TEXT>{o now}</TEXT></PARAGRAPH>\n");
    const std::string before = body();
    const auto send = [&](const QString& composed, const QString& typed, int from, int length) {
        QInputMethodEvent event(composed, {});
        event.setCommitString(typed, from, length);
        QApplication::sendEvent(&view(), &event);
    };
    const auto asked = [&](Qt::InputMethodQuery query) {
        return asWidget().inputMethodQuery(query);
    };
    goTo("o now"); // behind "häel"
    EXPECT_EQ(asked(Qt::ImSurroundingText), QString::fromUtf8("Say h\xC3\xA4"
                                                              "elo now"));
    EXPECT_EQ(asked(Qt::ImCursorPosition), 8);
    EXPECT_EQ(asked(Qt::ImTextBeforeCursor), QString::fromUtf8("Say h\xC3\xA4"
                                                               "el"));
    send({}, QStringLiteral("ello"), -3, 4);
    EXPECT_THAT(body(), HasSubstr("{Say }</TEXT><EMPH>{hello}</EMPH><TEXT>{ now}"));
    EXPECT_EQ(document().steps(), 1U);
    document().undo();
    EXPECT_EQ(body(), before);
    // The selected text goes as soon as something is composed, and comes back if nothing is typed.
    const std::size_t at = document().bytes().find("now");
    view().text().cursor().set({at, at + 3});
    EXPECT_EQ(asked(Qt::ImAnchorPosition), 10);
    EXPECT_EQ(asked(Qt::ImCursorPosition), 13);
    send(QStringLiteral("ima"), {}, 0, 0);
    EXPECT_THAT(body(), HasSubstr("{o }"));
    send({}, {}, 0, 0);
    EXPECT_EQ(body(), before);
    EXPECT_EQ(view().text().cursor().interval(), (text::Range{at, at + 3}));
    send(QStringLiteral("ima"), {}, 0, 0);
    send(QStringLiteral("im"), {}, 0, 0);
    send(QStringLiteral("n"), QString(QChar(0x4ECA)), 0, 0); // and goes on composing
    send({}, {}, 0, 0);
    EXPECT_THAT(body(), HasSubstr("{o \xE4\xBB\x8A}"));
    EXPECT_EQ(document().steps(), 1U);
    document().undo();
    EXPECT_EQ(body(), before);
}

TEST_F(WritingTest, AClipboardWithoutTextTakesNothingAway) {
    write(paragraph("One two"));
    auto* other = new QMimeData;
    other->setData("application/x-other", "x");
    QApplication::clipboard()->setMimeData(other);
    goTo("two");
    press(Qt::Key_End, Qt::ShiftModifier);
    action("paste")->trigger();
    EXPECT_EQ(body(), paragraph("One two").toStdString());
    EXPECT_EQ(window_->statusBar()->currentMessage(), "The clipboard holds no text.");
}

TEST_F(WritingTest, TabIsForTheTextAndShortcutsTypeNoLetters) {
    write("<LIST>\n<ITEM><TEXT>{One}</TEXT></ITEM>\n<ITEM><TEXT>{Two}</TEXT></ITEM>\n</LIST>\n" +
          scripted("") + paragraph("Three"));
    goTo("Two");
    press(Qt::Key_Tab);
    EXPECT_THAT(body(), HasSubstr("{One}</TEXT><LIST>"));
    EXPECT_FALSE(view().chosen());
    press(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_THAT(body(), ::testing::Not(HasSubstr("{One}</TEXT><LIST>")));
    QTest::sendKeyEvent(QTest::Click, &view(), Qt::Key_0, "0",
                        Qt::ControlModifier | Qt::AltModifier);
    EXPECT_THAT(body(), ::testing::Not(HasSubstr("0Two")));
}

TEST_F(WritingTest, AWordGetsItsFormatAndTheCaretStays) {
    write(paragraph("One two"));
    goTo("wo}");
    action("strong")->trigger();
    EXPECT_EQ(body(), "<PARAGRAPH><TEXT>{One }</TEXT><STRONG>{two}</STRONG></PARAGRAPH>\n");
    type("x");
    EXPECT_EQ(body(), "<PARAGRAPH><TEXT>{One }</TEXT><STRONG>{txwo}</STRONG></PARAGRAPH>\n");
}

TEST_F(WritingTest, ARefusedCommandIsExplainedInTheStatusBar) {
    write(paragraph("One"));
    goTo("One");
    view().writing().perform([](const authoring::Manuscript&, authoring::Selection) {
        return authoring::Refusal{"Not here, since it is a test."};
    });
    EXPECT_EQ(window_->statusBar()->currentMessage(), "Not here, since it is a test.");
    EXPECT_FALSE(document().isModified());
}

TEST_F(WritingTest, ArrowsMoveTheCaretAndTheViewFollowsIt) {
    QByteArray body;
    for (int i = 0; i < 200; ++i)
        body += paragraph("Line " + QByteArray::number(i));
    write(body);
    goTo("Line 0}");
    press(Qt::Key_End, Qt::ControlModifier);
    const auto caret = view().text().caretRect();
    ASSERT_TRUE(caret);
    EXPECT_TRUE(QRectF(view().viewport()->rect()).contains(caret->center()));
    EXPECT_EQ(document().bytes().substr(view().text().cursor().selection()->caret, 2), "}<");
    type("!");
    EXPECT_THAT(document().bytes(), HasSubstr("Line 199!}"));
    press(Qt::Key_PageUp);
    EXPECT_TRUE(QRectF(view().viewport()->rect()).contains(view().text().caretRect()->center()));
}

TEST_F(WritingTest, TheMenuFormatsTheTextAndOffersWhatIsAllowed) {
    write(paragraph("One two"));
    QAction* menu = window_->findChild<QMenu*>("format")->menuAction();
    EXPECT_TRUE(menu->isVisible());
    goTo("two");
    press(Qt::Key_End, Qt::ShiftModifier);
    action("strong")->trigger();
    EXPECT_EQ(body(), "<PARAGRAPH><TEXT>{One }</TEXT><STRONG>{two}</STRONG></PARAGRAPH>\n");
    Q_EMIT menu->menu()->aboutToShow();
    EXPECT_TRUE(action("strong")->isChecked());
    EXPECT_FALSE(action("emphasis")->isChecked());
    EXPECT_FALSE(action("outdent")->isEnabled()); // in no list
    EXPECT_FALSE(action("outdent")->toolTip().isEmpty());
    Q_EMIT menu->menu()->aboutToHide();
    EXPECT_TRUE(action("outdent")->isEnabled());
    action("outdent")->trigger();
    EXPECT_FALSE(window_->statusBar()->currentMessage().isEmpty());
    action("numbers")->trigger();
    EXPECT_THAT(body(), HasSubstr("<LIST KIND=\"number\">"));
    EXPECT_TRUE(waitFor([&] { return shown().find("1.") != std::string::npos; })) << shown();
}

TEST_F(WritingTest, ANewReportIsWrittenFromItsFirstLine) {
    write(paragraph("One"));
    action("newReport")->trigger();
    const auto windows = QApplication::topLevelWidgets();
    const auto isNew = [](const QWidget* one) {
        const auto* window = qobject_cast<const DocumentWindow*>(one);
        return window && window->document().document().className() == "REPORT";
    };
    const auto found = std::ranges::find_if(windows, isNew);
    ASSERT_NE(found, windows.end());
    window_ = qobject_cast<DocumentWindow*>(*found);
    EXPECT_TRUE(view().isWriting());
    type("Findings");
    press(Qt::Key_Down);
    type("A. Uthor");
    EXPECT_THAT(document().bytes(), HasSubstr("<TITLE>{Findings}</TITLE>"));
    EXPECT_THAT(document().bytes(), HasSubstr("<AUTHOR>{A. Uthor}</AUTHOR>"));
    window_->document().document().undo();
}

TEST_F(WritingTest, ADocumentSavedAsATemplateBeginsNewOnes) {
    const QTemporaryDir data;
    qputenv("XDG_DATA_HOME", data.path().toUtf8());
    write(paragraph("Dear colleagues"));
    answering("saveAsTemplate", [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>()->setText("To all/of us");
        dialog.accept();
    });
    const auto named = [](const QString& name) {
        const auto all = filing::templates();
        return std::ranges::find(all, name, &filing::Template::name) != all.end();
    };
    EXPECT_TRUE(named("Memo"));
    ASSERT_TRUE(named("To allof us"));
    EXPECT_EQ(document().fileName(), folder_.filePath("1.ens"));
    DocumentWindow* made = application_.openNew(filing::templates().back(), nullptr);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->document().document().bytes(), document().bytes());
    EXPECT_TRUE(made->document().document().fileName().isEmpty());
    EXPECT_TRUE(made->view().isWriting());
    qunsetenv("XDG_DATA_HOME");
}

TEST_F(WritingTest, WhatIsCopiedKeepsItsStructureWhereItIsPasted) {
    write(paragraph("One two") + "<PARAGRAPH><TEXT>{a }</TEXT><EMPH>{b}</EMPH></PARAGRAPH>\n");
    goTo("a }");
    press(Qt::Key_End, Qt::ShiftModifier);
    action("copy")->trigger();
    goTo("two");
    action("paste")->trigger();
    EXPECT_THAT(body(), HasSubstr("<EMPH>{b}</EMPH><TEXT>{two}"));
    EXPECT_EQ(document().steps(), 1U);
    document().undo();
    EXPECT_THAT(body(), HasSubstr(paragraph("One two").toStdString()));
}

TEST_F(WritingTest, TypedQuotesBecomeThoseOfTheLanguageAndUndoGivesTheTypedOnesBack) {
    write("<PARAGRAPH LANG=\"de\">{}</PARAGRAPH>\n" + paragraph("One"));
    goTo("}</PARAGRAPH>");
    type("\"Ja");
    EXPECT_THAT(body(), HasSubstr("{\u201EJa}"));
    document().undo();
    document().undo();
    EXPECT_THAT(body(), HasSubstr("{\"}"));
    type("Ja");
    EXPECT_THAT(body(), HasSubstr("{\"Ja}"));
    action("typographicSigns")->setChecked(false);
    goTo("One");
    type("\"--");
    EXPECT_THAT(body(), HasSubstr("{\"--One}"));
    action("typographicSigns")->setChecked(true);
}

TEST_F(WritingTest, TheLanguageIsChosenForWhatIsSelected) {
    write(paragraph("One two"));
    goTo("two");
    press(Qt::Key_End, Qt::ShiftModifier);
    QMenu* language = window_->findChild<QMenu*>("language");
    QMenu* ofAll = window_->findChild<QMenu*>("documentLanguage");
    Q_EMIT language->aboutToShow();
    Q_EMIT ofAll->aboutToShow();
    // A document that says none is English.
    EXPECT_TRUE(action("language-")->isChecked());
    EXPECT_EQ(action("language-")->text(), "As the Document: English");
    EXPECT_TRUE(action("documentLanguage-")->isChecked());
    EXPECT_EQ(action("documentLanguage-")->text(), "Not Said: English");
    EXPECT_TRUE(action("language-fr")->isEnabled());
    action("language-fr")->trigger();
    EXPECT_THAT(body(), HasSubstr("<TEXT LANG=\"fr\">{two}</TEXT>"));
    Q_EMIT language->aboutToShow();
    EXPECT_TRUE(action("language-fr")->isChecked());
    EXPECT_FALSE(action("language-de")->isChecked());
    action("documentLanguage-de")->trigger();
    EXPECT_THAT(document().bytes(), HasSubstr("<CMEMO LANG=\"de\">"));
    EXPECT_EQ(document().steps(), 2U);
    Q_EMIT language->aboutToShow();
    EXPECT_TRUE(action("language-fr")->isChecked());
    EXPECT_EQ(action("language-")->text(), "As the Document: Deutsch");
    action("language-")->trigger();
    EXPECT_THAT(body(), Not(HasSubstr("LANG")));
    Q_EMIT language->aboutToShow();
    Q_EMIT ofAll->aboutToShow();
    EXPECT_TRUE(action("language-")->isChecked());
    EXPECT_TRUE(action("documentLanguage-de")->isChecked());
    action("documentLanguage-")->trigger();
    EXPECT_THAT(document().bytes(), Not(HasSubstr("LANG")));
}

TEST_F(WritingTest, ANewDocumentSaysTheLanguageOfTheDesktop) {
    EXPECT_THAT(filing::templates().front().readIn("sv").bytes, HasSubstr("<CMEMO LANG=\"sv\">\n"));
    EXPECT_THAT(filing::templates().front().readIn({}).bytes, HasSubstr("<CMEMO>\n"));
}

// Undo, search and references set a caret without its page. No key looks at all pages again.
TEST_F(WritingTest, ACaretThatIsSetFarAwayIsLookedForOnce) {
    QByteArray body;
    for (int i = 0; i < 300; ++i)
        body += "<PARAGRAPH>{paragraph number " + QByteArray::number(i) + "}</PARAGRAPH>\n";
    write(body);
    ASSERT_GT(view().pages().pages.size(), 5u);
    goTo("number 299");
    view().text().showCaret();
    EXPECT_EQ(view().text().cursor().page(), view().pages().pages.size() - 1);
}

TEST_F(WritingTest, UndoGoesBackOverSavesAndRedoComesBack) {
    write(paragraph("One"));
    const std::string first = document().bytes();
    const auto onDisk = [&] {
        QFile file(document().fileName());
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    };
    const auto save = [&] {
        action("save")->trigger();
        EXPECT_TRUE(waitFor([&] { return !document().isModified(); }));
        EXPECT_EQ(onDisk(), document().bytes());
    };
    goTo("}</TEXT>");
    type(" two");
    save();
    const std::string second = document().bytes();
    press(Qt::Key_Return);
    type("Three");
    save();
    const std::string third = document().bytes();
    while (document().canUndo() && document().bytes() != second)
        action("undo")->trigger();
    EXPECT_EQ(document().bytes(), second);
    EXPECT_TRUE(document().isModified());
    EXPECT_EQ(onDisk(), third);
    while (document().canUndo())
        action("undo")->trigger();
    EXPECT_EQ(document().bytes(), first);
    save();
    while (document().canRedo())
        action("redo")->trigger();
    EXPECT_EQ(document().bytes(), third);
    EXPECT_TRUE(document().isModified());
}

TEST_F(WritingTest, TheCaretStandsStillWhereTheDesktopWantsReducedMotion) {
    const int usual = QApplication::cursorFlashTime();
    const auto looks = [&](int flashTime, int ms) {
        QApplication::setCursorFlashTime(flashTime);
        goTo("One");
        goTo("}</TEXT>");
        const QRect caret = view().text().caretRect().value().toAlignedRect().adjusted(-2, 0, 2, 0);
        std::set<QByteArray> all;
        (void)QTest::qWaitFor(
            [&] {
                const QImage image = view().viewport()->grab(caret).toImage();
                all.insert(QByteArray(reinterpret_cast<const char*>(image.constBits()),
                                      image.sizeInBytes()));
                return all.size() > 1;
            },
            ms);
        return all.size();
    };
    write(paragraph("One"));
    constexpr int blinks = 60, hang = 120'000, still = 300;
    EXPECT_EQ(looks(blinks, hang), 2u);
    EXPECT_EQ(looks(0, still), 1u);
    QApplication::setCursorFlashTime(usual);
}

TEST_F(WritingTest, PaperHasThePagesOfTheViewThatShowsTheSamePresentation) {
    QByteArray text;
    for (int i = 0; i < 150; ++i)
        text += paragraph("Line " + QByteArray::number(i));
    write(text);
    paper::Paper paper(window_->document(), view().presentation(), 72, true);
    bool isReady = false;
    QObject::connect(&paper, &paper::Paper::ready, [&] { isReady = true; });
    paper.prepare();
    ASSERT_TRUE(waitFor([&] { return isReady; }));
    const auto& seen = view().pages().pages;
    ASSERT_GT(seen.size(), 2u);
    EXPECT_EQ(paper.pages().pages, seen); // the very same ones, not others like them
}

} // namespace
} // namespace writing
