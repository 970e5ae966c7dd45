#include "dialogs/recovery.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace dialogs {
namespace {

const Asking asking{"Ensemble", "A document without a name", "Windows open again."};

// The answer that a key gives to the question.
Recovery answeredBy(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTimer::singleShot(10, qApp, [key, modifiers] {
        QWidget* question = QApplication::activeModalWidget();
        ASSERT_TRUE(question);
        EXPECT_EQ(question->objectName(), "recover");
        QWidget* focus = question->focusWidget();
        QTest::keyClick(focus ? focus : question, key, modifiers);
    });
    return askAbout(nullptr, {.file = {"/a/b.ens", {}}}, asking);
}

TEST(Recovery, AKeyThatWasMeantForAnotherWindowLosesAndOpensNothing) {
    EXPECT_EQ(answeredBy(Qt::Key_Return), Recovery::later);
    EXPECT_EQ(answeredBy(Qt::Key_Space), Recovery::later);
    EXPECT_EQ(answeredBy(Qt::Key_Escape), Recovery::later);
}

TEST(Recovery, EachButtonAnswers) {
    const auto clicked = [](const QString& words) {
        QTimer::singleShot(10, qApp, [words] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_TRUE(box);
            for (QAbstractButton* button : box->buttons())
                if (button->text() == words)
                    return button->click();
            box->reject();
            ADD_FAILURE() << "no button " << words.toStdString();
        });
        return askAbout(nullptr, {.file = {"/a/b.ens", {}}}, asking);
    };
    EXPECT_EQ(clicked("&Recover"), Recovery::recover);
    EXPECT_EQ(clicked("&Discard"), Recovery::discard);
    EXPECT_EQ(clicked("&Later"), Recovery::later);
}

TEST(Recovery, TheQuestionSaysTheDayWhenItIsAnother) {
    const QDateTime at(QDate(2026, 3, 5), QTime(14, 3));
    files::Kept kept{.file = {"/a/b.ens", {}}, .at = at.toSecsSinceEpoch()};
    EXPECT_EQ(questionAbout(kept, asking, at.addSecs(3600)),
              "b.ens was not saved before Ensemble stopped at 14:03. Recover it?");
    const QString other = questionAbout(kept, asking, at.addDays(1));
    EXPECT_TRUE(other.startsWith("b.ens was not saved before Ensemble stopped on "));
    EXPECT_TRUE(other.endsWith("2026 at 14:03. Recover it?"));
    kept.file.path.clear();
    EXPECT_TRUE(questionAbout(kept, asking, at).startsWith("A document without a name was not"));
}

TEST(Recovery, TheAdviceSaysWhatBecomesOfTheFileAndOfDrafts) {
    files::Kept kept{};
    EXPECT_EQ(adviceAbout(kept, asking), "It has no file yet.");
    kept.drafts["1"] = "typed";
    EXPECT_EQ(adviceAbout(kept, asking), "It has no file yet. Windows open again.");
    kept = {.file = {"/nowhere/b.ens", {.exists = true}}};
    EXPECT_EQ(adviceAbout(kept, asking), "Its file is no longer there: saving writes it again.");
}

} // namespace
} // namespace dialogs
