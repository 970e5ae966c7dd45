// Round places and fitting sizes of what is made by clicks.
#include "picture/creating_testing.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QMenu>

#include <cmath>

namespace views {
namespace {

bool isRound(double value, double step) { return std::abs(std::remainder(value, step)) < 1e-9; }

TEST_F(CreatingTest, OnAFloorPlacesAreAsRoundAsOnTheGrid) {
    open("shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1\n"
         "shape_set s -desc {-sub {-sphere 0.5}}\nbody b s -init_pos {0 0.5 0}\n");
    display().lookAlong(Vector(0, 0.8, 1));
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    click({1.387, 0, 0.831});
    done();
    const Vector place = scene().bodies.back().initialPosition;
    EXPECT_TRUE(isRound(place.x(), 0.05) && isRound(place.z(), 0.05)) << place.transpose();
    EXPECT_EQ(place.y(), 0.5);
}

TEST_F(CreatingTest, AJointOnTheGroundStandsAtARoundPlace) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\nbody c ball -init_pos {4 0 0}\n");
    const auto make = [&](const Vector& place) {
        display().creating().start(newJoint(scene::JointType::hinge));
        click({0, 0, 0});
        click(place);
        if (display().creating().active())
            key(Qt::Key_Return);
        done();
        display().grab();
        return scene().joints.back().offset1.value_or(Vector::Zero());
    };
    const Vector place = make({0.618, 1.137, 0});
    EXPECT_TRUE(isRound(place.x(), 0.05) && isRound(place.y(), 0.05)) << text();
    EXPECT_LT((place - Vector(0.618, 1.137, 0)).norm(), 0.15);
    EXPECT_EQ(make({0.02, 1.137, 0}).x(), 0); // above its middle
}

TEST_F(CreatingTest, ThePlaceOfAJointIsTyped) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball -init_pos {1 0 0}\n");
    display().creating().start(newJoint(scene::JointType::hinge));
    click({1, 0, 0});
    QTest::keyClicks(&display(), "0 2 0");
    EXPECT_THAT(display().creating().prompt().toStdString(), testing::HasSubstr("x y z = 0 2 0_"));
    key(Qt::Key_Return);
    done();
    ASSERT_EQ(scene().joints.size(), 1U);
    EXPECT_EQ(scene().joints[0].offset1, Vector(-1, 2, 0)) << text();
    EXPECT_FALSE(scene().joints[0].body2.has_value());
}

// As large as one sees well, where the usual size is a dot or does not fit.
TEST_F(CreatingTest, ANewBodyFitsThePicture) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\n");
    QMenu menu;
    buildCreateMenu(&menu, editor.document(), display());
    QAction* box = nullptr;
    for (QAction* one : menu.findChild<QMenu*>("createBody")->actions())
        if (one->text().remove('&') == "New Box")
            box = one;
    ASSERT_NE(box, nullptr);
    for (const double times : {1.0, 60.0, 1.0 / 2000}) {
        render::Camera camera = display().camera();
        camera.scale *= times;
        display().setCamera(camera);
        display().grab();
        box->trigger();
        key(Qt::Key_Return);
        done();
        const auto& part = scene().shapeSets.back().parts.front();
        const double edge = std::get<scene::BoxShape>(part.shape).edges.x();
        const double height =
            display().sight().pixelLength(camera.center) * display().sight().size.height;
        EXPECT_EQ(edge == 1, times == 1) << text();
        EXPECT_GT(edge, height / 40) << times;
        EXPECT_LT(edge, height) << times;
    }
}

TEST_F(CreatingTest, ABodyThatIsTypedPartlyOutOfSightComesIntoThePicture) {
    open("shape_set ball -desc {-sub {-sphere 0.5}}\nbody b ball\n");
    display().frameNow();
    display().grab();
    display().creating().start(newBody(BasicShape::box));
    QTest::keyClicks(&display(), "0 0.5 0");
    key(Qt::Key_Return);
    done();
    display().grab();
    EXPECT_TRUE(display().rect().contains(
        display().fromPixels(display().sight().pixels({0.5, 1, 0})).toPoint()));
}

} // namespace
} // namespace views
