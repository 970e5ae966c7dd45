#include "dialogs/windows_stay.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QTest>

namespace dialogs {
namespace {

TEST(WindowsStay, AWindowOutlivesItsQuestion) {
    const WindowsStay stay;
    QPointer<QMainWindow> window = new QMainWindow;
    window->show();
    {
        QMessageBox question(window); // on the stack, as most are
        QTimer::singleShot(10, window, [&] { window->deleteLater(); });
        question.exec();
        EXPECT_TRUE(window);
        EXPECT_FALSE(window->isVisible());
        EXPECT_FALSE(question.isVisible());
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window; }));
}

TEST(WindowsStay, AQuestionThatHasClosedMayStillRun) {
    const WindowsStay stay;
    QPointer<QMainWindow> window = new QMainWindow;
    window->show();
    {
        QMessageBox question(window);
        QTimer::singleShot(10, window, [&] {
            question.close();
            window->deleteLater();
            QCoreApplication::sendPostedEvents(window, QEvent::DeferredDelete); // in its loop
        });
        question.exec();
        ASSERT_TRUE(window);
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window; }));
}

TEST(WindowsStay, AnothersQuestionStaysOpen) {
    const WindowsStay stay;
    QPointer<QMainWindow> window = new QMainWindow;
    QPointer<QMainWindow> closed = new QMainWindow;
    closed->setAttribute(Qt::WA_DeleteOnClose);
    window->show();
    closed->show();
    {
        QMessageBox question(window);
        question.addButton(QMessageBox::Ok);
        QTimer::singleShot(10, window, [&] { closed->close(); });
        QTimer::singleShot(100, &question, [&] { question.accept(); });
        EXPECT_EQ(question.exec(), QDialog::Accepted);
        EXPECT_TRUE(closed);
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return !closed; }));
    EXPECT_TRUE(window);
    delete window;
}

TEST(WindowsStay, AMenuIsAQuestionToo) {
    const WindowsStay stay;
    QPointer<QMainWindow> window = new QMainWindow;
    window->show();
    {
        QMenu menu(window);
        menu.addAction("One");
        QTimer::singleShot(10, window, [&] { window->deleteLater(); });
        QTimer::singleShot(100, &menu, [&] { menu.close(); });
        menu.exec(QPoint(10, 10));
        EXPECT_TRUE(window);
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window; }));
}

TEST(WindowsStay, WithoutAQuestionNothingWaits) {
    const WindowsStay stay;
    QPointer<QMainWindow> window = new QMainWindow;
    window->show();
    window->deleteLater();
    QCoreApplication::sendPostedEvents(window, QEvent::DeferredDelete);
    EXPECT_FALSE(window);
}

} // namespace
} // namespace dialogs

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
