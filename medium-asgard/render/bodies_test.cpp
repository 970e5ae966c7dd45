// Bodies in a picture: where they are, what they hide, how they are lit.
#include "render/test_renderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace render {
namespace {

// The outline of a ball of radius r at the plane z = 0: lines of sight touch it at the angle
// asin(r / D) from the axis, which is r D / sqrt(D^2 - r^2) on screen.
TEST_F(RendererTest, ABallCoversItsDisc) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red);
    for (int samples : {1, 4}) {
        drawing_.display.samples = samples;
        const Picture picture = draw();
        const double radius = 120 * 0.5 * eyeDistance / std::sqrt(eyeDistance * eyeDistance - 0.25);
        const double area = M_PI * radius * radius;
        const int covered =
            picture.count([&](int x, int y) { return picture.at(x, y) != 0xFFFFFF; });
        // The rim's soft edge reaches half a pixel further.
        EXPECT_NEAR(covered, area + 2 * M_PI * radius * 0.5, 0.02 * area) << samples;
        EXPECT_TRUE(isRed(picture, 160, 120));
    }
}

TEST_F(RendererTest, WhatIsNearerHidesWhatIsBehind) {
    addBody(scene_, sphere(0.4), {0, 0, 0.5}, red);
    addBody(scene_, sphere(0.4), {0, 0, -0.5}, blue);
    Picture picture = draw();
    EXPECT_TRUE(isRed(picture, 160, 120));
    // From behind it is the other way round.
    drawing_.camera.rotation = Quaternion(Eigen::AngleAxisd(M_PI, Vector::UnitY()));
    picture = draw();
    EXPECT_TRUE(isBlue(picture, 160, 120));
    EXPECT_EQ(picture.count([&](int x, int y) { return isRed(picture, x, y); }), 0);
}

TEST_F(RendererTest, TransparencyLetsTheColourBehindThrough) {
    addBody(scene_, sphere(0.3), {0, 0, -0.5}, blue);
    scene::Body& front = addBody(scene_, box({0.8, 0.8, 0.1}), {0, 0, 0.6}, red);
    const Picture opaque = draw();
    EXPECT_LT(opaque.blue(160, 120), 110);
    front.appearance.transparency = 0.6;
    const Picture glass = draw();
    EXPECT_GT(glass.blue(160, 120), opaque.blue(160, 120) + 40);
    EXPECT_TRUE(isRed(glass, 160, 78)); // beside the ball: red over white
    EXPECT_GT(glass.green(160, 78), opaque.green(160, 78) + 40);
    front.appearance.transparency = 1;
    const Picture gone = draw();
    EXPECT_EQ(gone.at(160, 78), 0xFFFFFFU);
    EXPECT_TRUE(isBlue(gone, 160, 120));
}

// Two panes in either order of the text look the same: sorting is by depth.
TEST_F(RendererTest, TransparentBodiesAreSortedByDepth) {
    const auto pane = [&](double z, const scene::Color& color) {
        addBody(scene_, box({1, 1, 0.05}), {0, 0, z}, color).appearance.transparency = 0.5;
    };
    pane(0.4, red);
    pane(-0.4, blue);
    const Picture one = draw();
    scene_ = {};
    pane(-0.4, blue);
    pane(0.4, red);
    EXPECT_EQ(one.bytes, draw().bytes);
    EXPECT_TRUE(isRed(one, 160, 120)); // the nearer one prevails
}

TEST_F(RendererTest, PartsInheritTheirColour) {
    addBody(scene_, sphere(0.3), {0, 0, 0}, red).appearance.color.reset();
    scene_.shapeSets[0].appearance.color = blue;
    EXPECT_TRUE(isBlue(draw(), 160, 120));
    scene_.bodies[0].appearance.color = red;
    EXPECT_TRUE(isRed(draw(), 160, 120));
    scene_.shapeSets[0].parts[0].appearance.color = blue;
    EXPECT_TRUE(isBlue(draw(), 160, 120));
}

TEST_F(RendererTest, WireframeCoversLittleAndShowsWhatIsBehind) {
    addBody(scene_, box({1.2, 1.2, 1.2}), {0, 0, 0}, red);
    addBody(scene_, box({0.3, 0.3, 0.3}), {0, 0, -2}, blue);
    const Picture solid = draw();
    EXPECT_EQ(solid.count([&](int x, int y) { return isBlue(solid, x, y); }), 0);
    drawing_.display.wireframe = true;
    const Picture lines = draw();
    EXPECT_LT(lines.drawn(), solid.drawn() / 4);
    EXPECT_GT(lines.drawn(), 400);
    EXPECT_GT(lines.count([&](int x, int y) { return isBlue(lines, x, y); }), 20);
}

// A box seen along a diagonal shows three faces of three different shades, and no edge of the
// hidden three.
TEST_F(RendererTest, FacesAreFlatAndDifferInBrightness) {
    addBody(scene_, box({1, 1, 1}), {0, 0, 0}, {0.7, 0.7, 0.7}).appearance.shininess = 0;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.6, 0, 0)) *
                               geometry::fromRotationVector(Vector(0, 0.6, 0));
    const Picture picture = draw();
    const auto shade = [&](const Vector& place) {
        const Eigen::Vector2d p = toPixels(drawing_.camera, picture.size, place);
        return picture.red(static_cast<int>(p.x()), static_cast<int>(p.y()));
    };
    const int top = shade({0, 0.5, 0}), front = shade({0, 0, 0.5}), left = shade({-0.5, 0, 0});
    // The sun comes over the left shoulder of whoever looks from the front.
    EXPECT_GT(top, front + 8);
    EXPECT_GT(front, left + 8);
    EXPECT_NEAR(shade({0.2, 0.5, 0.2}), top, 6);
    EXPECT_NEAR(shade({0.2, 0.2, 0.5}), front, 6);
}

TEST_F(RendererTest, ALightOfTheSceneReplacesTheDefaultOne) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, {0.7, 0.7, 0.7});
    scene::LightSource light;
    light.direction = Vector(1, 0, 0); // shines to the right: from the left
    scene_.lights = {light};
    const Picture directed = draw();
    EXPECT_GT(directed.red(115, 120), directed.red(205, 120) + 40);
    light = {};
    light.position = Vector(5, 0, 0);
    light.color = {1, 0, 0};
    scene_.lights = {light};
    const Picture point = draw();
    EXPECT_GT(point.red(205, 120), point.red(115, 120) + 40);
    EXPECT_GT(point.red(205, 120), point.blue(205, 120) + 40);
}

TEST_F(RendererTest, BodiesStandWhereTheMotionPutsThem) {
    addBody(scene_, sphere(0.2), {0, 0, 0}, red);
    drawing_.motion = std::make_shared<GivenMotion>(2, std::vector<GivenMotion::Law>{[](double t) {
                                                        return placed({t - 1, 0, 0});
                                                    }});
    drawing_.time = 1.5;
    const Picture picture = draw();
    EXPECT_TRUE(isRed(picture, 220, 120));
    EXPECT_EQ(picture.at(160, 120), 0xFFFFFFU);
}

// A wheel on an axis along z, seen from the front: only a turn about this axis needs a mark.
TEST_F(RendererTest, AWheelThatTurnsAboutItsAxisIsSeenToTurn) {
    scene::Part wheel;
    wheel.shape = scene::CylinderShape{0.6, 0.2};
    wheel.rotation = {M_PI / 2, 0, 0};
    addBody(scene_, wheel, {0, 0, 0}, red);
    const auto turn = [&](const Vector& velocity) {
        drawing_.motion =
            std::make_shared<GivenMotion>(1, std::vector<GivenMotion::Law>{[=](double t) {
                                              simulation::BodyState state = placed({0, 0, 0});
                                              state.attitude =
                                                  geometry::fromRotationVector(t * velocity);
                                              state.angularVelocity = velocity;
                                              return state;
                                          }});
    };
    const auto darker = [](const Picture& one, const Picture& other) {
        return one.count([&](int x, int y) { return one.red(x, y) + 10 < other.red(x, y); });
    };
    const double quarters = M_PI * 72 * 72 / 2;
    const Picture still = draw();
    turn({0, 0, M_PI / 2});
    const Picture before = draw();
    EXPECT_NEAR(darker(before, still), quarters, 0.2 * quarters);
    drawing_.time = 1;
    EXPECT_NEAR(darker(draw(), before), quarters, 0.2 * quarters);
    turn({0, 0.3, 0}); // as a coin that is turned over
    drawing_.time = 0;
    EXPECT_LT(darker(draw(), still), 50);
}

TEST_F(RendererTest, BodiesWithoutAKnownShapeOrPlaceAreLeftOut) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red).shape = "gone";
    addBody(scene_, sphere(0.5), Vector::Constant(std::nan("")), red);
    EXPECT_EQ(draw().drawn(), 0);
}

} // namespace
} // namespace render
