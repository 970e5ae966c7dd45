// Where marks stand in a picture: grid, triad, shadows' maps, handles, labels.
#include "render/backdrop.h"
#include "render/ground.h"
#include "render/handle_layout.h"
#include "render/round_numbers.h"
#include "render/shadow_map.h"
#include "render/stroke_text.h"
#include "render/test_scenes.h"
#include "render/triad.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

using Pixels = Eigen::Vector2d;

TEST(Grid, ItsStepsAreOfTheSeriesOneTwoFive) {
    EXPECT_DOUBLE_EQ(roundAbove(1), 1);
    EXPECT_DOUBLE_EQ(roundAbove(1.1), 2);
    EXPECT_DOUBLE_EQ(roundAbove(0.021), 0.05);
    EXPECT_DOUBLE_EQ(roundAbove(6), 10);
    EXPECT_DOUBLE_EQ(roundBelow(1), 1);
    EXPECT_DOUBLE_EQ(roundBelow(4.9), 2);
    EXPECT_DOUBLE_EQ(roundBelow(0.0009), 0.0005);
}

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
}

TEST(StrokeText, WritesAsFewDigitsAsTheStepNeeds) {
    EXPECT_EQ(coordinateText(3, 1), "3");
    EXPECT_EQ(coordinateText(-20, 10), "-20");
    EXPECT_EQ(coordinateText(0.5, 0.5), "0.5");
    EXPECT_EQ(coordinateText(1e-17, 0.1), "0");
    EXPECT_EQ(coordinateText(0.15, 0.05), "0.15");
    EXPECT_EQ(coordinateText(3e7, 1e7), "3e7");
    EXPECT_EQ(coordinateText(2e-7, 1e-7), "2e-7");
    EXPECT_GT(textWidth("10", 8), textWidth("1", 8));
    EXPECT_EQ(textWidth("", 8), 0);
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

// Every solid lies within the map, seen from afar and from a place.
TEST(ShadowMap, HoldsAllThatThrowsAShadow) {
    scene::Scene scene;
    addBody(scene, sphere(0.3), {-0.5, 0.2, 0}, {});
    addBody(scene, box({0.4, 0.6, 0.2}), {0.5, -0.2, 0.3}, {});
    Drawing drawing;
    drawing.scene = &scene;
    const Frame frame(drawing, {320, 240});
    const auto solids = solidsOf(drawing, extentOf(scene, nullptr), frame);
    const auto room = visibleRoom(frame, 2, -5);
    Light light;
    for (const Vector& place : {Vector(0.3, 0.8, 0.5), Vector(-3, 4, 2)}) {
        light.isPoint = place.norm() > 2;
        light.place = light.isPoint ? place : Vector(place.normalized());
        const auto sight = sightOf(light, solids, room, 512);
        ASSERT_TRUE(sight);
        for (const Solid& solid : solids)
            for (const Vector& side : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)})
                for (const double sign : {-1.0, 1.0}) {
                    const Vector p = sight->toMap(solid.middle + sign * solid.radius * side);
                    EXPECT_LE(p.cwiseAbs().maxCoeff(), 1) << place.transpose();
                }
        // A point nearer to the light has the lesser depth.
        const Vector to = light.isPoint ? Vector(light.place.normalized()) : light.place;
        EXPECT_LT(sight->toMap(0.1 * to).z(), sight->toMap(-0.1 * to).z());
        EXPECT_GT(sight->texel, 0);
        EXPECT_LT(sight->texel, 0.02);
    }
    EXPECT_FALSE(sightOf(light, {}, room, 512));
    light.place = solids[0].middle; // within the ball about them
    EXPECT_FALSE(sightOf(light, solids, room, 512));
}

HandleSet handlesAt(const std::vector<Vector>& places, HandleKind kind) {
    HandleSet set;
    for (const Vector& place : places)
        set.handles.push_back({kind, set.handles.size(), 0, place, place});
    return set;
}

TEST(HandleLayout, HandlesInOnePlaceStandSideBySide) {
    const Size size{640, 480};
    const Camera camera;
    for (const std::size_t count : {2U, 3U, 6U}) {
        HandleSet set = handlesAt(std::vector(count, Vector(0.1, 0.2, 0)), HandleKind::velocity);
        set.handles.push_back({HandleKind::position, 9, 0, {0.1, 0.2, 0}, {0.1, 0.2, 0}});
        set.handles.push_back({HandleKind::position, 9, 0, {-0.5, 0, 0}, {-0.5, 0, 0}});
        spread(set, camera, size);
        EXPECT_TRUE(set.handles[count].aside.isZero()); // the largest stays
        EXPECT_TRUE(set.handles[count + 1].aside.isZero());
        for (std::size_t i = 0; i < set.handles.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(
                    (standOf(set.handles[i], camera, size) - standOf(set.handles[j], camera, size))
                        .norm(),
                    8)
                    << count;
    }
}

TEST(HandleLayout, HeadsOutsideThePictureAreBroughtInside) {
    const Size size{640, 480};
    Camera camera;
    camera.rotation = geometry::fromRotationVector({0.3, 0.2, 0});
    HandleSet set;
    set.handles.push_back({HandleKind::velocity, 0, 0, {0, 0, 0}, {40, 3, -2}, 2});
    set.handles.push_back({HandleKind::velocity, 1, 0, {0, 0, 0}, {0.4, 0, 0}, 2});
    set.handles.push_back({HandleKind::velocity, 2, 0, {40, 0, 0}, {41, 0, 0}, 2});
    const HandleSet before = set;
    keepInside(set, camera, size);
    const Pixels head = toPixels(camera, size, set.handles[0].place);
    EXPECT_GT(head.x(), 0);
    EXPECT_LT(head.x(), 640);
    EXPECT_TRUE(set.handles[0].cut);
    // It means the same value.
    EXPECT_LT((set.handles[0].place / set.handles[0].perUnit - Vector(20, 1.5, -1)).norm(), 1e-9);
    EXPECT_EQ(set.handles[1].place, before.handles[1].place);
    EXPECT_EQ(set.handles[2].place, before.handles[2].place); // its foot is not seen either
    EXPECT_FALSE(set.handles[1].cut);
}

TEST(HandleLayout, LabelsAvoidEachOther) {
    const Eigen::AlignedBox2d picture(Pixels(0, 0), Pixels(400, 300));
    std::vector<LabelWish> wishes;
    for (const Pixels& point :
         {Pixels(200, 150), Pixels(204, 152), Pixels(206, 148), Pixels(396, 4), Pixels(3, 297)})
        wishes.push_back({point, {50, 14}});
    const auto boxes = placedLabels(wishes, picture, 6);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(picture.contains(boxes[i])) << i;
        EXPECT_LT(boxes[i].squaredExteriorDistance(wishes[i].point), 20 * 20);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(boxes[i].intersection(boxes[j]).isEmpty()) << i << ' ' << j;
    }
    EXPECT_TRUE(placedLabels({}, picture, 6).empty());
}

} // namespace
} // namespace render
