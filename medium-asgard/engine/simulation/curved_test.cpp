// Curved bodies and half spaces: bounces against the impulse at the point that touches, and rest on
// a half space.
#include "simulation/testing.h"

#include <cmath>
#include <numbers>

namespace simulation::testing {
namespace {

void addBody(SceneBuilder& b, const std::string& name, const scene::Part& part,
             const Vector& place) {
    b.scene.shapeSets.push_back({name, {part}, {}, {}});
    scene::Body body;
    body.name = body.shape = name;
    body.initialPosition = place;
    b.scene.bodies.push_back(body);
}

scene::Part partOf(decltype(scene::Part::shape) shape) {
    scene::Part part;
    part.shape = std::move(shape);
    return part;
}

// A floor that is everywhere, and a body above it.
SceneBuilder above(const scene::Part& part, const Vector& place, double finish) {
    SceneBuilder b(finish, 1e-9);
    addBody(b, "b", part, place);
    addBody(b, "floor", partOf(scene::PlaneShape{}), Vector::Zero());
    b.scene.bodies[1].fixed = true;
    b.weight("b");
    return b;
}

struct Leaning {
    scene::Part part;
    double low;       // its lowest point below the centre of mass
    double beside;    // and beside it along x, when it leans by the angle about z
    double inertia;   // about z, over the mass
    double below = 0; // the centre of mass below the part's origin, along its axis
};

// It falls from rest, touches after `fall`, and the impulse j there gives it j/m and a spin
// j beside / I:    j (1/m + beside^2 / I) = (1 + e) speed.
void expectBounce(const Leaning& leaning, double angle, double restitution) {
    const double fall = 0.4, speed = g * fall, after = 0.01;
    const geometry::Quaternion turn = geometry::fromRotationVector({0, 0, angle});
    const Vector centre(0, leaning.low + g * fall * fall / 2, 0);
    SceneBuilder b = above(leaning.part, centre + turn * Vector(0, leaning.below, 0), fall + after);
    b.scene.bodies[0].initialAttitude = turn;
    b.scene.bodies[0].restitution = restitution;
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion);
    ASSERT_FALSE(result.motion->stop(0)) << result.motion->stop(0)->sentence;
    const double impulse =
        (1 + restitution) * speed / (1 + leaning.beside * leaning.beside / leaning.inertia);
    const BodyState state = result.motion->at(0, fall + after);
    EXPECT_NEAR(state.angularVelocity.z(), impulse * leaning.beside / leaning.inertia, 1e-7);
    EXPECT_NEAR(state.velocity.y(), impulse - speed - g * after, 1e-7);
    EXPECT_LT(state.velocity.head<1>().norm() + state.angularVelocity.head<2>().norm(), 1e-9);
    EXPECT_NEAR(state.position.y(), leaning.low + (impulse - speed) * after - g * after * after / 2,
                1e-8);
}

TEST(CurvedBodies, BounceByTheImpulseAtThePointThatTouches) {
    const double a = 0.4, c = std::cos(a), s = std::sin(a), r = 0.3, h = 0.8;
    for (const double e : {1.0, 0.5}) {
        const double tube = r * r * h, ball = 4 * r * r * r / 3, volume = tube + ball;
        const double capsule =
            (tube * (r * r / 4 + h * h / 12) + ball * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8)) /
            volume;
        expectBounce({partOf(scene::CapsuleShape{r, h}), h / 2 * c + r, h / 2 * s, capsule}, a, e);
        expectBounce({partOf(scene::CylinderShape{r, h}), h / 2 * c + r * s, h / 2 * s - r * c,
                      r * r / 4 + h * h / 12},
                     a, e);
        // The rim at -h/4 from the centre of mass; upside down the tip at 3 h / 4.
        const double cone = 3 * r * r / 20 + 3 * h * h / 80;
        expectBounce(
            {partOf(scene::ConeShape{r, h}), h / 4 * c + r * s, h / 4 * s - r * c, cone, h / 4}, a,
            e);
        const double b = a + std::numbers::pi;
        expectBounce({partOf(scene::ConeShape{r, h}), 3 * h / 4 * c, 3 * h / 4 * s, cone, h / 4}, b,
                     e);
        const double p = 0.2, q = 0.5, low = std::hypot(p * s, q * c);
        expectBounce({partOf(scene::EllipsoidShape{{p, q, 0.3}}), low,
                      (q * q - p * p) * s * c / low, (p * p + q * q) / 5},
                     a, e);
    }
}

TEST(CurvedBodies, MeetAHalfSpaceEverywhere) {
    SceneBuilder b = above(partOf(scene::SphereShape{0.5}), {0, 20.5, 0}, 3);
    b.scene.bodies[0].initialVelocity = {5000, 0, 0};
    b.scene.bodies[0].restitution = 1;
    const double fall = std::sqrt(2 * 20 / g);
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion);
    const double t = 3 - fall;
    const BodyState state = result.motion->at(0, 3);
    EXPECT_NEAR(state.position.y(), 0.5 + g * fall * t - g * t * t / 2, 1e-8);
    EXPECT_NEAR(state.position.x(), 15000, 1e-6);
}

TEST(CurvedBodies, RestOnAHalfSpace) {
    for (const scene::Part& part :
         {partOf(scene::SphereShape{0.5}), partOf(scene::BoxShape{{1, 1, 2}})}) {
        SceneBuilder b = above(part, {3, 1.5, 0}, 5);
        b.scene.bodies[0].restitution = 0.5;
        b.scene.bodies[0].initialVelocity = {0.5, 0, 0};
        const Result result = simulate(b.scene);
        ASSERT_TRUE(result.motion);
        ASSERT_FALSE(result.motion->stop(0)) << result.motion->stop(0)->sentence;
        const BodyState state = result.motion->at(0, 5);
        EXPECT_NEAR(state.position.y(), 0.5, 1e-9);
        EXPECT_NEAR(state.position.x(), 5.5, 1e-8);
        EXPECT_NEAR(state.velocity.y(), 0, 1e-9);
    }
}

// On a half space and on a box: dropped flat they bounce, come to rest and slide on; the capsule
// lands with one end first.
TEST(CurvedBodies, RestOnFlatEndsAndCapsulesOnTheirSides) {
    const geometry::Vector up(0, 0, 0), lying(0, 0, std::numbers::pi / 2);
    struct Case {
        scene::Part part;
        geometry::Vector rotation;
        double height;
    };
    for (const auto& [part, rotation, height] :
         {Case{partOf(scene::CylinderShape{0.5, 1}), up, 0.5},
          Case{partOf(scene::ConeShape{0.5, 1}), up, 0.5},
          Case{partOf(scene::CapsuleShape{0.25, 1}), lying, 0.25},
          Case{partOf(scene::CapsuleShape{0.25, 1}), lying - geometry::Vector(0, 0, 0.1), 0.25}})
        for (const bool isBox : {false, true}) {
            SceneBuilder b = above(part, {0, height + 0.5, 0}, 6);
            b.scene.bodies[0].restitution = 0.5;
            b.scene.bodies[0].initialVelocity = {0.25, 0, 0};
            b.scene.bodies[0].initialAttitude = geometry::fromRotationVector(rotation);
            if (isBox) {
                b.scene.shapeSets[1].parts = {partOf(scene::BoxShape{{20, 2, 20}})};
                b.scene.bodies[1].initialPosition = {0, -1, 0};
            }
            const Result result = simulate(b.scene);
            ASSERT_TRUE(result.motion);
            ASSERT_FALSE(result.motion->stop(0)) << result.motion->stop(0)->sentence;
            const BodyState state = result.motion->at(0, 6);
            const geometry::Quaternion turn = state.attitude;
            const double sag = part.shape.index() == 4 ? 0.25 : 0; // centre of mass of the cone
            EXPECT_NEAR(state.position.y(), height - sag, 1e-7);
            EXPECT_NEAR(state.position.x(), 1.5, 1e-6);
            EXPECT_LT(state.angularVelocity.norm(), 1e-6);
            EXPECT_NEAR((turn * Vector::UnitY())
                            .dot(geometry::fromRotationVector(height == 0.25 ? lying : up) *
                                 Vector::UnitY()),
                        1, 1e-9);
        }
}

// A half space has no size of its own: in a scene of 1e-10 m all is as in one of 1 m.
TEST(CurvedBodies, BounceAlikeInScenesOfAnySize) {
    const auto after = [](double scale) {
        SceneBuilder b =
            above(partOf(scene::CylinderShape{0.4 * scale, scale}), {0, 2 * scale, 0}, 1);
        b.scene.forces.clear();
        b.weight("b", {0, -g * scale, 0});
        b.scene.bodies[0].initialAttitude = geometry::fromRotationVector({0.3, 0, 0.8});
        const Result result = simulate(b.scene);
        EXPECT_TRUE(result.motion);
        return result.motion->at(0, 1);
    };
    const BodyState large = after(1);
    EXPECT_GT(large.angularVelocity.norm(), 1);
    for (const double scale : {1e-3, 1e-10, 1e10}) {
        const BodyState other = after(scale);
        EXPECT_LT((other.position / scale - large.position).norm(), 1e-12);
        EXPECT_LT((other.angularVelocity - large.angularVelocity).norm(), 1e-11);
    }
}

// A cylinder's side on another's, an ellipsoid on a ball: the impulse goes through the centres.
TEST(CurvedBodies, HitEachOther) {
    SceneBuilder b(2, 1e-9);
    addBody(b, "a", partOf(scene::CylinderShape{0.5, 2}), {-2, 0, 0});
    addBody(b, "b", partOf(scene::EllipsoidShape{{0.5, 0.2, 0.7}}), {0, 0, 0});
    b.scene.bodies[0].mass = 1;
    b.scene.bodies[1].mass = 3;
    b.scene.bodies[0].initialVelocity = {2, 0, 0};
    const Result result = simulate(b.scene);
    ASSERT_TRUE(result.motion);
    EXPECT_NEAR(result.motion->at(0, 2).velocity.x(), -1, 1e-12);
    EXPECT_NEAR(result.motion->at(1, 2).velocity.x(), 1, 1e-12);
    EXPECT_NEAR(result.motion->at(1, 2).position.x(), 1.5, 1e-9);
}

} // namespace
} // namespace simulation::testing
