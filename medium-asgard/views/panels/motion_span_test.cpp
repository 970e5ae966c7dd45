// (text, what is typed into a field, text), and what a field says that cannot be.
#include "frame/manual.h"
#include "frame/manual_window.h"
#include "panels/motion_span.h"
#include "shapes/shape_editor.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolTip>
#include <QVBoxLayout>

#include <gmock/gmock.h>

namespace views {
namespace {

using ::testing::HasSubstr;

class MotionSpanTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    QLineEdit* field(const char* name) {
        for (QLineEdit* one : span.findChildren<QLineEdit*>())
            if (one->accessibleName() == name)
                return one;
        return nullptr;
    }
    void enter(const char* name, const char* value) {
        QLineEdit* one = field(name);
        one->selectAll();
        QTest::keyClicks(one, value);
        QTest::keyClick(one, Qt::Key_Return);
    }
    // The text after a value was typed into the field.
    std::string after(const std::string& text, const char* name, const char* value) {
        document.setText(text, "Edit");
        EXPECT_TRUE(settle(document));
        enter(name, value);
        EXPECT_TRUE(settle(document));
        refusal = field(name)->property("refusal").toString().toStdString();
        return document.text();
    }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    MotionSpan span{document};
    std::string refusal;
};

constexpr const char* finish = "End of the motion";
constexpr const char* start = "Start of the motion";

TEST_F(MotionSpanTest, TheSimulatorOfTheTextIsChangedOrMade) {
    const std::string body = "shape_set s -desc {-sub {-sphere 1}}\nbody b s\n";
    const struct {
        std::string before;
        const char *name, *value;
        std::string after;
    } rows[] = {
        {"", finish, "2", "simulator -finish 2\n"},
        {body, finish, "2.5", "simulator -finish 2.5\n" + body},
        {"# A ball\n" + body, start, "-1", "# A ball\nsimulator -start -1\n" + body},
        {"simulator -finish 2 ;# short\n" + body, finish, "3",
         "simulator -finish 3 ;# short\n" + body},
        {"simulator -accuracy 1e-6\n" + body, finish, "4",
         "simulator -accuracy 1e-6 -finish 4\n" + body},
        {"set T 5\nsimulator -finish $T\n" + body, finish, "6",
         "set T 6\nsimulator -finish $T\n" + body},
    };
    for (const auto& row : rows)
        EXPECT_EQ(after(row.before, row.name, row.value), row.after) << row.before;
    EXPECT_EQ(field(finish)->text(), "6");
    document.undo();
    EXPECT_THAT(document.text(), HasSubstr("set T 5"));
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(field(finish)->text(), "5");
}

TEST_F(MotionSpanTest, WhatCannotBeSaysWhyAndStays) {
    const std::string text = "simulator -start 1 -finish [expr 2 + 3]\n";
    const struct {
        const char *name, *value;
        std::string why;
    } rows[] = {
        {finish, "1", "The motion begins at 1 s: its end must be after that."},
        {start, "7", "The motion ends at 5 s: its start must be before that."},
        {finish, "soon", "\"soon\" is not a decimal number."},
        {finish, "8", "2 + 3"},
    };
    QString told;
    QObject::connect(&span, &MotionSpan::refused, [&](const QString& why) { told = why; });
    for (const auto& row : rows) {
        told.clear();
        EXPECT_EQ(after(text, row.name, row.value), text);
        EXPECT_THAT(refusal, HasSubstr(row.why));
        EXPECT_EQ(told.toStdString(), refusal); // in the picture
        EXPECT_EQ(field(finish)->text(), "5");
        EXPECT_EQ(field(start)->text(), "1");
    }
}

// Return gives the keyboard back to the picture.
TEST_F(MotionSpanTest, TheReasonStaysAtTheFieldThoughTheKeyboardGoesElsewhere) {
    document.setText("simulator -finish 3\n", "Edit");
    EXPECT_TRUE(settle(document));
    QWidget window;
    auto* row = new QVBoxLayout(&window);
    auto* picture = new QLineEdit;
    row->addWidget(picture);
    row->addWidget(&span);
    QObject::connect(&span, &MotionSpan::left, picture, [picture] { picture->setFocus(); });
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    field(finish)->setFocus();
    enter(finish, "-1");
    EXPECT_TRUE(waitFor([&] { return picture->hasFocus() && QToolTip::isVisible(); }));
    EXPECT_EQ(QToolTip::text(), field(finish)->property("refusal").toString());
    QToolTip::hideText();
    span.setParent(nullptr);
}

TEST_F(MotionSpanTest, EscapeLeavesItAsItWas) {
    document.setText("simulator -finish 3\n", "Edit");
    ASSERT_TRUE(settle(document));
    QLineEdit* one = field(finish);
    QTest::keyClicks(one, "77");
    QTest::keyClick(one, Qt::Key_Escape);
    EXPECT_EQ(one->text(), "3");
    EXPECT_EQ(document.text(), "simulator -finish 3\n");
}

TEST_F(MotionSpanTest, EveryWindowHasHelpThatOpensTheManualAtItsChapter) {
    Editor editor(made.workshop());
    QMainWindow* const windows[] = {editor.openGraphicalViewer(), editor.openLanguageViewer(),
                                    editor.openShapeEditor(), editor.openTrajectoryEditor()};
    for (QMainWindow* window : windows) {
        QStringList entries;
        for (const QAction* menu : window->menuBar()->actions())
            if (menu->text() == "&Help")
                for (const QAction* entry : menu->menu()->actions())
                    entries << entry->text();
        EXPECT_TRUE(entries.contains("&Manual")) << window->windowTitle().toStdString();
        EXPECT_TRUE(entries.contains("&What Is This?"));
        EXPECT_EQ(entries.size(), 3) << window->windowTitle().toStdString();
    }
    showManual("Shapes");
    QTextBrowser* manual = nullptr;
    for (QWidget* one : QApplication::topLevelWidgets())
        if (auto* browser = qobject_cast<ManualWindow*>(one))
            manual = &browser->text();
    ASSERT_NE(manual, nullptr);
    EXPECT_TRUE(waitFor([&] { return manual->textCursor().block().text() == "Shapes"; }));
    EXPECT_THAT(manual->toPlainText().toStdString(), HasSubstr("gravitational")); // the language
    manual->window()->close();
}

} // namespace
} // namespace views
