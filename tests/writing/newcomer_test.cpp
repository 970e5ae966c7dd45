// What somebody meets who writes a first document: keys while a figure is chosen, places that wait
// for text, what undo shows, where files are proposed.
#include "filing/choosing.h"
#include "filing/templates.h"
#include "paper/paper.h"
#include "places/find.h"
#include "writing/writing_testing.h"

#include <QMimeData>
#include <QSettings>
#include <QStatusBar>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class NewcomerTest : public WritingTest {
protected:
    void writeFrom(const char* name) {
        const std::vector<filing::Template> all = filing::templates();
        const auto one = std::ranges::find(all, QString(name), &filing::Template::name);
        ASSERT_NE(one, all.end());
        window_ = application_.openNew(*one, nullptr);
        window_->resize(900, 1000);
        window_->activateWindow();
        view().setFocus();
        ASSERT_TRUE(waitFor([&] { return view().hasFocus() && view().isLaidOut(); }));
    }
    static QByteArray inFigure(const QByteArray& text) {
        return "<FIGURE>" +
               scripted(text).replace("<PARAGRAPH>", "").replace("</PARAGRAPH>\n", "") +
               "<CAPTION>{Words}</CAPTION></FIGURE>\n";
    }
    void choose(std::size_t n) const {
        ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, n); }));
        view().choose(nth(*window_, n));
    }
    [[nodiscard]] bool says(const char* words) const {
        return waitFor([&] { return window_->statusBar()->currentMessage().contains(words); });
    }
    [[nodiscard]] bool isNoneChosen() const {
        return waitFor([&] { return view().chosen() == document::noSubdocument; });
    }
    [[nodiscard]] int scrolled() const { return view().verticalScrollBar()->value(); }
    static QByteArray lines(int count) {
        QByteArray all;
        for (int i = 0; i < count; ++i)
            all += paragraph("line " + QByteArray::number(i) + ".");
        return all;
    }
};

// --- pages

TEST_F(NewcomerTest, TheKeyOfAPageBreakDoesAsItsMenuAndTheCaretIsOnTheNewPage) {
    const auto broken = [&](const std::function<void()>& breakPage) {
        window_ = open("DOCUMENT REPORT\n<REPORT>\n<TITLE>{R}</TITLE>\n<BODY>\n"
                       "<PARAGRAPH>{One}</PARAGRAPH>\n"
                       "<SECTION>\n<HEADING>{Two}</HEADING>\n</SECTION>\n</BODY>\n</REPORT>\n");
        EXPECT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        writeIn(*window_);
        goTo("}</PARAGRAPH>");
        breakPage();
        type("n");
        return body();
    };
    const std::string byKey = broken([&] { press(Qt::Key_Return, Qt::ControlModifier); });
    EXPECT_EQ(byKey, broken([&] { action("pageBreak")->trigger(); }));
    EXPECT_THAT(byKey, HasSubstr("{One}</PARAGRAPH>\n<PAGEBREAK></PAGEBREAK>\n"
                                 "<PARAGRAPH>{n}</PARAGRAPH>\n<SECTION>"));
    view().settle();
    EXPECT_EQ(view().text().cursor().page(), 1u);
}

// --- what the window says

TEST_F(NewcomerTest, TheWordsOfAFigureGoWithIt) {
    write(paragraph("One") + inFigure("red"));
    choose(0);
    Q_EMIT window_->document().figureSaid(nth(*window_, 0), "Drag turns the view");
    EXPECT_TRUE(says("Drag turns"));
    press(Qt::Key_Delete);
    EXPECT_TRUE(waitFor([&] { return document().subdocuments().empty(); }));
    EXPECT_EQ(window_->statusBar()->currentMessage(), "");
}

TEST_F(NewcomerTest, ATextThatIsBrokenWhileItIsWrittenIsNoDamagedFile) {
    write(paragraph("One"));
    const std::size_t at = document().bytes().find("</BODY>");
    (void)document().edit({{{at, document().bytes().size()}, ""}}, "Break");
    const auto* banner = window_->findChild<QLabel*>("banner");
    EXPECT_TRUE(waitFor([&] { return banner->isVisible(); }));
    EXPECT_FALSE(banner->text().contains("file is damaged"));
    EXPECT_TRUE(banner->text().contains("Undo"));
    document().undo();
    EXPECT_TRUE(waitFor([&] { return !banner->isVisible(); }));
}

// --- windows

TEST_F(NewcomerTest, AFileTakesThePlaceOfAMemoInWhichNobodyHasWritten) {
    writeFrom("Memo");
    window_->move(120, 90);
    const QPoint place = window_->pos();
    QPointer<DocumentWindow> untouched = window_;
    window_ = open(memo(paragraph("One")));
    EXPECT_EQ(window_->pos(), place);
    EXPECT_TRUE(waitFor([&] { return untouched.isNull(); }));
    writeFrom("Memo");
    type("x");
    const QPointer<DocumentWindow> written = window_;
    window_ = open(memo(paragraph("Two")));
    QTest::qWait(50);
    EXPECT_TRUE(written);
    (void)written->document().document().undo();
}

TEST_F(NewcomerTest, AReportTakesThePlaceOfAnUntouchedMemoAndASecondMemoDoesNot) {
    writeFrom("Memo");
    const QPointer<DocumentWindow> first = window_;
    writeFrom("Memo");
    const QPointer<DocumentWindow> second = window_;
    EXPECT_TRUE(first);
    writeFrom("Report");
    EXPECT_TRUE(waitFor([&] { return !first && !second; }));
}

// --- between two tables

TEST_F(NewcomerTest, ACaretStandsBetweenTwoTablesAndWritesAParagraphThere) {
    const QByteArray first = "<TABLE><ROW><CELL>{a}</CELL></ROW></TABLE>\n",
                     second = "<TABLE><ROW><CELL>{b}</CELL></ROW></TABLE>\n";
    write(paragraph("One") + first + second + paragraph("Two"));
    goTo("a}");
    const QRectF above = view().text().caretRect().value();
    press(Qt::Key_Down);
    const QRectF between = view().text().caretRect().value();
    EXPECT_GT(between.top(), above.bottom());
    EXPECT_GT(between.width(), above.width()); // a line across
    press(Qt::Key_Down);
    const QRectF below = view().text().caretRect().value();
    EXPECT_GT(below.top(), between.top());
    EXPECT_EQ(body(), (paragraph("One") + first + second + paragraph("Two")).toStdString());
    press(Qt::Key_Up);
    EXPECT_EQ(view().text().caretRect().value(), between);
    press(Qt::Key_Backspace); // to the end of the first table
    press(Qt::Key_Right);
    EXPECT_EQ(view().text().caretRect().value(), between);
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, above.center().toPoint());
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, between.center().toPoint());
    type("new");
    EXPECT_THAT(body(),
                HasSubstr("{a}</CELL></ROW></TABLE>\n<PARAGRAPH>{new}</PARAGRAPH>\n<TABLE>"));
    document().undo();
    EXPECT_EQ(view().text().caretRect().value(), between);
    press(Qt::Key_Return);
    EXPECT_THAT(body(), HasSubstr("{a}</CELL></ROW></TABLE>\n<PARAGRAPH>{}</PARAGRAPH>\n<TABLE>"));
}

TEST_F(NewcomerTest, ACaretStandsBetweenATableAndAFigureAndBetweenTwoFigures) {
    const QByteArray table = "<TABLE><ROW><CELL>{a}</CELL></ROW></TABLE>\n";
    write(table + inFigure("red") + inFigure("blue"));
    goTo("a}");
    press(Qt::Key_Down);
    type("x");
    EXPECT_THAT(body(), HasSubstr("</TABLE>\n<PARAGRAPH>{x}</PARAGRAPH>\n<FIGURE>"));
    goTo("Words}");
    press(Qt::Key_Down);
    type("y");
    EXPECT_THAT(body(), HasSubstr("</FIGURE>\n<PARAGRAPH>{y}</PARAGRAPH>\n<FIGURE>"));
}

// --- behind a table that ends the document

TEST_F(NewcomerTest, ArrowsAndAClickLeadBehindWhatEndsTheDocument) {
    const QByteArray table = "<TABLE><ROW><CELL>{a}</CELL><CELL>{b}</CELL></ROW>\n"
                             "<ROW><CELL>{c}</CELL><CELL>{d}</CELL></ROW></TABLE>\n";
    const auto isLeft = [&](const QByteArray& block, const char* from,
                            const std::function<void()>& leave) {
        write(paragraph("One") + block);
        goTo(from);
        const std::string before = body();
        leave();
        type("n");
        EXPECT_EQ(body(), before + "<PARAGRAPH>{n}</PARAGRAPH>\n") << from;
    };
    isLeft(table, "c}", [&] { press(Qt::Key_Down); });
    isLeft(table, "}</CELL></ROW></TABLE>", [&] { press(Qt::Key_Right); });
    isLeft(table, "a}", [&] {
        const QRect all = view().viewport()->rect();
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {},
                          QPoint(all.center().x(), all.bottom() - 200));
    });
    isLeft("<VERBATIM>{code}</VERBATIM>\n", "code", [&] { press(Qt::Key_Down); });
}

TEST_F(NewcomerTest, ArrowsPassAFigureWithoutWords) {
    const QByteArray image = "<FIGURE><IMAGE FILE=\"none.png\"></IMAGE></FIGURE>\n";
    const QByteArray text = "<PARAGRAPH><TEXT>{One}</TEXT><FOOTNOTE>{Note}</FOOTNOTE></PARAGRAPH>\n"
                            "<VERBATIM>{code}</VERBATIM>\n";
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Right}) {
        write(text + image + image);
        const std::string before = body();
        const auto typedAfter = [&](int presses) {
            goTo("}</VERBATIM>");
            for (int i = 0; i < presses; ++i)
                press(key);
            type("n");
            const std::string typed = body();
            while (document().canUndo())
                document().undo();
            return typed;
        };
        const std::string made = "<PARAGRAPH>{n}</PARAGRAPH>\n";
        EXPECT_THAT(typedAfter(1), HasSubstr("</VERBATIM>\n" + made + "<FIGURE>"));
        EXPECT_THAT(typedAfter(2), HasSubstr("</FIGURE>\n" + made + "<FIGURE>"));
        EXPECT_EQ(typedAfter(3), before + made);
    }
}

TEST_F(NewcomerTest, ArrowsAtTheEndsOfTextChangeNothing) {
    write("<TABLE><ROW><CELL>{a}</CELL><CELL>{b}</CELL></ROW></TABLE>\n" + paragraph("One"));
    const std::string before = body();
    goTo("a}");
    press(Qt::Key_Left);
    press(Qt::Key_Up);
    goTo("One");
    press(Qt::Key_Down);
    press(Qt::Key_End);
    press(Qt::Key_Right);
    EXPECT_EQ(body(), before);
}

// --- below a formula

TEST_F(NewcomerTest, BelowAFormulaThatStandsAloneTheCaretIsWhereTextGoes) {
    write(paragraph("One") + "<PARAGRAPH>{}</PARAGRAPH>\n");
    goTo("}</PARAGRAPH>\n</BODY>");
    const double above = view().text().caretRect()->top();
    view().writing().perform([](const authoring::Manuscript& in, authoring::Selection at) {
        return authoring::insertFormula(in, at, "x", " KIND=\"display\"");
    });
    EXPECT_THAT(body(), Not(HasSubstr("{}</TEXT>\n<FORMULA")));
    view().settle();
    const double below = view().text().caretRect()->top();
    EXPECT_GT(below, above);
    type("n");
    view().settle();
    EXPECT_NEAR(view().text().caretRect()->top(), below, 1);
}

// --- keys while a figure is chosen

TEST_F(NewcomerTest, WhoTypesWhileAFigureIsChosenLearnsWhyNoLetterComes) {
    write(paragraph("One") + inFigure("colour 20A040") + paragraph("Two"));
    goTo("One");
    choose(0);
    const std::string before = document().bytes();
    type("k");
    EXPECT_TRUE(says("Escape"));
    EXPECT_EQ(document().bytes(), before);
    press(Qt::Key_Escape);
    type("k"); // behind the figure, not where the caret was before
    EXPECT_THAT(body(), HasSubstr("{kTwo}"));
}

TEST_F(NewcomerTest, ArrowsAndEnterLeaveAFigureThatHasNoUseForThem) {
    write(paragraph("One") + inFigure("colour 20A040") + paragraph("Two"));
    choose(0);
    press(Qt::Key_Up);
    ASSERT_TRUE(isNoneChosen());
    type("!");
    EXPECT_THAT(body(), HasSubstr("{One!}"));
    choose(0);
    press(Qt::Key_Down);
    ASSERT_TRUE(isNoneChosen());
    type("!");
    EXPECT_THAT(body(), HasSubstr("{!Two}"));
    choose(0);
    press(Qt::Key_Return);
    ASSERT_TRUE(isNoneChosen());
    type("New");
    EXPECT_THAT(body(),
                HasSubstr("</FIGURE>\n<PARAGRAPH>{New}</PARAGRAPH>\n<PARAGRAPH><TEXT>{!Two"));
}

TEST_F(NewcomerTest, CommandsOfWritingComeInBehindAChosenFigure) {
    write(paragraph("One") + inFigure("colour 20A040") + paragraph("Two"));
    goTo("One");
    choose(0);
    auto* insert = window_->findChild<QMenu*>("insert");
    Q_EMIT insert->aboutToShow();
    EXPECT_TRUE(action("rule")->isEnabled());
    action("rule")->trigger();
    Q_EMIT insert->aboutToHide();
    EXPECT_THAT(body(), HasSubstr("</FIGURE>\n<RULE></RULE>"));
    choose(0);
    Q_EMIT insert->aboutToShow();
    EXPECT_TRUE(action("caption")->isEnabled());
    action("caption")->trigger();
    Q_EMIT insert->aboutToHide();
    type("!");
    EXPECT_THAT(body(), HasSubstr("{Words!}"));
}

TEST_F(NewcomerTest, TheMenuFigureIsForTheOneWhoseCaptionIsWritten) {
    write(paragraph("One") + inFigure("colour 20A040"));
    auto* figure = window_->findChild<QMenu*>("figure");
    goTo("One");
    Q_EMIT figure->aboutToShow();
    EXPECT_TRUE(action("figureHint")->isVisible());
    EXPECT_FALSE(action("figureRight")->isEnabled());
    goTo("Words");
    Q_EMIT figure->aboutToShow();
    EXPECT_FALSE(action("figureHint")->isVisible());
    ASSERT_TRUE(action("figureRight")->isEnabled());
    action("figureRight")->trigger();
    EXPECT_EQ(document().subdocument(nth(*window_, 0))->placement, document::Placement::right);
    action("figureDelete")->trigger();
    EXPECT_EQ(body(), paragraph("One").toStdString());
}

// --- where the caret is, and what is seen

TEST_F(NewcomerTest, UndoOfAChangeThatIsSeenScrollsNothing) {
    write(lines(100) + inFigure("colour 20A040") + lines(100));
    goTo("line 3.");
    view().scrollTo(nth(*window_, 0));
    ASSERT_TRUE(waitFor([&] { return hasPicture(*window_, 0); }));
    view().choose(nth(*window_, 0));
    action("figureRight")->trigger();
    const int before = scrolled();
    ASSERT_GT(before, 1000);
    action("undo")->trigger();
    EXPECT_EQ(scrolled(), before);
    // One that is not seen is shown, and not the caret.
    view().choose(document::noSubdocument);
    view().verticalScrollBar()->setValue(0);
    action("redo")->trigger();
    EXPECT_GT(scrolled(), 1000);
    EXPECT_TRUE(view().placeOf(nth(*window_, 0)).intersects(QRectF(view().viewport()->rect())));
}

TEST_F(NewcomerTest, TheEndsOfADocumentShowTheEdgeOfThePage) {
    write(lines(200));
    view().setZoom(0.5);
    goTo("line 100.");
    view().text().showCaret();
    press(Qt::Key_Home, Qt::ControlModifier);
    EXPECT_EQ(scrolled(), 0);
    press(Qt::Key_End, Qt::ControlModifier);
    EXPECT_EQ(scrolled(), view().verticalScrollBar()->maximum());
    // Also where the caret is there already.
    press(Qt::Key_Home, Qt::ControlModifier);
    view().verticalScrollBar()->setValue(20);
    press(Qt::Key_Home, Qt::ControlModifier);
    EXPECT_EQ(scrolled(), 0);
}

TEST_F(NewcomerTest, TheCaretStaysWhileOneScrollsAndAKeyGoesBackToIt) {
    write(lines(200));
    goTo("line 3.");
    view().verticalScrollBar()->setValue(3000);
    type("x");
    EXPECT_THAT(body(), HasSubstr("{xline 3.}"));
    EXPECT_LT(scrolled(), 500);
    view().verticalScrollBar()->setValue(3000);
    press(Qt::Key_Right);
    EXPECT_LT(scrolled(), 500);
}

TEST_F(NewcomerTest, ACaretWhoseTextAnotherWindowTookWritesOn) {
    write(paragraph("One") + paragraph("Two") + paragraph("Three"));
    goTo("wo}");
    document().edit({{{document().bytes().find("<PARAGRAPH><TEXT>{Two"),
                       document().bytes().find("<PARAGRAPH><TEXT>{Three")},
                      ""}},
                    "Away");
    type("x");
    EXPECT_EQ(body(), (paragraph("One") + paragraph("xThree")).toStdString());
}

TEST_F(NewcomerTest, ADocumentThatIsOneFigureIsWrittenIn) {
    window_ =
        open("DOCUMENT REPORT\n<REPORT>" +
             inFigure("colour 20A040").replace("<CAPTION>{Words}</CAPTION>", "") + "</REPORT>\n");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    writeIn(*window_);
    type("Before");
    EXPECT_THAT(document().bytes(), HasSubstr("{Before}"));
}

TEST_F(NewcomerTest, AnInputMethodReplacesWhatIsSelected) {
    write(paragraph("One two"));
    goTo("two");
    press(Qt::Key_End, Qt::ShiftModifier);
    QInputMethodEvent event;
    event.setCommitString("drei");
    QApplication::sendEvent(&view(), &event);
    EXPECT_EQ(body(), paragraph("One drei").toStdString());
}

// --- places that wait for text

TEST_F(NewcomerTest, ReturnLeadsThroughATemplateWhosePlacesSayWhatTheyAre) {
    writeFrom("Report");
    const auto pixels = [&] { return view().viewport()->grab().toImage(); };
    goTo("}</TITLE>");
    const QImage hinted = pixels();
    type("Falling");
    press(Qt::Key_Return);
    type("Me");
    press(Qt::Key_Return);
    type("Question");
    press(Qt::Key_Return);
    type("Why?");
    EXPECT_THAT(document().bytes(), HasSubstr("<TITLE>{Falling}</TITLE>\n<AUTHOR>{Me}</AUTHOR>\n"
                                              "<SECTION>\n<HEADING>{Question}</HEADING>\n"
                                              "<PARAGRAPH><TEXT>{Why?}</TEXT></PARAGRAPH>"));
    while (document().canUndo())
        document().undo();
    action("write")->trigger(); // who reads sees no hints
    EXPECT_NE(pixels(), hinted);
    EXPECT_THAT(shown(), Not(HasSubstr("Title")));
}

TEST_F(NewcomerTest, TabGoesFromFieldToField) {
    writeFrom("Memo");
    goTo("}</TO>");
    type("You");
    press(Qt::Key_Tab);
    type("Me");
    press(Qt::Key_Tab);
    type("It");
    press(Qt::Key_Tab);
    type("Text");
    press(Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_THAT(document().bytes(), HasSubstr("<TO>{You}</TO>\n<FROM>{Me}</FROM>\n"
                                              "<SUBJECT>{It}</SUBJECT>\n<BODY>\n"
                                              "<PARAGRAPH><TEXT>{Text}</TEXT></PARAGRAPH>"));
}

TEST_F(NewcomerTest, PaperHasNoPlacesThatNobodyFilled) {
    writeFrom("Laboratory Report");
    goTo("}</TITLE>");
    type("Falling");
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    EXPECT_EQ(places::findText(view().pages(), "Abstract").size(), 1U);
    paper::Paper paper(window_->document(), {}, 72, true);
    bool isReady = false;
    QObject::connect(&paper, &paper::Paper::ready, [&] { isReady = true; });
    paper.prepare();
    ASSERT_TRUE(waitFor([&] { return isReady; }));
    EXPECT_TRUE(places::findText(paper.pages(), "Abstract").empty());
    EXPECT_EQ(places::findText(paper.pages(), "Falling").size(), 1U);
    EXPECT_EQ(places::findText(paper.pages(), "Question").size(), 1U);
}

// --- files

TEST_F(NewcomerTest, AFileIsProposedByTheTitleInTheFolderUsedLast) {
    EXPECT_EQ(filing::fileNameOf("  A/B: \"what?\"\n now "), "A B what now");
    EXPECT_EQ(filing::fileNameOf(".hidden"), "hidden");
    EXPECT_EQ(filing::fileNameOf("///"), "Untitled");
    EXPECT_LE(filing::fileNameOf(QString("word ").repeated(40)).size(), 80);
    filing::rememberFolderOf(folder_.filePath("other.ens"));
    writeFrom("Memo");
    goTo("}</SUBJECT>");
    type("On/falling");
    QString proposed;
    answering("saveAs", [&](QDialog& dialog) {
        proposed = qobject_cast<QFileDialog*>(&dialog)->selectedFiles().value(0);
        dialog.reject();
    });
    EXPECT_EQ(proposed, folder_.filePath("On falling.ens"));
}

} // namespace
} // namespace writing
