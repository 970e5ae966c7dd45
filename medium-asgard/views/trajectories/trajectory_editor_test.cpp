#include "trajectories/point_table.h"
#include "trajectories/trajectory_editor.h"
#include "views/test_workshop.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>

namespace views {
namespace {

const std::string scene = "simulator -finish 2\n"
                          "trajectory path -points {{0 0 0 0} {1 1 0 0} {2 3 0 0}} ;# led\n"
                          "trajectory turn -bezier {{0 1 {0 0 0} {0 1 0} {0 2 0} {0 2 1}}}\n"
                          "shape_set ball -desc {-sub {-sphere 0.5}}\n"
                          "body b1 ball\nconstrain b1 -pos path\n";

class TrajectoryEditorTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }

    void SetUp() override {
        document.setText(scene, "Edit");
        ASSERT_TRUE(settle(document));
        editor = std::make_unique<TrajectoryEditor>(document);
        editor->setAttribute(Qt::WA_DeleteOnClose, false);
        editor->resize(700, 720);
        editor->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(editor.get(), longestWait));
    }

    [[nodiscard]] QPoint at(int component, double time, double value) const {
        return editor->graph(component).place(time, value).toPoint();
    }
    void drag(int component, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
        TrajectoryGraph& graph = editor->graph(component);
        QTest::mousePress(&graph, Qt::LeftButton, modifiers, from);
        for (int k = 1; k <= 4; ++k) {
            const QPoint now = from + (to - from) * k / 4;
            QMouseEvent move(QEvent::MouseMove, now, graph.mapToGlobal(now), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(&graph, &move);
        }
        QTest::mouseRelease(&graph, Qt::LeftButton, modifiers, to);
        ASSERT_TRUE(settle(document));
    }
    // Into a cell of the table.
    void type(int row, int column, const QString& text) {
        PointTable& table = editor->points();
        table.setCurrentCell(row, column);
        table.editItem(table.item(row, column));
        auto* field = table.findChild<QLineEdit*>();
        ASSERT_TRUE(field);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        ASSERT_TRUE(waitFor([&] { return table.findChild<QLineEdit*>() == nullptr; }));
        ASSERT_TRUE(settle(document));
    }
    [[nodiscard]] QString cell(int row, int column) const {
        return editor->points().item(row, column)->text();
    }
    [[nodiscard]] const scene::Trajectory& shown(std::size_t index) const {
        return document.shown().scene->trajectories.at(index);
    }

    TestWorkshop made;
    SceneDocument document{made.workshop()};
    std::unique_ptr<TrajectoryEditor> editor;
};

TEST_F(TrajectoryEditorTest, ADraggedPointChangesItsNumberInOneStepOfUndo) {
    drag(1, at(1, 1, 0), at(1, 1, 0) - QPoint(1, 40));
    const double y = shown(0).points[1].second.y();
    EXPECT_GT(y, 0.1);
    EXPECT_EQ(shown(0).points[1].first, 1); // hardly moved aside: its time stays
    EXPECT_EQ(shown(0).points[1].second.x(), 1);
    EXPECT_NE(document.text().find(" {2 3 0 0}} ;# led\n"), std::string::npos);
    EXPECT_EQ(document.undoLabel(), "Change Trajectory path");
    document.undo();
    EXPECT_EQ(document.text(), scene);
    EXPECT_FALSE(document.canUndo() && document.undoLabel() != "Edit");
}

TEST_F(TrajectoryEditorTest, TimesAreDraggedToo) {
    drag(0, at(0, 1, 1), at(0, 1.4, 1));
    EXPECT_NEAR(shown(0).points[1].first, 1.4, 0.05);
    drag(0, at(0, shown(0).points[1].first, 1), at(0, 5, 1)); // not past the next
    EXPECT_LT(shown(0).points[1].first, 2);
    EXPECT_FALSE(document.hasErrors());
}

TEST_F(TrajectoryEditorTest, ATimeThatCannotBeSaysWhatItIsInstead) {
    type(1, 0, "7");
    EXPECT_TRUE(editor->words().startsWith("A point stays between its neighbours"))
        << qPrintable(editor->words());
    ASSERT_TRUE(settle(document));
    EXPECT_LT(shown(0).points[1].first, 2);
}

TEST_F(TrajectoryEditorTest, ATangentRewritesThePointsAsCurvesAndUndoTakesItBack) {
    QTest::mouseClick(&editor->graph(0), Qt::LeftButton, {}, at(0, 1, 1));
    const auto tangent = editing::controlPointsOf(shown(0).curves)[4];
    ASSERT_FALSE(tangent.onCurve);
    const QPoint from = at(1, tangent.time, tangent.place.y());
    drag(1, from, from - QPoint(0, 30));
    EXPECT_NE(document.text().find("trajectory path -bezier {{0 1 "), std::string::npos);
    EXPECT_NE(editor->words().indexOf("-bezier"), -1);
    EXPECT_TRUE(shown(0).points.empty());
    EXPECT_EQ(shown(0).curves.size(), 2U);
    document.undo();
    EXPECT_EQ(document.text(), scene);
}

TEST_F(TrajectoryEditorTest, PointsAreAddedAndDeleted) {
    QTest::mouseDClick(&editor->graph(1), Qt::LeftButton, {}, at(1, 0.5, 0.2));
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(shown(0).points.size(), 4U);
    EXPECT_NEAR(shown(0).points[1].first, 0.5, 0.02);
    EXPECT_NEAR(shown(0).points[1].second.y(), 0.2, 0.03);
    ASSERT_TRUE(editor->chosen()); // the new one, to go on with
    EXPECT_EQ(*editor->chosen(), 3U);
    QTest::keyClick(editor.get(), Qt::Key_Delete);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), scene);
}

TEST_F(TrajectoryEditorTest, ATrajectoryOfOnePointGetsAnother) {
    document.setText("simulator -finish 2\ntrajectory hold -bezier {{0 5 {1 2 3}}}\n", "Edit");
    ASSERT_TRUE(settle(document));
    editor->graph(0).setFocus();
    QTest::keyClick(&editor->graph(0), Qt::Key_Insert);
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(shown(0).curves.size(), 2U) << document.text();
    EXPECT_EQ(shown(0).curves[1].from, 5);
    EXPECT_EQ(shown(0).curves[1].to, 6);
    EXPECT_FALSE(document.hasErrors());
}

TEST_F(TrajectoryEditorTest, EverythingIsDoneByKeysToo) {
    QTest::keyClick(editor.get(), Qt::Key_PageDown);
    ASSERT_EQ(editor->chosen(), 0U);
    editor->graph(2).setFocus();
    QTest::keyClick(editor.get(), Qt::Key_Up);
    ASSERT_TRUE(settle(document));
    EXPECT_GT(shown(0).points[0].second.z(), 0);
    QTest::keyClick(editor.get(), Qt::Key_Insert);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(shown(0).points.size(), 4U);
    EXPECT_EQ(shown(0).points[1].first, 0.5);
}

// A gesture changes the number that it moves, and no digit of the others.
TEST_F(TrajectoryEditorTest, OtherNumbersKeepTheirDigits) {
    const std::string exact = "simulator -finish 2\ntrajectory path -points "
                              "{{0 0.1234567890123456 0 0} {1.0000000001 0.1234567890123456 "
                              "0.123456789 0} {2 3 0 0}}\n";
    const auto again = [&] {
        document.setText(exact, "Edit");
        ASSERT_TRUE(settle(document));
        QTest::mouseClick(&editor->graph(1), Qt::LeftButton, {}, at(1, 1, 0.123456789));
    };
    again();
    type(1, 3, "4");
    EXPECT_NE(document.text().find("{1.0000000001 0.1234567890123456 0.123456789 4}"),
              std::string::npos)
        << document.text();
    again();
    QTest::keyClick(&editor->graph(1), Qt::Key_Right);
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text(), exact);
    EXPECT_NE(document.text().find(" 0.1234567890123456 0.123456789 0} {2"), std::string::npos)
        << document.text();
    again();
    drag(1, at(1, 1, 0.123456789), at(1, 1.5, 0.123456789)); // its time alone
    EXPECT_NE(document.text(), exact);
    EXPECT_NE(document.text().find(" 0.1234567890123456 0.123456789 0} {2"), std::string::npos)
        << document.text();
}

TEST_F(TrajectoryEditorTest, AfterEscapeTheHandHoldsNothing) {
    TrajectoryGraph& graph = editor->graph(1);
    const QPoint from = at(1, 1, 0);
    const auto moveTo = [&](QPoint to) {
        QMouseEvent move(QEvent::MouseMove, to, graph.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         {});
        QCoreApplication::sendEvent(&graph, &move);
    };
    QTest::mousePress(&graph, Qt::LeftButton, {}, from);
    moveTo(from - QPoint(0, 20));
    ASSERT_TRUE(settle(document));
    EXPECT_NE(document.text(), scene);
    QTest::keyClick(&graph, Qt::Key_Escape);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), scene);
    moveTo(from - QPoint(0, 40));
    QTest::mouseRelease(&graph, Qt::LeftButton, {}, from - QPoint(0, 40));
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(document.text(), scene);
}

// The far end of the language's times: lines of the grid are fewer than what a double tells apart.
TEST_F(TrajectoryEditorTest, AxesAreDrawnFarFromZero) {
    TrajectoryGraph& graph = editor->graph(0);
    graph.setTimes(1e17, 1e17 + 16);
    EXPECT_FALSE(graph.grab().isNull());
}

TEST_F(TrajectoryEditorTest, ExactValuesAreTyped) {
    type(2, 2, "0.125");
    EXPECT_NE(document.text().find("{2 3 0.125 0}} ;# led"), std::string::npos) << document.text();
}

TEST_F(TrajectoryEditorTest, TheTableIsInStepWithTheGraphsAndTheText) {
    PointTable& table = editor->points();
    ASSERT_EQ(table.rowCount(), 3); // its tangents are nobody's numbers
    EXPECT_EQ(table.horizontalHeaderItem(0)->text(), "time, s");
    EXPECT_EQ(table.horizontalHeaderItem(1)->text(), "x, m");
    EXPECT_EQ(cell(2, 1), "3");
    QTest::mouseClick(&editor->graph(0), Qt::LeftButton, {}, at(0, 1, 1));
    EXPECT_EQ(table.currentRow(), 1);
    table.setCurrentCell(2, 1);
    ASSERT_TRUE(editor->chosen());
    EXPECT_EQ(table.rowOf(*editor->chosen()), 2);
    table.setCurrentCell(0, 1);
    QTest::keyClick(&table, Qt::Key_Insert);
    ASSERT_TRUE(settle(document));
    ASSERT_EQ(table.rowCount(), 4);
    EXPECT_EQ(cell(1, 0), "0.5");
    EXPECT_EQ(table.currentRow(), 1); // to go on with
    QTest::keyClick(&table, Qt::Key_Delete);
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(table.rowCount(), 3);
    EXPECT_EQ(document.text(), scene);
    document.setText("trajectory path -points {{0 0 0 0} {1 8 0 0}}\n", "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(table.rowCount(), 2);
    EXPECT_EQ(cell(1, 1), "8");
}

// It stays there, and the text as it is, until another value is taken.
TEST_F(TrajectoryEditorTest, AFaultStandsAtItsCell) {
    type(1, 1, "much");
    EXPECT_EQ(document.text(), scene);
    EXPECT_EQ(cell(1, 1), "much");
    EXPECT_EQ(editor->points().item(1, 1)->toolTip(), "\"much\" is no number.");
    EXPECT_EQ(editor->words(), "\"much\" is no number.");
    QTest::keyClick(&editor->points(), Qt::Key_Escape);
    EXPECT_EQ(cell(1, 1), "1");
    EXPECT_EQ(editor->points().item(1, 1)->toolTip(), "");
    type(1, 0, "7");
    EXPECT_TRUE(editor->points().item(1, 0)->toolTip().contains("between its neighbours"));
    type(1, 0, "1.5");
    EXPECT_EQ(cell(1, 0), "1.5");
    EXPECT_EQ(editor->points().item(1, 0)->toolTip(), "");
    EXPECT_EQ(shown(0).points[1].first, 1.5);
}

TEST_F(TrajectoryEditorTest, WhatIsComputedSaysWhyItStays) {
    const std::string computed =
        "set way {}\nfor {set i 0} {$i < 4} {incr i} {lappend way [list $i $i 0 0]}\n"
        "trajectory path -points $way\n";
    document.setText(computed, "Edit");
    ASSERT_TRUE(settle(document));
    drag(1, at(1, 1, 0), at(1, 1, 0) - QPoint(0, 40));
    EXPECT_EQ(document.text(), computed);
    QTest::mouseDClick(&editor->graph(1), Qt::LeftButton, {}, at(1, 0.5, 0.2));
    EXPECT_NE(editor->words().indexOf("-points of trajectory \"path\""), -1)
        << qPrintable(editor->words());
}

TEST_F(TrajectoryEditorTest, FollowsTheSceneAndSaysWhatATrajectoryLeads) {
    editor->showTrajectory("turn");
    EXPECT_EQ(editor->trajectory(), "turn");
    document.setText("simulator -finish 2\n", "Edit");
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->trajectory(), "");
    EXPECT_NE(editor->words().indexOf("no trajectory"), -1);
    document.undo();
    ASSERT_TRUE(settle(document));
    EXPECT_EQ(editor->trajectory(), "path");
}

} // namespace
} // namespace views
