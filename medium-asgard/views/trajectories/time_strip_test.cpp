// The strip of a trajectory's times: (text, gesture, text).
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QLineEdit>
#include <QWheelEvent>

namespace views {
namespace {

using ::testing::HasSubstr;

class TimeStripTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void open(const std::string& path) {
        before = ball + path;
        editor.document().setText(before, "Edit");
        ASSERT_TRUE(settle(editor.document()));
        viewer = editor.openGraphicalViewer();
        showTrajectories(true);
        editor.document().select({{editing::Kind::trajectory, 0}});
        viewer->grab();
    }
    void showTrajectories(bool shown) {
        for (auto* box : viewer->findChildren<QCheckBox*>())
            if (box->text().remove('&') == "Trajectories")
                box->setChecked(shown);
    }
    TimeStrip& strip() { return viewer->times().strip(); }
    const std::string& text() { return editor.document().text(); }
    std::vector<double> times() {
        std::vector<double> all;
        for (const auto& [time, place] : editor.document().shown().scene->trajectories[0].points)
            all.push_back(time);
        return all;
    }
    QPoint at(double time) {
        return QPointF(strip().position(time), strip().height() / 2.0).toPoint();
    }
    void moveTo(QPoint there) {
        QMouseEvent move(QEvent::MouseMove, there, strip().mapToGlobal(there), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&strip(), &move);
    }
    void drag(double from, double to) {
        QTest::mousePress(&strip(), Qt::LeftButton, {}, at(from));
        moveTo(at(to));
        QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(to));
        ASSERT_TRUE(settle(editor.document()));
    }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&strip(), which, modifiers);
        ASSERT_TRUE(settle(editor.document()));
    }

    const std::string ball = "simulator -finish 4\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
                             "body b1 ball\n";
    std::string before;
    TestWorkshop made;
    Editor editor{made.workshop()};
    GraphicalViewer* viewer = nullptr;
};

const std::string line = "trajectory T -points {{0 -1 0 0}  {1.0 0 2 0} {4 1 0 0}} ;# along x\n";

TEST_F(TimeStripTest, IsThereForTheSelectedTrajectoryAndAboveTheScrollbarsTimes) {
    open(line);
    EXPECT_TRUE(strip().isVisibleTo(viewer));
    const TimeBar& bar = viewer->times().bar();
    for (const double time : {0.0, 1.0, 4.0})
        EXPECT_NEAR(strip().mapTo(viewer, QPointF(strip().position(time), 0)).x(),
                    bar.mapTo(viewer, QPointF(bar.position(time), 0)).x(), 0.6);
    // It stays while trajectories are shown, whatever is selected: the picture keeps its size.
    editor.document().select({});
    EXPECT_TRUE(strip().isVisibleTo(viewer));
    EXPECT_FALSE(strip().trajectory());
    showTrajectories(false);
    EXPECT_FALSE(strip().isVisibleTo(viewer));
    EXPECT_FALSE(strip().controls()->isVisibleTo(viewer));
}

TEST_F(TimeStripTest, ADraggedMarkChangesItsTimeAndNothingElseInOneNamedStep) {
    open(line);
    drag(1, 2);
    ASSERT_NEAR(times()[1], 2, 0.02);
    std::string expected = before;
    const std::size_t place = expected.find("1.0 0 2 0");
    const std::size_t end = text().find(" 0 2 0", place);
    EXPECT_EQ(text().substr(0, place), expected.substr(0, place));
    EXPECT_EQ(text().substr(end), expected.substr(place + 3));
    EXPECT_EQ(editor.document().undoLabel(), "Retime point 2 of T");
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(TimeStripTest, AMotionThatGrowsWhileOneDragsTheScaleIsAllShownAfterwards) {
    open(line);
    const double time = strip().from() + 0.6 * (strip().to() - strip().from());
    const QPoint from = at(time), to = from + QPoint(40, 0);
    QTest::mousePress(&strip(), Qt::LeftButton, {}, from);
    moveTo(from + QPoint(20, 0));
    strip().setRange(0, 8);
    moveTo(to);
    EXPECT_NEAR(strip().position(time), to.x(), 1.5); // what was taken is under the pointer
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, to);
    strip().showAll();
    EXPECT_EQ(strip().to(), 8);
}

TEST_F(TimeStripTest, TheTextFollowsWhileAMarkMovesAndEscapeBringsItBack) {
    open(line);
    QTest::mousePress(&strip(), Qt::LeftButton, {}, at(1));
    moveTo(at(1.5));
    EXPECT_NE(text(), before);
    EXPECT_TRUE(viewer->display().editing().said().startsWith("T: point 2 at 1."));
    QTest::keyClick(&strip(), Qt::Key_Escape);
    EXPECT_EQ(text(), before);
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(1.5));
    EXPECT_EQ(text(), before);
}

TEST_F(TimeStripTest, TimesStayInOrder) {
    open(line);
    drag(1, 3.9);
    EXPECT_LT(times()[1], times()[2]);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    QTest::mousePress(&strip(), Qt::LeftButton, {}, at(1));
    moveTo(at(1) - QPoint(2000, 0)); // far before the first
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(0));
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_GT(times()[1], 0);
    EXPECT_LT(times()[1], 0.01);
    EXPECT_EQ(times()[0], 0);
}

TEST_F(TimeStripTest, CurvesThatMeetAreRetimedTogether) {
    open("trajectory T -bezier {{0 1 {0 0 0} {1 0 0}} {1 3 {1 0 0} {2 1 0}}}\n");
    drag(1, 2);
    const auto& curves = editor.document().shown().scene->trajectories[0].curves;
    EXPECT_NEAR(curves[0].to, 2, 0.02);
    EXPECT_EQ(curves[0].to, curves[1].from);
    editor.document().undo();
    EXPECT_EQ(text(), before);
}

TEST_F(TimeStripTest, WhatTheTextComputesStaysAndSaysWhy) {
    open("set end [expr {2 + 1}]\n"
         "trajectory T -points [list {0 0 0 0} [list $end 1 0 0]]\n");
    drag(3, 3.5);
    EXPECT_EQ(text(), before);
    EXPECT_FALSE(viewer->display().editing().said().isEmpty());
    EXPECT_FALSE(editor.document().undoLabel().startsWith("Retime"));
}

TEST_F(TimeStripTest, TheKeysChooseAndRetimeInOneStepAndAskForTheExactTime) {
    open(line);
    key(Qt::Key_PageDown);
    key(Qt::Key_PageDown);
    ASSERT_TRUE(strip().chosen());
    EXPECT_EQ(viewer->display().editing().marked()->part, 1U);
    for (int i = 0; i < 3; ++i) {
        QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::ShiftModifier);
        QApplication::sendEvent(&strip(), &right);
    }
    QTest::keyRelease(&strip(), Qt::Key_Right);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_GT(times()[1], 1.2);
    editor.document().undo();
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(text(), before);
    QTest::keyClick(&strip(), Qt::Key_Return);
    auto* field = strip().findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    EXPECT_EQ(field->text(), "1");
    QTest::keyClicks(field, "1.0625");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_EQ(times()[1], 1.0625);
    EXPECT_THAT(text(), HasSubstr("{1.0625 0 2 0}"));
}

TEST_F(TimeStripTest, AnExactTimeThatCannotBeSaysWhatItIsInstead) {
    open(line);
    key(Qt::Key_PageDown);
    key(Qt::Key_PageDown);
    QTest::keyClick(&strip(), Qt::Key_Return);
    auto* field = strip().findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, "7");
    QTest::keyClick(field, Qt::Key_Return);
    const QString said = viewer->display().editing().said();
    EXPECT_TRUE(said.startsWith("A point stays between its neighbours: 3.99")) << qPrintable(said);
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_LT(times()[1], 4);
}

TEST_F(TimeStripTest, DeleteDoesNotTakeBackWhatAnArrowThatIsStillDownHasRetimed) {
    open(line);
    key(Qt::Key_PageDown);
    key(Qt::Key_PageDown);
    QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::ShiftModifier);
    QApplication::sendEvent(&strip(), &right);
    key(Qt::Key_Delete); // of a text that is still to be read
    EXPECT_FALSE(viewer->display().editing().said().isEmpty());
    QTest::keyRelease(&strip(), Qt::Key_Right);
    ASSERT_EQ(times().size(), 3U);
    EXPECT_GT(times()[1], 1);
    key(Qt::Key_Delete);
    EXPECT_EQ(times(), (std::vector<double>{0, 4}));
}

TEST_F(TimeStripTest, AStepHasTheNameOfTheTrajectoryThatItRetimed) {
    open(line + "trajectory U -points {{0 0 0 0} {1 1 1 1}}\n");
    QTest::mousePress(&strip(), Qt::LeftButton, {}, at(1));
    moveTo(at(1.5));
    ASSERT_TRUE(settle(editor.document()));
    editor.document().select({{editing::Kind::trajectory, 1}});
    EXPECT_EQ(editor.document().undoLabel(), "Retime point 2 of T");
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(1.5));
}

TEST_F(TimeStripTest, AMarkThatIsHeldWhileTheTextIsChangedElsewhereSaysSo) {
    open(line);
    QTest::mousePress(&strip(), Qt::LeftButton, {}, at(1));
    moveTo(at(1.5));
    const std::string other = text() + "# other\n";
    editor.document().setText(other, "Elsewhere");
    moveTo(at(2));
    EXPECT_EQ(viewer->display().editing().said(), SceneDocument::overtaken());
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(2));
    EXPECT_EQ(text(), other);
}

TEST_F(TimeStripTest, ZoomAndPanShowAFinerPieceOfTime) {
    open(line);
    const double step = strip().position(1) - strip().position(0);
    strip().zoom(0.5, 1);
    EXPECT_NEAR(strip().position(1) - strip().position(0), 2 * step, 1e-9);
    const double from = strip().from();
    // Beside the marks the scale is taken along.
    QTest::mousePress(&strip(), Qt::LeftButton, {}, at(1.5));
    moveTo(at(1.5) + QPoint(-50, 0));
    QTest::mouseRelease(&strip(), Qt::LeftButton, {}, at(1.5));
    EXPECT_GT(strip().from(), from);
    EXPECT_EQ(text(), before);
    QTest::keyClick(&strip(), Qt::Key_0);
    EXPECT_NEAR(strip().position(1) - strip().position(0), step, 1e-9);
}

} // namespace
} // namespace views
