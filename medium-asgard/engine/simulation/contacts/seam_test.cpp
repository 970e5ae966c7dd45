// Boxes that slide over seams, past faces in their own plane and through doors of their own width;
// boxes that are pushed; and what has no room. Right values by hand: without friction nothing slows
// what slides in one plane.
#include "contacts/held_level_testing.h"

#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

using ::testing::HasSubstr;

// Tiles four wide along x with their upper sides at y = 0, the first about the origin.
void tiles(SceneBuilder& b, int count, const Vector& away = Vector::Zero()) {
    for (int i = 0; i < count; ++i)
        b.box("tile" + std::to_string(i), away + Vector(4.0 * i, -0.5, 0), {4, 1, 4}).fixed = true;
}

struct Sliding {
    bool isHeavy;
    double restitution, turned, spin, far, accuracy;
};

class Seam : public ::testing::TestWithParam<Sliding> {};

TEST_P(Seam, IsSlidOverAtTheSameSpeed) {
    const Sliding& p = GetParam();
    const Vector away(p.far, -p.far / 2, p.far);
    SceneBuilder b(2, p.accuracy);
    tiles(b, 2, away);
    scene::Body& box = b.box("box", away + Vector(0, 0.5, 0), {1, 1, 1});
    box.restitution = p.restitution;
    box.initialVelocity = {2, 0, 0};
    box.initialAttitude = geometry::fromRotationVector({0, p.turned, 0});
    box.initialAngularVelocity = {0, p.spin, 0};
    if (p.isHeavy)
        b.weight("box");
    const Result result = simulate(b.scene);
    const Motion& motion = *result.motion;
    EXPECT_FALSE(motion.stop(2));
    EXPECT_TRUE(motion.impacts().empty());
    const BodyState end = motion.at(2, 2);
    EXPECT_LT(distance(end.position, away + Vector(4, 0.5, 0)), 10 * p.accuracy);
    EXPECT_LT(distance(end.velocity, {2, 0, 0}), 10 * p.accuracy);
    EXPECT_LT(distance(end.angularVelocity, {0, p.spin, 0}), 10 * p.accuracy);
}

INSTANTIATE_TEST_SUITE_P(
    Boxes, Seam,
    ::testing::Values(Sliding{true, 1, 0, 0, 0, 1e-4}, Sliding{true, 0.5, 0, 0, 0, 1e-2},
                      Sliding{true, 0, 0, 0, 0, 1e-9}, Sliding{false, 1, 0, 0, 0, 1e-4},
                      Sliding{false, 0, 0, 0, 0, 1e-9}, Sliding{true, 1, 0.3, 0, 0, 1e-4},
                      Sliding{true, 0.5, M_PI / 4, 0, 0, 1e-6},
                      Sliding{false, 0.5, 0.3, 0, 0, 1e-4}, Sliding{true, 1, 0, 3, 0, 1e-6},
                      Sliding{false, 1, 0, 3, 0, 1e-4}, Sliding{true, 1, 0, 0, 1e6, 1e-4},
                      Sliding{false, 0.5, 0.3, 0, 1e6, 1e-9}));

TEST(Seams, OfManyTilesAndOfOneBodysPartsAreSlidOver) {
    for (const bool isOneBody : {false, true}) {
        SceneBuilder b(3);
        if (isOneBody) {
            scene::Body& floor = b.box("floor", {0, -0.5, 0}, {1, 1, 4});
            floor.fixed = true;
            scene::ShapeSet& parts = b.scene.shapeSets.back();
            for (int i = 1; i < 9; ++i) {
                parts.parts.push_back(parts.parts[0]);
                parts.parts.back().position = {static_cast<double>(i), 0, 0};
            }
        } else {
            for (int i = 0; i < 9; ++i)
                b.box("tile" + std::to_string(i), {static_cast<double>(i), -0.5, 0}, {1, 1, 4})
                    .fixed = true;
        }
        scene::Body& box = b.box("box", {0.1, 0.5, 0}, {1, 1, 1});
        box.restitution = 0.5;
        box.initialVelocity = {2, 0, 0};
        b.weight("box");
        const Result result = simulate(b.scene);
        const BodyState end = result.motion->at(b.scene.bodies.size() - 1, 3);
        EXPECT_LT(distance(end.position, {6.1, 0.5, 0}), 1e-9);
        EXPECT_LT(distance(end.velocity, {2, 0, 0}), 1e-9);
    }
}

TEST(Seams, OfAStepAMillimetreHighStopTheBox) {
    SceneBuilder b(2);
    tiles(b, 2);
    b.scene.bodies[1].initialPosition.y() += 1e-3;
    b.box("box", {0, 0.5, 0}, {1, 1, 1}).initialVelocity = {2, 0, 0};
    b.weight("box");
    const Result result = simulate(b.scene);
    ASSERT_FALSE(result.motion->impacts().empty());
    EXPECT_NEAR(result.motion->impacts()[0].time, 0.75, 1e-9);
    EXPECT_LT(distance(result.motion->impacts()[0].normal, {1, 0, 0}), 1e-9); // from box to tile
}

// With its front edge exactly on the seam, neither weight nor push nor a blow holds it there.
TEST(Seams, DoNotHoldWhatStandsOnThem) {
    SceneBuilder b(2);
    tiles(b, 2);
    b.box("box", {1.5, 0.5, 0}, {1, 1, 1});
    b.weight("box");
    b.force("box", "1", "0", "0"); // mass 1: x = t^2 / 2
    EXPECT_LT(distance(simulate(b.scene).motion->at(2, 2).position, {3.5, 0.5, 0}), 1e-9);

    SceneBuilder hit(2);
    tiles(hit, 2);
    hit.box("box", {1.5, 0.5, 0}, {1, 1, 1});
    hit.ball("ball", {-0.2, 0.5, 0}, 0.2).initialVelocity = {1, 0, 0}; // meets it at t = 1
    hit.weight("box");
    const Result result = simulate(hit.scene);
    EXPECT_LT(distance(result.motion->at(2, 2).position, {2.5, 0.5, 0}), 1e-9);
    EXPECT_LT(result.motion->at(3, 2).velocity.norm(), 1e-9);
}

// Eight tiles down a slope, the box on the first: s = g sin(a) t^2 / 2.
TEST(Seams, OfASlopeAreSlidOver) {
    const double a = 0.3, s = std::sin(a), c = std::cos(a);
    SceneBuilder b(1.5);
    for (int i = 0; i < 8; ++i) {
        scene::Body& tile =
            b.box("tile" + std::to_string(i), {i * c - s, -i * s - c, 0}, {1, 1, 4});
        tile.fixed = true;
        tile.initialAttitude = geometry::fromRotationVector({0, 0, -a});
    }
    b.box("box", Vector::Zero(), {1, 1, 1}).initialAttitude =
        geometry::fromRotationVector({0, 0, -a});
    b.weight("box");
    const double way = g * s * 1.5 * 1.5 / 2;
    EXPECT_LT(distance(simulate(b.scene).motion->at(8, 1.5).position, {way * c, -way * s, 0}),
              1e-6);
}

TEST(Grazing, FacesInOnePlanePassEachOther) {
    for (const bool isFixed : {true, false})
        for (const double aside : {0.0, 1.0}) {
            SceneBuilder b(4);
            b.box("box", {0, 0, 0}, {1, 1, 1}).initialVelocity = {2, 0, 0};
            b.box("other", {4, 1, aside}, {1, 1, 1}).fixed = isFixed;
            const Result result = simulate(b.scene);
            EXPECT_TRUE(result.motion->impacts().empty());
            EXPECT_LT(distance(result.motion->at(0, 4).position, {8, 0, 0}), 1e-12);
            EXPECT_LT(distance(result.motion->at(1, 4).position, {4, 1, aside}), 1e-12);
        }
}

TEST(Grazing, ADoorAsWideAsTheBoxLetsItThrough) {
    for (const bool isHeavy : {false, true}) {
        SceneBuilder b(4);
        b.floor(40);
        for (const double side : {-1.0, 1.0})
            b.box(side < 0 ? "left" : "right", {4, 0.5, side}, {1, 1, 1}).fixed = true;
        b.box("box", {0, 0.5, 0}, {1, 1, 1}).initialVelocity = {2, 0, 0};
        if (isHeavy)
            b.weight("box");
        const Result result = simulate(b.scene);
        EXPECT_TRUE(result.motion->impacts().empty());
        EXPECT_LT(distance(result.motion->at(3, 4).position, {8, 0.5, 0}), 1e-9);
    }
}

// A plastic blow on a face whose patch covers the centre of mass: the box goes on with the pusher
// and does not turn, although the patch's own centre lies beside it.
TEST(Pushing, ABoxIsTakenAlongByAHeldPusherOfAnotherHeight) {
    for (const bool isHeavy : {false, true})
        for (const double height : {-0.1, 0.0, 0.1}) {
            SceneBuilder b(3);
            b.floor(40);
            b.box("pusher", {-4, 0.5, 0}, {1, 1, 1});
            b.hold("pusher", 0, 3, {{-4, 0.6 + height, 0}, {2, 0.6 + height, 0}}); // 2 m/s
            holdLevel(b, "pusher", 0, 3);
            b.box("box", {0, 0.5, 0}, {1, 1, 1}).restitution = 0;
            b.scene.bodies.back().initialVelocity = {1e-9, 0, 0};
            if (isHeavy)
                b.weight("box");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(2)) << height;
            const BodyState end = result.motion->at(2, 3); // met at 1.5
            EXPECT_LT(distance(end.position, {3, 0.5, 0}), 1e-6) << height;
            EXPECT_LT(distance(end.velocity, {2, 0, 0}), 1e-6);
            EXPECT_LT(end.angularVelocity.norm(), 1e-6);
        }
}

// At 1e6 coordinates are known to 1e-10, and times no better: the one hit is found and is none of
// resting.
TEST(FarAway, ABoxAndABallMeetAsTheyDoNearTheOrigin) {
    std::array<Vector, 2> velocities;
    for (const double far : {0.0, 1e6}) {
        SceneBuilder b(4, 1e-4);
        b.box("box", {far - 1.9064264215, 4.32867979, 0}, {0.5, 0.4, 0.7}).initialVelocity = {
            0.34425749, -0.55911557, 0};
        b.ball("ball", {far - 0.848359567, 3.69441026, 0.12583855}, 0.3).initialVelocity = {
            0.46336234, -0.53116242, 0};
        for (scene::Body& body : b.scene.bodies)
            body.mass = 50;
        scene::Link spring;
        spring.first.body = "ball";
        spring.second = scene::PointEnd{{std::to_string(far - 0.8), "3", "0"}};
        spring.damping = 0;
        spring.tightness = 63305.268135;
        b.scene.links.push_back(spring);
        const Result result = simulate(b.scene);
        EXPECT_FALSE(result.motion->stop(0)) << far;
        ASSERT_FALSE(result.motion->impacts().empty()) << far;
        velocities[far > 0] = result.motion->at(0, 4).velocity;
    }
    EXPECT_LT(distance(velocities[0], velocities[1]), 1e-2);
}

// A box slides onto a ramp that begins exactly where the floor ends as onto one that begins within
// the floor, `within` before that.
Vector endOnRamp(double angle, double friction, double within, double width = 1) {
    SceneBuilder b(1.2);
    const double s = std::sin(angle), c = std::cos(angle), along = 3 - within;
    b.box("floor", {-2, -0.1, 0}, {4, 0.2, 1});
    b.box("ramp", {along * c + 0.1 * s, along * s - 0.1 * c, 0}, {6, 0.2, width}).initialAttitude =
        geometry::fromRotationVector({0, 0, angle});
    b.box("box", {-1, 0.05, 0}, {0.2, 0.1, 0.2}).initialVelocity = {3, 0, 0};
    for (scene::Body& body : b.scene.bodies) {
        body.fixed = body.name != "box";
        body.friction = friction;
        body.restitution = 0;
    }
    b.weight("box");
    const Result result = simulate(b.scene);
    EXPECT_FALSE(result.motion->stop(2)) << angle << " " << friction << " " << within;
    return result.motion->at(2, 1.2).position;
}

TEST(Ramps, MayBeginWhereTheFloorEnds) {
    for (const double degrees : {10, 20, 35, 45})
        for (const double friction : {0.0, 0.05, 0.3}) {
            const double angle = degrees * std::numbers::pi / 180;
            EXPECT_LT(distance(endOnRamp(angle, friction, 0), endOnRamp(angle, friction, 1e-3)),
                      1e-5)
                << degrees << " " << friction;
        }
}

TEST(Ramps, MayBeNarrowerThanTheBox) {
    const double angle = 0.2;
    EXPECT_LT(distance(endOnRamp(angle, 0, 0, 0.1), endOnRamp(angle, 0, 1e-3, 0.1)), 1e-5);
}

// A box slides down to a floor that begins at the foot of the slope, or `within` before it.
Vector endBelowSlope(double angle, double within) {
    SceneBuilder b(0.7);
    const double s = std::sin(angle), c = std::cos(angle), along = 1.5 - within;
    b.box("floor", {-1.5, -0.1, 0}, {3, 0.2, 2});
    b.box("slope", {along * c + 0.1 * s, along * s - 0.1 * c, 0}, {3, 0.2, 2}).initialAttitude =
        geometry::fromRotationVector({0, 0, angle});
    b.box("box", {0.5 * c - 0.05 * s, 0.5 * s + 0.05 * c, 0}, {0.2, 0.1, 0.2}).initialAttitude =
        geometry::fromRotationVector({0, 0, angle});
    for (scene::Body& body : b.scene.bodies) {
        body.fixed = body.name != "box";
        body.restitution = 0;
    }
    b.weight("box");
    const Result result = simulate(b.scene);
    EXPECT_FALSE(result.motion->stop(2)) << angle << " " << within;
    return result.motion->at(2, 0.7).position;
}

TEST(Ramps, MayEndWhereTheFloorBegins) {
    for (const double degrees : {30.0, 53.13, 60.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        EXPECT_LT(distance(endBelowSlope(angle, 0), endBelowSlope(angle, 1e-5)), 1e-4) << degrees;
    }
}

TEST(NoRoom, ABallThatFitsBetweenElasticWallsIsSaidToLoseItsSpeed) {
    SceneBuilder b(1);
    b.box("left", {-1, 0, 0}, {1, 10, 10}).fixed = true;
    b.box("right", {1, 0, 0}, {1, 10, 10}).fixed = true;
    b.ball("ball", {0, 0, 0}, 0.5).initialVelocity = {3, 1, 0};
    const Result result = simulate(b.scene);
    ASSERT_EQ(result.motion->notes().size(), 1u);
    EXPECT_THAT(result.motion->notes()[0],
                HasSubstr("Body \"ball\" has no room between \"left\" and \"right\""));
    EXPECT_LT(distance(result.motion->at(2, 1).position, {0, 1, 0}), 1e-9);
}

// A cube in a V of two walls comes to lie on both, at any accuracy.
TEST(Groove, ACubeThatFallsBesideTheMiddleComesToLie) {
    for (const double accuracy : {1e-3, 1e-4, 1e-6})
        for (const double beside : {0.02, 0.1, 0.3}) {
            SceneBuilder b(4, accuracy);
            const double half = std::sqrt(0.5);
            for (const double side : {-1.0, 1.0}) {
                scene::Body& wall = b.box(side < 0 ? "left" : "right",
                                          {side * 3.5 * half, 2.5 * half, 0}, {6, 1, 6});
                wall.fixed = true;
                wall.initialAttitude =
                    geometry::fromRotationVector({0, 0, side * std::numbers::pi / 4});
            }
            scene::Body& cube = b.box("cube", {beside, 1.5, 0}, {1, 1, 1});
            cube.restitution = 0.3;
            cube.initialAttitude = geometry::fromRotationVector({0, 0, std::numbers::pi / 4});
            b.weight("cube");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(2)) << accuracy << " " << beside;
            EXPECT_LT(distance(result.motion->at(2, 4).position, {0, half, 0}), 1e-5)
                << accuracy << " " << beside;
        }
}

} // namespace
} // namespace simulation::testing
