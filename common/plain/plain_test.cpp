#include "plain/plain.h"

#include "plain/qt_messages.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QToolTip>

namespace plain {
namespace {

// Reading this file never ends; a label that reads it takes all memory.
const QString hostile = QStringLiteral("<img src=\"/dev/zero\"> & <b>bold</b>\n[*]");

// Shown by this label as it was written.
void expectPlain(const QLabel& label, const QString& text) {
    EXPECT_EQ(label.text(), text);
    EXPECT_EQ(label.textFormat(), Qt::PlainText);
}

TEST(Plain, ALabelShowsAnyText) {
    const std::unique_ptr<QLabel> made(label(hostile));
    expectPlain(*made, hostile);
    EXPECT_GT(made->sizeHint().width(),
              made->fontMetrics().horizontalAdvance("<img src=\"/dev/zero\">"));
    made->setText("<b>x</b>");
    expectPlain(*made, "<b>x</b>");
}

TEST(Plain, ATipIsTheTextOnScreenToo) {
    QWidget widget;
    widget.resize(200, 100);
    widget.show();
    QToolTip::showText(widget.mapToGlobal(QPoint(20, 20)), tip(hostile), &widget);
    ASSERT_TRUE(QToolTip::isVisible());
    EXPECT_FALSE(QToolTip::text().contains("<img"));
    EXPECT_TRUE(QToolTip::text().contains("&lt;img"));
    EXPECT_EQ(tip("Step <2 s>"), "Step <2 s>"); // no markup: as it is
    QToolTip::hideText();
}

TEST(Plain, ACaptionHasNoKeyAndNoSecondColumn) {
    QPushButton button(caption("Black & White\tCtrl+Q\n"));
    EXPECT_EQ(button.text(), "Black && White Ctrl+Q ");
    EXPECT_TRUE(button.shortcut().isEmpty());
}

TEST(Plain, ATitleKeepsWhatLooksLikeTheMark) {
    QWidget widget;
    widget.setWindowTitle(title("a[*].al") + "[*]");
    EXPECT_EQ(widget.windowTitle(), "a[*][*].al[*]");
}

TEST(Plain, EveryTextOfAMessageIsPlain) {
    Message box(QMessageBox::Warning, "a[*]", hostile, QMessageBox::Ok, nullptr);
    box.setSecondText(hostile);
    box.show();
    int shown = 0;
    for (const QLabel* part : box.findChildren<QLabel*>())
        if (!part->text().isEmpty()) {
            expectPlain(*part, hostile);
            ++shown;
        }
    EXPECT_EQ(shown, 2);
}

TEST(Plain, WhatQtSaysIsPrintedLikeOurMessages) {
    testing::internal::CaptureStderr();
    printQtMessages("program", QtMessages::all);
    qWarning("no font \033]0;owned\007\nensemble: forged");
    printQtMessages("program", QtMessages::errors);
    qWarning("hidden");
    qInstallMessageHandler(nullptr);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "program: no font ␛]0;owned␇\n    ensemble: forged\n");
}

} // namespace
} // namespace plain

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
