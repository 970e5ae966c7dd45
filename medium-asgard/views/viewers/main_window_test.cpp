// One window with its panes: what it opens with, what its keys mean, and how it ends.
#include "frame/help_page.h"
#include "frame/placing.h"
#include "language/scene_editor.h"
#include "panels/parameters_panel.h"
#include "plots/plots_panel.h"
#include "plots/study_window.h"
#include "shapes/shape_editor.h"
#include "start/first_page.h"
#include "trajectories/trajectory_editor.h"
#include "viewers/main_window_testing.h"
#include "viewers/scene_files.h"
#include "viewers/starting.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QToolButton>
#include <QTreeWidget>

#include <gmock/gmock.h>

#include <map>

namespace views {
namespace {

using ::testing::HasSubstr;

TEST_F(MainWindowTest, TheTourClosesWhenAnotherSceneIsOpened) {
    GraphicalViewer& viewer = open();
    viewer.showTour();
    ASSERT_TRUE(viewer.panes().isShown("tour"));
    editor.document().setText("# mine\n" + ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(viewer.panes().isShown("tour"));
    editor.document().reset(ballScene);
    EXPECT_FALSE(viewer.panes().isShown("tour"));
}

TEST_F(MainWindowTest, TheToolBarAndTheStripOfTimesHaveTheirOwnHelp) {
    const GraphicalViewer& viewer = open();
    const auto topicOf = [&](const char* name) {
        const auto* widget = viewer.findChild<QWidget*>(name);
        return widget ? helpOf(widget) : QString();
    };
    EXPECT_EQ(topicOf("tool.frameAll"), "Tools");
    EXPECT_EQ(topicOf("timeStrip"), "Strip of times");
    EXPECT_EQ(topicOf("timeBar"), "Time");
    EXPECT_EQ(topicOf("scene"), "The picture");
}

// A key of two commands in one window would call neither; of two meanings, surprise.
TEST_F(MainWindowTest, EachKeyMeansOneThingInAllWindows) {
    editor.beginSession();
    GraphicalViewer& viewer = open();
    viewer.panes().show("plots");
    QMainWindow* const windows[] = {&viewer, editor.openLanguageViewer(), editor.openShapeEditor(),
                                    editor.openTrajectoryEditor(), editor.openStudy()};
    // Words that differ for one meaning: the name of what is undone, and the object of a deletion.
    const std::map<QString, QString> same{{"Update", "Save"},
                                          {"Dismiss", "Close"},
                                          {"Larger", "Zoom In"},
                                          {"Smaller", "Zoom Out"},
                                          {"As It Was", "Whole Trajectory"}};
    std::map<QString, QString> meaning;
    for (QMainWindow* window : windows) {
        std::map<const QKeySequence, QString> inWindow;
        for (const QAction* one : window->findChildren<QAction*>()) {
            QString label = one->text().remove('&').remove(QStringLiteral("…"));
            if (const auto found = same.find(label); found != same.end())
                label = found->second;
            label = label.section(' ', 0, label.startsWith("Frame") ? 1 : 0);
            if (label.isEmpty())
                continue; // Escape, which leaves what one looks at
            for (const QKeySequence& key : one->shortcuts()) {
                EXPECT_TRUE(inWindow.emplace(key, label).second)
                    << key.toString().toStdString() << " twice in "
                    << window->windowTitle().toStdString();
                const auto [known, isNew] = meaning.emplace(key.toString(), label);
                EXPECT_EQ(known->second, label) << key.toString().toStdString();
            }
        }
    }
    EXPECT_EQ(meaning["Ctrl+N"], "New");
    EXPECT_EQ(meaning["Ctrl+W"], "Close");
    EXPECT_EQ(meaning["Ctrl+Q"], "Quit");
    EXPECT_EQ(meaning["F11"], "Full");
}

// Whichever menus were open: the keyboard is where it was, and its keys do what they say.
TEST_F(MainWindowTest, EscapeLeavesEachMenuAndTheKeysStay) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("scene.al");
    editor.beginSession();
    ASSERT_EQ(editor.document().save(path).sentence, "");
    GraphicalViewer& viewer = open();
    ASSERT_NE(viewer.text(), nullptr); // whose menus the window has, too
    viewer.display().setFocus();
    QMenuBar& bar = *viewer.menuBar();
    for (QAction* entry : bar.actions()) {
        if (!entry->isVisible())
            continue;
        const std::string title = entry->text().toStdString();
        QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.actionGeometry(entry).center());
        ASSERT_TRUE(waitFor([&] { return entry->menu()->isVisible(); })) << title;
        QTest::keyClick(entry->menu(), Qt::Key_Escape);
        ASSERT_TRUE(waitFor([&] { return viewer.focusWidget() == &viewer.display(); })) << title;
        EXPECT_EQ(bar.activeAction(), nullptr) << title;
        std::map<QKeySequence, const QAction*> owners;
        for (const QAction* one : viewer.findChildren<QAction*>())
            for (const QKeySequence& key : one->shortcuts())
                if (one->isEnabled() && one->isVisible()) {
                    EXPECT_TRUE(owners.emplace(key, one).second)
                        << key.toString().toStdString() << " twice after " << title;
                }
        editor.document().setText("# " + title + "\n" + editor.document().text(), "Edit");
        QTest::keyClick(viewer.focusWidget(), Qt::Key_S, Qt::ControlModifier);
        EXPECT_FALSE(editor.document().isModified()) << title;
    }
}

TEST_F(MainWindowTest, EveryWindowHasTheCommandsOfTheFile) {
    editor.beginSession();
    for (QMainWindow* window : std::initializer_list<QMainWindow*>{
             &open(), editor.openLanguageViewer(), editor.openShapeEditor(),
             editor.openTrajectoryEditor(), editor.openStudy()}) {
        const QStringList entries = fileMenu(*window);
        for (const char* wanted :
             {"New Scene", "Open", "Open Recent", "Save", "Save As", "Export", "Quit"})
            EXPECT_EQ(entries.count(wanted), 1)
                << wanted << " in " << entries.join(", ").toStdString();
        EXPECT_EQ(entries.back(), "Quit");
    }
}

TEST_F(MainWindowTest, UnderAHostTheDocumentHasTheFile) {
    HostLink link;
    link.changed = [](const text::Edit&, const QString&) {};
    editor.document().setHostLink(link);
    const QStringList entries = fileMenu(open());
    EXPECT_FALSE(entries.contains("Open"));
    EXPECT_FALSE(entries.contains("Quit"));
}

TEST_F(MainWindowTest, ThePaneOfTheTextTakesItsKeysAndLeavesTheOthers) {
    GraphicalViewer& viewer = open();
    ASSERT_NE(viewer.text(), nullptr);
    viewer.showText();
    SceneEditor& text = viewer.text()->editor();
    ASSERT_TRUE(text.hasFocus());
    QTest::keyClick(&text, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClicks(&text, "# a");
    EXPECT_TRUE(viewer.text()->hasDraft());
    EXPECT_FALSE(viewer.playback().isPlaying()); // the space was typed
    const int before = made.simulations;
    QTest::keyClick(&text, Qt::Key_F5);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(made.simulations, before + 1);
    action(viewer, "Undo")->trigger(); // of the window: what was typed goes first
    EXPECT_FALSE(viewer.text()->hasDraft());
    EXPECT_EQ(editor.document().text(), ballScene);
    QTest::keyClicks(&text, "#");
    QTest::keyClick(&text, Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(editor.document().text(), "#" + ballScene);
    QTest::keyClick(&text, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(editor.document().text(), ballScene);
    QTest::keyClick(&text, Qt::Key_F6);
    EXPECT_TRUE(viewer.display().hasFocus());
}

// A window on a small screen has its panes behind each other at one side.
TEST_F(MainWindowTest, ANarrowWindowHasOneColumnOfPanes) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->resize(750, 470);
    viewer->showUsualPanes();
    viewer->show();
    QCoreApplication::processEvents();
    const auto side = [&](const char* pane) {
        return viewer->dockWidgetArea(viewer->findChild<QDockWidget*>(pane));
    };
    EXPECT_EQ(side("pane.text"), side("pane.properties"));
    EXPECT_EQ(side("pane.status"), side("pane.properties"));
    EXPECT_FALSE(viewer->panes().isShown("sceneList"));
}

// The second of two clicks means what the first one saw.
TEST_F(MainWindowTest, ThePictureStaysWhereItIsWhateverIsSelected) {
    editor.document().setText(ballScene + "body other ball -init_pos {3 0 0}\n"
                                          "joint j -type hinge -body1 b1\n"
                                          "force -body b1 -gravitational {0 -9.81 0}\n"
                                          "light -pos {1 2 3}\n"
                                          "rope r -points {b1 {0 5 0} other}\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer& viewer = open();
    const auto seen = [&] {
        QTest::qWait(60); // longer than Properties waits
        return QRect(viewer.display().mapTo(&viewer, QPoint(0, 0)), viewer.display().size());
    };
    const QRect before = seen();
    for (const editing::Kind kind :
         {editing::Kind::body, editing::Kind::joint, editing::Kind::force, editing::Kind::light,
          editing::Kind::rope, editing::Kind::shapeSet}) {
        editor.document().select({{kind, 0}});
        EXPECT_EQ(seen(), before) << static_cast<int>(kind);
    }
    viewer.display().pointing().moveTo(viewer.display().rect().center(), Qt::NoModifier);
    EXPECT_EQ(seen(), before);
}

// At no moment of the motion a button is elsewhere, nor another one folds: 10.00 s is longer than
// 9.99 s.
TEST_F(MainWindowTest, TheButtonsOfTheTimeStayWhereTheyAreAtEachTime) {
    std::string longer = ballScene;
    longer.replace(longer.find("-finish 2"), 9, "-finish 10");
    editor.document().setText(longer, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer& viewer = open();
    TimeControls& controls = viewer.times().controls();
    const auto places = [&] {
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        std::vector<std::pair<QString, QRect>> all;
        for (const QToolButton* one : controls.findChildren<QToolButton*>())
            if (one->isVisible())
                all.emplace_back(one->objectName(), one->geometry());
        return all;
    };
    for (int width = 1400; width > 700; width -= 8) {
        viewer.resize(width, 760);
        viewer.playback().seek(0);
        const auto before = places();
        viewer.playback().seek(10);
        ASSERT_EQ(viewer.playback().time(), 10);
        ASSERT_EQ(places(), before) << width;
    }
}

// 750 points are what a screen of 1500 pixels has at scale 2.
TEST_F(MainWindowTest, TheWindowFitsASmallScreen) {
    editor.document().setText(
        "parameter pull -value 1 -label {The pull of the spring}\n" + ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openMainWindow();
    viewer->resize(700, 450);
    viewer->showUsualPanes();
    editor.document().select({{editing::Kind::body, 0}});
    ASSERT_TRUE(QTest::qWaitForWindowExposed(viewer, longestWait));
    EXPECT_LE(viewer->minimumSizeHint().width(), 700);
    EXPECT_LE(viewer->minimumSizeHint().height(), 450);
    EXPECT_EQ(viewer->size(), QSize(700, 450));
}

// What was arranged on a large screen is arranged anew on a small one.
TEST_F(MainWindowTest, AnArrangementThatIsTooLargeForTheScreenIsLeft) {
    GraphicalViewer& viewer = open();
    viewer.resize(1600, 1000);
    for (const char* one : {"text", "sceneList", "status", "properties", "plots", "faults"})
        viewer.panes().show(one);
    const QByteArray kept = viewer.panes().arrangement();
    const QSize least = viewer.minimumSizeHint();
    EXPECT_TRUE(viewer.panes().restore(kept, least));
    EXPECT_TRUE(viewer.panes().isShown("plots"));
    EXPECT_FALSE(viewer.panes().restore(kept, least - QSize(1, 0)));
    for (const char* one : {"text", "sceneList", "status", "properties", "plots", "faults"})
        EXPECT_FALSE(viewer.panes().isShown(one)) << one;
}

TEST_F(MainWindowTest, AWindowThatIsArrangedAnewFitsItsScreen) {
    GraphicalViewer& viewer = open();
    viewer.resize(3000, 1000);
    QDockWidget* before = nullptr;
    for (const char* one : {"text", "sceneList", "status", "properties", "plots", "faults"}) {
        viewer.panes().show(one);
        auto* dock = viewer.findChild<QDockWidget*>(QStringLiteral("pane.") + one);
        if (before)
            viewer.splitDockWidget(before, dock, Qt::Horizontal);
        before = dock;
    }
    QCoreApplication::processEvents();
    const QSize room = viewer.screen()->availableSize();
    ASSERT_GT(viewer.minimumSizeHint().width(), room.width());
    const QByteArray kept = viewer.panes().arrangement();
    GraphicalViewer* next = editor.openGraphicalViewer();
    next->resize(room - QSize(40, 60));
    next->arrange(kept);
    QCoreApplication::processEvents();
    EXPECT_LE(next->width(), room.width());
    EXPECT_LE(next->geometry().right(), next->screen()->availableGeometry().right());
    EXPECT_TRUE(next->panes().isShown("status"));
}

// An arrangement and a place of a large screen come back on a small one: its frame has room, too.
TEST_F(MainWindowTest, TheTitleOfAWindowThatComesBackIsOnTheScreen) {
    QSettings().remove("mainWindow");
    {
        Editor first(made.workshop());
        GraphicalViewer* viewer = first.openMainWindow();
        viewer->panes().show("plots");
        viewer->resize(viewer->screen()->availableSize() + QSize(400, 300));
        viewer->move(viewer->screen()->availableGeometry().topLeft() - QPoint(20, 40));
        viewer->close();
    }
    Editor next(made.workshop());
    GraphicalViewer* viewer = next.openMainWindow();
    QCoreApplication::processEvents();
    const QRect screen = viewer->screen()->availableGeometry();
    EXPECT_TRUE(screen.contains(viewer->frameGeometry()))
        << viewer->frameGeometry().top() << " to " << viewer->frameGeometry().bottom();
    QSettings().remove("mainWindow");
}

TEST_F(MainWindowTest, WhatIsArrangedAnewHasItsSliders) {
    GraphicalViewer& viewer = open();
    viewer.resize(1600, 1000);
    editor.document().setText("parameter pull -value 1\n" + ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    auto* sliders = viewer.findChild<QDockWidget*>("pane.parameters");
    sliders->setFloating(true);
    const QByteArray kept = viewer.panes().arrangement();
    EXPECT_FALSE(viewer.panes().restore(kept, QSize(10, 10)));
    EXPECT_TRUE(viewer.panes().isShown("parameters"));
    EXPECT_FALSE(sliders->isFloating());
    EXPECT_FALSE(viewer.panes().isShown("text"));
}

// The sliders are seen beside the values of the selected, while there are any.
TEST_F(MainWindowTest, SlidersHaveAPaneOfTheirOwn) {
    GraphicalViewer& viewer = open();
    EXPECT_FALSE(viewer.panes().isShown("parameters"));
    editor.document().setText("parameter pull -value 1\n" + ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(viewer.panes().isShown("parameters"));
    const QSlider* slider = viewer.findChild<ParametersPanel*>()->slider("pull");
    EXPECT_TRUE(waitFor([&] { return !slider->visibleRegion().isEmpty(); }));
    EXPECT_FALSE(viewer.panes().content("properties")->visibleRegion().isEmpty());
    viewer.panes().hide("parameters"); // the user's choice stays
    editor.document().setText("parameter pull -value 2\n" + ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_FALSE(viewer.panes().isShown("parameters"));
    editor.document().setText(ballScene, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(viewer.panes().isShown("parameters"));
}

TEST_F(MainWindowTest, PanesAreMadeWhenTheyAreShownAndRemembered) {
    GraphicalViewer* first = editor.openGraphicalViewer();
    EXPECT_EQ(first->text(), nullptr);
    EXPECT_EQ(first->panes().content("plots"), nullptr);
    first->resize(1200, 760);
    first->panes().show("plots");
    first->panes().hide("status");
    first->findChild<QDockWidget*>("pane.plots")->setFloating(true);
    const QByteArray kept = first->panes().arrangement();
    GraphicalViewer* second = editor.openGraphicalViewer();
    second->resize(1200, 760);
    ASSERT_TRUE(second->panes().restore(kept, QSize(5000, 5000)));
    EXPECT_TRUE(second->panes().isShown("plots"));
    EXPECT_FALSE(second->panes().isShown("status"));
    EXPECT_FALSE(second->panes().isShown("text"));
    EXPECT_TRUE(second->findChild<QDockWidget*>("pane.plots")->isFloating());
    EXPECT_FALSE(second->panes().restore("nonsense", QSize(5000, 5000)));
}

TEST_F(MainWindowTest, SwitchesOfWhatIsShownComeBack) {
    GraphicalViewer& viewer = open();
    viewer.switches().show(&render::Display::velocityHandles);
    viewer.switches().show(&render::Display::axes);
    viewer.findChild<QCheckBox*>("grid")->click();
    EXPECT_FALSE(viewer.display().display().grid);
    Editor next(made.workshop());
    next.restoreWindows(editor.windowsState(), {});
    ASSERT_EQ(next.graphicalViewers().size(), 1);
    const render::Display& now = next.graphicalViewers().front()->display().display();
    EXPECT_TRUE(now.velocityHandles);
    EXPECT_TRUE(now.axes);
    EXPECT_FALSE(now.grid);
    EXPECT_TRUE(now.studio);
    EXPECT_FALSE(now.forceHandles);
}

TEST_F(MainWindowTest, SwitchesThatTheUserChoseComeBackInTheNextSession) {
    QSettings().remove("mainWindow");
    {
        Editor first(made.workshop());
        GraphicalViewer* viewer = first.openMainWindow();
        viewer->findChild<QCheckBox*>("axes")->click();
        viewer->findChild<QCheckBox*>("grid")->click();
        viewer->switches().show(&render::Display::positionHandles); // as Create does
        viewer->close();
    }
    Editor next(made.workshop());
    const render::Display& now = next.openMainWindow()->display().display();
    EXPECT_TRUE(now.axes);
    EXPECT_FALSE(now.grid);
    EXPECT_FALSE(now.positionHandles);
    // A switch that another version does not know is as usual.
    next.graphicalViewers().front()->switches().setShown({"+axes", "-none"});
    EXPECT_TRUE(now.axes);
    EXPECT_TRUE(now.grid);
    QSettings().remove("mainWindow");
}

TEST_F(MainWindowTest, AViewersWindowsAndDraftsComeBack) {
    GraphicalViewer& viewer = open();
    viewer.text()->editor().setText(QString::fromStdString("# mine\n" + ballScene));
    ASSERT_TRUE(viewer.text()->hasDraft());
    const std::string state = editor.windowsState();
    Editor next(made.workshop());
    next.document().setText(ballScene, "Edit");
    ASSERT_TRUE(settle(next.document()));
    next.restoreWindows(state, "It is back.");
    ASSERT_EQ(next.graphicalViewers().size(), 1);
    LanguageViewer* text = next.graphicalViewers().front()->text();
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->draft(), "# mine\n" + ballScene);
    EXPECT_TRUE(text->hasDraft());
}

TEST_F(MainWindowTest, TheSceneListCopiesCommandsAndShowsValues) {
    GraphicalViewer& viewer = open();
    SceneDocument& document = editor.document();
    document.select({{editing::Kind::body, 0}});
    viewer.panes().show("sceneList");
    auto* list = viewer.findChild<QTreeWidget*>("elements");
    ASSERT_NE(list, nullptr);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_C, Qt::ControlModifier);
    EXPECT_THAT(QGuiApplication::clipboard()->text().toStdString(), HasSubstr("body b1 ball"));
    QTest::keyClick(list, Qt::Key_V, Qt::ControlModifier);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.undoLabel(), "Paste");
    QTest::keyClick(list, Qt::Key_D, Qt::ControlModifier);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.undoLabel(), "Duplicate");
    // An element without a handle has values, too.
    document.setText(ballScene + "parameter k -value 2\n", "Edit");
    ASSERT_TRUE(settle(document));
    viewer.panes().hide("properties");
    document.select({{editing::Kind::parameter, 0}});
    ASSERT_TRUE(waitFor(
        [&] { return !list->findItems("k", Qt::MatchExactly | Qt::MatchRecursive).isEmpty(); }));
    list->setCurrentItem(list->findItems("k", Qt::MatchExactly | Qt::MatchRecursive).front());
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_TRUE(viewer.panes().isShown("properties"));
    auto* field = qobject_cast<QLineEdit*>(viewer.focusWidget());
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->objectName(), "-value");
    const auto bodies = list->findItems("b1", Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_FALSE(bodies.isEmpty());
    list->setFocus();
    list->setCurrentItem(bodies.front());
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_EQ(viewer.focusWidget()->objectName(), "-init_pos1"); // no key changes the shape
}

TEST_F(MainWindowTest, AnotherWindowOpensBesideWhereThereIsRoom) {
    QMainWindow first, second;
    const QRect screen = first.screen()->availableGeometry();
    first.resize(screen.width() * 2 / 5, screen.height() * 2 / 3);
    first.move(screen.topLeft() + QPoint(20, 40));
    second.resize(screen.width() / 2, screen.height() / 2);
    placeBeside(second, first);
    EXPECT_FALSE(second.geometry().intersects(first.geometry()));
    EXPECT_TRUE(screen.contains(second.geometry()));
    // No room: the one in use makes some.
    QMainWindow large, third;
    large.resize(screen.size() * 9 / 10);
    large.move(screen.topLeft() + QPoint(8, 32));
    third.resize(screen.width() / 3, 300);
    placeBeside(third, large);
    EXPECT_FALSE(third.geometry().intersects(large.geometry()));
    EXPECT_TRUE(screen.contains(third.geometry()));
    EXPECT_LE(third.width(), mostBeside(large));
    // It makes none over another one: the next window is low.
    QMainWindow asks, low;
    large.show();
    asks.resize(screen.width() / 3, screen.height() * 3 / 5);
    asks.move(third.pos());
    low.resize(screen.width() / 2, screen.height());
    placeBeside(low, asks);
    EXPECT_FALSE(asks.geometry().intersects(large.geometry()));
    EXPECT_FALSE(low.geometry().intersects(asks.geometry()));
    EXPECT_FALSE(low.geometry().intersects(large.geometry()));
    // It cannot: both title bars are seen.
    large.setMinimumSize(screen.size() * 9 / 10);
    large.move(screen.topLeft() + QPoint(8, 32));
    placeBeside(third, large);
    EXPECT_TRUE(screen.contains(third.geometry()));
    EXPECT_GE(third.y(), large.y() + 20);
    // Of one that fills the screen the picture stays in sight, the panes are covered.
    large.showMaximized();
    placeBeside(third, large);
    EXPECT_TRUE(screen.contains(third.geometry()));
    EXPECT_GT(third.x(), screen.center().x());
}

// A figure's viewer covers no figure where the screen has room, and little of the document.
TEST(Placing, AViewerStandsBesideItsFigure) {
    const QRect room(8, 32, 1584, 960);
    const QSize size(1180, 760), least(590, 380);
    for (const QRect& figure : {QRect(60, 200, 480, 360), QRect(1000, 100, 480, 360),
                                QRect(500, 560, 700, 400), QRect(500, 40, 700, 300)}) {
        const QRect place = placeAround(figure, room, size, least);
        EXPECT_FALSE(place.intersects(figure));
        EXPECT_TRUE(room.contains(place));
        EXPECT_GE(place.width(), least.width());
        EXPECT_GE(place.height(), least.height());
    }
    // At the outer edge, as large as it is where there is room for that.
    const QRect place = placeAround({60, 200, 300, 300}, room, size, least);
    EXPECT_EQ(place.size(), size);
    EXPECT_EQ(place.right(), room.right());
    // No room: what it covers is as little as can be.
    const QRect crowded = placeAround({300, 100, 1200, 800}, room, size, least);
    EXPECT_TRUE(room.contains(crowded));
    EXPECT_EQ(crowded.left(), room.left());
    EXPECT_EQ(crowded.width(), least.width());
}

} // namespace
} // namespace views
