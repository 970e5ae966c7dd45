// What teachers wanted of the windows: a floor's size and its being fixed, plots that are refused
// or told apart, keys that every window has, and what is typed without Return.
#include "charts/scale.h"
#include "frame/manual_window.h"
#include "frame/typed_field.h"
#include "plots/plot_dialog.h"
#include "plots/plots_panel.h"
#include "shapes/shape_editor.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include "simulation/simulation.h"

#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTextBlock>
#include <QTextBrowser>

#include <gmock/gmock.h>

namespace views {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;

const std::string flooring = "simulator -finish 2\n"
                             "shape_set block -desc {-sub {-box {1 1 1}}} ;# the floor\n"
                             "body floor block -init_pos {0 0 0}\n";

class WindowsTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void open(const std::string& scene) {
        editor.document().setText(scene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        viewer->display().lookAlong(Vector::UnitZ());
        viewer->display().grab();
    }
    SceneDisplay& display() { return viewer->display(); }
    const std::string& text() { return editor.document().text(); }
    QPoint pixels(const Vector& world) {
        return display().fromPixels(display().sight().pixels(world)).toPoint();
    }
    QString undone() { return editor.document().undoLabel(); }
    static QAction* action(QWidget& window, const QString& begins) {
        for (QAction* one : window.findChildren<QAction*>())
            if (one->text().remove('&').startsWith(begins))
                return one;
        return nullptr;
    }
    // By the menu Edit, when it opens.
    bool isOffered(const QString& begins) {
        Q_EMIT viewer->menuBar()->actions().at(1)->menu()->aboutToShow();
        return action(*viewer, begins)->isEnabled();
    }
    QMenu* menuOf(std::size_t which) {
        menu = elementMenu(editor.document(), display(),
                           {{}, editing::Element{editing::Kind::body, which}, {}}, {});
        return menu.get();
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
    std::unique_ptr<QMenu> menu;
};

TEST_F(WindowsTest, TheSelectedAreCopiedAndCutByMenusAndAllAreSelected) {
    open(ballScene);
    menuOf(0);
    EXPECT_EQ(action(*menu, "Copy"), nullptr); // a menu without a window
    display().selecting().selectAll();
    const auto all = editor.document().selected();
    EXPECT_EQ(all.size(), editor.document().shown().scene->bodies.size());
    action(*viewer, "Cut")->trigger();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(editor.document().shown().scene->bodies.empty()) << text();
    Q_EMIT display().menuWanted({QPointF(5, 5), {}, {}});
    QMenu* background = nullptr;
    EXPECT_TRUE(waitFor([&] {
        background = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        return background != nullptr;
    }));
    ASSERT_NE(action(*background, "Paste"), nullptr);
    action(*background, "Paste")->trigger();
    background->close();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().shown().scene->bodies.size(), all.size());
    editor.document().select({});
    action(*viewer, "Select All")->trigger();
    EXPECT_EQ(editor.document().selected().size(), all.size());
}

// A pane of faults has its words beside no other pane.
TEST_F(WindowsTest, PanesStandAsAtFirstAgain) {
    open(ballScene);
    viewer->resize(1200, 760);
    viewer->showUsualPanes();
    const auto shown = [this] {
        QStringList all;
        for (const char* one : {"text", "status", "plots", "properties", "sceneList", "faults"})
            if (viewer->panes().isShown(one))
                all << one;
        return all;
    };
    const QStringList before = shown();
    viewer->panes().show("plots");
    viewer->panes().show("faults");
    auto* plots = viewer->findChild<QDockWidget*>("pane.plots");
    auto* faults = viewer->findChild<QDockWidget*>("pane.faults");
    EXPECT_TRUE(viewer->tabifiedDockWidgets(plots).contains(faults));
    viewer->panes().hide("text");
    viewer->addDockWidget(Qt::TopDockWidgetArea,
                          viewer->findChild<QDockWidget*>("pane.properties"));
    action(*viewer, "As at First")->trigger();
    EXPECT_EQ(shown(), before);
    EXPECT_EQ(viewer->dockWidgetArea(viewer->findChild<QDockWidget*>("pane.properties")),
              Qt::RightDockWidgetArea);
}

// One of two bodies stops at 1.2 s of 2: nothing says that all is computed, and right throughout.
TEST_F(WindowsTest, TheStatusOfAStoppedMotionAgreesWithItself) {
    Workshop workshop = made.workshop();
    workshop.simulate = [](const std::shared_ptr<const scene::Scene>& scene,
                           const simulation::Options& options,
                           const simulation::Observer& observer) {
        return simulation::simulate(*scene, options, observer);
    };
    Editor moving(workshop);
    moving.document().setText(
        "simulator -finish 2 -collisions 0\nshape_set s -desc {-sub {-sphere 0.1}}\nbody a s "
        "-mass 1\n"
        "body b s -mass 1 -init_pos {3 0 0}\nforce -body a -x {sqrt(1.2-t)}\n",
        "Edit");
    ASSERT_TRUE(settle(moving.document()));
    GraphicalViewer* shown = moving.openGraphicalViewer();
    const auto said = [&](const char* name) {
        for (const QLabel* label : shown->findChildren<QLabel*>())
            if (label->accessibleName() == QLatin1String(name))
                return label->text();
        return QString();
    };
    EXPECT_EQ(said("Computed"), "to 1.200 s");
    EXPECT_EQ(said("Reliable"), "to 1.200 s");
    EXPECT_NEAR(shown->times().bar().computed(), 1.2, 1e-3); // not to the end, as if all were known
}

TEST_F(WindowsTest, AFloorIsFixedAndFreedByAClick) {
    open(flooring);
    editor.document().select({{editing::Kind::body, 0}});
    QAction* fix = action(*menuOf(0), "Fixed");
    ASSERT_TRUE(fix && !fix->isChecked());
    fix->trigger();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(text(), flooring.substr(0, flooring.size() - 1) + " -fixed 1\n");
    EXPECT_EQ(undone(), "Fix floor");
    QAction* fixed = action(*menuOf(0), "Fixed");
    ASSERT_TRUE(fixed && fixed->isChecked());
    fixed->trigger();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(text(), HasSubstr("-fixed 0"));
    EXPECT_EQ(undone(), "Let floor Move");
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), flooring);
}

TEST_F(WindowsTest, WhatALoopFixesIsOffered) {
    open("shape_set s -desc {-sub {-sphere 0.5}}\n"
         "foreach i {1 2 3} {body b$i s -init_pos \"$i 0 0\"}\n");
    display().editing().setFixed(1, true);
    ASSERT_TRUE(display().editing().entry());
    QPushButton* only = nullptr;
    for (QPushButton* one : display().editing().entry()->findChildren<QPushButton*>())
        if (one->text() == "Only b2")
            only = one;
    ASSERT_TRUE(only);
    only->click();
    ASSERT_TRUE(settle(editor.document()));
    const auto& bodies = editor.document().shown().scene->bodies;
    EXPECT_FALSE(bodies[0].fixed);
    EXPECT_TRUE(bodies[1].fixed);
    EXPECT_FALSE(bodies[2].fixed);
}

TEST_F(WindowsTest, ABodyThatATrajectoryLeadsIsNotFixed) {
    const std::string led = flooring + "trajectory path -points {{0 0 0 0} {1 1 0 0}}\n"
                                       "constrain floor -pos path\n";
    open(led);
    display().editing().setFixed(0, true);
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("follows the trajectory path"));
    EXPECT_EQ(text(), led);
}

TEST_F(WindowsTest, ADoubleClickOnABodyAsksForItsSize) {
    open(flooring);
    QTest::mouseDClick(&display(), Qt::LeftButton, {}, pixels({0.2, 0.2, 0}));
    ValueEntry* entry = display().editing().entry();
    ASSERT_TRUE(entry);
    ASSERT_EQ(entry->fields().size(), 3U);
    entry->fields()[0]->selectAll();
    QTest::keyClicks(entry->fields()[0], "12");
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("<b>2</b>")); // behind the 1
    QTest::keyClick(entry->fields()[0], Qt::Key_Return);
    ASSERT_TRUE(settle(editor.document()));
    std::string wanted = flooring;
    wanted.replace(wanted.find("{1 1 1}"), 7, "{12 1 1}");
    EXPECT_EQ(text(), wanted);
    EXPECT_EQ(undone(), "Change the Size of block");
    action(*menuOf(0), "Size")->trigger();
    entry = display().editing().entry();
    entry->fields()[1]->selectAll();
    QTest::keyClicks(entry->fields()[1], "-3");
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("above 0"));
    QTest::keyClick(entry->fields()[1], Qt::Key_Return);
    EXPECT_EQ(text(), wanted);
}

TEST_F(WindowsTest, FrictionAndRestitutionAreAskedFor) {
    open(flooring);
    editor.document().select({{editing::Kind::body, 0}});
    action(*menuOf(0), "Surface")->trigger();
    ValueEntry* entry = display().editing().entry();
    ASSERT_TRUE(entry);
    ASSERT_EQ(entry->fields().size(), 4U);
    EXPECT_EQ(entry->fields()[0]->text(), "1");
    const auto type = [&](std::size_t field, const char* text) {
        entry->fields()[field]->selectAll();
        QTest::keyClicks(entry->fields()[field], text);
    };
    type(1, "0.5");
    type(2, "0.4");
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("at least the friction"));
    type(2, "0.6");
    QTest::keyClick(entry->fields()[2], Qt::Key_Return);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(text(),
              flooring.substr(0, flooring.size() - 1) + " -friction 0.5 -static_friction 0.6\n");
    EXPECT_EQ(undone(), "Change the Surface of floor");
    action(*menuOf(0), "Surface")->trigger();
    entry = display().editing().entry();
    type(0, "1.5");
    EXPECT_THAT(entry->saying().toStdString(), HasSubstr("from 0 to 1"));
    type(0, "0");
    QTest::keyClick(entry->fields()[0], Qt::Key_Return);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(text(), HasSubstr("-restitution 0"));
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), flooring);
}

TEST_F(WindowsTest, TheSizeOfAnotherShapeIsInTheShapeEditor) {
    open("shape_set two -desc {-sub {-sphere 0.5} -sub {-pos {1 0 0} -sphere 0.5}}\nbody b two\n");
    editor.document().select({{editing::Kind::body, 0}});
    action(*menuOf(0), "Size")->trigger();
    ShapeEditor* shapes = editor.openShapeEditor();
    EXPECT_EQ(shapes->shape(), "two");
    EXPECT_EQ(shapes->draft().size(), 2U);
    EXPECT_FALSE(display().editing().entry());
}

TEST_F(WindowsTest, WithNothingSelectedThereIsNothingToDelete) {
    open(flooring);
    EXPECT_FALSE(isOffered("Delete"));
    EXPECT_FALSE(isOffered("Exact Value"));
    editor.document().select({{editing::Kind::body, 0}});
    EXPECT_TRUE(isOffered("Delete"));
    EXPECT_TRUE(isOffered("Exact Value"));
}

TEST_F(WindowsTest, WhatIsNewHasAnExactValueAsSoonAsItIsSeen) {
    open(flooring);
    render::Display shown = display().display();
    shown.forceHandles = true;
    display().setDisplay(shown);
    WindowPicture::setPatience({}); // its handle is known later than the scene
    display().editing().expect({{editing::Kind::force, 0}});
    editor.document().setText(text() + "force -body floor -gravitational {0 -1 0}\n", "Edit");
    EXPECT_TRUE(waitFor([&] {
        display().grab();
        return display().editing().marked().has_value();
    }));
    WindowPicture::setPatience(std::chrono::seconds(60));
    EXPECT_TRUE(isOffered("Exact Value"));
}

TEST_F(WindowsTest, TheFirstBodyStandsWhereOneClickedAndThePictureStays) {
    open("# nothing yet\n");
    const QPoint at = display().rect().center() + QPoint(60, -40);
    display().creating().start(newBody(BasicShape::sphere));
    QTest::mouseClick(&display(), Qt::LeftButton, {}, at);
    ASSERT_TRUE(settle(editor.document()));
    display().grab();
    const auto& bodies = editor.document().shown().scene->bodies;
    ASSERT_EQ(bodies.size(), 1U);
    EXPECT_LT((pixels(bodies[0].initialPosition) - at).manhattanLength(),
              21); // at round numbers
}

// A quick hand chooses from Create before the window has a picture.
TEST_F(WindowsTest, TheFirstBodyLeavesThePictureThatItWasPutIn) {
    open("# nothing yet\n");
    GraphicalViewer* quick = editor.openGraphicalViewer();
    ASSERT_EQ(quick->display().showsScene(), false);
    quick->display().creating().start(newBody(BasicShape::sphere));
    quick->display().grab();
    const render::Camera before = quick->display().camera();
    QTest::mouseClick(&quick->display(), Qt::LeftButton, {},
                      quick->display().rect().center() + QPoint(60, -40));
    ASSERT_TRUE(settle(editor.document()));
    quick->display().grab();
    EXPECT_EQ(editor.document().shown().scene->bodies.size(), 1U);
    EXPECT_TRUE(quick->display().camera() == before);
}

TEST_F(WindowsTest, ThePanelStaysAsItIsWhileASliderIsDragged) {
    open("parameter rhythm -value 3 -min 0 -max 6 -unit rad/s -label {Rhythm of the push}\n" +
         flooring);
    QSlider* slider = nullptr;
    for (QSlider* one : viewer->findChildren<QSlider*>())
        if (one->accessibleName() == "Rhythm of the push")
            slider = one;
    ASSERT_TRUE(slider);
    const auto place = [&] {
        QCoreApplication::processEvents();
        viewer->grab();
        return slider->mapTo(viewer, QPoint(0, 0));
    };
    const QPoint before = place();
    slider->setSliderDown(true);
    for (const int position : {501, 647, 999, 0, 333}) {
        slider->setValue(position);
        ASSERT_TRUE(settle(editor.document()));
        EXPECT_EQ(place(), before) << position;
    }
    slider->setSliderDown(false);
}

// --- plots -----------------------------------------------------------------------------------

TEST_F(WindowsTest, APlotOfNothingIsRefusedWhereItIsAskedFor) {
    open(flooring);
    PlotDialog dialog(editor.document().shown(), viewer);
    auto* field = dialog.findChild<QLineEdit*>();
    EXPECT_EQ(field->text(), "floor.y");
    for (const auto& [typed, why] :
         {std::pair("floor.q", "q"), std::pair("flor.y", "floor"), std::pair("1 +", ""),
          std::pair("[exit]", "brackets"), std::pair("", "An expression, please")}) {
        field->setText(typed);
        dialog.accept();
        EXPECT_NE(dialog.result(), QDialog::Accepted) << typed;
        QString said;
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            said += label->buddy() ? QString() : label->text();
        EXPECT_FALSE(said.isEmpty()) << typed;
        EXPECT_TRUE(said.contains(why)) << typed << ": " << said.toStdString();
    }
    field->setText(" floor.y + 2 * scene.energy ");
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(dialog.expression(), "floor.y + 2 * scene.energy");
}

TEST_F(WindowsTest, APlotHasItsPlaceBeforeItsValues) {
    made.blocked = true;
    std::string many = flooring;
    for (int i = 0; i < 9; ++i)
        many += "plot p" + std::to_string(i) + " -values floor.y\n";
    editor.document().setText(many, "Edit");
    ASSERT_TRUE(waitFor([&] { return editor.document().shown().scene->plots.size() == 9; }));
    PlotsPanel* window = editor.openPlots();
    EXPECT_EQ(window->charts().size(), 9U);
    EXPECT_EQ(window->charts()[8]->plot().title, "p8");
    EXPECT_LT(window->height(), 800); // they scroll
    made.blocked = false;
    EXPECT_TRUE(settle(editor.document()));
}

TEST_F(WindowsTest, WhatHardlyChangesIsAChartOfItsChange) {
    PlotChart chart;
    chart.resize(500, 300);
    charts::Plot plot;
    plot.times = {0, 1, 2};
    plot.curves.push_back({"energy", {1, 1.0001, 1.0002}});
    chart.setPlot(plot, 0, 2);
    EXPECT_LT(chart.axes().high - chart.axes().low, 3e-4);
    EXPECT_GT(chart.placeOf(0, 1).y() - chart.placeOf(2, 1.0002).y(), 100);
    EXPECT_THAT(chart.readingAt(chart.placeOf(2, 1)).toStdString(), HasSubstr("1.0002"));
    EXPECT_EQ(charts::digitsFor(1, 1e-10), 11);
    EXPECT_EQ(charts::digitsFor(0, 1e-10), 6);
}

// --- windows ---------------------------------------------------------------------------------

TEST_F(WindowsTest, TheManualClosesByItsKey) {
    auto* manual = new ManualWindow(QStringLiteral("# A\n\nx\n\n## B\n\ny\n"));
    const QPointer<ManualWindow> gone = manual;
    manual->show();
    QTest::keyClick(manual, Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !gone; }));
}

TEST_F(WindowsTest, TheManualIsFoundThrough) {
    ManualWindow manual(QStringLiteral(
        "# Editing\n\nA ball.\n\n## Shapes\n\n| | |\n|---|---|\n| drag | moves a Ball |\n"));
    manual.setAttribute(Qt::WA_DeleteOnClose, false);
    ASSERT_EQ(manual.chapters().count(), 2);
    EXPECT_EQ(manual.chapters().item(1)->text().trimmed(), "Shapes");
    manual.goTo("Shapes");
    EXPECT_EQ(manual.text().textCursor().block().text(), "Shapes");
    EXPECT_TRUE(manual.find("ball"));
    EXPECT_EQ(manual.text().textCursor().block().text(), "moves a Ball");
    EXPECT_TRUE(manual.find("ball")); // around the end
    EXPECT_EQ(manual.text().textCursor().block().text(), "A ball.");
    EXPECT_TRUE(manual.find("ball", true));
    EXPECT_EQ(manual.text().textCursor().block().text(), "moves a Ball");
    EXPECT_FALSE(manual.find("sphere"));
    EXPECT_EQ(manual.text().textCursor().block().text(), "moves a Ball");
    EXPECT_FALSE(manual.text().toPlainText().contains("\n\n\n")); // no empty row begins a table
}

// --- the fields of the motion ----------------------------------------------------------------

class SpanTest : public WindowsTest {
protected:
    QLineEdit* end(QWidget& window) {
        for (QLineEdit* one : window.findChildren<QLineEdit*>())
            if (one->accessibleName() == "End of the motion")
                return one;
        return nullptr;
    }
    void type(QWidget& window, const char* value) {
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window, longestWait));
        end(window)->setFocus();
        end(window)->selectAll();
        QTest::keyClicks(end(window), value);
    }
};

TEST_F(SpanTest, WhatIsTypedIsTakenBeforeAnythingElseIsDone) {
    open(flooring);
    type(*viewer, "7");
    QToolButton* play = nullptr;
    for (QToolButton* one : viewer->findChildren<QToolButton*>())
        if (one->accessibleName() == "Play or pause")
            play = one;
    ASSERT_TRUE(play);
    QTest::mouseClick(play, Qt::LeftButton);
    EXPECT_TRUE(viewer->playback().isPlaying());
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().shown().scene->simulator.finish, 7);
    EXPECT_EQ(viewer->playback().finish(), 7);
    EXPECT_EQ(viewer->focusWidget(), &display());
}

TEST_F(SpanTest, AKeyThatIsACommandTakesItToo) {
    open(flooring);
    type(*viewer, "9");
    QTest::keyClick(viewer->focusWidget(), Qt::Key_F5);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(editor.document().shown().scene->simulator.finish, 9);
    type(*viewer, "11");
    EXPECT_EQ(TypedField::settleAll(editor.document()), ""); // as Save, Quit and New Scene do
    EXPECT_THAT(text(), HasSubstr("-finish 11"));
}

TEST_F(SpanTest, TheSameAgainIsNoEditAndUndoIsTheScenes) {
    open("body_less ;# a fault\n");
    editor.document().setText("# empty\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(qobject_cast<QLineEdit*>(viewer->focusWidget()));
    type(*viewer, "10");
    QTest::keyClick(end(*viewer), Qt::Key_Return);
    EXPECT_EQ(text(), "# empty\n"); // ten seconds it had before
    end(*viewer)->setFocus();
    QTest::keyClick(end(*viewer), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text(), "body_less ;# a fault\n");
}

// --- menus -------------------------------------------------------------------------------------

TEST_F(WindowsTest, AMenuStaysWhileItsBodyDoes) {
    open(flooring);
    QMenu* of = menuOf(0);
    of->popup(viewer->mapToGlobal(QPoint(50, 50)));
    editor.document().setText(flooring + "# slower\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(of->isVisible());
    editor.document().setText("# nothing\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(of->isVisible());
}

TEST_F(WindowsTest, AJointIsChartedByOneClick) {
    const std::string pendulum =
        "shape_set s -desc {-sub {-sphere 0.1}}\n"
        "body bob s -mass 1 -init_pos {1 0 0}\n"
        "joint pivot -type hinge -body1 bob -offset1 {-1 0 0} -axis {0 0 1}\n";
    open(pendulum);
    const MenuPlace sign = menuPlaceAt(editor.document(), display(), pixels({0.02, 0, 0}));
    EXPECT_EQ(sign.element, (editing::Element{editing::Kind::joint, 0}));
    menu = elementMenu(editor.document(), display(), sign, {});
    QMenu* charts = action(*menu, "New Plot")->menu();
    ASSERT_EQ(charts->actions().size(), 5);
    charts->actions()[0]->trigger();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(text(), pendulum + "\nplot plot1 -values {{atan2(bob.x - pivot.px, pivot.py - "
                                 "bob.y)}} -labels {{angle of pivot}}\n");
    charts->actions()[3]->trigger();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_THAT(text(), HasSubstr("{{hypot(pivot.fx, pivot.fy, pivot.fz)}}"));
    ASSERT_EQ(editor.document().shown().scene->plots.size(), 2U);
    editor.document().undo();
    editor.document().undo();
    EXPECT_EQ(text(), pendulum);
}

// --- no crash --------------------------------------------------------------------------------

TEST_F(WindowsTest, AViewerGoesWithItsOpenMenu) {
    open(flooring);
    const QPointer<GraphicalViewer> gone = viewer;
    QTest::mouseClick(&display(), Qt::RightButton, {}, pixels({0, 0, 0}));
    EXPECT_TRUE(QApplication::activePopupWidget());
    viewer->close();
    EXPECT_TRUE(waitFor([&] { return !gone; }));
    EXPECT_FALSE(QApplication::activePopupWidget());
}

TEST_F(WindowsTest, UnderADocumentSavingSaysWhere) {
    HostLink link;
    link.changed = [](const text::Edit&, const QString&) {};
    editor.document().setHostLink(link);
    viewer = editor.openGraphicalViewer();
    QAction* save = action(*viewer, "Save");
    ASSERT_TRUE(save);
    EXPECT_EQ(save->shortcut(), QKeySequence(QKeySequence::Save));
    save->trigger();
    EXPECT_THAT(display().editing().said().toStdString(), HasSubstr("saved in its own window"));
    EXPECT_FALSE(action(*viewer, "Quit")); // the document's window decides
}

} // namespace
} // namespace views
