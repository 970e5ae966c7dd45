// Closing, saving and quitting, with windows and with values that are typed.
#include "language/scene_editor.h"
#include "properties/properties_pane.h"
#include "start/first_page.h"
#include "viewers/main_window_testing.h"
#include "viewers/scene_files.h"
#include "viewers/starting.h"

#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSettings>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;

// Into the field of the properties that are shown, and no Return.
void typeMass(QWidget& window, const QString& mass) {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, longestWait));
    QLineEdit* field = nullptr;
    ASSERT_TRUE(waitFor([&] { return (field = window.findChild<QLineEdit*>("-mass")); }));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, mass);
}

// Its fields are gone with it; the other windows have theirs.
TEST_F(MainWindowTest, AWindowThatHasARefusedValueAsksBeforeItCloses) {
    editor.beginSession();
    open();
    GraphicalViewer* second = editor.openGraphicalViewer();
    editor.document().select({{editing::Kind::body, 0}});
    second->panes().show("properties");
    typeMass(*second, "heavy");
    answer("No");
    EXPECT_FALSE(second->close());
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(second->isVisible());
    answer("Yes");
    EXPECT_TRUE(second->close());
    EXPECT_EQ(asked, 2);
}

// A copy that is not read yet is taken back, once the window is gone.
TEST_F(MainWindowTest, AWindowMayCloseWhileACopyIsRead) {
    editor.beginSession();
    open();
    SceneDocument& document = editor.document();
    const std::string before = document.text();
    const QString label = document.undoLabel();
    document.select({{editing::Kind::body, 0}});
    for (const char* pane : {"properties", "text"}) {
        QPointer<GraphicalViewer> second = editor.openGraphicalViewer();
        second->panes().show(pane);
        made.readsSlowly = true;
        if (auto* values = second->findChild<PropertiesPane*>()) {
            QTest::mouseClick(values->findChild<QPushButton*>("duplicate"), Qt::LeftButton);
        } else {
            auto* commands = second->findChild<ElementCommands*>({}, Qt::FindDirectChildrenOnly);
            ASSERT_NE(commands, nullptr);
            commands->duplicate();
        }
        EXPECT_NE(document.text(), before) << pane;
        EXPECT_TRUE(second->close());
        EXPECT_TRUE(waitFor([&] { return !second && document.text() == before; })) << pane;
        made.readsSlowly = false;
        ASSERT_TRUE(settle(document));
        EXPECT_EQ(document.undoLabel(), label) << pane;
    }
}

TEST_F(MainWindowTest, ClosingOneClosesThatOneAndTheLastAsks) {
    editor.beginSession();
    GraphicalViewer& first = open();
    GraphicalViewer* second = editor.openGraphicalViewer();
    editor.openShapeEditor();
    EXPECT_TRUE(second->close());
    EXPECT_EQ(asked, 0);
    EXPECT_TRUE(first.isVisible());
    first.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&first, longestWait));
    answer("Cancel");
    EXPECT_FALSE(first.close());
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(first.isVisible());
    answer("Discard");
    EXPECT_TRUE(first.close());
    EXPECT_EQ(asked, 2);
    for (const QWidget* one : QApplication::topLevelWidgets())
        EXPECT_FALSE(one->isVisible() && qobject_cast<const QMainWindow*>(one))
            << one->windowTitle().toStdString();
}

TEST_F(MainWindowTest, SavingTakesWhatIsTyped) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scene.al");
    SceneFiles& files = editor.beginSession();
    ASSERT_EQ(editor.document().save(path).sentence, "");
    GraphicalViewer& viewer = open();
    viewer.text()->editor().setText(QString::fromStdString("# mine\n" + ballScene));
    EXPECT_TRUE(files.save());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().toStdString(), "# mine\n" + ballScene);
    EXPECT_FALSE(viewer.text()->hasDraft());
}

TEST_F(MainWindowTest, SavingAndQuittingTakeAValueThatIsTyped) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scene.al");
    editor.beginSession();
    ASSERT_EQ(editor.document().save(path).sentence, "");
    GraphicalViewer& viewer = open();
    editor.document().select({{editing::Kind::body, 0}});
    viewer.panes().show("properties");
    typeMass(viewer, "5");
    QTest::keyClick(viewer.focusWidget(), Qt::Key_S, Qt::ControlModifier);
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_THAT(file.readAll().toStdString(), HasSubstr("-mass 5"));
    EXPECT_FALSE(editor.document().isModified());
    typeMass(viewer, "6");
    answer("Cancel"); // that it is not saved
    QTest::keyClick(viewer.focusWidget(), Qt::Key_Q, Qt::ControlModifier);
    EXPECT_EQ(asked, 1);
    EXPECT_THAT(editor.document().text(), HasSubstr("-mass 6"));
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    typeMass(viewer, "heavy");
    answer("No"); // that it is not taken
    QTest::keyClick(viewer.focusWidget(), Qt::Key_Q, Qt::ControlModifier);
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(viewer.isVisible());
    EXPECT_FALSE(editor.document().isModified());
}

// The window that one left the scene from closes before the question is put, and somebody presses
// New once more meanwhile.
TEST_F(MainWindowTest, AWindowMayCloseWhileASceneIsLeft) {
    SceneDocument& document = editor.document();
    document.setText("# mine\n" + ballScene, "Edit");
    auto* window = new QWidget;
    window->show();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window, longestWait));
    SceneFiles* again = nullptr;
    const auto meanwhile = [&] {
        EXPECT_FALSE(again->newScene());
        delete window;
        return true;
    };
    SceneFiles files(document, {meanwhile, [] { return true; }});
    again = &files;
    answer("Discard");
    EXPECT_TRUE(files.newScene());
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(document.text(), "");
}

TEST_F(MainWindowTest, QuittingEndsTheFirstPageTooFromEitherWindow) {
    SceneFiles& files = editor.beginSession();
    Starting starting(editor, files);
    for (const bool fromPage : {false, true}) {
        editor.document().reset();
        const QPointer<QWidget> viewer = &open(), page = starting.showFirstPage();
        QWidget* from = fromPage ? page : viewer;
        from->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(from, longestWait));
        QTest::keyClick(from, Qt::Key_Q, Qt::ControlModifier);
        for (const auto& window : {viewer, page})
            EXPECT_TRUE(waitFor([&] { return !window || !window->isVisible(); }));
    }
}

} // namespace
} // namespace views
