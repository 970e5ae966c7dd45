#include "framing/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace render {
namespace {

using Pixels = Eigen::Vector2d;

Camera someCamera(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    const Vector turn(2 * any(random), 2 * any(random), 2 * any(random));
    return {Vector(any(random), any(random), any(random)) * 10, geometry::fromRotationVector(turn),
            std::exp(2 * any(random)), Vector(any(random), any(random), 0.3 * any(random))};
}

TEST(Camera, TheCentreIsInTheMiddleAndUnitsAreHalfTheShorterSide) {
    const Camera camera{Vector(3, 4, 5), Quaternion::Identity(), 0.5, Vector::Zero()};
    const Size size{640, 480};
    EXPECT_NEAR((toPixels(camera, size, Vector(3, 4, 5)) - Pixels(320, 240)).norm(), 0, 1e-12);
    // Two units at scale 1/2 are one unit of view; y goes up, pixels go down.
    EXPECT_NEAR((toPixels(camera, size, Vector(5, 4, 5)) - Pixels(560, 240)).norm(), 0, 1e-12);
    EXPECT_NEAR((toPixels(camera, size, Vector(3, 6, 5)) - Pixels(320, 0)).norm(), 0, 1e-12);
}

TEST(Camera, WhatIsNearerIsLarger) {
    const Camera camera;
    const Size size{200, 100};
    const double far = toPixels(camera, size, Vector(0.5, 0, -1)).x() - 100;
    const double near = toPixels(camera, size, Vector(0.5, 0, 1)).x() - 100;
    EXPECT_NEAR(far, 25 * eyeDistance / (eyeDistance + 1), 1e-9);
    EXPECT_NEAR(near, 25 * eyeDistance / (eyeDistance - 1), 1e-9);
}

// Else a window with panes at both sides would cut what a view of the text shows.
TEST(Camera, ANarrowPictureCutsNothingAtItsSides) {
    const Camera camera;
    for (const Size size : {Size{400, 300}, Size{300, 300}, Size{300, 900}}) {
        const double side = toPixels(camera, size, Vector(4.0 / 3, 0, 0)).x();
        EXPECT_NEAR(side, size.width, 1e-9) << size.height;
        EXPECT_GE(toPixels(camera, size, Vector(0, 1, 0)).y(), 0);
    }
    EXPECT_NEAR(toPixels(camera, {900, 300}, Vector(0, 1, 0)).y(), 0, 1e-9);
}

TEST(Camera, IsAnotherOneWhenAnyPartOfItDiffers) {
    const Camera one;
    EXPECT_EQ(one, Camera());
    Camera orthographic, turned;
    orthographic.orthographic = true;
    turned.rotation = geometry::fromRotationVector(Vector(0, 0.1, 0));
    for (const Camera& other : {orthographic, turned, Camera{.center = Vector(1, 0, 0)},
                                Camera{.scale = 2}, Camera{.position = Vector(0, 0, 1)}})
        EXPECT_NE(one, other);
}

TEST(Camera, AnOrthographicPictureShowsEqualLengthsEqually) {
    Camera camera;
    camera.orthographic = true;
    const Size size{200, 100};
    for (const double z : {-20.0, -1.0, 0.0, 4.0, 30.0})
        EXPECT_NEAR(toPixels(camera, size, Vector(0.5, 0.2, z)).x(), 125, 1e-9) << z;
    camera.rotation = geometry::fromRotationVector({0.3, -0.5, 0.1});
    for (const double z : {-3.0, 0.0, 8.0}) {
        const Vector world = toWorld(camera, size, {12, 77}, z);
        EXPECT_LT((toPixels(camera, size, world) - Pixels(12, 77)).norm(), 1e-9);
    }
}

TEST(Camera, PixelsLeadBackToTheWorld) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> across(0, 600);
    for (int i = 0; i < 200; ++i) {
        const Camera camera = someCamera(random);
        const Size size{600, 400};
        const Pixels pixels(across(random), across(random));
        const double z = across(random) / 300 - 1;
        const Vector world = toWorld(camera, size, pixels, z);
        EXPECT_LT((toPixels(camera, size, world) - pixels).norm(), 1e-8);
        const Vector view =
            camera.scale * (camera.rotation * (world - camera.center)) + camera.position;
        EXPECT_NEAR(view.z(), z, 1e-9);
    }
}

TEST(Camera, TurningAboutAnotherPointLeavesThePictureAsItIs) {
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const Camera before = someCamera(random);
        const Vector point(3, -1, 2), other(0.5, 0.7, -0.2);
        const Camera after = turningAbout(before, point);
        EXPECT_EQ(after.center, point);
        EXPECT_LT((toPixels(before, {}, other) - toPixels(after, {}, other)).norm(), 1e-6);
    }
}

TEST(Camera, FacingAnAxisMakesThePictureACoordinatePlane) {
    const Quaternion top = facing(Vector::UnitY(), Vector::UnitZ());
    EXPECT_LT((top * Vector::UnitY() - Vector::UnitZ()).norm(), 1e-12);
    EXPECT_LT((top * Vector::UnitZ() - Vector::UnitY()).norm(), 1e-12);
    // Where up is the line of sight itself, any side will do.
    const Quaternion down = facing(Vector::UnitY(), Vector::UnitY());
    EXPECT_LT((down * Vector::UnitY() - Vector::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(down.norm(), 1, 1e-12);
}

// --- the pointer ----------------------------------------------------------------------------

const Size picture{500, 500};

void drag(CameraControl& control, CameraControl::Button button, Pixels from, Pixels to,
          int steps = 1) {
    control.press(button, from, picture);
    for (int i = 1; i <= steps; ++i)
        control.move(from + (to - from) * i / steps, picture);
    control.release();
}

// A point on the front of the virtual sphere goes with the pointer.
TEST(CameraControl, AFrontPointFollowsTheLeftButton) {
    CameraControl control;
    const Pixels from(250, 250), to(290, 230);
    // The point of the virtual sphere that is nearest to the eye.
    const Vector front(0, 0, virtualSphere);
    drag(control, CameraControl::Button::left, from, to, 10);
    const Vector after = control.camera().rotation * front;
    EXPECT_NEAR(after.x(), 40 / pixelsPerUnit(picture), 0.005);
    EXPECT_NEAR(after.y(), 20 / pixelsPerUnit(picture), 0.005);
    EXPECT_EQ(control.camera().position, Vector::Zero());
    EXPECT_EQ(control.camera().scale, 1);
}

TEST(CameraControl, TheWayBackUndoesTheTurn) {
    CameraControl control;
    control.press(CameraControl::Button::left, {250, 250}, picture);
    for (Pixels to : {Pixels(330, 200), Pixels(380, 190), Pixels(330, 200), Pixels(250, 250)})
        EXPECT_TRUE(control.move(to, picture));
    EXPECT_LT(control.camera().rotation.angularDistance(Quaternion::Identity()), 1e-9);
}

TEST(CameraControl, TurnsStayTurnsHoweverManyThereAre) {
    CameraControl control;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> across(0, 500);
    control.press(CameraControl::Button::left, {250, 250}, picture);
    for (int i = 0; i < 10000; ++i)
        control.move({across(random), across(random)}, picture);
    EXPECT_NEAR(control.camera().rotation.norm(), 1, 1e-12);
}

// Wherever the drag begins and however long it is: the horizon stays level and upwards stays up,
// and the view stops straight from above and straight from below.
TEST(CameraControl, AnUprightPictureStaysUpright) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> across(0, 500);
    for (const Vector& up : {Vector(0, 1, 0), Vector(0, 0, 1), Vector(-1, 0, 0)}) {
        CameraControl control;
        Camera camera;
        camera.rotation = facing(Vector(0.3, 0.5, 0.4), up);
        control.set(camera);
        control.press(CameraControl::Button::left, {10, 250}, picture, up);
        for (int i = 0; i < 300; ++i) {
            control.move({across(random), across(random)}, picture);
            const Vector seen = control.camera().rotation * up;
            ASSERT_NEAR(seen.x(), 0, 1e-9);
            ASSERT_GT(seen.y(), 0);
        }
        control.move({250, -1e5}, picture);
        EXPECT_NEAR((control.camera().rotation * up).z(), -1, 1e-6);
        control.move({250, 1e5}, picture);
        EXPECT_NEAR((control.camera().rotation * up).z(), 1, 1e-6);
        control.release();
    }
}

// Sideways is about the world's own upright axis: seen from above the ground turns in its plane.
TEST(CameraControl, ADragSidewaysKeepsTheHeightOfTheEye) {
    CameraControl control;
    Camera camera;
    camera.rotation = facing(Vector(0, 2, 1), Vector::UnitY());
    control.set(camera);
    const double before = (camera.rotation * Vector::UnitY()).z();
    drag(control, CameraControl::Button::left, {20, 40}, {420, 40});
    EXPECT_NEAR((control.camera().rotation * Vector::UnitY()).z(), before, 1e-12);
    const double turn = camera.rotation.angularDistance(control.camera().rotation);
    EXPECT_NEAR(turn, 400 / pixelsPerUnit(picture) / virtualSphere, 1e-9);
    camera.rotation = facing(Vector::UnitY(), Vector::UnitZ()); // straight from above
    control.set(camera);
    drag(control, CameraControl::Button::left, {250, 250}, {300, 250});
    EXPECT_NEAR((control.camera().rotation * Vector::UnitY()).z(), 1, 1e-6);
}

// A picture that was rolled by choice keeps its roll.
TEST(CameraControl, ARolledPictureKeepsItsRoll) {
    CameraControl control;
    Camera camera;
    camera.rotation = Quaternion(Eigen::AngleAxisd(0.5, Vector::UnitZ())) *
                      facing(Vector(0, 0.4, 1), Vector::UnitY());
    control.set(camera);
    const auto roll = [&] {
        const Vector seen = control.camera().rotation * Vector::UnitY();
        return std::atan2(-seen.x(), seen.y());
    };
    const double before = roll();
    drag(control, CameraControl::Button::left, {20, 40}, {320, 190}, 7);
    EXPECT_NEAR(roll(), before, 1e-9);
}

TEST(CameraControl, FreelyDraggingOutsideTheSphereRolls) {
    CameraControl control;
    const auto onRim = [](double angle) {
        return Pixels(250 + 240 * std::sin(angle), 250 - 240 * std::cos(angle));
    };
    control.press(CameraControl::Button::left, onRim(0), picture);
    for (int i = 1; i <= 20; ++i)
        control.move(onRim(0.05 * i), picture, true);
    // Clockwise by one radian, as the pointer went.
    const Quaternion roll(Eigen::AngleAxisd(-1, Vector::UnitZ()));
    EXPECT_LT(control.camera().rotation.angularDistance(roll), 1e-9);
}

TEST(CameraControl, TheMiddleButtonPansExactly) {
    std::mt19937 random(2);
    for (int i = 0; i < 20; ++i) {
        CameraControl control(someCamera(random));
        const Pixels from(120, 300), to(260, 110);
        const Vector held = toWorld(control.camera(), picture, from, control.camera().position.z());
        drag(control, CameraControl::Button::middle, from, to, 3);
        EXPECT_LT((toPixels(control.camera(), picture, held) - to).norm(), 1e-8);
    }
}

TEST(CameraControl, TheRightButtonScalesOrRollsAndNeverBoth) {
    CameraControl up;
    drag(up, CameraControl::Button::right, {250, 250}, {260, 150}, 10);
    EXPECT_GT(up.camera().scale, 1.2);
    EXPECT_TRUE(up.camera().rotation.isApprox(Quaternion::Identity()));

    CameraControl side;
    drag(side, CameraControl::Button::right, {250, 250}, {350, 260}, 10);
    EXPECT_EQ(side.camera().scale, 1);
    const Vector right = side.camera().rotation * Vector::UnitX();
    EXPECT_LT(right.y(), -0.3);
    EXPECT_NEAR(right.z(), 0, 1e-12);
}

TEST(CameraControl, TheWheelKeepsThePointUnderThePointer) {
    std::mt19937 random(3);
    for (double notches : {1.0, -3.0, 0.25}) {
        CameraControl control(someCamera(random));
        const Pixels pointer(77, 402);
        const double depth = control.camera().position.z();
        const Vector held = toWorld(control.camera(), picture, pointer, depth);
        const double before = control.camera().scale;
        control.wheel(pointer, notches, picture);
        EXPECT_LT((toPixels(control.camera(), picture, held) - pointer).norm(), 1e-8);
        EXPECT_NEAR(control.camera().scale / before, std::exp(0.15 * notches), 1e-12);
    }
}

TEST(CameraControl, WithoutAButtonNothingMoves) {
    CameraControl control;
    EXPECT_FALSE(control.move({10, 10}, picture));
    EXPECT_FALSE(control.active());
    control.press(CameraControl::Button::left, {10, 10}, picture);
    EXPECT_TRUE(control.active());
    EXPECT_FALSE(control.move({10, 10}, picture));
    EXPECT_TRUE(control.move({20, 10}, picture));
    control.release();
    EXPECT_FALSE(control.move({30, 10}, picture));
}

} // namespace
} // namespace render
