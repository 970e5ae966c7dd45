// A scene's picture in its window: views, times, switches.
#include "surroundings/triad.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QHelpEvent>
#include <QImage>
#include <QScreen>
#include <QTest>
#include <QToolTip>

namespace views {
namespace {

class GraphicalViewerTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        editor.document().setText(ballScene, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }

    // Pixels of the picture that are not background, on a bare page.
    static int drawn(GraphicalViewer& viewer) {
        render::Display page = viewer.display().display();
        page.studio = page.triad = false;
        viewer.display().setDisplay(page);
        const QImage image = viewer.display().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += (image.pixel(x, y) & 0xFFFFFF) != 0xFFFFFF ? 1 : 0;
        return count;
    }

    TestWorkshop made;
    Editor editor{made.workshop()};
};

TEST_F(GraphicalViewerTest, AGraphicalViewerShowsTheSceneAndItsLength) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    EXPECT_EQ(viewer->playback().finish(), 2);
    EXPECT_GT(drawn(*viewer), 300);
    EXPECT_TRUE(viewer->windowTitle().contains("Graphical Viewer"));
}

TEST_F(GraphicalViewerTest, ViewersHaveTimesAndViewpointsOfTheirOwn) {
    GraphicalViewer* one = editor.openGraphicalViewer();
    GraphicalViewer* two = editor.openGraphicalViewer();
    one->playback().seek(1.5);
    EXPECT_EQ(two->playback().time(), 0);
    EXPECT_EQ(one->display().time(), 1.5);
    render::Camera camera = one->display().camera();
    camera.scale *= 3;
    one->display().setCamera(camera);
    two->display().grab();
    EXPECT_NE(two->display().camera().scale, camera.scale);
    // A new one begins where the last one is.
    two->playback().seek(0.5);
    EXPECT_EQ(editor.openGraphicalViewer()->playback().time(), 0.5);
}

TEST_F(GraphicalViewerTest, PlayingAdvancesTimeAndMovesThePicture) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    const QImage before = viewer->display().grab().toImage();
    double now = 0;
    viewer->playback().setClock([&] { return now; });
    viewer->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(viewer, longestWait));
    viewer->display().setFocus();
    QTest::keyClick(&viewer->display(), Qt::Key_Space);
    EXPECT_TRUE(viewer->playback().isPlaying());
    now = 1;
    ASSERT_TRUE(waitFor([&] { return viewer->playback().time() == 1; }));
    EXPECT_NE(viewer->display().grab().toImage(), before);
    QTest::keyClick(&viewer->display(), Qt::Key_Space);
    EXPECT_FALSE(viewer->playback().isPlaying());
    QTest::keyClick(&viewer->display(), Qt::Key_Home);
    EXPECT_EQ(viewer->playback().time(), 0);
    QTest::keyClick(&viewer->display(), Qt::Key_End);
    EXPECT_EQ(viewer->playback().time(), 2);
    // On a check box the space bar is the box's own.
    const auto boxes = viewer->findChildren<QCheckBox*>();
    auto* box = *std::ranges::find_if(
        boxes, [](const QCheckBox* one) { return one->isVisible() && one->isEnabled(); });
    const bool checked = box->isChecked();
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    EXPECT_NE(box->isChecked(), checked);
    EXPECT_FALSE(viewer->playback().isPlaying());
}

TEST_F(GraphicalViewerTest, TheTimeBarsLeftEdgeIsNow) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    TimeBar& bar = viewer->times().bar();
    const double begin = bar.position(0), end = bar.position(2);
    EXPECT_GT(end - begin, 200);
    viewer->playback().seek(0.5);
    // The slider, one second long, is taken in its middle and carried on by half a second.
    const double middle = bar.position(1), y = 11;
    QTest::mousePress(&bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(middle), static_cast<int>(y)));
    EXPECT_NEAR(viewer->playback().time(), 0.5, 0.02);
    QTest::mouseMove(&bar, QPoint(static_cast<int>(bar.position(1.5)), static_cast<int>(y)));
    ASSERT_TRUE(waitFor([&] { return std::abs(viewer->playback().time() - 1) < 0.02; }));
    QTest::mouseRelease(&bar, Qt::LeftButton, {},
                        QPoint(static_cast<int>(bar.position(1.5)), static_cast<int>(y)));
    // Elsewhere in the trough: its left edge comes there.
    QTest::mouseClick(&bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(bar.position(0.25)), static_cast<int>(y)));
    EXPECT_NEAR(viewer->playback().time(), 0.25, 0.02);
    // A click within it means its place, as anywhere.
    QTest::mouseClick(&bar, Qt::LeftButton, {},
                      QPoint(static_cast<int>(bar.position(0.9)), static_cast<int>(y)));
    EXPECT_NEAR(viewer->playback().time(), 0.9, 0.02);
}

TEST_F(GraphicalViewerTest, DraggingTurnsTheViewAndFrameAllKeepsTheDirection) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const render::Camera framed = viewer->display().camera();
    QTest::mousePress(&viewer->display(), Qt::LeftButton, {}, QPoint(200, 200));
    QTest::mouseMove(&viewer->display(), QPoint(260, 220));
    ASSERT_TRUE(
        waitFor([&] { return !viewer->display().camera().rotation.isApprox(framed.rotation); }));
    QTest::mouseRelease(&viewer->display(), Qt::LeftButton, {}, QPoint(260, 220));
    const render::Camera turned = viewer->display().camera();
    // An update of the scene leaves the user's viewpoint alone.
    editor.document().setText(ballScene + "# more\n", "Edit");
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    render::Camera nearer = turned;
    nearer.scale *= 7;
    viewer->display().setCamera(nearer);
    viewer->display().frameAll();
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    EXPECT_LT(viewer->display().camera().scale, 2 * framed.scale);
    // Another motion is framed from there, too; another scene from its best side.
    editor.document().recompute();
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(turned.rotation));
    editor.document().reset(ballScene);
    ASSERT_TRUE(settle(editor.document()));
    viewer->display().grab();
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(framed.rotation));
}

// Its window may have another size by then, or was told of before its first picture.
TEST_F(GraphicalViewerTest, AViewerThatOpensAgainFramesTheSceneUnlessSomebodyMovedItsView) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const std::string framing = editor.windowsState();
    render::Camera camera = viewer->display().camera();
    camera.scale *= 3;
    viewer->display().setCamera(camera);
    const std::string moved = editor.windowsState();
    const auto again = [&](const std::string& state) {
        editor.restoreWindows(state, {});
        return editor.graphicalViewers().back();
    };
    EXPECT_TRUE(again(framing)->display().framesItself());
    EXPECT_FALSE(again(moved)->display().framesItself());
    EXPECT_EQ(again(moved)->display().camera().scale, camera.scale);
}

// As where letters are large: the window stays within the screen.
TEST_F(GraphicalViewerTest, APaneWithoutRoomBelowThePictureOpensBesideIt) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->panes().show("status");
    viewer->centralWidget()->setMinimumHeight(viewer->screen()->availableGeometry().height() - 200);
    viewer->panes().show("plots");
    auto* plots = viewer->findChild<QDockWidget*>("pane.plots");
    ASSERT_NE(plots, nullptr);
    EXPECT_EQ(viewer->dockWidgetArea(plots), Qt::RightDockWidgetArea);
    EXPECT_TRUE(plots->isVisible());
    QCoreApplication::processEvents();
    EXPECT_LE(viewer->height(), viewer->screen()->availableGeometry().height());
}

TEST_F(GraphicalViewerTest, AFaultStandsAtItsTimeOnTheBar) {
    TimeBar bar;
    bar.resize(400, 40);
    bar.setRange(0, 10, 10);
    const QImage before = bar.grab().toImage();
    bar.setFaults({{4, true, "It stops."}, {4.01, false, "It slips."}});
    EXPECT_EQ(bar.faultsAt(bar.position(4)), "It stops.\nIt slips.");
    EXPECT_EQ(bar.faultsAt(bar.position(7)), "");
    bar.setMarks({}, {4, 7, 7.01});
    EXPECT_EQ(bar.wordsAt(bar.position(4)), "It stops.\nIt slips.\nA collision at 4 s");
    EXPECT_EQ(bar.wordsAt(bar.position(7)), "2 collisions, the first at 7 s");
    bar.show();
    const QPoint mark(static_cast<int>(std::lround(bar.position(7))), bar.height() / 2);
    QHelpEvent asked(QEvent::ToolTip, mark, bar.mapToGlobal(mark));
    QApplication::sendEvent(&bar, &asked);
    EXPECT_EQ(QToolTip::text(), "2 collisions, the first at 7 s");
    EXPECT_NE(bar.grab().toImage(), before);
}

TEST_F(GraphicalViewerTest, AViewerThatOpensAgainIsAsOrthographicAndHidesTheSame) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().setOrthographic(true);
    viewer->display().setHidden({"b"});
    editor.restoreWindows(editor.windowsState(), {});
    SceneDisplay& again = editor.graphicalViewers().back()->display();
    EXPECT_TRUE(again.camera().orthographic);
    EXPECT_EQ(again.hidden(), std::set<std::string>{"b"});
}

TEST_F(GraphicalViewerTest, AClickOnTheTriadLooksAlongItsAxis) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.lookAlong({0.4, 0.3, 1});
    display.grab();
    const render::Size size{display.width(), display.height()};
    for (const render::TriadEnd& end : render::triadOf(display.camera(), size))
        if (end.axis == 0 && !end.against) {
            const QPointF place(end.place.x(), end.place.y());
            EXPECT_EQ(display.triadEndAt(place), "x");
            QTest::mouseClick(&display, Qt::LeftButton, Qt::NoModifier, place.toPoint());
        }
    const geometry::Vector toward =
        display.camera().rotation.conjugate() * geometry::Vector::UnitZ();
    EXPECT_LT((toward - geometry::Vector::UnitX()).norm(), 1e-9);
    EXPECT_TRUE(display.triadEndAt({300, 200}).isEmpty());
}

TEST_F(GraphicalViewerTest, FramesWhatIsThereNowFromTheSameDirection) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    display.setOrthographic(true);
    EXPECT_TRUE(display.framesItself()); // anew, in the other projection
    display.grab();
    EXPECT_TRUE(display.camera().orthographic);
    const render::Camera motion = display.camera();
    display.frameNow();
    EXPECT_TRUE(display.camera().rotation.isApprox(motion.rotation));
    EXPECT_TRUE(display.camera().orthographic);
    EXPECT_GT(display.camera().scale, motion.scale); // the ball alone, not its flight
    const geometry::Vector ball = editor.document().shown().scene->bodies[0].initialPosition;
    EXPECT_LT((display.camera().center - ball).norm(), 0.2);
    const double one = display.camera().scale;
    display.frameMotion();
    EXPECT_LT(display.camera().scale, one);
    editor.document().select({{editing::Kind::body, 0}});
    display.frameSelected();
    EXPECT_NEAR(display.camera().scale, one, 1e-9);
}

TEST_F(GraphicalViewerTest, ShiftedButtonsDoNotMoveTheView) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    const render::Camera before = viewer->display().camera();
    QTest::mousePress(&viewer->display(), Qt::LeftButton, Qt::ShiftModifier, QPoint(200, 200));
    QTest::mouseMove(&viewer->display(), QPoint(260, 220));
    QTest::mouseRelease(&viewer->display(), Qt::LeftButton, Qt::ShiftModifier, QPoint(260, 220));
    EXPECT_TRUE(viewer->display().camera().rotation.isApprox(before.rotation));
}

TEST_F(GraphicalViewerTest, TheCentreOfRotationGoesToTheNearestVertexOrToMidDepth) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    display.grab();
    const render::Size size{display.width(), display.height()};
    const Eigen::Vector2d ball = render::toPixels(display.camera(), size, {-1, 0, 0});
    display.centerAt(QPointF(ball.x() + 3, ball.y() - 2));
    EXPECT_LT((display.camera().center - geometry::Vector(-1, 0, 0)).norm(), 1e-9);
    // The picture itself stays.
    EXPECT_LT((render::toPixels(display.camera(), size, {-1, 0, 0}) - ball).norm(), 1e-6);
    display.centerAt(QPointF(ball.x() + 90, ball.y() - 60));
    EXPECT_NEAR(display.camera().center.z(), 0, 1e-6);
    EXPECT_GT((display.camera().center - geometry::Vector(-1, 0, 0)).norm(), 0.1);
}

TEST_F(GraphicalViewerTest, LookingAlongAnAxisMakesThePictureThatPlane) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().grab();
    for (const geometry::Vector& axis :
         {geometry::Vector(1, 0, 0), geometry::Vector(0, 1, 0), geometry::Vector(0, 0, -1)}) {
        viewer->display().lookAlong(axis);
        const geometry::Vector seen = viewer->display().camera().rotation * axis;
        EXPECT_LT((seen - geometry::Vector(0, 0, 1)).norm(), 1e-9);
    }
}

TEST_F(GraphicalViewerTest, SwitchesOfThePanelAndTheMenuAreTheSame) {
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    QCheckBox* wireframe = nullptr;
    for (auto* box : viewer->findChildren<QCheckBox*>())
        if (box->text().contains("ireframe"))
            wireframe = box;
    ASSERT_NE(wireframe, nullptr);
    const int solid = drawn(*viewer);
    wireframe->click();
    EXPECT_TRUE(viewer->display().display().wireframe);
    EXPECT_LT(drawn(*viewer), solid);
}

TEST_F(GraphicalViewerTest, ASceneWithViewsOpensInItsFirst) {
    editor.document().setText(ballScene + "view top -rot {1.5708 0 0}\nview side -scale 0.2\n",
                              "Edit");
    ASSERT_TRUE(settle(editor.document()));
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    EXPECT_EQ(viewer->display().followedView(), "top");
    viewer->display().grab();
    const geometry::Vector up = viewer->display().camera().rotation * geometry::Vector::UnitY();
    EXPECT_NEAR(up.z(), 1, 1e-3);
    viewer->display().followView("side");
    viewer->display().grab();
    EXPECT_NEAR(viewer->display().camera().scale, 0.2, 1e-12);
}

// A view that gives a direction alone frames the scene that opens, and not each step of a drag.
TEST_F(GraphicalViewerTest, WhatAViewFramesStaysWhileOneEdits) {
    const std::string view = "view front -rot {0.18 0 0}\n",
                      far = "body b2 ball -init_pos {0 9 0}\n";
    const auto open = [&](const std::string& text) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    };
    open(ballScene + view);
    SceneDisplay& display = editor.openGraphicalViewer()->display();
    display.grab();
    const render::Camera before = display.camera();
    open(ballScene + far + view);
    display.grab();
    EXPECT_EQ(display.camera(), before);
    EXPECT_EQ(display.followedView(), "front");
    editor.document().reset(ballScene + far + view);
    ASSERT_TRUE(settle(editor.document()));
    display.grab();
    EXPECT_NE(display.camera(), before);
}

// The fall makes the picture larger, in which 0 would do for a scene that is opened.
TEST_F(GraphicalViewerTest, TheGridStaysWhereItIsWhenTheMotionIsFramedAnew) {
    Editor own{engineWorkshop()};
    SceneDocument& document = own.document();
    const std::string ball = "simulator -finish 3\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                             "body a s -init_pos {0 3 0}\n",
                      weight = "force -body a -gravitational {0 -9.81 0}\n";
    document.reset(ball);
    ASSERT_TRUE(settle(document));
    SceneDisplay& display = own.openGraphicalViewer()->display();
    display.grab();
    const double height = display.ground().value().height;
    EXPECT_GT(height, 1);
    document.setText(ball + weight, "Edit");
    ASSERT_TRUE(settle(document));
    display.frameAll();
    display.grab();
    EXPECT_EQ(display.ground().value().height, height);
    document.reset(ball + weight);
    ASSERT_TRUE(settle(document));
    display.grab();
    EXPECT_EQ(display.ground().value().height, 0);
}

// The scene before had its own view and began at its own time.
TEST_F(GraphicalViewerTest, AnotherSceneBeginsAtItsFirstMomentAndTheTourInItsOwnView) {
    Editor own{engineWorkshop()};
    SceneDocument& document = own.document();
    document.reset("simulator -start 1.6 -finish 3\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                   "body a s\nbody far s -init_pos {900 0 0}\n");
    ASSERT_TRUE(settle(document));
    GraphicalViewer* viewer = own.openGraphicalViewer();
    viewer->display().grab();
    ASSERT_TRUE(waitFor([&] { return viewer->playback().time() > 1.5; }));
    document.reset("");
    viewer->showTour();
    ASSERT_TRUE(settle(document));
    viewer->display().grab();
    EXPECT_EQ(viewer->playback().time(), 0);
    const gestures::Sight sight = viewer->display().sight();
    EXPECT_LT(sight.camera.center.norm(), 0.5);
    EXPECT_LT(sight.pixelLength({0, 0, 0}) * sight.size.height, 40);
}

} // namespace
} // namespace views
