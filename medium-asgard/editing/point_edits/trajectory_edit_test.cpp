// (text, gesture, text) of trajectories; and that what is drawn meanwhile is what the text becomes.
#include "editing/test_reading.h"
#include "point_edits/trajectory_edit.h"

#include "scene/curves.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace editing {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;

struct Edited {
    std::string text;
    TrajectoryEdits edits;
    explicit Edited(const std::string& source)
        : text(source), edits(source, readScene(source), 0) {}
    [[nodiscard]] std::string with(const Answer& answer) const {
        return answer.possible() ? text::applied(text, answer.edits) : answer.reason;
    }
};

constexpr double least = 0.01;

const std::string path = "trajectory path -points {{0 0 0 0}  {1 2 0 0}\n  {2 2.50 1 0}} ;# led\n";
const std::string curve = "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 1 0} {2 2 0}} "
                          "{1 3 {2 2 0} {2 4 0} {0 4 0} {0 0 0}}}\n";

TEST(TrajectoryEditTest, PointsAndTheirTangentsAreControlPoints) {
    const Edited it(path);
    ASSERT_EQ(it.edits.points().size(), 7U); // 3 points, 2 tangents in each of 2 curves
    EXPECT_FALSE(it.edits.hasOwnTangents());
    EXPECT_TRUE(it.edits.points()[3].onCurve);
    EXPECT_TRUE(it.edits.points()[3].joins);
    EXPECT_EQ(it.edits.points()[3].place, Vector(2, 0, 0));
    EXPECT_FALSE(it.edits.points()[4].onCurve);
    EXPECT_DOUBLE_EQ(it.edits.points()[4].time, 1 + 1.0 / 3);
}

TEST(TrajectoryEditTest, AMovedPointRewritesItsNumbersAlone) {
    const Edited it(path);
    EXPECT_EQ(it.with(it.edits.move(6, 2.5, {2.5, 1, -3}, least)),
              "trajectory path -points {{0 0 0 0}  {1 2 0 0}\n  {2.5 2.50 1 -3}} ;# led\n");
    // Not past its neighbours.
    EXPECT_THAT(it.with(it.edits.move(3, 7, {2, 0, 0}, least)), HasSubstr("{1.99 2 0 0}"));
    EXPECT_THAT(it.with(it.edits.move(3, -7, {2, 0, 0}, least)), HasSubstr("{0.01 2 0 0}"));
}

TEST(TrajectoryEditTest, ATangentOfPointsRewritesTheListAsCurves) {
    const Edited it(path);
    const ControlPoint& tangent = it.edits.points()[1];
    const std::string after = it.with(it.edits.move(1, 0, tangent.place + Vector(0, 1, 0), least));
    EXPECT_THAT(after, HasSubstr("trajectory path -bezier {{0 1 {0 0 0} {"));
    EXPECT_THAT(after, HasSubstr(";# led\n"));
    const auto scene = readScene(after);
    auto wanted = it.edits.moved(1, 0, tangent.place + Vector(0, 1, 0), least, false);
    EXPECT_EQ(scene->trajectories[0].curves, wanted); // to the last bit
}

// 1e17 + 1 is 1e17.
TEST(TrajectoryEditTest, PointsAtHugeTimesAreAddedAndRemoved) {
    const Edited it("trajectory path -points {{0 0 0 0} {1e17 1 0 0} {2e17 2 0 0}}\n");
    EXPECT_EQ(it.with(it.edits.remove(3)), "trajectory path -points {{0 0 0 0} {2e17 2 0 0}}\n");
    EXPECT_EQ(readScene(it.with(it.edits.add(1.5e17, {5, 0, 0})))->trajectories[0].points[2],
              std::pair(1.5e17, Vector(5, 0, 0)));
    const Edited curves(
        "trajectory path -bezier {{1e17 2e17 {0 0 0} {1 0 0}} {2e17 3e17 {1 0 0}}}\n");
    EXPECT_EQ(curves.with(curves.edits.remove(2)),
              "trajectory path -bezier {{1e17 2e17 {0 0 0} {1 0 0}}}\n");
}

TEST(TrajectoryEditTest, ASmoothPassageStaysSmooth) {
    const std::string smooth = "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 0 0} {3 0 0}} "
                               "{1 3 {3 0 0} {5 0 0} {5 1 0} {5 5 0}}}\n";
    const Edited it(smooth);
    EXPECT_EQ(it.with(it.edits.move(2, 0, {2, 1, 0}, least)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 1 0} {3 0 0}} "
              "{1 3 {3 0 0} {5 -2 0} {5 1 0} {5 5 0}}}\n");
    EXPECT_EQ(it.with(it.edits.move(2, 0, {2, 1, 0}, least, true)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 1 0} {3 0 0}} "
              "{1 3 {3 0 0} {5 0 0} {5 1 0} {5 5 0}}}\n");
    // What was a corner stays one.
    const Edited corner("trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 1 0} {2 2 0}} "
                        "{1 3 {2 2 0} {2 5 0} {0 4 0} {0 0 0}}}\n");
    EXPECT_THAT(corner.with(corner.edits.move(2, 0, {2, 1.5, 0}, least)),
                HasSubstr("{1 3 {2 2 0} {2 5 0} {0 4 0}"));
}

TEST(TrajectoryEditTest, APointBetweenCurvesMovesBothWithTheirTangents) {
    const Edited it(curve);
    EXPECT_EQ(it.with(it.edits.move(3, 1, {2, 3, 0}, least)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 2 0} {2 3 0}} "
              "{1 3 {2 3 0} {2 5 0} {0 4 0} {0 0 0}}}\n");
    const std::string later = it.with(it.edits.move(3, 2, {2, 2, 0}, least));
    EXPECT_THAT(later, HasSubstr("{0 2 {0 0 0} {2 0 0} {2 0 0} {2 2 0}}")); // slopes are kept
    EXPECT_THAT(later, HasSubstr("{2 3 {2 2 0} {2 3 0} {0 2 0} {0 0 0}}"));
}

TEST(TrajectoryEditTest, AddsAPointInTheStyleOfItsNeighbours) {
    const Edited it(path);
    EXPECT_EQ(it.with(it.edits.add(0.5, {1, 1, 1})),
              "trajectory path -points {{0 0 0 0}  {0.5 1 1 1}  {1 2 0 0}\n  {2 2.50 1 0}} ;# "
              "led\n");
    EXPECT_EQ(it.with(it.edits.add(3, {1, 1, 1})),
              "trajectory path -points {{0 0 0 0}  {1 2 0 0}\n  {2 2.50 1 0}\n  {3 1 1 1}} ;# "
              "led\n");
    EXPECT_EQ(it.with(it.edits.add(-1, {1, 1, 1})),
              "trajectory path -points {{-1 1 1 1}  {0 0 0 0}  {1 2 0 0}\n  {2 2.50 1 0}} ;# "
              "led\n");
    EXPECT_EQ(it.with(it.edits.add(1, {1, 1, 1})), "There is a point at that time already.");
}

TEST(TrajectoryEditTest, ACurveThatIsSplitStaysWhereItWas) {
    const Edited it(curve);
    const auto before = readScene(curve)->trajectories[0].curves;
    const auto on = scene::valueAt(before, 2);
    ASSERT_TRUE(on);
    const auto after = readScene(it.with(it.edits.add(2, *on)))->trajectories[0].curves;
    ASSERT_EQ(after.size(), 3U);
    for (double t = 0; t <= 3; t += 0.125)
        EXPECT_LT((*scene::valueAt(before, t) - *scene::valueAt(after, t)).norm(), 1e-14) << t;
    EXPECT_EQ(readScene(it.with(it.edits.add(4, {1, 1, 1})))->trajectories[0].curves.back().to, 4);
    EXPECT_EQ(readScene(it.with(it.edits.add(-4, {1, 1, 1})))->trajectories[0].curves.front().from,
              -4);
}

TEST(TrajectoryEditTest, RemovesAPointAndTheSpaceBeforeIt) {
    const Edited it(path);
    EXPECT_EQ(it.with(it.edits.remove(3)),
              "trajectory path -points {{0 0 0 0}\n  {2 2.50 1 0}} ;# led\n");
    EXPECT_EQ(it.with(it.edits.remove(0)),
              "trajectory path -points {{1 2 0 0}\n  {2 2.50 1 0}} ;# led\n");
    EXPECT_THAT(it.with(it.edits.remove(1)), HasSubstr("tangent"));
    const Edited two("trajectory path -points {{0 0 0 0} {1 2 0 0}}\n");
    EXPECT_THAT(two.with(two.edits.remove(0)), HasSubstr("needs two points"));
    const Edited curves(curve);
    EXPECT_EQ(curves.with(curves.edits.remove(3)),
              "trajectory path -bezier {{0 3 {0 0 0} {3 0 0} {0 6 0} {0 0 0}}}\n");
    EXPECT_EQ(curves.with(curves.edits.remove(6)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 1 0} {2 2 0}}}\n");
}

TEST(TrajectoryEditTest, ListsInVariablesAreChangedThere) {
    const Edited it("set way {{0 0 0 0} {1 1 0 0}}\ntrajectory path -points $way\n");
    EXPECT_EQ(it.with(it.edits.move(3, 1, {1, 5, 0}, least)),
              "set way {{0 0 0 0} {1 1 5 0}}\ntrajectory path -points $way\n");
    EXPECT_EQ(it.with(it.edits.add(2, {1, 5, 0})),
              "set way {{0 0 0 0} {1 1 0 0} {2 1 5 0}}\ntrajectory path -points $way\n");
}

TEST(TrajectoryEditTest, WhatIsComputedSaysSo) {
    const Edited it("set way {}\nfor {set i 0} {$i < 4} {incr i} {lappend way [list $i $i 0 0]}\n"
                    "trajectory path -points $way\n");
    for (const Answer& answer : {it.edits.move(0, 0, {1, 5, 0}, least), it.edits.add(9, {0, 0, 0}),
                                 it.edits.remove(3), it.edits.move(1, 0, {1, 5, 0}, least)}) {
        EXPECT_TRUE(answer.edits.empty());
        EXPECT_THAT(answer.reason, HasSubstr("-points of trajectory \"path\""));
    }
}

TEST(TrajectoryEditTest, CurvesWrittenOutOfOrderAreFound) {
    const Edited it("trajectory path -bezier {{5 6 {1 1 1}} {0 1 {0 0 0} {1 0 0}}}\n");
    EXPECT_EQ(it.with(it.edits.move(0, 0, {9, 0, 0}, least)),
              "trajectory path -bezier {{5 6 {1 1 1}} {0 1 {9 0 0} {1 0 0}}}\n");
}

TEST(TrajectoryEditTest, TangentsThatAreCarriedAreWrittenAsAnAuthorWould) {
    const Edited it("trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 0.1 0} {3 0.3 0}}}\n");
    EXPECT_EQ(it.with(it.edits.move(3, 1, {3, 0.5, 0}, least)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 0.3 0} {3 0.5 0}}}\n");
    EXPECT_EQ(it.with(it.edits.move(3, 1, {3, 0.2, 0}, least)),
              "trajectory path -bezier {{0 1 {0 0 0} {1 0 0} {2 0 0} {3 0.2 0}}}\n");
}

// Where points are nearer than what a gesture leaves between them, only times that are dragged
// move.
TEST(TrajectoryEditTest, ATimeThatIsNotDraggedStays) {
    const Edited it("trajectory path -points {{0 0 0 0} {5 0 0 0} {5.005 1 0 0} {10 0 0 0}}\n");
    EXPECT_EQ(it.with(it.edits.move(3, 5, {0, 2, 0}, least)),
              "trajectory path -points {{0 0 0 0} {5 0 2 0} {5.005 1 0 0} {10 0 0 0}}\n");
}

TEST(TrajectoryEditTest, AConstantCurveEndsAfterItBegins) {
    const Edited it("trajectory path -bezier {{0 1 {0 0 0} {1 0 0}} {2 3 {5 5 5}} "
                    "{3 4 {1 0 0} {2 0 0}}}\n");
    ASSERT_EQ(it.edits.points()[2].place, Vector(5, 5, 5));
    EXPECT_THAT(it.with(it.edits.move(2, 4, {5, 5, 5}, least)), HasSubstr("{2.99 3 {5 5 5}}"));
    EXPECT_THAT(it.with(it.edits.move(3, 1, {1, 0, 0}, least)), HasSubstr("{3 4 {1 0 0}"));
    (void)readScene(it.with(it.edits.move(3, 2.5, {1, 0, 0}, least)));
}

TEST(TrajectoryEditTest, APointIsAWishOfItsPlaceInTheText) {
    const Edited it("trajectory path -bezier {{1 2 {3 0 0} {3 0 0} {5 0 0} {6 0 0}} "
                    "{0 1 {0 0 0} {1 0 0} {2 0 0} {3 0 0}}}\n");
    const Wish joint = it.edits.wishOf(3), tangent = it.edits.wishOf(4);
    EXPECT_EQ(joint.path, (std::vector<std::size_t>{1, 5}));
    EXPECT_EQ(tangent.path, (std::vector<std::size_t>{0, 3}));
    EXPECT_EQ(tangent.values, (std::vector<double>{3, 0, 0}));
    const Edited points(path);
    EXPECT_EQ(points.edits.wishOf(3).values, (std::vector<double>{1, 2, 0, 0}));
    EXPECT_EQ(points.edits.wishOf(3).path, (std::vector<std::size_t>{1}));
}

// Whatever is moved, added and removed: the text reads as the curves that were promised.
// But for the rounding that numberText() leaves out of numbers that were worked out.
void expectAlike(double written, double shown) {
    EXPECT_NEAR(written, shown, 1e-14 * std::abs(shown));
}

void expectAlike(const std::vector<scene::BezierCurve>& written,
                 const std::vector<scene::BezierCurve>& shown) {
    ASSERT_EQ(written.size(), shown.size());
    for (std::size_t c = 0; c < written.size(); ++c) {
        expectAlike(written[c].from, shown[c].from);
        expectAlike(written[c].to, shown[c].to);
        ASSERT_EQ(written[c].control.size(), shown[c].control.size());
        for (std::size_t p = 0; p < written[c].control.size(); ++p)
            for (int axis = 0; axis < 3; ++axis)
                expectAlike(written[c].control[p][axis], shown[c].control[p][axis]);
    }
}

TEST(TrajectoryEditTest, RandomGesturesReadAsTheCurvesThatWereShown) {
    std::mt19937 random(20261120);
    const auto number = [&](double from, double to) {
        return std::round(100 * std::uniform_real_distribution(from, to)(random)) / 100;
    };
    std::string text = path;
    int changed = 0;
    for (int k = 0; k < 150; ++k) {
        const Edited it(text);
        const std::size_t count = it.edits.points().size();
        const std::size_t point = random() % count;
        const Vector place(number(-5, 5), number(-5, 5), number(-5, 5));
        const double time = number(-1, 6);
        const unsigned what = random() % 8;
        const bool moves = what > 1;
        const Answer answer = what == 0   ? it.edits.add(time, place)
                              : what == 1 ? it.edits.remove(point)
                                          : it.edits.move(point, time, place, least);
        if (!answer.possible())
            continue;
        const std::string after = it.with(answer);
        const auto scene = readScene(after);
        ASSERT_EQ(scene->trajectories.size(), 1U) << text << after;
        if (moves) {
            SCOPED_TRACE(text + after);
            expectAlike(scene->trajectories[0].curves,
                        it.edits.moved(point, time, place, least, false));
        }
        EXPECT_THAT(after, HasSubstr(";# led\n"));
        text = after;
        ++changed;
    }
    EXPECT_GT(changed, 100);
}

} // namespace
} // namespace editing
