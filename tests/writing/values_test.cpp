// Values of figures in the text: inserted, changed and taken away by who writes.
#include "menus/formula_dialog.h"
#include "menus/value_dialog.h"
#include "writing/writing_testing.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

namespace writing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ValuesInWindowTest : public WritingTest {
protected:
    void writeWithFigure() {
        write(paragraph("It is ") + scripted("duration 8\nvalue height 1 2\nvalue width 5 0"));
        goTo("}</TEXT></PARAGRAPH>");
    }
    static bool comesToSay(QDialog& dialog, const QString& number) {
        const auto* label = dialog.findChild<QLabel*>("number");
        return waitFor([&] { return label->text() == number; });
    }
    bool comesToShow(const std::string& words) {
        return waitFor([&] { return shown().find(words) != std::string::npos; });
    }
    std::size_t startOfValue() const { return document().bytes().find("<VALUE"); }
    std::size_t endOfValue() const { return document().bytes().find("</VALUE>") + 8; }
};

TEST_F(ValuesInWindowTest, AValueIsChosenFromWhatTheFigureOffersAndShowsAtOnce) {
    writeWithFigure();
    const std::string before = document().bytes();
    const std::size_t steps = document().steps();
    answering("value", [](QDialog& dialog) {
        auto* list = dialog.findChild<QListWidget*>("offers");
        ASSERT_TRUE(waitFor([&] { return list->count() == 2; }));
        auto* field = dialog.findChild<QLineEdit*>("expression");
        QTest::keyClicks(field, "wid");
        EXPECT_EQ(list->count(), 1);
        field->clear();
        QTest::keyClicks(field, "hei");
        QTest::keyClick(field, Qt::Key_Down);
        EXPECT_EQ(field->text(), "height");
        EXPECT_TRUE(comesToSay(dialog, "1.00"));
        dialog.findChild<QDoubleSpinBox*>("time")->setValue(2.5);
        EXPECT_TRUE(comesToSay(dialog, "6.00"));
        dialog.findChild<QRadioButton*>("follows")->setChecked(true);
        dialog.findChild<QSpinBox*>("digits")->setValue(1);
        dialog.findChild<QComboBox*>("unit")->setCurrentIndex(1);
        EXPECT_TRUE(comesToSay(dialog, "1.0"));
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("<TEXT>{It is }</TEXT><VALUE OF=\"scripted-1\" "
                                  "EXPRESSION=\"height\" FORMAT=\"1 decimal\"></VALUE>"));
    EXPECT_THAT(body(), HasSubstr("ID=\"scripted-1\""));
    EXPECT_EQ(document().steps(), steps + 1);
    EXPECT_TRUE(comesToShow("It is 1.0"));
    live(*window_, 0).seek(4);
    EXPECT_TRUE(comesToShow("It is 9.0"));
    document().undo();
    EXPECT_EQ(document().bytes(), before);
}

TEST_F(ValuesInWindowTest, AnExpressionThatIsNotKnownIsSaidInTheDialogAndNotTaken) {
    writeWithFigure();
    const std::string before = document().bytes();
    answering("value", [](QDialog& dialog) {
        auto* field = dialog.findChild<QLineEdit*>("expression");
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        EXPECT_FALSE(ok->isEnabled());
        QTest::keyClicks(field, "depth");
        EXPECT_TRUE(comesToSay(dialog, "there is no value \"depth\""));
        EXPECT_FALSE(ok->isEnabled());
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_TRUE(dialog.isVisible());
        field->setText("width");
        EXPECT_TRUE(comesToSay(dialog, "5.00"));
        EXPECT_TRUE(ok->isEnabled());
        field->setText("depth");
        QTest::keyClick(field, Qt::Key_Return); // before the figure has answered
        EXPECT_TRUE(comesToSay(dialog, "there is no value \"depth\""));
        EXPECT_TRUE(dialog.isVisible());
        dialog.reject();
    });
    EXPECT_EQ(document().bytes(), before);
}

TEST_F(ValuesInWindowTest, EnterTakesTheFirstValueThatHasTheTypedWords) {
    for (const bool waits : {true, false}) {
        writeWithFigure();
        answering("value", [&](QDialog& dialog) {
            auto* list = dialog.findChild<QListWidget*>("offers");
            ASSERT_TRUE(waitFor([&] { return list->count() == 2; }));
            auto* field = dialog.findChild<QLineEdit*>("expression");
            QTest::keyClicks(field, "wid");
            if (waits) {
                EXPECT_TRUE(comesToSay(dialog, "there is no value \"wid\"\nEnter takes width."));
            }
            QTest::keyClick(field, Qt::Key_Return);
        });
        EXPECT_THAT(body(), HasSubstr("EXPRESSION=\"width\""));
    }
}

TEST_F(ValuesInWindowTest, AnExpressionThatIsNotKnownIsAmongTheFaults) {
    write("<PARAGRAPH><TEXT>{It is }</TEXT><VALUE OF=\"s\" EXPRESSION=\"depth\"></VALUE>"
          "</PARAGRAPH>" +
          scripted("duration 8\nvalue height 1 2", "ID=\"s\""));
    EXPECT_TRUE(comesToShow("It is [depth]"));
    EXPECT_TRUE(waitFor([&] { return !window_->document().valueFaults().empty(); }));
}

TEST_F(ValuesInWindowTest, ItIsOneUnitWhichReturnAndTwoClicksChangeAndDeleteTakesAway) {
    writeWithFigure();
    answering("value", [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("expression")->setText("height");
        dialog.accept();
    });
    ASSERT_TRUE(comesToShow("It is 1.00"));
    // The caret goes over it in one step.
    view().text().cursor().set({endOfValue(), endOfValue()});
    press(Qt::Key_Left);
    EXPECT_LE(view().text().cursor().selection()->caret, startOfValue());
    view().text().cursor().set({startOfValue(), endOfValue()});
    EXPECT_TRUE(answers(
        [](QDialog& dialog) {
            EXPECT_EQ(dialog.objectName(), "valueDialog");
            EXPECT_EQ(dialog.findChild<QLineEdit*>("expression")->text(), "height");
            dialog.findChild<QLineEdit*>("expression")->setText("width");
            dialog.accept();
        },
        [this] { press(Qt::Key_Return); }));
    EXPECT_THAT(body(), HasSubstr("<VALUE OF=\"scripted-1\" EXPRESSION=\"width\"></VALUE>"));
    ASSERT_TRUE(comesToShow("It is 5.00"));
    EXPECT_TRUE(answers(
        [](QDialog& dialog) {
            dialog.findChild<QDoubleSpinBox*>("time")->setValue(3);
            dialog.accept();
        },
        [this] {
            Q_EMIT view().elementActivated(document().tree().innermostAt(startOfValue() + 1),
                                           schemas::Display::value);
        }));
    EXPECT_THAT(body(), HasSubstr("EXPRESSION=\"width\" TIME=\"3 s\"></VALUE>"));
    view().text().cursor().set({endOfValue(), endOfValue()});
    press(Qt::Key_Backspace);
    press(Qt::Key_Backspace);
    EXPECT_THAT(body(), Not(HasSubstr("<VALUE")));
}

TEST_F(ValuesInWindowTest, AFormulaTakesAValueFromTheSameDialog) {
    writeWithFigure();
    answering("formula", [](QDialog& dialog) {
        auto* source = dialog.findChild<QPlainTextEdit*>("source");
        source->setPlainText("h = ");
        source->moveCursor(QTextCursor::End);
        EXPECT_TRUE(answers(
            [](QDialog& inner) {
                EXPECT_EQ(inner.objectName(), "valueDialog");
                inner.findChild<QLineEdit*>("expression")->setText("height");
                inner.findChild<QDoubleSpinBox*>("time")->setValue(2);
                inner.accept();
            },
            [&] { dialog.findChild<QPushButton*>("value")->click(); }));
        EXPECT_EQ(source->toPlainText(), "h = \\value[at 2 s]{scripted-1}{height}");
        dialog.accept();
    });
    EXPECT_THAT(body(), HasSubstr("ID=\"scripted-1\""));
    EXPECT_TRUE(waitFor([&] {
        const auto& blocks = view().model()->blocks;
        return std::ranges::any_of(blocks, [](const auto& block) {
            return std::ranges::any_of(block->runs, [](const model::Run& run) {
                return run.formula && run.text == "h = 5.00";
            });
        });
    }));
}

TEST_F(ValuesInWindowTest, WithoutAFigureItIsNotOfferedAndSaysWhy) {
    write(paragraph("It is "));
    goTo("}</TEXT></PARAGRAPH>");
    QString why;
    QObject::connect(&view().writing(), &view::Writing::refused, &view(),
                     [&](const QString& sentence) { why = sentence; });
    action("value")->trigger();
    EXPECT_FALSE(QApplication::activeModalWidget());
    EXPECT_THAT(why.toStdString(), HasSubstr("insert one first"));
    EXPECT_THAT(body(), Not(HasSubstr("VALUE")));
}

} // namespace
} // namespace writing
