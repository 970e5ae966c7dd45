// The tool bar of the main window: what its buttons do, say and look like.
#include "frame/tool_bar.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCursor>
#include <QMenu>
#include <QTest>
#include <QToolButton>

namespace views {
namespace {

class ToolBarTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openMainWindow();
        viewer->resize(1200, 760);
        viewer->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
    }
    [[nodiscard]] QToolButton& button(const QString& name) const {
        auto* found = viewer->findChild<QToolButton*>("tool." + name);
        EXPECT_TRUE(found) << name.toStdString();
        return *found;
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    QMainWindow* viewer = nullptr;
};

TEST_F(ToolBarTest, ButtonsDoWhatTheMenusDo) {
    editor.document().setText("# other\n" + ballScene, "Edit");
    ASSERT_TRUE(button("undo").isEnabled());
    QTest::mouseClick(&button("undo"), Qt::LeftButton);
    EXPECT_EQ(editor.document().text(), ballScene);
    EXPECT_TRUE(button("redo").isEnabled());
    QTest::mouseClick(&button("redo"), Qt::LeftButton);
    EXPECT_EQ(editor.document().text(), "# other\n" + ballScene);
    EXPECT_FALSE(button("redo").isEnabled());
}

TEST_F(ToolBarTest, TipsSayTheCommandAsItIsNowAndItsKey) {
    editor.document().setText("# other\n" + ballScene, "Change Color");
    EXPECT_EQ(button("undo").toolTip(), "Undo Change Color (Ctrl+Z)");
    EXPECT_EQ(button("createBody").toolTip(), "Body");
}

// A click on a button leaves the keys where one works.
TEST_F(ToolBarTest, ButtonsTakeNoKeys) {
    const QWidget* before = viewer->focusWidget();
    ASSERT_TRUE(before);
    QTest::mouseClick(&button("frameAll"), Qt::LeftButton); // which stays enabled
    EXPECT_EQ(viewer->focusWidget(), before);
    for (const QToolButton* one : viewer->findChild<ToolBar*>()->findChildren<QToolButton*>())
        EXPECT_TRUE(!one->objectName().startsWith("tool.") || one->focusPolicy() == Qt::NoFocus)
            << one->objectName().toStdString();
}

// Its menu took the pointer away from it, and it stays dark no longer than that.
TEST_F(ToolBarTest, AButtonWithAMenuIsLeftWhenAnEntryWasChosen) {
    QToolButton& body = button("createBody");
    QMenu* menu = body.defaultAction()->menu();
    ASSERT_TRUE(menu);
    QCursor::setPos(viewer->mapToGlobal(viewer->rect().center()));
    body.setAttribute(Qt::WA_UnderMouse);
    menu->popup(body.mapToGlobal(QPoint(0, body.height())));
    ASSERT_TRUE(menu->isVisible());
    menu->hide();
    EXPECT_TRUE(waitFor([&] { return !body.testAttribute(Qt::WA_UnderMouse); }));
}

// Icons are drawn in the colours of the theme.
TEST_F(ToolBarTest, IconsFollowTheTheme) {
    auto* bar = viewer->findChild<ToolBar*>();
    ASSERT_TRUE(bar);
    const auto drawn = [&] { return button("frameAll").icon().pixmap(22, 22).toImage(); };
    const QImage light = drawn();
    QPalette dark(QColor(40, 40, 40));
    bar->setPalette(dark);
    QEvent changed(QEvent::PaletteChange);
    QApplication::sendEvent(bar, &changed);
    EXPECT_NE(drawn(), light);
}

} // namespace
} // namespace views
