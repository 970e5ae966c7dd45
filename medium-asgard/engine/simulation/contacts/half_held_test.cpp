// Bodies of which trajectories hold a part: what blows and weights do to the rest. Against impulses
// worked out by hand, and against rigid bodies that tip about a fixed place.
#include "contacts/held_level_testing.h"

#include <algorithm>
#include <cmath>

namespace simulation::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double length = 2, thickness = 0.2; // of the bar, whose mass is 1
constexpr double inertia = (length * length + thickness * thickness) / 12;

scene::Body& heldBar(SceneBuilder& b, const Vector& position = {0, 0, 0},
                     const std::string& name = "bar") {
    scene::Body& bar = b.box(name, position, {length, thickness, 0.2});
    b.hold(name, 0, 10, {position});
    return bar;
}

// A further hold of the body, by the trajectory that the last constraint has.
scene::Constraint& alsoHold(SceneBuilder& b, scene::Held held) {
    scene::Constraint constraint = b.scene.constraints.back();
    constraint.held = held;
    b.scene.constraints.push_back(constraint);
    return b.scene.constraints.back();
}

// j (1/m + a^2/I) = (1 + e) v
TEST(HalfHeld, ABarOnAHeldCentreTakesTheSpinOfABlow) {
    constexpr double arm = 0.8, speed = 3;
    for (const double restitution : {1.0, 0.5})
        for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
            SceneBuilder b(0.5, accuracy);
            heldBar(b);
            scene::Body& ball = b.ball("ball", {arm, 1, 0});
            ball.initialVelocity = {0, -speed, 0};
            ball.restitution = restitution;
            const Result result = simulate(b.scene);
            expectNoStops(result, b.scene);
            const double impulse = (1 + restitution) * speed / (1 + arm * arm / inertia);
            const BodyState bar = result.motion->at(0, 0.5), after = result.motion->at(1, 0.5);
            EXPECT_NEAR(bar.angularVelocity.z(), -arm * impulse / inertia, 1e-12);
            EXPECT_EQ(bar.position, Vector(0, 0, 0));
            EXPECT_EQ(bar.velocity, Vector(0, 0, 0));
            EXPECT_NEAR(after.velocity.y(), impulse - speed, 1e-12);
            EXPECT_LT(*result.statistics.errorEstimate, accuracy);
        }
}

// Both take spin: with the same inertia the one gives all of its own to the other.
TEST(HalfHeld, TwoBarsOnHeldCentresTurnEachOther) {
    SceneBuilder b(0.4);
    heldBar(b);
    heldBar(b, {1.9, 0.35, 0}, "other").initialAngularVelocity = {0, 0, 1};
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    ASSERT_EQ(result.motion->impacts().size(), 1u);
    const Impact hit = result.motion->impacts()[0];
    const auto lever = [&](double x, double y) {
        return Vector(hit.point - Vector(x, y, 0)).cross(hit.normal).z();
    };
    const double sign = hit.first == 0 ? 1 : -1;
    const double first = sign * lever(0, 0), second = -sign * lever(1.9, 0.35);
    const double impulse = -2 * second / (first * first / inertia + second * second / inertia);
    EXPECT_NEAR(result.motion->at(0, 0.4).angularVelocity.z(), first * impulse / inertia, 1e-9);
    EXPECT_NEAR(result.motion->at(1, 0.4).angularVelocity.z(), 1 + second * impulse / inertia,
                1e-9);
}

// A bead on a rail moves along it only, by the part of the blow that is along it.
TEST(HalfHeld, ABeadOnARailMovesAlongItOnly) {
    SceneBuilder b(0.5, 1e-9);
    b.ball("bead", {0, 0, 0});
    b.hold("bead", 0, 10, {{0, 0, 0}});
    b.scene.constraints.back().held = scene::Held::y;
    alsoHold(b, scene::Held::z);
    const Vector direction = Vector(0.6, 0.8, 0);
    b.ball("ball", -direction).initialVelocity = 5 * direction;
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    const double impulse = 2 * 5 / (1 + 0.6 * 0.6);
    const BodyState bead = result.motion->at(0, 0.5);
    EXPECT_NEAR(bead.velocity.x(), 0.6 * impulse, 1e-12);
    EXPECT_EQ(bead.velocity.y(), 0);
    EXPECT_EQ(bead.position.y(), 0);
    EXPECT_NEAR((result.motion->at(1, 0.5).velocity - (5 - impulse) * direction).norm(), 0, 1e-12);
}

TEST(HalfHeld, ABodyThatIsHeldInRotationMovesAndDoesNotTurn) {
    SceneBuilder b(0.5, 1e-9);
    heldBar(b);
    b.scene.constraints.back().held = scene::Held::attitude;
    scene::Body& ball = b.ball("ball", {0.8, 1, 0});
    ball.initialVelocity = {0, -3, 0};
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    EXPECT_NEAR(result.motion->at(0, 0.5).velocity.y(), -3, 1e-12); // equal masses
    EXPECT_EQ(result.motion->at(0, 0.5).angularVelocity, Vector(0, 0, 0));
}

// A weight at one end pulls it down; it lies on the floor with that end, and stays.
TEST(HalfHeld, ABarOnAHeldCentreComesToLieOnTheFloor) {
    constexpr double height = 0.5;
    for (const double restitution : {0.0, 0.4})
        for (const double accuracy : {1e-3, 1e-6}) {
            SceneBuilder b(6, accuracy);
            b.floor().restitution = restitution;
            heldBar(b, {0, height, 0});
            scene::Force& pull = b.force("bar", "0", "-2", "0");
            pull.offset = {length / 2, 0, 0};
            const Result result = simulate(b.scene);
            expectNoStops(result, b.scene);
            // length/2 sin a + thickness/2 cos a = height
            const double reach = std::hypot(length, thickness) / 2;
            const double angle = std::asin(height / reach) - std::atan2(thickness, length);
            const Quaternion q = result.motion->at(1, 6).attitude;
            EXPECT_NEAR(2 * std::atan2(q.z(), q.w()), -angle, accuracy) << restitution;
            EXPECT_LT(result.motion->at(1, 6).angularVelocity.norm(), 1e-12) << restitution;
        }
}

// It is free along the floor only: dragged sideways, it falls, and lies.
TEST(HalfHeld, ABoxThatIsHeldSidewaysFallsAndLies) {
    SceneBuilder b(2, 1e-6);
    b.floor().restitution = 0;
    b.box("box", {0, 1, 0}, {0.4, 0.4, 0.4});
    b.hold("box", 0, 2, {{0, 0, 0}, {3, 0, 0}});
    b.scene.constraints.back().held = scene::Held::x;
    b.weight("box");
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    EXPECT_NEAR(result.motion->at(1, 2).position.y(), 0.2, 1e-9);
    EXPECT_NEAR(result.motion->at(1, 1.9).position.x(), 2.85, 1e-12);
}

// A weight that comes to rest beside the centre turns the bar for as long as it lies there.
TEST(HalfHeld, ASeesawTurnsUnderAWeightBesideItsCentre) {
    for (const bool isBall : {true, false})
        for (const double restitution : {0.0, 0.5}) {
            SceneBuilder b(4);
            heldBar(b);
            scene::Body& weight = isBall ? b.ball("weight", {0.3, 0.5, 0})
                                         : b.box("weight", {0.3, 0.5, 0}, {0.2, 0.2, 0.2});
            weight.restitution = restitution;
            b.weight("weight");
            const Result result = simulate(b.scene);
            expectNoStops(result, b.scene);
            EXPECT_LT(result.motion->at(0, 4).angularVelocity.z(), -1);
        }
}

TEST(HalfHeld, AHeldTableBearsWhatLiesOnItsCentre) {
    for (const bool isBall : {true, false}) {
        SceneBuilder b(1);
        b.box("table", {0, 0, 0}, {2, 0.2, 2});
        b.hold("table", 0, 2, {{0, 0, 0}});
        (isBall ? b.ball("load", {0, 0.3, 0}) : b.box("load", {0, 0.3, 0}, {0.2, 0.2, 0.2}))
            .restitution = 0;
        b.weight("load");
        const Result result = simulate(b.scene);
        expectNoStops(result, b.scene);
        EXPECT_NEAR(result.motion->at(1, 1).position.y(), 0.2, 1e-12);
    }
}

// Nothing about a bar that is driven flat against a wall can give way.
TEST(HalfHeld, ABarThatIsDrivenFlatAgainstAWallPassesThroughItAndSaysSo) {
    SceneBuilder b(1);
    b.floor();
    b.box("bar", {0, 1, 0}, {length, thickness, 0.2});
    b.hold("bar", 0, 1, {{0, 1, 0}, {0, -1, 0}});
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    EXPECT_NEAR(result.motion->at(1, 0.9).position.y(), -0.8, 1e-12);
    EXPECT_THAT(result.motion->notes(), Contains(HasSubstr("pass through each other")));
}

// The floor keeps it from turning, whichever way the blow would turn it: the ball goes off with
// twice the cart's speed, by its restitution.
TEST(HalfHeld, ACartThatIsLedAlongTheFloorKicksABallAsAWallDoes) {
    for (const double radius : {0.2, 0.3}) // below and above the cart's centre
        for (const double bounce : {0.0, 1.0}) {
            SceneBuilder b(2);
            b.floor().restitution = bounce;
            b.box("cart", {-2, 0.25, 0}, {1, 0.5, 0.6});
            b.hold("cart", 0, 2, {{-2, 0.25, 0}, {2, 0.25, 0}});
            b.weight("cart");
            b.ball("ball", {0, radius, 0}, radius).restitution = 0.8;
            b.weight("ball");
            const Result result = simulate(b.scene);
            expectNoStops(result, b.scene);
            EXPECT_TRUE(result.motion->notes().empty());
            EXPECT_NEAR(result.motion->at(2, 2).velocity.x(), 1.8 * 2, 1e-12);
            EXPECT_EQ(result.motion->at(1, 2).angularVelocity, Vector(0, 0, 0));
        }
}

// A hold beside the centre of mass makes no hinge.
TEST(HalfHeld, ABodyThatIsHeldBesideItsCentreTakesNoSpinAndSaysSo) {
    SceneBuilder b(0.5);
    heldBar(b);
    b.scene.shapeSets[0].parts[0].position = {0.5, 0, 0};
    scene::Body& ball = b.ball("ball", {0.8, 1, 0});
    ball.initialVelocity = {0, -3, 0};
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    EXPECT_EQ(result.motion->at(0, 0.5).angularVelocity, Vector(0, 0, 0));
    EXPECT_NEAR(result.motion->at(1, 0.5).velocity.y(), 3, 1e-12);
    EXPECT_THAT(result.motion->notes(), Contains(HasSubstr("beside its centre of mass")));
}

} // namespace
} // namespace simulation::testing
