// Coils, trails and the signs of joints.
#include "framing/framing.h"
#include "framing/test_scenes.h"
#include "signs/coils.h"
#include "signs/joint_signs.h"
#include "signs/trails.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

const scene::Color red{0.9, 0.1, 0.1}, blue{0.1, 0.2, 0.9}, green{0.1, 0.8, 0.2};

TEST(Coil, HasItsTurnsAtAnyLength) {
    for (const double length : {0.1, 1.0, 7.0}) {
        const auto points = coilBetween({0, 0, 0}, {length, 0, 0}, 0.05, 16);
        EXPECT_EQ(points.front(), Vector(0, 0, 0));
        EXPECT_EQ(points.back(), Vector(length, 0, 0));
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_GT(points[i].x(), points[i - 1].x());
            EXPECT_LT(std::hypot(points[i].y(), points[i].z()), 0.05 + 1e-12);
        }
    }
    EXPECT_EQ(coilBetween({1, 0, 0}, {1, 0, 0}, 1, 16).size(), 2U);
}

// See Framed.AMotionIsReadTimeAfterTime.
TEST(Trails, ReadAMotionPieceAfterPiece) {
    scene::Scene scene;
    double last = 0, back = 0;
    std::vector<GivenMotion::Law> laws;
    for (int i = 0; i < 8; ++i) {
        addBody(scene, sphere(1), Vector(4 * i, 0, 0), red);
        laws.push_back([&, i](double t) {
            back = std::max(back, last - t);
            last = t;
            return placed({4.0 * i + t, std::sin(3 * t), 0});
        });
    }
    Drawing drawing;
    drawing.scene = &scene;
    drawing.motion = std::make_shared<GivenMotion>(36, laws);
    const Extent extent = extentOf(scene, drawing.motion.get());
    last = back = 0;
    Trails trails;
    trails.follow(drawing, extent);
    EXPECT_GT(last, 35);
    EXPECT_LT(back, 0.2); // a piece is a tenth of a second
}

// Stops and the hand of a joint that begins at -from stand as those of one that begins at 0 and has
// its limits shifted.
TEST(JointSigns, LimitsCountFromTheFirstValue) {
    const auto strokes = [](scene::JointType type, double lower, double upper, double from) {
        scene::Scene scene;
        addBody(scene, box({1, 0.2, 0.2}), {0.5, 0, 0}, red);
        scene::Joint& joint = scene.joints.emplace_back();
        joint.name = "j";
        joint.type = type;
        joint.body1 = scene.bodies[0].name;
        joint.offset1 = Vector(-0.5, 0, 0);
        joint.axis = type == scene::JointType::hinge ? Vector::UnitZ() : Vector::UnitX();
        joint.coordinates.resize(1);
        joint.coordinates[0].lower = lower;
        joint.coordinates[0].upper = upper;
        joint.coordinates[0].from = from;
        Drawing drawing;
        drawing.scene = &scene;
        const Extent extent = extentOf(scene, nullptr);
        constexpr Size size{640, 480};
        drawing.camera = fitted(extent, geometry::Quaternion::Identity(), size, false);
        return jointSignsOf(drawing, extent, Frame(drawing, size)).strokes;
    };
    for (const auto type : {scene::JointType::hinge, scene::JointType::slider}) {
        const auto begun = strokes(type, -0.2, 0.9, 0.5), same = strokes(type, -0.7, 0.4, 0);
        ASSERT_EQ(begun.size(), same.size());
        EXPECT_GT(begun.size(), 3U);
        for (std::size_t i = 0; i < same.size(); ++i) {
            EXPECT_LT((begun[i].from - same[i].from).norm(), 1e-9);
            EXPECT_LT((begun[i].to - same[i].to).norm(), 1e-9);
        }
    }
}

} // namespace
} // namespace render
