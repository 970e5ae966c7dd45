// Faults of the text at their bodies and joints.
#include "viewers/editor.h"
#include "views/test_workshop.h"

#include <gmock/gmock.h>

namespace views {
namespace {

using geometry::Vector;
using ::testing::HasSubstr;

TEST(FaultSigns, StandAtTheElementsThatFaultsAreAbout) {
    theApplication();
    Editor editor{engineWorkshop()};
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    const std::string good = "simulator -finish 2\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                             "body a s\nbody b s -init_pos {3 0 0}\n";
    editor.document().setText(good, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(display.faultSigns().signs().empty());
    // The joint's points are 1 apart.
    const std::string joint =
        "joint j -type ball -body1 a -offset1 {1 0 0} -body2 b -offset2 {0 0 0}\n";
    editor.document().setText(good + joint, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    display.grab();
    const auto signs = display.faultSigns().signs();
    ASSERT_EQ(signs.size(), 1U);
    const QPointF point = display.placeOf(1, 0, 0);
    EXPECT_LT((signs[0].place - point).manhattanLength(), 30);
    EXPECT_TRUE(display.faultSigns().at(signs[0].place));
    EXPECT_THAT(signs[0].words.toStdString(), HasSubstr("j"));
    // It is said below the picture, too.
    display.pointing().moveTo(signs[0].place, {});
    EXPECT_THAT(display.pointing().hint().toStdString(), HasSubstr("all faults"));
    // The fault is read whole where the advice finds no room.
    EXPECT_THAT(display.pointing().hint().toStdString(), HasSubstr("at the start  ·  place them"));
    editor.document().setText(good, "Edit");
    ASSERT_TRUE(settle(editor.document()));
    EXPECT_TRUE(display.faultSigns().signs().empty());
}

TEST(FaultSigns, OfTwoBodiesThatOverlapStandWhereTheyDo) {
    theApplication();
    Editor editor{engineWorkshop()};
    GraphicalViewer* viewer = editor.openGraphicalViewer();
    SceneDisplay& display = viewer->display();
    const auto placeIn = [&](const std::string& text) {
        editor.document().setText("simulator -finish 1\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                                  "shape_set wide -desc {-sub {-box {40 1 40}}}\n" +
                                      text,
                                  "Edit");
        EXPECT_TRUE(settle(editor.document()));
        display.grab();
        const auto signs = display.faultSigns().signs();
        EXPECT_EQ(signs.size(), 1U);
        return signs.empty() ? QPointF() : signs[0].place;
    };
    const auto isAt = [&](const QPointF& sign, const QPointF& place) {
        return (sign + QPointF(0, 14) - place).manhattanLength() < 12;
    };
    const QPointF onFloor =
        placeIn("body floor wide -init_pos {0 -0.5 0} -fixed 1\nbody b s -init_pos {6 0.3 4}\n");
    EXPECT_TRUE(isAt(onFloor, display.placeOf(6, 0.2, 4)));
    const QPointF between = placeIn("body a s\nbody b s -init_pos {0.8 0 0}\n");
    EXPECT_TRUE(isAt(between, display.placeOf(0.4, 0, 0)));
}

} // namespace
} // namespace views
