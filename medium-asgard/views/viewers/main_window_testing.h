// An editor with one ball, and its window with the usual panes.
#pragma once

#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <QMenuBar>
#include <QTimer>

#include <gtest/gtest.h>

namespace views {

class MainWindowTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }
    GraphicalViewer& open() {
        GraphicalViewer* viewer = editor.openGraphicalViewer();
        viewer->resize(1200, 760);
        viewer->showUsualPanes();
        viewer->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
        return *viewer;
    }
    static QAction* action(const QWidget& window, const QString& begins) {
        for (QAction* one : window.findChildren<QAction*>())
            if (one->text().remove('&').startsWith(begins))
                return one;
        return nullptr;
    }
    static QStringList fileMenu(const QMainWindow& window) {
        QStringList entries;
        for (const QAction* menu : window.menuBar()->actions())
            if (menu->text().remove('&') == "File")
                for (const QAction* entry : menu->menu()->actions())
                    if (!entry->isSeparator())
                        entries << entry->text().remove('&').remove(QStringLiteral("…"));
        return entries;
    }
    // In the question that is about to be asked.
    void answer(const QString& label) {
        QTimer::singleShot(0, &editor, [this, label] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box) // a typed value is being read before
                return answer(label);
            ++asked;
            for (QAbstractButton* button : box->buttons())
                if (button->text().remove('&') == label)
                    return button->click();
            FAIL() << "no button " << label.toStdString();
        });
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    int asked = 0;
};

} // namespace views
