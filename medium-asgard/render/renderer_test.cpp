#include "render/coils.h"
#include "render/contact_forces.h"
#include "render/handles.h"
#include "render/renderer.h"
#include "render/test_scenes.h"
#include "render/triad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace render {
namespace {

const scene::Color red{0.9, 0.1, 0.1}, blue{0.1, 0.2, 0.9}, green{0.1, 0.8, 0.2};

class RendererTest : public testing::Test {
protected:
    void SetUp() override {
        auto made = Renderer::create();
        ASSERT_TRUE(std::holds_alternative<std::unique_ptr<Renderer>>(made))
            << std::get<std::string>(made);
        renderer_ = std::move(std::get<0>(made));
        drawing_.scene = &scene_;
        // Bare bodies: what the tests count.
        drawing_.display.grid = drawing_.display.trails = false;
    }

    Picture draw(Size size = {320, 240}, std::size_t padding = 0) {
        Picture picture(size, padding);
        EXPECT_TRUE(renderer_->draw(drawing_, picture.image()));
        return picture;
    }

    std::unique_ptr<Renderer> renderer_;
    scene::Scene scene_;
    Drawing drawing_;
};

bool isRed(const Picture& p, int x, int y) { return p.red(x, y) > p.green(x, y) + 20; }
bool isBlue(const Picture& p, int x, int y) { return p.blue(x, y) > p.red(x, y) + 20; }

TEST_F(RendererTest, AnEmptySceneIsTheBackground) {
    EXPECT_EQ(draw().drawn(), 0);
    drawing_.display.background = {0, 0, 0};
    const Picture black = draw();
    EXPECT_EQ(black.count([&](int x, int y) { return black.at(x, y) == 0; }), 320 * 240);
}

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

TEST_F(RendererTest, TheTopRowComesFirst) {
    addBody(scene_, sphere(0.2), {0, 0.6, 0}, red);
    addBody(scene_, sphere(0.2), {0.6, -0.6, 0}, blue);
    const Picture picture = draw();
    EXPECT_TRUE(isRed(picture, 160, 48));
    EXPECT_TRUE(isBlue(picture, 232, 192));
}

TEST_F(RendererTest, RowsKeepTheirStride) {
    addBody(scene_, sphere(0.5), {0.2, 0.1, 0}, red);
    const Picture tight = draw();
    for (std::size_t padding : {64U, 6U}) { // 6: no whole number of pixels
        const Picture wide = draw({320, 240}, padding);
        EXPECT_EQ(wide.count([&](int x, int y) { return wide.at(x, y) != tight.at(x, y); }), 0);
        for (int y = 0; y < 240; ++y)
            for (std::size_t i = 0; i < padding; ++i)
                ASSERT_EQ(wide.bytes[static_cast<std::size_t>(y) * wide.stride + 4 * 320 + i],
                          std::byte{0x5A});
    }
}

TEST_F(RendererTest, TheSameDrawingHasTheSamePixels) {
    addBody(scene_, sphere(0.5), {0.2, 0.1, 0}, red);
    addBody(scene_, box({1, 0.5, 0.2}), {-0.3, 0.1, 0.3}, blue).appearance.transparency = 0.4;
    drawing_.display.grid = drawing_.display.axes = true;
    const Picture first = draw();
    draw({100, 77}); // another size in between leaves nothing behind
    EXPECT_EQ(first.bytes, draw().bytes);
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

TEST_F(RendererTest, TrailsReachBackFromNowAndBreakAtJumps) {
    addBody(scene_, sphere(0.05), {0, 0, 0}, red);
    const auto motion = std::make_shared<GivenMotion>(
        2, std::vector<GivenMotion::Law>{[](double t) {
            return placed(t < 1 ? Vector(t - 0.9, 0.5, 0) : Vector(t - 0.9, -0.5, 0));
        }});
    motion->jumpTimes = {1};
    drawing_.motion = motion;
    drawing_.time = 1.5;
    EXPECT_EQ(draw().at(120, 60), 0xFFFFFFU);
    drawing_.display.trails = true;
    const Picture picture = draw();
    EXPECT_TRUE(isRed(picture, 120, 60));                      // before the jump, above
    EXPECT_TRUE(isRed(picture, 190, 180));                     // after it, below
    EXPECT_EQ(picture.at(260, 180), 0xFFFFFFU);                // the future has no trail
    EXPECT_EQ(picture.at(172, 120), 0xFFFFFFU);                // nothing joins the two
    EXPECT_GT(picture.green(60, 60), picture.green(190, 180)); // older is fainter
}

TEST_F(RendererTest, TheGroundLiesUnderTheScene) {
    addBody(scene_, sphere(0.3), {0, 0.5, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.5, 0, 0));
    const int bare = draw().drawn();
    drawing_.display.grid = true;
    const Picture ground = draw();
    EXPECT_GT(ground.drawn(), bare + 2000);
    EXPECT_EQ(ground.at(160, 4), 0xFFFFFFU); // nothing over it
    // Discreet: its lines are light.
    EXPECT_EQ(ground.count([&](int x, int y) {
        return !isRed(ground, x, y) && ground.blue(x, y) < 90 && y > 160;
    }),
              0);
}

// The grid is seen through a box that stands on it: its lines lie below the top face.
TEST_F(RendererTest, TheGridIsUnderALoneBoxAndNotOnIt) {
    addBody(scene_, box({1, 1, 1}), {0, 0.4, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.34, 0, 0));
    drawing_.camera.scale = 0.5;
    const Picture bare = draw();
    drawing_.display.grid = true;
    const Picture grid = draw();
    const Eigen::Vector2d top = toPixels(drawing_.camera, grid.size, {0, 0.9, 0});
    int onIt = 0;
    for (int x = -20; x <= 20; ++x)
        for (int y = -2; y <= 2; ++y) {
            const int px = static_cast<int>(top.x()) + x, py = static_cast<int>(top.y()) + y;
            onIt += grid.at(px, py) != bare.at(px, py) ? 1 : 0;
        }
    EXPECT_EQ(onIt, 0);
}

// A point far from the origin is as steady as one at it.
TEST_F(RendererTest, DistanceFromTheOriginChangesNothing) {
    addBody(scene_, box({0.8, 0.5, 0.3}), {0, 0, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.3, 0.4, 0.1));
    const Picture here = draw();
    const Vector far(1e7, -3e7, 2e7);
    scene_.bodies[0].initialPosition = far;
    drawing_.camera.center = far;
    const Picture there = draw();
    EXPECT_LT(
        there.count([&](int x, int y) { return std::abs(there.red(x, y) - here.red(x, y)) > 8; }),
        20);
}

TEST_F(RendererTest, HandlesLieOnTopAndShowTheVelocity) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, blue).initialVelocity = {0.9, 0, 0};
    drawing_.display.positionHandles = drawing_.display.velocityHandles = true;
    const Picture picture = draw();
    const auto orange = [&](int x, int y) {
        return picture.red(x, y) > picture.blue(x, y) + 60 &&
               picture.green(x, y) > picture.blue(x, y);
    };
    EXPECT_TRUE(orange(160, 120));
    // 0.5 view units for 1: the round scale that makes the longest arrow a good part of the
    // picture.
    const int head = 160 + 54;
    EXPECT_GT(picture.green(head, 120), picture.red(head, 120) + 20);
    scene_.bodies[0].fixed = true; // then it has a place to be moved to, and no velocity
    const Picture fixed = draw();
    EXPECT_TRUE(fixed.red(160, 120) > fixed.blue(160, 120) + 60);
    EXPECT_LE(fixed.green(head, 120), fixed.red(head, 120) + 20);
}

// A body of mass 2 under its weight, a push that never changes and one that does.
TEST(Handles, ForcesHaveHandlesUnlessTheyChangeOnTheirOwn) {
    scene::Scene scene;
    addBody(scene, sphere(1), {3, 0, 0}, red).mass = 2;
    const std::string body = scene.bodies[0].name;
    scene.forces.push_back(
        {body, false, std::nullopt, scene::GravitationalForce{{0, -10, 0}}, {}, {}});
    scene.forces.push_back({body,
                            false,
                            Vector(0, 1, 0),
                            scene::ComponentForce{{"5", "-10 * " + body + ".mass", "0"}},
                            {},
                            {}});
    scene.forces.push_back(
        {body, true, std::nullopt, scene::ComponentForce{{"0", "0", "1+t"}}, {}, {}});
    Display display;
    display.forceHandles = display.torqueHandles = true;
    const auto motion = simulation::simulate(scene).motion;
    ASSERT_NE(motion, nullptr);
    const HandleSet set = Handles(scene, motion).at(0, display);
    ASSERT_EQ(set.handles.size(), 6U);
    const auto value = [&](std::size_t i) -> Vector {
        return (set.handles[i].place - set.handles[i].base) / set.handles[i].perUnit;
    };
    EXPECT_LT((value(1) - Vector(0, -10, 0)).norm(), 1e-12); // an acceleration
    EXPECT_LT((value(3) - Vector(5, -20, 0)).norm(), 1e-12);
    EXPECT_LT((set.handles[2].place - Vector(3, 1, 0)).norm(), 1e-12);
    EXPECT_TRUE(set.handles[3].movable);
    EXPECT_LT((value(5) - Vector(0, 0, 1)).norm(), 1e-9); // as it is now
    const HandleSet later = Handles(scene, motion).at(2, display);
    EXPECT_NEAR((later.handles[5].place - later.handles[5].base).z() / later.handles[5].perUnit, 3,
                1e-9);
    EXPECT_FALSE(set.handles[5].movable);
}

TEST(Handles, LinksAndTrajectoriesAreLinesWithTheirEnds) {
    scene::Scene scene;
    addBody(scene, sphere(1), {3, 0, 0}, red);
    scene::Link link;
    link.first = {scene.bodies[0].name, Vector(-1, 0, 0)};
    link.second = scene::PointEnd{{"0", "1 - 1", "2"}};
    link.tightness = 1;
    scene.links.push_back(link);
    scene::Trajectory path;
    path.points = {{0, Vector(0, 0, 0)}, {0.5, Vector(1, 0, 0)}};
    path.curves = {{0, 0.5, {Vector(0, 0, 0), Vector(0.5, 0, 0), Vector(1, 0, 0)}}};
    scene.trajectories.push_back(path);
    Display display;
    display.linkHandles = display.trajectories = true;
    const HandleSet set = Handles(scene, nullptr).at(0, display);
    ASSERT_EQ(set.handles.size(), 4U);
    EXPECT_EQ(set.handles[0].place, Vector(2, 0, 0));
    EXPECT_EQ(set.handles[1].place, Vector(0, 0, 2));
    EXPECT_EQ(set.handles[3].label, "0.5 s");
    ASSERT_EQ(set.lines.size(), 2U);
    EXPECT_EQ(set.lines[1].points.back(), Vector(1, 0, 0));
}

// A spring is seen without handles, from its body to its other end, and no wider than its coil.
TEST_F(RendererTest, ASpringIsACoilBetweenItsEnds) {
    addBody(scene_, sphere(0.1), {0.6, 0, 0}, red);
    scene::Link spring;
    spring.first = {scene_.bodies[0].name, std::nullopt};
    spring.second = scene::PointEnd{{"0", "0", "0 - 0"}};
    scene_.links.push_back(spring);
    const auto dark = [](const Picture& p, int x, int y) {
        return p.red(x, y) < 150 && p.green(x, y) < 150 && p.blue(x, y) < 150;
    };
    const auto darkIn = [&](const Picture& p, int fromX, int toX, int fromY, int toY) {
        return p.count([&](int x, int y) {
            return x >= fromX && x < toX && y >= fromY && y < toY && dark(p, x, y);
        });
    };
    const Size large{1280, 960};
    EXPECT_EQ(darkIn(draw(large), 660, 860, 400, 560), 0); // a link without its handles
    scene_.links[0].spring = scene::SpringLaw{};
    const Picture picture = draw(large);
    EXPECT_GT(darkIn(picture, 660, 860, 400, 476), 50); // above its line, and below
    EXPECT_GT(darkIn(picture, 660, 860, 484, 560), 50);
    EXPECT_EQ(darkIn(picture, 0, 636, 0, 960), 0);
    scene_.links[0].spring = scene::SpringLaw{5, true}; // slack: a bare line
    const Picture slack = draw(large);
    EXPECT_EQ(darkIn(slack, 660, 860, 400, 476), 0);
    EXPECT_GT(darkIn(slack, 660, 860, 476, 484), 50);
}

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

scene::Joint& addJoint(scene::Scene& scene, scene::JointType type, const Vector& offset,
                       std::size_t coordinates = 1) {
    scene::Joint& joint = scene.joints.emplace_back();
    joint.name = "joint" + std::to_string(scene.joints.size());
    joint.type = type;
    joint.body1 = scene.bodies.front().name;
    joint.offset1 = offset;
    joint.coordinates.resize(coordinates);
    return joint;
}

TEST(Handles, JointsHaveTheirPointTheirAxisAndADistanceBothOfItsPoints) {
    scene::Scene scene;
    addBody(scene, sphere(1), {3, 0, 0}, red);
    addJoint(scene, scene::JointType::hinge, {-1, 0, 0});
    addJoint(scene, scene::JointType::ball, {0, 1, 0});
    addJoint(scene, scene::JointType::distance, {0, 0, 0}).offset2 = Vector(0, 2, 0);
    Display display;
    display.jointHandles = true;
    const auto all = Handles(scene, nullptr).at(0, display).handles;
    ASSERT_EQ(all.size(), 5U);
    EXPECT_EQ(all[0].kind, HandleKind::jointAxis);
    EXPECT_LT(((all[0].place - all[0].base) / all[0].perUnit - Vector(0, 0, 1)).norm(), 1e-12);
    EXPECT_EQ(all[1].place, Vector(2, 0, 0));
    EXPECT_EQ(all[2].place, Vector(3, 1, 0));
    EXPECT_EQ(all[3].place, Vector(3, 0, 0));
    EXPECT_EQ(all[4].place, Vector(0, 2, 0));
    EXPECT_EQ(all[4].part, 1U);
}

// Brown pixels: of a joint's sign.
int signPixels(const Picture& p) {
    return p.count([&](int x, int y) {
        return p.red(x, y) > p.green(x, y) + 25 && p.green(x, y) > p.blue(x, y) + 12;
    });
}

TEST_F(RendererTest, EveryTypeOfJointHasASignOverItsBody) {
    const scene::Color grey{0.7, 0.7, 0.7};
    addBody(scene_, box({1, 1, 1}), {0, 0, 0}, grey);
    EXPECT_EQ(signPixels(draw()), 0);
    using enum scene::JointType;
    std::vector<int> seen;
    for (const auto type :
         {fixed, hinge, slider, cylindrical, universal, ball, planar, distance, screw}) {
        scene_.joints.clear();
        scene::Joint& joint = addJoint(scene_, type, {0, 0, 0});
        joint.axis = {1, 1, 0};
        joint.pitch = 0.1;
        joint.offset2 = type == distance ? Vector(0, 0.4, 0) : Vector(0, 0, 0);
        seen.push_back(signPixels(draw()));
        EXPECT_GT(seen.back(), 15) << joint.name << static_cast<int>(type);
        EXPECT_LT(seen.back(), 900) << static_cast<int>(type);
        for (const scene::Color& paper : {scene::Color{1, 1, 1}, scene::Color{0, 0, 0}}) {
            drawing_.display.background = paper;
            EXPECT_GT(signPixels(draw()), 15) << static_cast<int>(type);
        }
        drawing_.display.background = {1, 1, 1};
    }
    drawing_.display.joints = false;
    EXPECT_EQ(signPixels(draw()), 0);
}

TEST_F(RendererTest, LimitsAreSeenAndAJointThatWasReleasedIsNot) {
    addBody(scene_, box({1, 1, 1}), {0, 0, 0}, {0.7, 0.7, 0.7});
    scene::Joint& joint = addJoint(scene_, scene::JointType::hinge, {0, 0.4, 0});
    const int bare = signPixels(draw());
    joint.coordinates[0].lower = -1;
    joint.coordinates[0].upper = 1;
    EXPECT_GT(signPixels(draw()), bare + 20);
    joint.coordinates[0].upper.reset();
    EXPECT_GT(signPixels(draw()), bare + 10);
    drawing_.motion = std::make_shared<GivenMotion>(2, std::vector<GivenMotion::Law>{[](double t) {
                                                        return placed({0.5 * t, 0, 0});
                                                    }});
    EXPECT_GT(signPixels(draw()), 15);
    drawing_.time = 1;
    EXPECT_EQ(signPixels(draw()), 0);
}

TEST(Handles, ArrowsHaveASteadyScaleOfTheScreen) {
    scene::Scene scene;
    addBody(scene, sphere(1), {0, 0, 0}, red).initialVelocity = {300, 0, 0};
    Display display;
    display.velocityHandles = true;
    Handles handles(scene, nullptr);
    const Size size{640, 480};
    std::vector<double> lengths;
    for (const double scale : {0.1, 0.2, 0.5}) {
        const Camera camera{Vector::Zero(), Quaternion::Identity(), scale, Vector::Zero()};
        const Handle one = handles.at(0, display, camera, size).handles.at(0);
        EXPECT_NEAR(((one.place - one.base) / one.perUnit - Vector(300, 0, 0)).norm(), 0, 1e-9);
        lengths.push_back(
            (toPixels(camera, size, one.place) - toPixels(camera, size, one.base)).norm());
    }
    EXPECT_NEAR(lengths[0], lengths[1], 1e-6);
    EXPECT_NEAR(lengths[0], lengths[2], 1e-6);
    EXPECT_GT(lengths[0], 60);
    EXPECT_LT(lengths[0], 240);
}

// A trajectory of a force is no path in space: its values are arrows from where it acts.
TEST(Handles, TheTrajectoryOfAForceIsItsArrows) {
    scene::Scene scene;
    addBody(scene, sphere(0.1), {3, 0, 0}, red);
    scene::Trajectory path;
    path.name = "push";
    path.points = {{0, Vector(0, 0, 0)}, {0.5, Vector(0, 40, 0)}};
    path.curves = {{0, 0.5, {Vector(0, 0, 0), Vector(0, 40, 0)}}};
    scene.trajectories.push_back(path);
    scene.forces.push_back(
        {scene.bodies[0].name, false, std::nullopt, scene::TrajectoryForce{"push"}, {}, {}});
    Display display;
    display.trajectories = true;
    const HandleSet set = Handles(scene, nullptr).at(0, display);
    EXPECT_TRUE(set.lines.empty());
    ASSERT_EQ(set.handles.size(), 2U);
    EXPECT_EQ(set.handles[1].base, Vector(3, 0, 0));
    EXPECT_LT((set.handles[1].valueAt(set.handles[1].place) - Vector(0, 40, 0)).norm(), 1e-9);
    EXPECT_TRUE(set.handles[1].movable);
    // One that bodies follow is a path.
    scene.constraints.push_back({scene.bodies[0].name, scene::Held::position, "push", {}, {}, {}});
    EXPECT_EQ(Handles(scene, nullptr).at(0, display).lines.size(), 1U);
}

TEST_F(RendererTest, BodiesShadeWhatIsBehindThemFromTheSun) {
    addBody(scene_, box({3, 0.1, 3}), {0, -0.5, 0}, {0.8, 0.8, 0.8}).fixed = true;
    addBody(scene_, box({0.4, 0.4, 0.4}), {0, 0.2, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.9, 0, 0));
    drawing_.camera.scale = 0.6;
    drawing_.display.shadows = false;
    for (const int samples : {1, 4}) {
        drawing_.display.samples = samples;
        drawing_.display.shadows = false;
        const Picture bare = draw();
        drawing_.display.shadows = true;
        const Picture shaded = draw();
        const int dark =
            shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 20; });
        const int light =
            shaded.count([&](int x, int y) { return shaded.red(x, y) > bare.red(x, y) + 2; });
        EXPECT_GT(dark, 150) << samples;
        EXPECT_LT(dark, 2500) << samples;
        EXPECT_EQ(light, 0) << samples;
        // Nothing shades itself: the lit faces of the box are as they were.
        const Eigen::Vector2d top = toPixels(drawing_.camera, shaded.size, {0, 0.4, 0});
        const int x = static_cast<int>(top.x()), y = static_cast<int>(top.y());
        EXPECT_EQ(shaded.at(x, y), bare.at(x, y)) << samples;
    }
}

TEST_F(RendererTest, ABallShadesNoDotsOnItself) {
    addBody(scene_, sphere(0.8), {0, 0, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.34, -0.48, 0));
    drawing_.display.samples = 4;
    drawing_.display.shadows = false;
    const Picture bare = draw();
    drawing_.display.shadows = true;
    const Picture shaded = draw();
    EXPECT_EQ(shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 4; }), 0);
}

TEST_F(RendererTest, ShadowsFallOnTheGroundOfASceneWithoutAFloor) {
    addBody(scene_, sphere(0.3), {0, 0.3, 0}, red);
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(0.7, 0, 0));
    drawing_.camera.scale = 0.7;
    drawing_.display.grid = true;
    drawing_.display.shadows = false;
    const Picture bare = draw();
    drawing_.display.shadows = true;
    const Picture shaded = draw();
    EXPECT_GT(shaded.count([&](int x, int y) { return shaded.red(x, y) < bare.red(x, y) - 20; }),
              100);
}

TEST_F(RendererTest, AStudioHasASkyAndAHorizonLightOrDark) {
    addBody(scene_, sphere(0.1), {0, 0, 0}, red);
    drawing_.display.studio = true;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(-0.1, 0, 0));
    const Picture light = draw();
    EXPECT_GT(light.red(20, 20), 180);
    EXPECT_GT(light.blue(20, 5), light.red(20, 5) + 8); // the sky is bluer than the ground
    EXPECT_LT(light.blue(20, 235), light.red(20, 235) + 8);
    drawing_.display.background = {0.1, 0.1, 0.1};
    const Picture dark = draw();
    EXPECT_LT(dark.green(20, 20), 90);
    EXPECT_LT(dark.green(20, 235), 60);
    EXPECT_EQ(draw().bytes, dark.bytes);
}

// The grid stands still in the world: the same lines are seen wherever the view's middle is.
TEST_F(RendererTest, TheGridStaysWhereItIsWhenTheViewMoves) {
    addBody(scene_, sphere(0.05), {0, 0, 0}, red);
    drawing_.display.grid = drawing_.display.studio = true;
    drawing_.camera.rotation = geometry::fromRotationVector(Vector(M_PI / 2, 0, 0)); // from above
    drawing_.camera.orthographic = true;
    const Picture before = draw();
    drawing_.camera.position = {0.5, 0, 0}; // 60 pixels
    const Picture after = draw();
    int same = 0, lines = 0;
    for (int x = 80; x < 240; ++x) {
        const bool line = before.red(x, 30) < before.red(x + 1, 30) - 4;
        lines += line ? 1 : 0;
        same += line && after.red(x + 60, 30) < after.red(x + 61, 30) - 4 ? 1 : 0;
    }
    EXPECT_GT(lines, 3);
    EXPECT_GE(same, lines - 1);
}

TEST_F(RendererTest, HandlesBehindABodyAreFaint) {
    addBody(scene_, sphere(0.1), {0, 0, -1}, green);
    addBody(scene_, box({1, 1, 0.1}), {0, 0, 0.5}, {0.2, 0.2, 0.25});
    drawing_.display.positionHandles = true;
    const Picture hidden = draw();
    const Eigen::Vector2d place = toPixels(drawing_.camera, hidden.size, {0, 0, -1});
    const int x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
    // The box's own handle is over it, the ball's shines through.
    scene_.bodies[1].initialPosition = {0.3, 0.3, 0.5};
    const Picture faint = draw();
    EXPECT_GT(faint.red(x, y), faint.blue(x, y) + 15);
    EXPECT_LT(faint.red(x, y), 200);
    scene_.bodies[1].initialPosition = {3, 0, 0.5};
    EXPECT_GT(draw().red(x, y), 225);
}

TEST_F(RendererTest, TheTriadAndTheCentreOfRotationAreMarks) {
    EXPECT_EQ(draw().drawn(), 0);
    drawing_.display.triad = true;
    const Picture triad = draw();
    const Eigen::Vector2d middle = triadMiddle(triad.size);
    const double reach = triadReach(triad.size);
    EXPECT_GT(triad.drawn(), 100);
    EXPECT_EQ(triad.count([&](int x, int y) {
        return triad.at(x, y) != 0xFFFFFF &&
               (Eigen::Vector2d(x, y) - middle).cwiseAbs().maxCoeff() > reach + 1;
    }),
              0);
    drawing_.display.triad = false;
    drawing_.display.rotationCenter = true;
    const Picture center = draw();
    EXPECT_LT(center.red(160, 120), 120);
    EXPECT_EQ(center.count([&](int x, int y) {
        return center.at(x, y) != 0xFFFFFF && std::hypot(x - 160, y - 120) > 12;
    }),
              0);
}

// A box that rests on a floor: its weight, upwards, within the cone of friction.
void expectWeightOnFloor(bool isDeclared) {
    scene::Scene scene;
    scene::Body& floor = addBody(scene, box({4, 0.2, 4}), {0, -0.1, 0}, red);
    floor.fixed = true;
    floor.friction = 0.5;
    scene::Body& block = addBody(scene, box({0.4, 0.4, 0.4}), {0.3, 0.2, 0}, blue);
    block.mass = 2;
    block.friction = 0.5;
    block.restitution = 0;
    for (scene::Body& body : scene.bodies)
        body.restitution = 0;
    scene.forces.push_back({scene.bodies[1].name,
                            false,
                            std::nullopt,
                            scene::GravitationalForce{{0, -10, 0}},
                            {},
                            {}});
    scene.simulator.finish = 1;
    if (isDeclared) { // without a name
        scene::Contact& contact = scene.contacts.emplace_back();
        contact.body1 = scene.bodies[1].name;
        contact.body2 = scene.bodies[0].name;
    }
    const auto motion = simulation::simulate(scene).motion;
    ASSERT_NE(motion, nullptr);
    ContactForces forces;
    const auto seen = forces.at(scene, motion, 0.5);
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_LT((seen[0].force - Vector(0, -20, 0)).norm(), 1e-3); // on the floor, the first
    EXPECT_LT((seen[0].normal - Vector(0, -1, 0)).norm(), 1e-6);
    EXPECT_NEAR(seen[0].friction, 0.5, 1e-12);
    EXPECT_NEAR(seen[0].point.y(), 0, 1e-6);
}

TEST(ContactForces, AreReadOfContactsThatTheSceneDoesNotName) {
    expectWeightOnFloor(false);
    expectWeightOnFloor(true);
}

TEST_F(RendererTest, MoreSamplesThanThereAreAreClamped) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red);
    drawing_.display.samples = 64;
    EXPECT_TRUE(isRed(draw(), 160, 120));
    EXPECT_GE(renderer_->maximumSamples(), 1);
    EXPECT_GE(renderer_->maximumSize(), 2048);
    EXPECT_FALSE(renderer_->description().empty());
}

TEST_F(RendererTest, ImagesThatDoNotHoldThePictureAreRefused) {
    Picture picture({32, 32});
    Image tooShort = picture.image();
    tooShort.pixels = tooShort.pixels.first(tooShort.pixels.size() - 1);
    EXPECT_FALSE(renderer_->draw(drawing_, tooShort));
    Image tooNarrow = picture.image();
    tooNarrow.stride = 100;
    EXPECT_FALSE(renderer_->draw(drawing_, tooNarrow));
    Image empty = picture.image();
    empty.size = {0, 32};
    EXPECT_FALSE(renderer_->draw(drawing_, empty));
}

// Several windows of one process have renderers of their own.
TEST_F(RendererTest, RenderersDoNotDisturbEachOther) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red);
    const Picture before = draw();
    auto second = Renderer::create();
    ASSERT_EQ(second.index(), 0U);
    Picture other({50, 50});
    EXPECT_TRUE(std::get<0>(second)->draw(drawing_, other.image()));
    EXPECT_EQ(before.bytes, draw().bytes);
    std::get<0>(second).reset();
    EXPECT_EQ(before.bytes, draw().bytes);
}

// A rope whose ends lie beyond the picture, one of them nearer to the eye, crosses all of it.
TEST_F(RendererTest, ARopeIsSeenWhoseEndsAreNot) {
    addBody(scene_, sphere(0.1), {5, 0, 0}, red); // beyond the picture, too
    scene_.ropes.resize(1);
    for (const double height : {0.4, -0.3}) {
        scene::Rope::Point point;
        point.place = Vector(0, height, 0);
        scene_.ropes[0].points.push_back(point);
    }
    drawing_.camera.scale = 8;
    const Vector toward = Vector(0.35, 0.13, 0.7).normalized();
    drawing_.camera.rotation = facing(toward, Vector::UnitY());
    const Picture picture = draw();
    for (const int y : {0, 60, 120, 180, 239}) {
        const int dark = picture.count([&](int x, int row) {
            return row == y && std::abs(x - 160) <= 3 && picture.red(x, row) < 160;
        });
        EXPECT_GE(dark, 1) << y;
        EXPECT_LE(dark, 3) << y;
    }
}

TEST_F(RendererTest, BodiesWithoutAKnownShapeOrPlaceAreLeftOut) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, red).shape = "gone";
    addBody(scene_, sphere(0.5), Vector::Constant(std::nan("")), red);
    EXPECT_EQ(draw().drawn(), 0);
}

} // namespace
} // namespace render
