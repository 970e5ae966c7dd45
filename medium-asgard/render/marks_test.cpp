// Handles, signs, paths and the triad in a picture.
#include "handles/handles.h"
#include "render/test_renderer.h"
#include "surroundings/triad.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace render {
namespace {

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

// Brown pixels: of a joint's sign.
int signPixels(const Picture& p) {
    return p.count([&](int x, int y) {
        return p.red(x, y) > p.green(x, y) + 25 && p.green(x, y) > p.blue(x, y) + 12;
    });
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

// Filled, it would be one more ball of the scene where its body has left it.
TEST_F(RendererTest, WhereABodyStartsIsARingAboutAPoint) {
    addBody(scene_, sphere(0.5), {0, 0, 0}, blue);
    drawing_.display.positionHandles = true;
    const Picture picture = draw({640, 480});
    std::string along; // to the right: of the mark, of the body
    for (int x = 320; x < 345; ++x) {
        const bool isMark = picture.red(x, 240) > picture.blue(x, 240) + 60;
        const bool isBody = picture.blue(x, 240) > picture.red(x, 240) + 40;
        const char now = isMark ? 'm' : isBody ? 'b' : ' ';
        if (along.empty() || along.back() != now)
            along += now;
    }
    EXPECT_EQ(std::erase(along, ' '), 2) << along; // its light edge
    EXPECT_EQ(along, "mbmb");
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

// Of an empty scene, too: the first body is to be put somewhere.
TEST_F(RendererTest, AGridFacesWhoLooksAlongAnAxis) {
    drawing_.display.studio = true;
    const auto inTheSky = [&] { // pixels of the grid's lines and numbers
        drawing_.display.grid = false;
        const Picture bare = draw();
        drawing_.display.grid = true;
        const Picture ruled = draw();
        return ruled.count(
            [&](int x, int y) { return y < 100 && ruled.at(x, y) != bare.at(x, y); });
    };
    EXPECT_GT(inTheSky(), 1000);
    drawing_.camera.rotation = facing({1, 0, 0}, Vector::UnitY());
    EXPECT_GT(inTheSky(), 1000);
    drawing_.camera.rotation = facing({0.3, 0, 1}, Vector::UnitY());
    EXPECT_EQ(inTheSky(), 0);
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

} // namespace
} // namespace render
