// Figures of media in a document that is written: how they come in, change, are copied and go.
#include "clipboard/copying.h"
#include "view/resizing.h"
#include "writing/writing_testing.h"

#include <QAccessible>
#include <QCheckBox>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStatusBar>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class FiguresTest : public WritingTest {
protected:
    [[nodiscard]] QMenu* menu(const char* name) const { return window_->findChild<QMenu*>(name); }
    [[nodiscard]] QAction* entry(const char* of, const char* name) const {
        return menu(of)->findChild<QAction*>(name);
    }
    // Opens a menu and closes it: its entries say what is allowed while it is open.
    [[nodiscard]] std::string whyNot(const char* of, const char* name) const {
        Q_EMIT menu(of)->aboutToShow();
        const QAction* action = entry(of, name);
        const std::string why = action->isEnabled() ? "" : action->toolTip().toStdString();
        Q_EMIT menu(of)->aboutToHide();
        return why;
    }
    // Of the scripted medium: other media may be installed beside it.
    void insert(const char* what, const std::function<void(QDialog&)>& act) const {
        entry("insertSCRIPTED", what)->setObjectName("wanted");
        answering("wanted", act);
        entry("insertSCRIPTED", "wanted")->setObjectName(what);
    }
    static void answerFile(QDialog& dialog, const QString& file) {
        auto* files = qobject_cast<QFileDialog*>(&dialog);
        ASSERT_TRUE(files);
        files->setDirectory(QFileInfo(file).path());
        files->selectFile(file);
        for (auto* view : files->findChildren<QAbstractItemView*>())
            view->clearSelection(); // as typing does
        files->findChild<QLineEdit*>()->setText(QFileInfo(file).fileName());
        dialog.accept();
    }
    [[nodiscard]] const document::Subdocument& figure(std::size_t n) const {
        return *document().subdocument(nth(*window_, n));
    }
    [[nodiscard]] std::string text(std::size_t n) const {
        return document().text(nth(*window_, n));
    }
    [[nodiscard]] std::size_t count() const { return document().subdocuments().size(); }
    void choose(std::size_t n) const {
        ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, n); }));
        view().choose(nth(*window_, n));
    }
    static QByteArray inFigure(const QByteArray& text, const QByteArray& attributes = {}) {
        return "<FIGURE>" +
               scripted(text, attributes).replace("<PARAGRAPH>", "").replace("</PARAGRAPH>\n", "") +
               "<CAPTION>{Words}</CAPTION></FIGURE>\n";
    }
};

TEST_F(FiguresTest, AnEmptyOneIsAFigureThatOpensItsEditorAndOneWritesInItsCaption) {
    write(paragraph("One"));
    const std::string before = document().bytes();
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    entry("insertSCRIPTED", "insertEmpty")->trigger();
    EXPECT_EQ(body(), paragraph("One").toStdString() +
                          "<FIGURE>\n<DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED WIDTH=\"300\" "
                          "HEIGHT=\"200\">\n<SCRIPT>{colour 3060A0}</SCRIPT>\n</SCRIPTED>\n"
                          "</DOCUMENT>\n<CAPTION>{}</CAPTION>\n</FIGURE>\n");
    EXPECT_EQ(document().steps(), 1U);
    EXPECT_EQ(view().chosen(), document::noSubdocument);
    const QStatusBar& line = *window_->statusBar();
    EXPECT_THAT(line.currentMessage().toStdString(), HasSubstr("Opening the editor of Scripted"));
    ASSERT_TRUE(waitFor([&] { return live(*window_, 0).windows().open == 1; }));
    EXPECT_TRUE(waitFor([&] { return line.currentMessage().isEmpty(); }));
    EXPECT_EQ(children().size(), 1U); // that has had no other one before it
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    type("Words");
    EXPECT_THAT(body(), HasSubstr("<CAPTION>{Words}</CAPTION>"));
    document().undo();
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_EQ(view().chosen(), document::noSubdocument);
}

// It may come from a file, or of a text that somebody has erased.
TEST_F(FiguresTest, OneWithoutATextSaysSoAndFigureEditOpensItsEditor) {
    write(inFigure("  \n") + inFigure("colour 20A040"));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0) && hasPicture(*window_, 1); }));
    EXPECT_EQ(window_->document().emptyNotice(nth(*window_, 0)), "Coloured Box: still empty");
    EXPECT_EQ(window_->document().emptyNotice(nth(*window_, 1)), "");
    choose(0);
    EXPECT_EQ(whyNot("figure", "figureEdit"), "");
    entry("figure", "figureEdit")->trigger();
    EXPECT_TRUE(waitFor([&] { return live(*window_, 0).windows().open == 1; }));
    action("write")->trigger(); // who reads is told why not
    EXPECT_THAT(whyNot("figure", "figureEdit"), HasSubstr("Edit > Write"));
}

TEST_F(FiguresTest, ASampleIsChosenByItsPicture) {
    write(paragraph("One"));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    const auto look = [](QDialog& dialog) {
        auto* list = dialog.findChild<QListWidget*>("samples");
        ASSERT_EQ(list->count(), 2);
        EXPECT_EQ(list->item(1)->text(), "Green");
        EXPECT_EQ(list->item(0)->data(Qt::AccessibleTextRole).toString(), "Red: A red box");
        const auto picture = [list](int i) {
            return list->item(i)->data(Qt::DecorationRole).value<QPixmap>().toImage();
        };
        EXPECT_TRUE(waitFor([&] { return !picture(0).isNull() && !picture(1).isNull(); }));
        EXPECT_EQ(picture(0).pixelColor(2, 2), QColor(255, 0, 0));
        EXPECT_EQ(picture(1).pixelColor(2, 2), QColor(0, 255, 0));
        // Its bar stands where it is at 2 of 4 s.
        EXPECT_EQ(picture(1).pixelColor(picture(1).width() / 2, 2), QColor(255, 255, 255));
        list->setCurrentRow(1);
    };
    insert("insertSample", [&](QDialog& dialog) {
        look(dialog);
        dialog.reject();
    });
    EXPECT_EQ(count(), 0U);
    insert("insertSample", [&](QDialog& dialog) {
        look(dialog); // the pictures are there at once
        dialog.accept();
    });
    ASSERT_EQ(count(), 1U);
    EXPECT_EQ(text(0), "duration 4\ncolour 00FF00");
    EXPECT_EQ(figure(0).poster, 2);
    EXPECT_EQ(figure(0).alternative, "A green box with a bar");
    type("Green box");
    EXPECT_THAT(body(), HasSubstr("<CAPTION>{Green box}</CAPTION>"));
    ASSERT_TRUE(waitFor([&] { return live(*window_, 0).time() && hasPicture(*window_, 0); }));
    EXPECT_EQ(live(*window_, 0).windows().open, 0);
    EXPECT_TRUE(waitFor([&] { return live(*window_, 0).time()->time == 2; }));
}

TEST_F(FiguresTest, AFileOfTheMediumComesInAndOneThatIsNoTextDoesNot) {
    write(paragraph("One"));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    const QString good = folder_.filePath("a {b.scripted"), bad = folder_.filePath("b.scripted");
    QFile file(good), wrong(bad);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && wrong.open(QIODevice::WriteOnly));
    file.write("colour 102030\n");
    wrong.write("colour \xFF\xFE");
    file.close();
    wrong.close();
    insert("insertFile", [&](QDialog& dialog) { answerFile(dialog, good); });
    ASSERT_EQ(count(), 1U);
    EXPECT_EQ(text(0), "colour 102030\n");
    type("Box");
    EXPECT_THAT(body(), HasSubstr("<CAPTION>{Box}</CAPTION>"));
    QTimer closing;
    QString said;
    QObject::connect(&closing, &QTimer::timeout, [&said] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            said = box->text();
            box->accept();
        }
    });
    insert("insertFile", [&](QDialog& dialog) {
        answerFile(dialog, bad);
        closing.start(5);
    });
    EXPECT_EQ(said, "b.scripted is no text in UTF-8.");
    EXPECT_EQ(count(), 1U);
}

TEST_F(FiguresTest, WhatMayNotBeIsNotOfferedAndSaysWhy) {
    write(paragraph("One") + inFigure("colour 20A040"));
    goTo("Test}");
    EXPECT_THAT(whyNot("insertSCRIPTED", "insertEmpty"), HasSubstr("A figure may not stand here."));
    goTo("One");
    EXPECT_EQ(whyNot("insertSCRIPTED", "insertEmpty"), "");
    EXPECT_THAT(whyNot("figure", "figureSize"), HasSubstr("Click a figure first."));
    choose(0);
    EXPECT_EQ(whyNot("figure", "figureSize"), "");
    EXPECT_THAT(whyNot("figure", "figurePoster"), HasSubstr("does not move"));
    action("write")->trigger();
    EXPECT_THAT(whyNot("figure", "figureSize"), HasSubstr("This window is for reading."));
    EXPECT_EQ(whyNot("figure", "figureSave"), "");
    const std::string before = document().bytes();
    entry("figure", "figureLeft")->setEnabled(true);
    entry("figure", "figureLeft")->trigger();
    EXPECT_EQ(document().bytes(), before);
}

TEST_F(FiguresTest, ItsAttributesAreCommandsOfOneStepEach) {
    write(paragraph("One") + inFigure("duration 4\ncolour 20A040"));
    const std::string before = document().bytes();
    choose(0);
    ASSERT_TRUE(waitFor([&] { return live(*window_, 0).time().has_value(); }));
    entry("figure", "figureRight")->trigger();
    EXPECT_EQ(figure(0).placement, document::Placement::right);
    live(*window_, 0).seek(1.25);
    ASSERT_TRUE(waitFor([&] { return live(*window_, 0).time()->time == 1.25; }));
    entry("figure", "figurePoster")->trigger();
    EXPECT_EQ(figure(0).poster, 1.25);
    answering("figureAlternative", [](QDialog& dialog) {
        dialog.findChild<QPlainTextEdit*>("alternative")->setPlainText("A \"box\"\nthat moves");
        dialog.accept();
    });
    EXPECT_EQ(figure(0).alternative, "A 'box' that moves");
    window_->activateWindow();
    view().setFocus();
    ASSERT_TRUE(waitFor([&] { return view().hasFocus(); }));
    const QAccessibleInterface* pages = QAccessible::queryAccessibleInterface(&view());
    ASSERT_TRUE(pages && pages->focusChild());
    EXPECT_EQ(pages->focusChild()->text(QAccessible::Name), "A 'box' that moves");
    EXPECT_EQ(document().steps(), 3U);
    answering("figureAlternative", [](QDialog& dialog) {
        dialog.findChild<QPlainTextEdit*>("alternative")->clear();
        dialog.accept();
    });
    EXPECT_THAT(body(), Not(HasSubstr("ALT")));
    while (document().canUndo())
        document().undo();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_EQ(view().chosen(), nth(*window_, 0)); // as long as it is there
}

TEST_F(FiguresTest, ItIsShownAsAnyPresentationOfItsMedium) {
    write(paragraph("One") + inFigure("colour 20A040"));
    choose(0);
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    auto* shownAs = window_->findChild<QMenu*>("figurePresentations");
    const auto take = [&](const char* name) {
        Q_EMIT window_->findChild<QMenu*>("figure")->aboutToShow();
        auto* action = shownAs->findChild<QAction*>(QStringLiteral("figureAs-") + name);
        ASSERT_TRUE(action) << name;
        action->trigger();
    };
    take("source");
    EXPECT_THAT(body(), HasSubstr("PRESENTATION=\"source\""));
    EXPECT_TRUE(waitFor([&] { return colourShown(*window_, 0) == QColor(0xDF, 0x5F, 0xBF); }));
    document().undo();
    EXPECT_TRUE(waitFor([&] { return colourShown(*window_, 0) == QColor(0x20, 0xA0, 0x40); }));
    document().redo();
    take("picture"); // the usual one needs no word
    EXPECT_THAT(body(), Not(HasSubstr("PRESENTATION")));
    EXPECT_EQ(document().steps(), 2U);
}

TEST_F(FiguresTest, APresentationThatItsMediumDoesNotHaveIsAFault) {
    write(paragraph("One") + inFigure("colour 20A040", "PRESENTATION=\"chart\""));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    const auto said = [&] {
        std::string all;
        for (const session::ListedFault& fault : window_->document().faults())
            all += fault.message.toStdString() + "\n";
        return all;
    };
    EXPECT_THAT(said(), HasSubstr("has no presentation \"chart\"; it has: picture, source"));
}

TEST_F(FiguresTest, AnotherSizeIsDrawnByTheSameProcess) {
    write(paragraph("One") + inFigure("colour 20A040"));
    choose(0);
    const std::vector<pid_t> processes = children();
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    answering("figureSize", [](QDialog& dialog) {
        auto* width = dialog.findChild<QDoubleSpinBox*>("width");
        auto* height = dialog.findChild<QDoubleSpinBox*>("height");
        const double ratio = width->value() / height->value();
        width->setValue(width->value() / 2);
        EXPECT_NEAR(width->value() / height->value(), ratio, 0.02);
        dialog.findChild<QCheckBox*>("keepRatio")->setChecked(false);
        height->setValue(height->value() * 2);
        dialog.accept();
    });
    EXPECT_NEAR(*figure(0).width, 150, 1);
    EXPECT_NEAR(*figure(0).height, 200, 2);
    EXPECT_EQ(document().steps(), 1U);
    const QSize wanted = QSize(150, 200) * window_->devicePixelRatio();
    EXPECT_TRUE(waitFor([&] { return picture(*window_, 0).size() == wanted; }));
    EXPECT_EQ(children(), processes);
    answering("figureSize",
              [](QDialog& dialog) { dialog.findChild<QPushButton*>("usualSize")->click(); });
    EXPECT_FALSE(figure(0).width);
    EXPECT_FALSE(figure(0).height);
}

TEST_F(FiguresTest, AnEdgeChangesItsSideAloneAndACornerBoth) {
    write(paragraph("One") + inFigure("colour 20A040"));
    choose(0);
    const auto drag = [&](QPointF from, QPoint by) {
        QWidget* pages = view().viewport();
        QTest::mousePress(pages, Qt::LeftButton, {}, from.toPoint());
        QTest::mouseMove(pages, from.toPoint() + by / 2);
        QTest::mouseMove(pages, from.toPoint() + by);
        QTest::mouseRelease(pages, Qt::LeftButton, {}, from.toPoint() + by);
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    };
    const auto place = [&] { return view::sizedUnit(view())->place; };
    const auto expectSize = [&](double width, double height) {
        EXPECT_NEAR(figure(0).width.value_or(0), width, 2);
        EXPECT_NEAR(figure(0).height.value_or(0), height, 2);
    };
    drag({place().right(), place().center().y()}, {20, 40});
    expectSize(340, 200); // it stands in the middle, and grows to both sides
    drag({place().center().x(), place().bottom()}, {40, 30});
    expectSize(340, 230);
    drag({place().left(), place().center().y()}, {20, 0});
    expectSize(300, 230);
    drag(place().bottomRight(), {15, 0});
    expectSize(330, 253);
    EXPECT_EQ(document().steps(), 4U);
}

TEST_F(FiguresTest, TheCaptionGetsTheCaret) {
    write("<FIGURE>" +
          scripted("colour 20A040").replace("<PARAGRAPH>", "").replace("</PARAGRAPH>\n", "") +
          "</FIGURE>\n" + paragraph("One"));
    choose(0);
    entry("figure", "figureCaption")->trigger();
    EXPECT_EQ(view().chosen(), document::noSubdocument);
    type("Words");
    EXPECT_THAT(body(), HasSubstr("<CAPTION>{Words}</CAPTION></FIGURE>"));
}

TEST_F(FiguresTest, AChosenOneIsCopiedWithItsCaptionAlsoAfterItsDocumentIsClosed) {
    write(paragraph("One") + inFigure("colour 20A040", "ID=\"box\""));
    choose(0);
    ASSERT_TRUE(action("copy")->isEnabled());
    action("copy")->trigger();
    EXPECT_FALSE(QApplication::clipboard()->image().isNull()); // for other programs
    // In the same document, where it is chosen: behind it, with another ID or none.
    action("paste")->trigger();
    ASSERT_EQ(count(), 2U);
    EXPECT_EQ(text(1), "colour 20A040");
    EXPECT_EQ(figure(1).name, "");
    EXPECT_EQ(document().steps(), 1U);
    // In another one, when the first is closed.
    QPointer<DocumentWindow> first = window_;
    document().undo();
    first->close();
    ASSERT_TRUE(waitFor([&] { return !first; }));
    write(paragraph("Two"));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    action("paste")->trigger();
    ASSERT_EQ(count(), 1U);
    EXPECT_EQ(text(0), "colour 20A040");
    EXPECT_EQ(figure(0).name, "box");
    EXPECT_THAT(body(), HasSubstr("<CAPTION>{Words}</CAPTION>\n</FIGURE>"));
    EXPECT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
}

TEST_F(FiguresTest, OneThatIsCutAndPastedIsMovedAndKeepsItsId) {
    write(paragraph("One") + inFigure("colour 20A040", "ID=\"box\"") + paragraph("Two"));
    const std::string before = document().bytes();
    choose(0);
    action("cut")->trigger();
    EXPECT_EQ(body(), (paragraph("One") + paragraph("Two")).toStdString());
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    action("paste")->trigger();
    ASSERT_EQ(count(), 1U);
    EXPECT_LT(body().find("{Two}"), body().find("<FIGURE>"));
    EXPECT_EQ(figure(0).name, "box");
    EXPECT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    document().undo();
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    EXPECT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
}

TEST_F(FiguresTest, DeleteTakesAChosenOneAwayWhereOneWrites) {
    write(paragraph("One") + inFigure("colour 20A040"));
    choose(0);
    action("write")->trigger(); // the reading view
    const std::string before = document().bytes();
    press(Qt::Key_Delete);
    action("write")->trigger();
    choose(0);
    EXPECT_EQ(document().bytes(), before);
    press(Qt::Key_Delete); // the medium has no use for it
    EXPECT_TRUE(waitFor([&] { return count() == 0; }));
    EXPECT_EQ(body(), paragraph("One").toStdString());
    document().undo();
    EXPECT_EQ(document().bytes(), before);
    // Also where its medium does not live.
    choose(0);
    live(*window_, 0).makeStill();
    press(Qt::Key_Backspace);
    EXPECT_EQ(count(), 0U);
}

TEST_F(FiguresTest, SelectedTextIsCopiedWithItsFigures) {
    write(paragraph("One two") + inFigure("colour 20A040") + paragraph("Three four"));
    const std::size_t from = document().bytes().find("two"), to = document().bytes().find(" four");
    view().text().cursor().set({from, to});
    action("copy")->trigger();
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    action("paste")->trigger();
    ASSERT_EQ(count(), 2U);
    EXPECT_EQ(text(1), "colour 20A040");
    // An end beside a figure is no place in a text.
    const std::size_t beside = document().tree().node(figure(0).element).range.from;
    view().text().cursor().set({from, beside});
    view().text().cursor().set(
        {document().tree().node(document().tree().node(figure(0).element).parent).range.from,
         document().bytes().find("Three")});
    action("copy")->trigger();
    EXPECT_THAT(QApplication::clipboard()->mimeData()->data(view::fragmentFormat).toStdString(),
                HasSubstr("<SCRIPT>{colour 20A040}</SCRIPT>"));
}

TEST_F(FiguresTest, ItsTextGoesToAFileAndComesFromOne) {
    write(paragraph("One") + inFigure("colour 20A040 \\{"));
    choose(0);
    const QString saved = folder_.filePath("copy");
    answering("figureSave", [&](QDialog& dialog) { answerFile(dialog, saved); });
    QFile file(saved + ".scripted");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), "colour 20A040 {");
    file.close();
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("colour 102030\nmenu }");
    file.close();
    const std::vector<pid_t> processes = children();
    answering("figureReplace", [&](QDialog& dialog) { answerFile(dialog, saved + ".scripted"); });
    EXPECT_EQ(text(0), "colour 102030\nmenu }");
    EXPECT_EQ(document().steps(), 1U);
    EXPECT_TRUE(waitFor([&] { return colourShown(*window_, 0) == QColor(0x10, 0x20, 0x30); }));
    EXPECT_EQ(children(), processes);
    document().undo();
    EXPECT_EQ(text(0), "colour 20A040 {");
}

} // namespace
} // namespace writing
