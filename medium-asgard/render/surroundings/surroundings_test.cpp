// Where the grid, the ground, the horizon and the triad stand in a picture.
#include "framing/test_scenes.h"
#include "surroundings/backdrop.h"
#include "surroundings/ground.h"
#include "surroundings/triad.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace render {
namespace {

using Pixels = Eigen::Vector2d;

// Over five decades of scale: always legible, and no line comes or goes at once.
TEST(Grid, StepsChangeGraduallyWithTheScale) {
    std::vector<GridStep> last;
    for (double pixels = 1e-2; pixels < 1e3; pixels *= 1.01) {
        const std::vector<GridStep> steps = gridSteps(pixels, 1);
        double sum = 0;
        for (const GridStep& one : steps) {
            EXPECT_GE(one.step * pixels, 90 * (1 - 1e-9));
            EXPECT_LE(one.step * pixels, 90 * 2.5 * 2.5);
            sum += one.weight;
        }
        EXPECT_NEAR(sum, 1, 1e-12);
        for (const GridStep& before : last) {
            double now = 0;
            for (const GridStep& one : steps)
                if (std::abs(one.step / before.step - 1) < 1e-9)
                    now = one.weight;
            EXPECT_LT(std::abs(now - before.weight), 0.15) << pixels;
        }
        last = steps;
    }
}

TEST(Grid, HasNoMoreLinesThanCanBeToldApart) {
    const auto rows = [](double step, double focus, double radius, double middle) {
        const GridRows found = gridRows(step, focus, radius, middle);
        return std::pair(found.first, found.last);
    };
    EXPECT_EQ(rows(0.5, 0.1, 1, 0.1), std::pair(-1L, 2L));
    EXPECT_EQ(rows(1e-4, 3, 1e6, 3), std::pair(29600L, 30400L)); // high above the ground
    EXPECT_EQ(rows(1e-4, 0, 5, 3), std::pair(29600L, 30400L));   // near what is beside the focus
    EXPECT_EQ(rows(1e-4, 0, 5, 3e9), std::pair(0L, -1L));        // far beside all of it
    EXPECT_EQ(rows(1e-30, 7, 1e9, 7), std::pair(0L, -1L));       // finer than numbers are there
    EXPECT_EQ(rows(1, NAN, 1, 0), std::pair(0L, -1L));
}

TEST(Ground, IsARoundHeightThatSmallChangesLeaveAlone) {
    Extent extent;
    extent.size = 10;
    extent.lowest = -3.2;
    const double height = groundHeight(extent);
    EXPECT_LE(height, extent.lowest);
    EXPECT_NEAR(std::remainder(height, 1), 0, 1e-12);
    for (const double moved : {-3.3, -3.5, -3.9}) {
        extent.lowest = moved;
        EXPECT_EQ(groundHeight(extent), height);
    }
    extent.lowest = -3 - 1e-9; // what rests on it at a round height rests on it
    EXPECT_NEAR(groundHeight(extent), -3, 1e-12);
    for (const double above : {0.0, 0.7, 9.0}) { // a body that is lifted leaves it behind
        extent.lowest = above;
        EXPECT_EQ(groundHeight(extent), 0);
    }
    extent.lowest = -3.3;
    extent.lowestStands = true;
    EXPECT_EQ(groundHeight(extent), -3.3);
    extent.lowest = 0.45; // a table leaves it behind, too
    EXPECT_EQ(groundHeight(extent), 0);
}

// Nor is it cut by the picture's edge.
TEST(Grid, NoNumberIsWrittenOverAnother) {
    const auto room = [](double x, double y) {
        return Eigen::AlignedBox2d(Pixels(x, y), Pixels(x + 20, y + 10));
    };
    TakenRoom taken;
    EXPECT_TRUE(takeRoom(taken, room(30, 30), {200, 100}));
    EXPECT_FALSE(takeRoom(taken, room(45, 35), {200, 100}));
    EXPECT_TRUE(takeRoom(taken, room(60, 30), {200, 100}));
    for (const auto& [x, y] : {std::pair(-1, 60), {60, -1}, {181, 60}, {60, 91}})
        EXPECT_FALSE(takeRoom(taken, room(x, y), {200, 100})) << x << ' ' << y;
    EXPECT_EQ(taken.size(), 2U);
}

// A number stands upright below its line, where a floor that is seen from above is nearer.
TEST(Grid, NoNumberIsBehindTheGround) {
    const Size size{640, 480};
    const GroundPlane ground = groundPlane(Vector::UnitY(), -0.2);
    const std::array corners{Pixels(-3, -14), Pixels(-20, -14)};
    for (const bool orthographic : {false, true})
        for (const double slope : {0.15, 0.5, 1.2}) {
            Drawing drawing;
            drawing.camera.orthographic = orthographic;
            drawing.camera.rotation = geometry::fromRotationVector({slope, 0.3, 0});
            const Frame frame(drawing, size);
            const Vector onGround = ground.place(0.3, 0.1);
            const Vector moved = beforeGround(ground, frame, frame.toView(onGround), corners);
            const Vector world = frame.linear().inverse() * (moved - drawing.camera.position) +
                                 drawing.camera.center;
            const Pixels at = toPixels(drawing.camera, size, onGround);
            EXPECT_LT((toPixels(drawing.camera, size, world) - at).norm(), 1e-4);
            for (const Pixels& corner : corners) {
                const Vector foot =
                    toWorld(drawing.camera, size, at + Pixels(corner.x(), -corner.y()), moved.z());
                EXPECT_GT(foot.y(), ground.height) << slope;
            }
        }
}

// Along an axis one builds as on a plan: its grid lies in the plane of the bodies. From above the
// ground is that plane itself.
TEST(Grid, FacesWhoLooksAlongAnAxis) {
    scene::Scene scene;
    scene.bodies.resize(2);
    scene.bodies[0].initialPosition = {0, 1, 3};
    scene.bodies[1].initialPosition = {2, 0, 3};
    Drawing drawing;
    drawing.scene = &scene;
    const auto seen = [&](const Vector& toward) {
        drawing.camera.rotation =
            facing(toward, std::abs(toward.y()) > 0.9 ? Vector(0, 0, -1) : Vector(0, 1, 0));
        return facingPlane(drawing, Vector::UnitY());
    };
    const auto front = seen(Vector::UnitZ()), back = seen(-Vector::UnitZ());
    ASSERT_TRUE(front && back);
    EXPECT_EQ(front->weight, 1);
    EXPECT_EQ(front->plane.place(5, 7), Vector(5, 7, 3));
    EXPECT_EQ(back->plane.up, Vector(0, 0, -1));
    EXPECT_EQ(back->plane.place(5, 7), Vector(5, 7, 3));
    drawing.camera.center = {0.4, 0, 0}; // the bodies differ in x
    const auto side = seen(Vector::UnitX());
    ASSERT_TRUE(side);
    EXPECT_EQ(side->plane.place(5, 7), Vector(0.4, 5, 7));
    EXPECT_FALSE(seen(Vector::UnitY()));
    EXPECT_FALSE(seen({0.1, 0, 1}));
    const auto nearly = seen({0.03, 0, 1});
    ASSERT_TRUE(nearly);
    EXPECT_LT(nearly->weight, 1);
    scene.bodies.clear();
    EXPECT_EQ(seen(Vector::UnitX())->plane.height, 0);
}

TEST(Horizon, IsWhereLevelLinesOfSightLead) {
    Drawing drawing;
    const Size size{640, 480};
    for (const double tilt : {0.0, 0.3, -0.2}) {
        drawing.camera.rotation = geometry::fromRotationVector({tilt, 0, 0.4});
        const Frame frame(drawing, size);
        const auto horizon = horizonOf(frame, frame.directionInView(Vector::UnitY()));
        ASSERT_TRUE(horizon);
        // A point very far away on a level way is seen on it.
        const Vector level = drawing.camera.rotation.conjugate() * Vector(0.1, 0, -1);
        const Vector far = 1e7 * Vector(level.x(), 0, level.z());
        const Pixels at = toPixels(drawing.camera, size, far) - Pixels(320, 240);
        EXPECT_NEAR(Pixels(at.x(), -at.y()).dot(horizon->toSky) / 240, horizon->offset, 1e-5);
    }
    drawing.camera.orthographic = true;
    EXPECT_FALSE(horizonOf(Frame(drawing, size), Vector::UnitY()));
    drawing.camera.orthographic = false; // straight down there is ground alone
    EXPECT_FALSE(horizonOf(Frame(drawing, size), Vector::UnitZ()));
}

TEST(Triad, IsAsLargeInASmallPictureOnAFineScreen) {
    const auto reach = [](Size size) { return triadReach(size) / size.ratio; }; // reader's pixels
    EXPECT_NEAR(reach({600, 400, 2}), reach({300, 200, 1}), 1e-5);
    EXPECT_NEAR(reach({1280, 960, 2}), reach({640, 480, 1}), 1e-5);
}

TEST(Triad, AClickOnAnEndMeansItsDirection) {
    const Size size{640, 480};
    Camera camera;
    camera.rotation = geometry::fromRotationVector({0.4, 0.5, 0});
    for (const TriadEnd& end : triadOf(camera, size)) {
        const auto direction = triadDirectionAt(camera, size, end.place);
        ASSERT_TRUE(direction);
        EXPECT_EQ(*direction, end.direction());
        EXPECT_LE((end.place - triadMiddle(size)).norm(), triadReach(size));
    }
    EXPECT_FALSE(triadDirectionAt(camera, size, {320, 240}));
    // Of two in one place the one in front.
    camera.rotation = Quaternion::Identity();
    EXPECT_EQ(triadDirectionAt(camera, size, triadMiddle(size)), Vector(Vector::UnitZ()));
}

} // namespace
} // namespace render
