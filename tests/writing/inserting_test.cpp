// What comes in at the caret: links, references, formulas, pasted and dropped text.
#include "clipboard/pasted_html.h"
#include "menus/formula_dialog.h"
#include "menus/formula_preview.h"
#include "menus/insert_menu.h"
#include "menus/reference_dialog.h"
#include "places/carets.h"
#include "writing/writing_testing.h"

#include <QListWidget>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(WritingTest, ALinkIsMadeChangedAndTakenAway) {
    write(paragraph("One two three"));
    goTo("wo three");
    answering("link", [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("address")->setText("www.example.org");
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<LINK TO=\"https://www.example.org\">{two}</LINK>"));
    goTo("wo}");
    answering("link", [](QDialog& dialog) {
        auto* field = dialog.findChild<QLineEdit*>("address");
        EXPECT_EQ(field->text(), "https://www.example.org");
        field->setText("#figure-1");
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<LINK TO=\"#figure-1\">{two}</LINK>"));
    goTo("wo}");
    answering("link",
              [](QDialog& dialog) { dialog.findChild<QPushButton*>("removeLink")->click(); });
    EXPECT_THAT(body(), Not(HasSubstr("LINK")));
    while (document().canUndo())
        document().undo();
    EXPECT_EQ(body(), paragraph("One two three").toStdString());
}

TEST_F(WritingTest, BetweenWordsAnAddressIsTheTextOfItsLink) {
    write(paragraph("See "));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    answering("link", [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("address")->setText("https://example.org/");
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<LINK TO=\"https://example.org/\">{https://example.org/}"));
}

TEST_F(WritingTest, AReferenceIsChosenByTheWordsOfWhatItLeadsTo) {
    write(paragraph("See ") + "<TABLE><ROW><CELL>{a}</CELL></ROW><CAPTION>{Some masses}</CAPTION>"
                              "</TABLE>\n<TABLE><ROW><CELL>{b}</CELL></ROW><CAPTION>{Some "
                              "lengths}</CAPTION></TABLE>\n");
    goTo("}</TEXT></PARAGRAPH>");
    answering("reference", [](QDialog& dialog) {
        const auto* list = dialog.findChild<QListWidget*>("targets");
        EXPECT_EQ(list->count(), 2);
        EXPECT_EQ(list->item(0)->text(), "Table 1: Some masses");
        dialog.findChild<QLineEdit*>("words")->setText("LENGTH");
        EXPECT_EQ(list->count(), 1);
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<REF TO=\"table-1\"></REF>"));
    EXPECT_THAT(body(), HasSubstr("<TABLE ID=\"table-1\"><ROW><CELL>{b}"));
    EXPECT_TRUE(waitFor([&] { return shown().find("See Table\u00A02") != std::string::npos; }));
}

// Nobody wants to read "equation Equation 1".
TEST_F(WritingTest, AReferenceBehindTheWordForItsTargetShowsTheNumberAlone) {
    const QByteArray formula = "<FORMULA KIND=\"numbered\">{a = b}</FORMULA>\n",
                     table =
                         "<TABLE><ROW><CELL>{a}</CELL></ROW><CAPTION>{Masses}</CAPTION></TABLE>\n";
    const auto referred = [&](const QByteArray& words, int target) {
        write(paragraph(words) + formula + table);
        goTo("}</TEXT></PARAGRAPH>");
        answering("reference", [&](QDialog& dialog) {
            dialog.findChild<QListWidget*>("targets")->setCurrentRow(target);
            dialog.accept();
        });
        EXPECT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        view().settle();
        return shown();
    };
    EXPECT_THAT(referred("From equation ", 0), HasSubstr("From equation (1)"));
    EXPECT_THAT(referred("From eq. ", 0), HasSubstr("From eq. (1)"));
    EXPECT_THAT(referred("From ", 0), HasSubstr("From Equation\u00A01"));
    EXPECT_THAT(referred("In Tables ", 1), HasSubstr("In Tables 1"));
    EXPECT_THAT(referred("Here is a table. ", 1), HasSubstr("Here is a table. Table\u00A01"));
    EXPECT_THAT(referred("In figure ", 1), HasSubstr("In figure Table\u00A01"));
    EXPECT_THAT(body(), HasSubstr("<REF TO=\"table-1\"></REF>"));
    // Whatever fits, the author chooses, also of one that is there.
    const std::size_t at = document().bytes().find("<REF");
    view().text().cursor().set({at, document().bytes().find("</REF>") + 6});
    answering("reference", [](QDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QRadioButton*>("byKind")->isChecked());
        EXPECT_EQ(dialog.findChild<QRadioButton*>("byKind")->text(), "Equation and &number");
        dialog.findChild<QListWidget*>("targets")->setCurrentRow(1);
        EXPECT_EQ(dialog.findChild<QRadioButton*>("byKind")->text(), "Table and &number");
        dialog.findChild<QRadioButton*>("byNumber")->click();
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<REF TO=\"table-1\" KIND=\"number\"></REF>"));
    EXPECT_TRUE(waitFor([&] { return shown().find("In figure 1") != std::string::npos; }));
}

TEST_F(WritingTest, AReferenceWhoseTargetIsDeletedSaysSoAndGetsAnotherOne) {
    const std::string table = "<TABLE ID=\"t\"><ROW><CELL>{a}</CELL></ROW><CAPTION>{First}"
                              "</CAPTION></TABLE>\n";
    write("<PARAGRAPH><TEXT>{See }</TEXT><REF TO=\"t\"></REF></PARAGRAPH>\n" +
          QByteArray::fromStdString(table) +
          "<TABLE><ROW><CELL>{b}</CELL></ROW><CAPTION>{Second}</CAPTION></TABLE>\n");
    const std::size_t at = document().bytes().find("<TABLE ID");
    (void)document().edit({{{at, at + table.size()}, ""}}, "Delete");
    EXPECT_TRUE(waitFor([&] { return shown().find("See (missing)") != std::string::npos; }));
    const auto& faults = window_->findChild<panes::FaultsPane*>()->faults();
    EXPECT_TRUE(waitFor([&] {
        return std::ranges::any_of(faults, [](const session::ListedFault& one) {
            return one.message.contains("nothing has the ID t");
        });
    }));
    document().undo();
    EXPECT_TRUE(waitFor([&] { return shown().find("See Table\u00A01") != std::string::npos; }));
    document().redo();
    ASSERT_TRUE(waitFor([&] { return shown().find("See (missing)") != std::string::npos; }));
    const std::size_t place = document().bytes().find("<REF");
    view().text().cursor().set({place, place});
    const QRectF caret = view().text().caretRect().value();
    QMenu menu;
    window_->findChild<menus::InsertMenu*>()->addTo(
        menu, view().viewport()->mapToGlobal((caret.center() + QPointF(5, 0)).toPoint()));
    ASSERT_EQ(menu.actions().size(), 2);
    EXPECT_TRUE(answers([](QDialog& dialog) { dialog.accept(); },
                        [&] { menu.actions().front()->trigger(); }));
    EXPECT_TRUE(waitFor([&] { return shown().find("See Table\u00A01") != std::string::npos; }));
    EXPECT_THAT(body(), HasSubstr("<TABLE ID=\"table-1\"><ROW><CELL>{b}"));
}

TEST_F(WritingTest, AFormulaIsWrittenWithItsPictureAndItsFaults) {
    write(paragraph("The energy "));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    answering("formula", [](QDialog& dialog) {
        auto* source = dialog.findChild<QPlainTextEdit*>("source");
        const auto* fault = dialog.findChild<QLabel*>("fault");
        source->setPlainText("\\frac{1}{2} m v^");
        EXPECT_FALSE(fault->text().isEmpty());
        source->setPlainText("\\frac{1}{2} m v^2");
        EXPECT_TRUE(fault->text().isEmpty());
        EXPECT_FALSE(dialog.findChild<QWidget*>("preview")->accessibleName().isEmpty());
        QTest::keyClick(source, Qt::Key_Return);
    });
    EXPECT_THAT(body(), HasSubstr("<FORMULA>{\\\\frac\\{1\\}\\{2\\} m v^2}</FORMULA>"));
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    // The formula that is selected alone is changed.
    const std::string& bytes = document().bytes();
    const std::size_t from = bytes.find("<FORMULA"), to = bytes.find("</FORMULA>") + 10;
    view().text().cursor().set({from, to});
    answering("formula", [](QDialog& dialog) {
        auto* source = dialog.findChild<QPlainTextEdit*>("source");
        EXPECT_EQ(source->toPlainText(), "\\frac{1}{2} m v^2");
        source->setPlainText("m g h");
        dialog.findChild<QRadioButton*>("numbered")->setChecked(true);
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<FORMULA KIND=\"numbered\">{m g h}</FORMULA>"));
    EXPECT_THAT(body(), Not(HasSubstr("frac")));
}

TEST_F(WritingTest, TabLeadsThroughTheEmptyPartsOfAFormulaAndAClickIntoThem) {
    write(paragraph("The ratio "));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    answering("formula", [](QDialog& dialog) {
        auto* source = dialog.findChild<QPlainTextEdit*>("source");
        auto* preview = dialog.findChild<menus::FormulaPreview*>();
        QTest::keyClicks(source, "\\frac{}{} ");
        ASSERT_TRUE(preview->frameAt(6) && preview->frameAt(8));
        EXPECT_LT(preview->frameAt(6)->y(), preview->frameAt(8)->y());
        QTest::mouseClick(preview, Qt::LeftButton, {}, preview->frameAt(6)->toPoint());
        QTest::keyClicks(source, "a");
        EXPECT_FALSE(preview->frameAt(6)); // it waits no more
        QTest::keyClick(source, Qt::Key_Tab);
        QTest::keyClicks(source, "b");
        QTest::keyClick(source, Qt::Key_Tab); // behind the fraction
        QTest::keyClicks(source, "m");
        EXPECT_EQ(source->toPlainText(), "\\frac{a}{b}m ");
        EXPECT_EQ(dialog.focusWidget(), source);
        QTest::keyClick(source, Qt::Key_Tab);
        EXPECT_NE(dialog.focusWidget(), source);
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<FORMULA>{\\\\frac\\{a\\}\\{b\\}m}</FORMULA>"));
}

TEST_F(WritingTest, AFormulaInPlainWordsIsWrittenInTexAtAClick) {
    write(paragraph("The period "));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    answering("formula", [](QDialog& dialog) {
        auto* source = dialog.findChild<QPlainTextEdit*>("source");
        auto* tex = dialog.findChild<QPushButton*>("tex");
        source->setPlainText("\\frac{1}{2}");
        EXPECT_FALSE(tex->isVisible());
        source->setPlainText("2 pi sqrt(L/g");
        EXPECT_TRUE(tex->isVisible());
        EXPECT_EQ(dialog.findChild<QLabel*>("fault")->text(),
                  "TeX writes \\pi for pi. All of it: 2 \\pi \\sqrt{L/g}");
        EXPECT_EQ(source->extraSelections().size(), 2);
        tex->click();
        EXPECT_EQ(source->toPlainText(), "2 \\pi \\sqrt{L/g}");
        EXPECT_FALSE(tex->isVisible());
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<FORMULA>{2 \\\\pi \\\\sqrt\\{L/g\\}}</FORMULA>"));
}

TEST_F(WritingTest, EmphasisBetweenWordsIsForWhatIsTypedNext) {
    write(paragraph("One "));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    const std::size_t steps = document().steps();
    action("strong")->trigger();
    EXPECT_EQ(document().steps(), steps);
    EXPECT_TRUE(view().writing().isMarked(schemas::ContainerRole::strong));
    type("two");
    EXPECT_THAT(body(), HasSubstr("<STRONG>{two}</STRONG>"));
    action("strong")->trigger(); // at its end: what follows is none
}

TEST_F(WritingTest, PastedHtmlKeepsItsStructure) {
    write(paragraph("One"));
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    press(Qt::Key_Return);
    QMimeData data;
    data.setHtml("<p style='color:red'>A <b>bold</b> &amp; <i>sloping</i> <a "
                 "href='https://example.org/'>link</a><img src='/dev/zero'></p>"
                 "<ul><li>one</li><li>two<ol><li>inner</li></ol></li></ul>"
                 "<table><tr><td>a</td><td>b</td></tr><tr><td>c</td><td>d</td></tr></table>");
    data.setText("unused");
    EXPECT_TRUE(view().writing().paste(data));
    EXPECT_THAT(body(), HasSubstr("<STRONG>{bold}</STRONG>"));
    EXPECT_THAT(body(), HasSubstr("<EMPH>{sloping}</EMPH>"));
    EXPECT_THAT(body(), HasSubstr("<LINK TO=\"https://example.org/\">{link}</LINK>"));
    EXPECT_THAT(body(), HasSubstr("<LIST KIND=\"number\">"));
    EXPECT_THAT(body(), HasSubstr("<TEXT>{d}</TEXT></CELL>"));
    EXPECT_THAT(body(), Not(HasSubstr("unused")));
    EXPECT_THAT(body(), Not(HasSubstr("zero")));
    document().undo();
    EXPECT_EQ(view().text().cursor().selects(), false);
    EXPECT_THAT(body(), Not(HasSubstr("bold")));
}

TEST_F(WritingTest, HeadingsOfPastedHtmlBeginSectionsWhereTheClassHasThem) {
    const authoring::Grammars grammars(window_ ? view().document().schemas()
                                               : open(memo(""))->document().schemas());
    const std::string report = view::fragmentOf(
        "<h1>Top</h1><p>a</p><h2>Inner</h2><p>b</p><h1>Next</h1>", *grammars.of("REPORT"));
    EXPECT_EQ(report, "<SECTION><HEADING><TEXT>{Top}</TEXT></HEADING><PARAGRAPH><TEXT>{a}</TEXT>"
                      "</PARAGRAPH><SECTION><HEADING><TEXT>{Inner}</TEXT></HEADING><PARAGRAPH>"
                      "<TEXT>{b}</TEXT></PARAGRAPH></SECTION></SECTION><SECTION><HEADING>"
                      "<TEXT>{Next}</TEXT></HEADING></SECTION>");
    EXPECT_EQ(view::fragmentOf("<h1>Top</h1>", *grammars.of("CMEMO")),
              "<SECTION><HEADING><TEXT>{Top}</TEXT></HEADING></SECTION>");
    EXPECT_EQ(view::fragmentOf("<p> </p><img src='a'>", *grammars.of("CMEMO")), "");
}

TEST_F(WritingTest, OneWritesOnBehindTheFootnoteTheReferenceAndTheFormulaThatEndALine) {
    const std::string units[] = {"<FOOTNOTE><TEXT>{Note}</TEXT></FOOTNOTE>",
                                 "<REF TO=\"gone\"></REF>", "<FORMULA>{x^2}</FORMULA>"};
    for (const std::string& unit : units) {
        const std::string line = "<PARAGRAPH><TEXT>{One}</TEXT>" + unit;
        write(QByteArray::fromStdString(line + "</PARAGRAPH>\n"));
        for (const Qt::KeyboardModifier key : {Qt::NoModifier, Qt::ControlModifier}) {
            goTo("One");
            press(Qt::Key_End, key);
            type(" two");
            EXPECT_THAT(body(), HasSubstr(line + "<TEXT>{ two}</TEXT></PARAGRAPH>"));
            for (int i = 0; i < 4; ++i)
                press(Qt::Key_Backspace);
            type("!");
            EXPECT_THAT(body(), HasSubstr(line + "<TEXT>{!}</TEXT></PARAGRAPH>"));
            while (document().canUndo())
                document().undo();
        }
        goTo("One");
        press(Qt::Key_End);
        press(Qt::Key_Return);
        type("Next");
        EXPECT_THAT(body(), HasSubstr(line + "</PARAGRAPH>\n<PARAGRAPH>"));
        EXPECT_THAT(body(), HasSubstr("{Next}"));
    }
}

TEST_F(WritingTest, TablesOfPastedHtmlKeepTheirSpansAndHeaders) {
    const authoring::Grammars grammars(open(memo(""))->document().schemas());
    const QString html = "<table><thead><tr><th colspan='2'>wide</th></tr></thead><tbody>"
                         "<tr><td rowspan='2'>high</td><td>b</td></tr><tr><td>c</td></tr>"
                         "</tbody></table>";
    const std::string rest = "<ROW><CELL ROWS=\"2\"><TEXT>{high}</TEXT></CELL><CELL><TEXT>{b}"
                             "</TEXT></CELL></ROW><ROW><CELL><TEXT>{c}</TEXT></CELL></ROW></TABLE>";
    const std::string wide = "<CELL COLUMNS=\"2\"><TEXT>{wide}</TEXT></CELL></ROW>";
    EXPECT_EQ(view::fragmentOf(html, *grammars.of("CMEMO")),
              "<TABLE><ROW KIND=\"header\">" + wide + rest);
    // The first row of a report's table is a header anyway.
    EXPECT_EQ(view::fragmentOf(html, *grammars.of("REPORT")), "<TABLE><ROW>" + wide + rest);
    // A table in a cell is its text, and no section begins behind it.
    const std::string inner = view::fragmentOf(
        "<table><tr><td><table><tr><td>in</td></tr></table><h1>Title</h1></td></tr></table>",
        *grammars.of("CMEMO"));
    EXPECT_THAT(inner, Not(HasSubstr("SECTION")));
    EXPECT_THAT(inner, HasSubstr("{in}"));
    EXPECT_THAT(inner, HasSubstr("{Title}"));
}

TEST_F(WritingTest, WhatIsDraggedMovesInOneStepAndKeepsItsIds) {
    write(paragraph("One <two") + "<PARAGRAPH><TEXT ID=\"x\">{three}</TEXT></PARAGRAPH>\n" +
          paragraph("four"));
    ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
    const std::string before = document().bytes();
    const std::size_t from = before.find("three"), to = from + 5;
    view().text().cursor().set({from, to});
    const std::unique_ptr<QMimeData> data = view().text().copied();
    ASSERT_TRUE(data);
    const std::size_t steps = document().steps();
    // Behind "four".
    view().text().cursor().set({before.find("four") + 4, before.find("four") + 4});
    const QPointF at = view().text().caretRect()->center();
    view().text().cursor().set({from, to});
    view().writing().drop(*data, at, text::Range{from, to});
    EXPECT_THAT(body(), HasSubstr("{four}</TEXT><TEXT ID=\"x\">{three}</TEXT>"));
    EXPECT_EQ(document().steps(), steps + 1);
    document().undo();
    EXPECT_EQ(document().bytes(), before);
}

TEST_F(WritingTest, BackspaceSelectsAFigureBeforeItTakesIt) {
    write(scripted("colour 20A040") + paragraph("One"));
    goTo("One");
    press(Qt::Key_Backspace);
    EXPECT_TRUE(view().text().cursor().selects());
    EXPECT_THAT(body(), HasSubstr("SCRIPTED"));
    press(Qt::Key_Backspace);
    EXPECT_THAT(body(), Not(HasSubstr("SCRIPTED")));
    document().undo();
    EXPECT_THAT(body(), HasSubstr("SCRIPTED"));
}

TEST_F(WritingTest, TheCaretIsSeenAfterEachNewParagraph) {
    write(paragraph("One"));
    window_->resize(700, 400);
    goTo("}</TEXT></PARAGRAPH>\n</BODY>");
    for (int i = 0; i < 40; ++i) {
        press(Qt::Key_Return);
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        const std::optional<QRectF> caret = view().text().caretRect();
        ASSERT_TRUE(caret);
        EXPECT_TRUE(QRectF(view().viewport()->rect()).contains(caret->center())) << i;
    }
}

TEST_F(WritingTest, AFormulaIsEditedBesideItsPlaceOnThePage) {
    write("<PARAGRAPH><TEXT>{Here }</TEXT><FORMULA>{x^2}</FORMULA><TEXT>{ and on}</TEXT>"
          "</PARAGRAPH>\n");
    const std::size_t from = document().bytes().find("<FORMULA>"),
                      to = document().bytes().find("</FORMULA>") + 10;
    view().text().cursor().set({from, to});
    const QRect formula =
        view().placeOfFormula(document().tree().innermostAt(from)).value().toAlignedRect();
    const QRect place(view().viewport()->mapToGlobal(formula.topLeft()), formula.size());
    EXPECT_GT(place.width(), 5);
    EXPECT_TRUE(answers(
        [&](QDialog& dialog) {
            const QRect stands = dialog.frameGeometry();
            EXPECT_FALSE(stands.intersects(place));
            EXPECT_LT(std::min(std::abs(stands.top() - place.bottom()),
                               std::abs(place.top() - stands.bottom())),
                      20);
            QTest::keyClicks(dialog.findChild<QWidget*>("source"), "+y");
            QTest::keyClick(dialog.findChild<QWidget*>("source"), Qt::Key_Return);
        },
        [&] { press(Qt::Key_Return); }));
    EXPECT_THAT(body(), HasSubstr("<FORMULA>{x^2+y}</FORMULA>"));
}

} // namespace
} // namespace writing
