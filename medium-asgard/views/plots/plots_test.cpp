// What a `plot` says is to be seen, and follows the motion.
#include "commands/quantities.h"
#include "plots/chart_axes.h"
#include "plots/plot_dialog.h"
#include "plots/plots_panel.h"
#include "scene/units.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <QMenu>
#include <QScrollBar>
#include <QTimer>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace views {

using commands::Measured, commands::Quantity, commands::quantitiesOf;
namespace {

const std::string flying = "simulator -finish 2\n"
                           "shape_set s -desc {-sub {-sphere 0.5}}\n"
                           "body b s -init_pos {1 5 0} -init_dpos {3 0 0}\n"
                           "plot p -values {b.x {b.y + 1}} -labels {way height} -title Flight\n";

class PlotsTest : public testing::Test {
protected:
    static void SetUpTestSuite() { theApplication(); }
    void show(const std::string& text) {
        editor.document().setText(text, "Edit");
        ASSERT_TRUE(settle(editor.document()));
    }
    Editor editor{engineWorkshop()};
};

TEST_F(PlotsTest, TheDialogOffersTheQuantitiesOfTheScene) {
    show("shape_set s -desc {-sub {-sphere 0.5}}\nbody floor s -fixed 1\n"
         "body b s -init_pos {0 3 0}\njoint pin -type hinge -body1 b -offset1 {0 1 0}\n");
    PlotDialog whole(editor.document().shown(), nullptr);
    EXPECT_EQ(whole.expression(), "atan2(b.x - pin.px, pin.py - b.y)"); // b can do nothing else
    auto* list = whole.findChild<QTreeWidget*>("quantities");
    ASSERT_EQ(list->topLevelItemCount(), 2); // a fixed body has none
    EXPECT_EQ(list->topLevelItem(1)->child(0)->text(0), "Angle from straight down, °");
    list->setCurrentItem(list->topLevelItem(1)->child(0));
    EXPECT_EQ(whole.expression(), "atan2(b.x - pin.px, pin.py - b.y)");
    EXPECT_EQ(whole.name(), "angle of pin");
    list->setCurrentItem(list->topLevelItem(1)->child(1));
    EXPECT_EQ(whole.expression(), "pin.q");
    EXPECT_EQ(whole.name(), "");
    const PlotDialog about(editor.document().shown(), nullptr,
                           editing::Element{editing::Kind::joint, 0});
    EXPECT_EQ(about.expression(), "atan2(b.x - pin.px, pin.py - b.y)");
}

// The list begins with its first row where the proposal is seen so, and else shows that.
TEST_F(PlotsTest, TheListOfQuantitiesOpensAtItsBeginning) {
    std::string bodies = "shape_set s -desc {-sub {-sphere 0.1}}\n";
    for (int i = 0; i < 5; ++i)
        bodies += "body b" + std::to_string(i) + " s -init_pos {" + std::to_string(i) + " 0 0}\n";
    show(bodies);
    for (const std::size_t about : {0U, 4U}) {
        PlotDialog dialog(editor.document().shown(), nullptr,
                          editing::Element{editing::Kind::body, about});
        dialog.show();
        QCoreApplication::processEvents();
        const auto* list = dialog.findChild<QTreeWidget*>("quantities");
        const int scrolled = list->verticalScrollBar()->value();
        EXPECT_EQ(scrolled == 0, about == 0);
        EXPECT_TRUE(list->viewport()->rect().contains(list->visualItemRect(list->currentItem())));
    }
}

TEST_F(PlotsTest, TheDialogProposesWhatMoves) {
    using editing::Kind;
    const std::string two = "simulator -finish 1\nshape_set s -desc {-sub {-sphere 0.1}}\n"
                            "body a s -init_pos {0 3 0} -init_dpos {0 0 9}\n"
                            "body b s -init_pos {5 3 0}\n";
    show(two + "force -body b -gravitational {0 -9.81 0}\n"
               "body c s -init_pos {9 3 0}\njoint rail -type slider -body1 c -axis {1 0 0}\n"
               "body d s -init_pos {9 1 0}\njoint arm -type hinge -body1 d -body2 c\n"
               "gear g -joint1 rail -joint2 arm -ratio 2\n");
    const auto proposed = [&](std::optional<editing::Element> about) {
        return PlotDialog(editor.document().shown(), nullptr, about).expression().toStdString();
    };
    EXPECT_EQ(proposed({}), "a.z");
    EXPECT_EQ(proposed({{Kind::body, 0}}), "a.z");
    EXPECT_EQ(proposed({{Kind::body, 1}}), "b.y");
    EXPECT_EQ(proposed({{Kind::force, 0}}), "b.y");
    EXPECT_EQ(proposed({{Kind::body, 2}}), "rail.q"); // c moves by it alone
    EXPECT_EQ(proposed({{Kind::joint, 0}}), "rail.q");
    EXPECT_EQ(proposed({{Kind::gear, 0}}), "rail.q");
    EXPECT_EQ(proposed({{Kind::body, 3}}), "d.y"); // it rests
    EXPECT_EQ(proposed({{Kind::shapeSet, 0}}), "a.z");
}

TEST_F(PlotsTest, EachQuantityHasItsUnit) {
    show("shape_set s -desc {-sub {-sphere 0.5}}\nbody floor s -fixed 1\n"
         "body b s -init_pos {0 3 0}\nbody c s -init_pos {3 3 0}\nbody d s -init_pos {6 3 0}\n"
         "joint pin -type hinge -body1 b -offset1 {0 1 0} -motor 1\n"
         "joint rail -type slider -body1 c -axis {1 0 0} -motor 1\n"
         "spring coil -body1 b -body2 c -stiffness 5\n"
         "rope string -points {{d} {6 9 0}} -length 7\n"
         "contact touch -body1 d -body2 floor -friction 0.1\n");
    const scene::Scene& scene = *editor.document().shown().scene;
    const scene::Units units(scene);
    int count = 0;
    for (const Measured& one : quantitiesOf(scene))
        for (const Quantity& quantity : one.quantities) {
            EXPECT_EQ(units.of(quantity.expression), quantity.unit) << quantity.expression;
            ++count;
        }
    EXPECT_GT(count, 40);
}

// What one asks of a pendulum is an angle, though its rod has none.
TEST_F(PlotsTest, ARodThatHangsFromAPointHasAnAngle) {
    show("shape_set s -desc {-sub {-sphere 0.5}}\nbody b s -init_pos {1 2 0}\n"
         "joint rod -type distance -body1 b -offset2 {0 3 0}\n");
    const auto all =
        quantitiesOf(*editor.document().shown().scene, editing::Element{editing::Kind::joint, 0});
    const auto angle = std::ranges::find(all, "rad", &Quantity::unit);
    ASSERT_NE(angle, all.end());
    EXPECT_EQ(angle->expression, "atan2(b.x - rod.px, rod.py - b.y)");
}

// The same plot counts from below the hinge wherever that is moved.
TEST_F(PlotsTest, APendulumsPlotFollowsItsHinge) {
    const auto atStart = [&](const std::string& hinge) {
        show("simulator -finish 0.1\nshape_set s -desc {-sub {-sphere 0.1}}\n"
             "body b s -init_pos {1 2 0}\n"
             "joint pin -type hinge -body1 b -offset1 {" +
             hinge +
             "}\nforce -body b -gravitational {0 -9.81 0}\n"
             "plot p -values {{atan2(b.x - pin.px, pin.py - b.y)}}\n");
        const Shown& shown = editor.document().shown();
        simulation::ReadableScene readable(*shown.scene);
        const auto plot =
            charts::sampled(readable, *shown.scene, shown.scene->plots[0], shown.motion);
        return plot->curves[0].values.front(); // degrees
    };
    EXPECT_NEAR(atStart("-1 1 0"), 45, 1e-9);
    EXPECT_NEAR(atStart("0 1 0"), 0, 1e-9);
    EXPECT_NEAR(atStart("1 1 0"), -45, 1e-9);
}

// Whatever it was pulled to before the joint was made: 0 is where it hangs, and to the right of an
// axis that looks at the viewer is positive, as the joint's own angle counts.
TEST_F(PlotsTest, APendulumsAngleIsFromStraightDown) {
    const auto angle = [&](const std::string& joint, const std::string& gravity = "0 -9.81 0") {
        show("simulator -finish 1\nshape_set s -desc {-sub {-sphere 0.1}}\n"
             "body wall s -fixed 1 -init_pos {0 9 0}\nbody b s -init_pos {0.6 2.2 0}\n" +
             joint + "\nforce -body b -gravitational {" + gravity + "}\n");
        const auto all = quantitiesOf(*editor.document().shown().scene,
                                      editing::Element{editing::Kind::joint, 0});
        return all.front();
    };
    const Quantity own = angle("joint pin -type hinge -body1 b -offset1 {-0.6 0.8 0}");
    EXPECT_EQ(own.label, "&Angle from straight down");
    EXPECT_EQ(own.expression, "atan2(b.x - pin.px, pin.py - b.y)");
    EXPECT_EQ(own.name, "angle of pin");
    EXPECT_EQ(worded(own), "Angle from straight down, °");
    EXPECT_EQ(angle("joint pin -type hinge -body1 b -body2 wall -offset1 {-0.6 -0.8 0}").expression,
              "atan2(b.x - pin.px, pin.py - b.y)");
    EXPECT_EQ(
        angle("joint pin -type hinge -body1 b -offset1 {-0.6 0.8 0} -axis {0 0 -1}").expression,
        "atan2(pin.px - b.x, pin.py - b.y)");
    EXPECT_EQ(angle("joint pin -type hinge -body1 b -offset1 {0 0 0.8} -axis {0 1 0}", "0 0 -9.81")
                  .expression,
              "atan2(pin.px - b.x, pin.pz - b.z)");
    // A turntable hangs nowhere, nor does what turns about its middle.
    EXPECT_EQ(angle("joint pin -type hinge -body1 b -offset1 {1 0 0} -axis {0 1 0}").expression,
              "pin.q");
    EXPECT_EQ(angle("joint pin -type hinge -body1 b").expression, "pin.q");
    // The plot that is made of it has its name.
    angle("joint pin -type hinge -body1 b -offset1 {-0.6 0.8 0}");
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().creating().start(newPlot(own.expression, own.name));
    ASSERT_TRUE(settle(editor.document()));
    ASSERT_EQ(editor.document().shown().scene->plots.size(), 1U) << editor.document().text();
    const charts::Plot plot =
        charts::named(*editor.document().shown().scene, editor.document().shown().scene->plots[0]);
    EXPECT_EQ(plot.values, "angle of pin, °");
}

// A chart that is flat, as one below a picture, tells how far a pendulum swings, not its middle
// alone.
TEST_F(PlotsTest, AFlatChartHasThreeNumbersAtLeast) {
    const ChartAxes flat{{0, 0, 460, 70}, 0, 10, -26.8, 26.8};
    EXPECT_EQ(stepOfValues(flat, 14), 20);
    const ChartAxes high{{0, 0, 460, 300}, 0, 10, -26.8, 26.8};
    EXPECT_EQ(stepOfValues(high, 14), 10);
    const ChartAxes tiny{{0, 0, 460, 20}, 0, 10, -26.8, 26.8};
    EXPECT_EQ(stepOfValues(tiny, 14), 50); // the numbers would overlap
}

// "°" alone does not tell of what.
TEST_F(PlotsTest, TheNameOfAFlatChartsAxisUsesTheWholeHeight) {
    const QFontMetricsF metrics{QFont()};
    const QString name = QStringLiteral("angle of hinge1, °");
    const double length = metrics.horizontalAdvance(name);
    const auto named = [&](double height) {
        return nameOfValues({{64, 30, 460, height - 66}, 0, 10, -27, 27, {}, name, height},
                            metrics);
    };
    EXPECT_EQ(named(400).words, name);
    EXPECT_EQ(named(400).middle, 30 + 334.0 / 2);
    EXPECT_EQ(named(length + 10).words, name); // the axis is shorter than it
    EXPECT_GE(named(length + 10).middle, length / 2);
    EXPECT_LE(named(length + 10).middle, length / 2 + 10);
    const AxisName shorter = named(length - 20);
    EXPECT_TRUE(shorter.words.startsWith("angle")) << shorter.words.toStdString();
    EXPECT_TRUE(shorter.words.endsWith(QStringLiteral("…, °"))) << shorter.words.toStdString();
    EXPECT_EQ(named(35).words, QStringLiteral("°"));
}

TEST_F(PlotsTest, TheRightButtonOnAChartAsksForItsMenu) {
    show(flying);
    PlotsPanel* window = editor.openPlots();
    ASSERT_EQ(window->charts().size(), 1U);
    QMenu* menu = nullptr;
    QTimer::singleShot(0, window, [&] {
        menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (menu)
            menu->close();
    });
    Q_EMIT window->charts()[0]->customContextMenuRequested(QPoint(20, 20));
    EXPECT_TRUE(waitFor([&] { return menu != nullptr; }));
    EXPECT_EQ(editor.document().selected(),
              (std::vector{editing::Element{editing::Kind::plot, 0}}));
}

TEST_F(PlotsTest, EachQuantityIsACurveOverTheWholeMotion) {
    show(flying);
    PlotsPanel* window = editor.openPlots();
    ASSERT_TRUE(waitFor([&] {
        return window->charts().size() == 1 && !window->charts()[0]->plot().times.empty();
    }));
    const charts::Plot& plot = window->charts()[0]->plot();
    EXPECT_EQ(plot.title, "Flight");
    EXPECT_EQ(plot.curves[0].label, "way");
    EXPECT_EQ(plot.times.back(), 2);
    EXPECT_NEAR(plot.curves[0].values.back(), 1 + 3 * 2, 1e-12);
    EXPECT_NEAR(plot.curves[1].values.front(), 6, 1e-12);
    PlotChart& chart = *window->charts()[0];
    EXPECT_EQ(chart.readingAt(chart.placeOf(1, 4)), "t = 1 s   way = 4 m   height = 6 m");
    EXPECT_EQ(chart.readingAt(QPointF(0, 0)), "");
    EXPECT_EQ(chart.axes().across, "time, s");
    EXPECT_EQ(chart.axes().up, "m"); // of curves that differ, what is the same
    window->setTime(1);
    EXPECT_EQ(chart.legendOf(0), "way = 4 m"); // the values of the moment that is seen
    double chosen = 0;
    QObject::connect(window, &PlotsPanel::timeChosen, [&](double time) { chosen = time; });
    QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf(0.5, 4).toPoint());
    EXPECT_NEAR(chosen, 0.5, 0.01);
    const QImage before = chart.grab().toImage();
    show(flying + "plot q -values scene.px\n");
    ASSERT_TRUE(waitFor([&] { return window->charts().size() == 2; }));
    QString slower = QString::fromStdString(flying).replace("{3 0 0}", "{-1 0 0}");
    show(slower.toStdString());
    ASSERT_TRUE(waitFor([&] {
        return window->charts().size() == 1 &&
               window->charts()[0]->plot().curves[0].values.back() == -1;
    }));
    EXPECT_NE(window->charts()[0]->grab().toImage(), before);
}

TEST_F(PlotsTest, APlotThatIsCreatedIsShown) {
    show(flying);
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    viewer->display().creating().start(newPlot("b.y"));
    ASSERT_TRUE(settle(editor.document()));
    auto* window = viewer->findChild<PlotsPanel*>();
    ASSERT_NE(window, nullptr);
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(waitFor([&] { return window->charts().size() == 2; }));
}

TEST_F(PlotsTest, CoordinatesAndForcesOfJointsCanBePlotted) {
    show("shape_set s -desc {-sub {-sphere 0.5}}\nbody b s\n"
         "joint pin -type hinge -body1 b -offset1 {0 1 0}\n");
    const scene::Scene& scene = *editor.document().shown().scene;
    EXPECT_EQ(faultOfPlotted(scene, "pin.q + pin.dq * pin.fx").toStdString(), "");
    EXPECT_NE(faultOfPlotted(scene, "pin.q2").toStdString(), "");
}

TEST_F(PlotsTest, WhatCannotBeReadSaysWhyAndWithoutPlotsNothingIsLeft) {
    show(flying);
    PlotsPanel* window = editor.openPlots();
    ASSERT_TRUE(waitFor([&] { return window->charts().size() == 1; }));
    show("shape_set s -desc {-sub {-sphere 0.5}}\nbody b s\n");
    EXPECT_TRUE(waitFor([&] { return window->charts().empty(); }));
    PlotChart chart;
    chart.resize(400, 200);
    charts::Plot plot;
    plot.title = "p";
    chart.setPlot(plot, 0, 1);
    const QImage empty = chart.grab().toImage();
    plot.fault = "There is no body a.";
    chart.setPlot(plot, 0, 1);
    EXPECT_NE(chart.grab().toImage(), empty);
    EXPECT_EQ(chart.readingAt(chart.placeOf(0.5, 0)), "");
}

} // namespace
} // namespace views
