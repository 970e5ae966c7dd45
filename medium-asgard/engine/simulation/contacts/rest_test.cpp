// Rest and sliding: bouncing that would never end, bodies laid down, tables and what falls off
// them, platforms that move, and what is refused.
#include "contacts/held_level_testing.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace simulation::testing {
namespace {

using ::testing::HasSubstr;

// A ball let fall from h bounces for sqrt(2 h / g) (1 + e) / (1 - e) and then rests.
class Zeno : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(Zeno, BouncingEndsWhenItsTimesSumUp) {
    const auto [e, restTime] = GetParam();
    SceneBuilder b(100);
    b.floor(8);
    b.ball("ball", {0, 1.1, 0}).restitution = e;
    b.weight("ball");
    const Result result = simulate(b.scene);
    EXPECT_FALSE(result.motion->stop(1));
    EXPECT_NEAR(result.motion->impacts().back().time, restTime, 1e-6 * restTime);
    EXPECT_LT(result.motion->impacts().size(), 1500u);
    for (int i = 0; i <= 4000; ++i)
        ASSERT_GE(result.motion->at(1, 0.025 * i).position.y(), 0.1 - 1e-9) << 0.025 * i;
    EXPECT_EQ(result.motion->at(1, 100).velocity.y(), 0);
    // All impulses together turned the momentum of the whole fall.
    double sum = 0;
    for (const Impact& impact : result.motion->impacts())
        sum += impact.impulse;
    EXPECT_NEAR(sum, g * restTime, 1e-5 * g * restTime);
}

INSTANTIATE_TEST_SUITE_P(Restitutions, Zeno,
                         ::testing::Values(std::pair(0.3, 0.838543905), std::pair(0.5, 1.354570923),
                                           std::pair(0.7, 2.558633966), std::pair(0.9, 8.578949179),
                                           std::pair(0.99, 89.853204556)));

TEST(Rest, ABodyLaidOnTheFloorStaysWhateverItsRestitution) {
    for (const double e : {0.0, 0.5, 1.0}) {
        SceneBuilder b(5);
        b.floor();
        b.ball("ball", {0, 0.1, 0}).restitution = e;
        b.box("box", {3, 0.2, 0}, {0.4, 0.4, 0.4}).restitution = e;
        b.weight("ball");
        b.weight("box");
        const Result result = simulate(b.scene);
        EXPECT_NEAR(result.motion->at(1, 5).position.y(), 0.1, 1e-12);
        EXPECT_NEAR(result.motion->at(2, 5).position.y(), 0.2, 1e-12);
        EXPECT_EQ(result.motion->at(2, 5).angularVelocity.norm(), 0);
        EXPECT_FALSE(result.motion->stop(1) || result.motion->stop(2));
    }
}

// However fast it spins: what is pressed to the floor is the ball, not the point of it that
// touches.
TEST(Rest, ASpinningBallThatBouncesComesToRestOnTheFloor) {
    for (const double w : {4.0, 4.43, 5.0, 30.0, 1000.0}) {
        SceneBuilder b(5, 1e-5);
        b.floor();
        scene::Body& ball = b.ball("ball", {0, 1.442, 0}, 0.5);
        ball.restitution = 0.3;
        ball.initialVelocity = {0.17, 0, 0};
        ball.initialAngularVelocity = {-0.28, -5.34, w};
        b.weight("ball");
        const Result result = simulate(b.scene);
        EXPECT_NEAR(result.motion->at(1, 5).position.y(), 0.5, 1e-9) << w;
        EXPECT_EQ(result.motion->at(1, 5).velocity.y(), 0) << w;
    }
}

// Two spheres at the ends of an axis about which they spin: the one below hangs on no centre.
TEST(Rest, ASpinningDumbbellThatBouncesComesToRestOnTheFloor) {
    SceneBuilder b(5, 1e-5);
    b.floor();
    scene::ShapeSet dumbbell;
    dumbbell.name = "dumbbell";
    dumbbell.parts.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
        dumbbell.parts[i].shape = scene::SphereShape{0.5};
        dumbbell.parts[i].position = {i == 0 ? -1.0 : 1.0, 0, 0};
    }
    b.scene.shapeSets.push_back(dumbbell);
    b.scene.bodies.push_back(physics::testing::body("dumbbell", "dumbbell", 1));
    scene::Body& body = b.scene.bodies.back();
    body.restitution = 0.3;
    body.initialPosition = {0, 1.3, 0};
    body.initialAngularVelocity = {6, 0, 0};
    b.weight("dumbbell");
    const Result result = simulate(b.scene);
    EXPECT_NEAR(result.motion->at(1, 5).position.y(), 0.5, 1e-6);
}

// Without friction a body slides down a slope by g sin(a) t^2 / 2, and a ball does not roll.
TEST(Rest, ABallSlidesDownASlope) {
    const double a = 0.3;
    SceneBuilder b(1.2);
    scene::Body& ramp = b.box("ramp", {0, 0, 0}, {8, 0.2, 2});
    ramp.fixed = true;
    ramp.initialAttitude = Quaternion(Eigen::AngleAxisd(a, Vector::UnitZ()));
    const Vector normal(-std::sin(a), std::cos(a), 0), down(-std::cos(a), -std::sin(a), 0);
    b.ball("ball", 0.2 * normal);
    b.weight("ball");
    const Result result = simulate(b.scene);
    const Vector expected = 0.2 * normal + 0.5 * g * std::sin(a) * 1.2 * 1.2 * down;
    EXPECT_LT(distance(result.motion->at(1, 1.2).position, expected), 1e-12);
    EXPECT_EQ(result.motion->at(1, 1.2).angularVelocity.norm(), 0);
}

TEST(Rest, ABoxDroppedFlatWithoutBounceSlidesOnAndTurnsOn) {
    SceneBuilder b(3);
    b.floor();
    scene::Body& box = b.box("box", {0, 1, 0}, {0.3, 0.2, 0.4});
    box.restitution = 0;
    box.initialVelocity = {0.3, 0, 0};
    box.initialAngularVelocity = {0, 0.7, 0};
    b.weight("box");
    const Result result = simulate(b.scene);
    const BodyState end = result.motion->at(1, 3);
    EXPECT_LT(distance(end.position, {0.9, 0.1, 0}), 1e-9);
    EXPECT_LT(distance(end.velocity, {0.3, 0, 0}), 1e-12);
    EXPECT_NEAR(end.attitude.angularDistance(Quaternion(Eigen::AngleAxisd(2.1, Vector::UnitY()))),
                0, 1e-6);
    EXPECT_EQ(result.motion->impacts().size(), 1u);
}

// The rate at which a can of radius 0.4 and height 1 tips over one point after 1 s: a small fall
// from unstable balance,  l^2 = g |arm| / I  of the pendulum that stands on the point of its rim.
double tippingRate(double angle) {
    constexpr double radius = 0.4, height = 1,
                     inertia = (3 * radius * radius + height * height) / 12;
    constexpr double arm = radius * radius + height * height / 4;
    const double turns =
        g * (height / 2 * std::sin(angle) - radius * std::cos(angle)) / (inertia + arm);
    const double rate =
        std::sqrt(g * (height / 2 * std::cos(angle) + radius * std::sin(angle)) / (inertia + arm));
    return turns / rate * std::sinh(rate);
}

// Gravity leans by the part `lean` of the tangent at which a can tips, and to any side of the can.
// It stands on few points of its rim, and gets those over which it tips: below that angle it
// stands, and beyond it tips to that side, as over one point.
TEST(Rest, ACanTipsOverItsRimToAllSides) {
    for (const double side : {0.0, 7.3, 11.25, 40.0, 200.0})
        for (const double lean : {0.97, 0.99999, 1.00002}) {
            SCOPED_TRACE(side);
            SCOPED_TRACE(lean);
            constexpr double radius = 0.4, height = 1;
            SceneBuilder b(1);
            b.floor();
            scene::ShapeSet set;
            set.name = "can";
            set.parts.emplace_back().shape = scene::CylinderShape{radius, height};
            b.scene.shapeSets.push_back(set);
            b.scene.bodies.push_back(physics::testing::body("can", "can", 1));
            b.scene.bodies.back().initialPosition = {0, height / 2, 0};
            const double angle = std::atan(2 * radius / height * lean),
                         to = side * std::numbers::pi / 180;
            b.weight("can", g * Vector(std::sin(angle) * std::cos(to), -std::cos(angle),
                                       std::sin(angle) * std::sin(to)));
            for (scene::Body& body : b.scene.bodies) {
                body.friction = 2;
                body.restitution = 0;
            }
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(1));
            const BodyState end = result.motion->at(1, 1);
            if (lean < 1) {
                // Next to where it tips its forces have several answers, which may leave rounding.
                const double none = lean > 0.9999 ? 1e-11 : 1e-14;
                EXPECT_LT(distance(end.position, {0, height / 2, 0}), none);
                EXPECT_LT(end.velocity.norm(), none);
                continue;
            }
            const Vector across(std::sin(to), 0, -std::cos(to)); // about which it tips
            EXPECT_NEAR(end.angularVelocity.dot(across), tippingRate(angle),
                        0.03 * tippingRate(angle));
            EXPECT_LT(end.angularVelocity.cross(across).norm(), 0.03 * tippingRate(angle));
        }
}

// Corners above those that bear land, too.
TEST(Rest, ABoxThatFallsFlatAndIsBrakedTipsOnToItsSide) {
    for (const double height : {1e-7, 1e-4, 0.05})
        for (const double turned : {0.0, 0.2})
            for (const double speed : {1.5, 2.6}) {
                SCOPED_TRACE(height);
                SCOPED_TRACE(turned);
                SCOPED_TRACE(speed);
                SceneBuilder b(1.5);
                b.box("floor", {0, -0.5, 0}, {10, 1, 4}).fixed = true;
                scene::Body& box = b.box("box", {0, 0.2 + height, 0}, {0.2, 0.4, 0.3});
                box.initialVelocity = {-speed, 0, 0};
                box.initialAttitude = geometry::fromRotationVector({0, turned, 0});
                b.weight("box");
                for (scene::Body& body : b.scene.bodies) {
                    body.friction = 0.8;
                    body.restitution = 0;
                }
                const Result result = simulate(b.scene);
                ASSERT_FALSE(result.motion->stop(1));
                const BodyState end = result.motion->at(1, 1.5);
                EXPECT_NEAR(end.position.y(), 0.1, 1e-6);
                EXPECT_NEAR((end.attitude * Vector::UnitY()).y(), 0, 1e-6);
                EXPECT_LT(end.velocity.norm(), 1e-9);
            }
}

TEST(Rest, ABallEndsInTheCornerOfARoom) {
    SceneBuilder b(4);
    b.floor(8);
    scene::Body& left = b.box("left", {-0.1, 0, 0}, {0.2, 8, 8});
    left.fixed = true;
    scene::Body& back = b.box("back", {0, 0, -0.1}, {8, 8, 0.2});
    back.fixed = true;
    b.ball("ball", {0.5, 0.7, 0.6}).restitution = 0.3;
    b.weight("ball", {-2, -9.81, -1});
    const Result result = simulate(b.scene);
    EXPECT_LT(distance(result.motion->at(3, 4).position, {0.1, 0.1, 0.1}), 1e-9);
    EXPECT_LT(result.motion->at(3, 4).velocity.norm(), 1e-9);
    EXPECT_FALSE(result.motion->stop(3));
}

// Once its centre is past the edge, a box tips about it; energy is kept, as nothing rubs.
TEST(Rest, ABoxThatSlidesOffATableTips) {
    SceneBuilder b(0.72, 1e-8);
    b.box("table", {0, -0.1, 0}, {2, 0.2, 2}).fixed = true;
    scene::Body& box = b.box("box", {0.5, 0.1, 0}, {0.4, 0.2, 0.4});
    box.restitution = 0.3;
    box.initialVelocity = {1, 0, 0};
    b.weight("box");
    std::vector<std::string> faults;
    const Result result = simulate(b.scene);
    EXPECT_LT(distance(result.motion->at(1, 0.5).position, {1, 0.1, 0}), 1e-9);
    EXPECT_LT(result.motion->at(1, 0.49).angularVelocity.norm(), 1e-9);
    EXPECT_LT(result.motion->at(1, 0.7).angularVelocity.z(), -0.5);
    const Quantities energy(b.scene, {}, result.motion,
                            {"0.5*(box.dx^2+box.dy^2+box.dz^2)+9.81*box.y+0.5*(box.izz*box.wz^2)"},
                            faults);
    EXPECT_NEAR(energy.at(0.72)[0], energy.at(0.1)[0], 1e-6);
    // The table's edge stays under the box's lower face.
    const BodyState tipped = result.motion->at(1, 0.65);
    const Vector edge = tipped.attitude.conjugate() * Vector(Vector(1, 0, 0) - tipped.position);
    EXPECT_NEAR(edge.y(), -0.1, 1e-7);
}

// It turns about the edge, slides along it, and opens where the edge would have to pull; from there
// its face stays so near the edge for so long that no fixed line parts them.
TEST(Rest, ABoxThatTipsOverAnEdgeFallsFree) {
    SceneBuilder b(1.5, 1e-8);
    b.box("table", {-1, -0.1, 0}, {2, 0.2, 2}).fixed = true;
    b.box("box", {0.05, 0.1, 0}, {0.4, 0.2, 0.3}).restitution = 0;
    b.weight("box");
    const Result result = simulate(b.scene);
    const Motion& motion = *result.motion;
    EXPECT_FALSE(motion.stop(1));
    EXPECT_TRUE(motion.impacts().empty());
    const BodyState early = motion.at(1, 0.5), late = motion.at(1, 1.5);
    EXPECT_LT(early.angularVelocity.z(), -2);
    EXPECT_LT(distance(late.angularVelocity, early.angularVelocity), 1e-7);
    EXPECT_LT(distance(late.velocity, early.velocity + Vector(0, -g, 0)), 1e-7);
    std::vector<std::string> faults;
    const Quantities energy(b.scene, {}, result.motion,
                            {"0.5*(box.dx^2+box.dy^2)+9.81*box.y+0.5*box.izz*box.wz^2"}, faults);
    EXPECT_NEAR(energy.at(1.5)[0], energy.at(0)[0], 1e-6);
}

// Over the edge its centre goes round it, until the edge would have to pull; nothing rubs.
TEST(Rest, ABallThatSlidesOffATableGoesRoundItsEdgeAndFalls) {
    SceneBuilder b(1);
    b.box("table", {0, -0.1, 0}, {2, 0.2, 2}).fixed = true;
    b.ball("ball", {0.9, 0.1, 0}).initialVelocity = {0.3, 0, 0};
    b.weight("ball");
    const Result result = simulate(b.scene);
    const auto fromEdge = [&](double t) {
        return distance(result.motion->at(1, t).position, {1, 0, 0});
    };
    EXPECT_NEAR(fromEdge(0.4), 0.1, 1e-7);
    EXPECT_NEAR(fromEdge(0.45), 0.1, 1e-7);
    EXPECT_GT(fromEdge(0.7), 0.2);
    const BodyState end = result.motion->at(1, 1);
    EXPECT_NEAR(0.5 * end.velocity.squaredNorm() + g * end.position.y(), 0.045 + 0.1 * g, 1e-5);
}

TEST(Rest, BodiesOnAPlatformGoUpAndDownWithItAndSlideOtherwise) {
    SceneBuilder b(4);
    b.box("lift", {0, 0, 0}, {2, 0.2, 2});
    // y = 0.4 t (4 - t) / 4 at most; sideways too, which frictionless bodies do not follow.
    b.hold("lift", 0, 4, {{0, -0.1, 0}, {0.1, 0.7, 0}, {0.2, -0.1, 0}});
    holdLevel(b, "lift", 0, 4); // else the loads would turn it
    b.box("box", {0.5, 0.1, 0}, {0.4, 0.2, 0.4}).restitution = 0.3;
    b.ball("ball", {-0.5, 0.1, 0}).restitution = 0;
    b.weight("box");
    b.weight("ball");
    const Result result = simulate(b.scene);
    for (const double t : {1.0, 2.0, 3.0, 4.0}) {
        const double top = result.motion->at(0, t).position.y() + 0.1;
        EXPECT_NEAR(result.motion->at(1, t).position.y(), top + 0.1, 1e-6) << t;
        EXPECT_NEAR(result.motion->at(2, t).position.y(), top + 0.1, 1e-6) << t;
        EXPECT_NEAR(result.motion->at(2, t).position.x(), -0.5, 1e-9) << t;
    }
    EXPECT_FALSE(result.motion->stop(1) || result.motion->stop(2));
}

// Wind of 5 t N lifts 1 kg at t = g / 5; from then on y'' = 5 (t - g / 5).
TEST(Rest, WindThatGrowsOpensTheContactWhenItPulls) {
    SceneBuilder b(4);
    b.floor();
    b.ball("ball", {0, 0.1, 0}).restitution = 0.5;
    b.weight("ball");
    b.force("ball", "0", "5*t", "0");
    const Result result = simulate(b.scene);
    const double flight = 4 - g / 5;
    EXPECT_NEAR(result.motion->at(1, g / 5).position.y(), 0.1, 1e-9);
    EXPECT_NEAR(result.motion->at(1, 4).position.y(), 0.1 + 5.0 / 6 * std::pow(flight, 3), 1e-6);
}

// Equal spheres exchange their velocities; the one that is hit goes on sliding on the floor.
TEST(Rest, ARestingBallThatIsHitSlidesAway) {
    SceneBuilder b(1);
    b.floor();
    b.ball("hit", {0, 0.1, 0});
    b.ball("hitting", {-1, 0.1, 0}).initialVelocity = {2, 0, 0};
    b.weight("hit");
    b.weight("hitting");
    const Result result = simulate(b.scene);
    EXPECT_LT(distance(result.motion->at(1, 1).position, {1.2, 0.1, 0}), 1e-9);
    EXPECT_LT(distance(result.motion->at(2, 1).position, {-0.2, 0.1, 0}), 1e-9);
}

TEST(Rest, ATumblingBoxComesToRestOnAFace) {
    SceneBuilder b(4, 1e-4);
    b.floor();
    scene::Body& box = b.box("box", {0, 1, 0}, {0.3, 0.2, 0.4});
    box.restitution = 0.4;
    box.initialAttitude = Quaternion(Eigen::AngleAxisd(1, Vector(0.3, 0.4, 0.9).normalized()));
    b.weight("box");
    const Result result = simulate(b.scene);
    ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
    const BodyState end = result.motion->at(1, 4);
    const Vector up = end.attitude.conjugate() * Vector::UnitY();
    EXPECT_NEAR(up.cwiseAbs().maxCoeff(), 1, 1e-9);
    EXPECT_LT(end.velocity.cwiseProduct(Vector(0, 1, 0)).norm(), 1e-9);
}

// Turning about all axes: it rocks on edges and corners, and each way of bearing ends in the next.
TEST(Rest, ABoxThatTurnsAboutAllAxesComesToLieFlatAtAnyAccuracy) {
    for (const double accuracy : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
        SceneBuilder b(8, accuracy);
        b.floor().restitution = 0.5;
        scene::Body& box =
            b.box("box", {-0.7162089149785369, 3.0124003006934377, 0}, {0.5, 0.4, 0.7});
        box.initialVelocity = {1.558304223052036, 1.0903209527353512, 0};
        box.initialAngularVelocity = {-1.8272211194192405, 0.8352028991699139, -1.9789135790058023};
        b.weight("box");
        b.force("box", "-box.mass*2*sign(box.dx)", "0", "0");
        const Result result = simulate(b.scene);
        EXPECT_FALSE(result.motion->stop(1)) << accuracy;
        EXPECT_NEAR(result.motion->at(1, 8).position.y(), 0.2, 1e-9) << accuracy;
        EXPECT_LT(result.motion->at(1, 8).velocity.norm(), 1e-9) << accuracy;
        EXPECT_LT(result.statistics.collisions, 300u) << accuracy;
        EXPECT_LT(result.statistics.steps, 10'000u) << accuracy;
        for (int i = 0; i <= 800; ++i)
            ASSERT_GT(result.motion->at(1, 0.01 * i).position.y(), 0.2 - 1e-3 * accuracy - 1e-8)
                << accuracy;
    }
}

// A box 1 x 0.4 whose centre is over a table's edge, in the plane: an independent integration. It
// turns about the edge and slides on until the edge would have to pull, or until its own end is
// past the edge; from there it falls.
class TippingBox {
public:
    explicit TippingBox(double speed) { state_ << 0, half, 0, speed, 0, 0; }

    // From the edge, so much later.
    Vector centreAfter(double time) {
        for (double h = 1e-4; h > 1e-13 && time > h;) {
            const State k1 = rates(state_), k2 = rates(state_ + h / 2 * k1);
            const State k3 = rates(state_ + h / 2 * k2), k4 = rates(state_ + h * k3);
            const State next = state_ + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            if (push(next) < 0 || std::abs(arm(next)) > length) {
                h /= 2;
                continue;
            }
            state_ = next;
            time -= h;
        }
        return {state_[0] + time * state_[3], state_[1] + time * (state_[4] - g * time / 2), 0};
    }

private:
    using State = Eigen::Matrix<double, 6, 1>; // x, y, angle forward and their rates
    static constexpr double half = 0.2, length = 0.5, inertia = (1 + 0.16) / 12;

    static double arm(const State& s) { return s[0] * std::cos(s[2]) - s[1] * std::sin(s[2]); }
    static double push(const State& s) {
        const double along = s[3] * std::cos(s[2]) - s[4] * std::sin(s[2]);
        return (g * std::cos(s[2]) - 2 * s[5] * along + s[5] * s[5] * half) /
               (1 + arm(s) * arm(s) / inertia);
    }
    static State rates(const State& s) {
        const double n = push(s);
        State result;
        result << s[3], s[4], s[5], n * std::sin(s[2]), n * std::cos(s[2]) - g,
            n * arm(s) / inertia;
        return result;
    }

    State state_;
};

// Slowly it leaves where the edge's push vanishes, fast where its own end is past the edge.
TEST(Rest, ABoxThatSlidesOffATableTipsOverItsEdge) {
    for (const double speed : {0.5, 0.8, 1.0, 1.5, 2.0, 4.0})
        for (const double accuracy : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
            SceneBuilder b(3, accuracy);
            b.box("table", {0, -0.5, 0}, {4, 1, 4}).fixed = true;
            b.box("box", {0.9, 0.2, 0}, {1, 0.4, 0.6}).initialVelocity = {speed, 0, 0};
            b.weight("box");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
            EXPECT_LT(distance(result.motion->at(1, 3).position - Vector(2, 0, 0),
                               TippingBox(speed).centreAfter(3 - 1.1 / speed)),
                      std::max(10 * accuracy, 1e-6))
                << speed << " " << accuracy;
        }
}

// It leaves the edge along one of its own, where the two cross: at any accuracy alike.
TEST(Rest, ABoxThatSpinsLeavesATablesEdgeWhereItsOwnCrossesIt) {
    for (const double spin : {0.3, 1.0, 5.0})
        for (const double speed : {0.8, 1.5, 3.0}) {
            std::optional<Vector> before;
            for (const double accuracy : {1e-8, 1e-6, 1e-4}) {
                SceneBuilder b(3, accuracy);
                b.box("table", {0, -0.5, 0}, {4, 1, 4}).fixed = true;
                scene::Body& box = b.box("box", {0.9, 0.2, 0}, {1, 0.4, 0.6});
                box.initialVelocity = {speed, 0, 0};
                box.initialAngularVelocity = {0, spin, 0};
                b.weight("box");
                const Result result = simulate(b.scene);
                ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
                const Vector place = result.motion->at(1, 3).position;
                EXPECT_LT(distance(place, before.value_or(place)), 30 * accuracy)
                    << spin << " " << speed;
                before = place;
            }
        }
}

// LIMIT: how a box that falls beside the middle of two rails comes to bear on both is not followed
// (docs/numerics.md); that ends soon, and in bounded work.
TEST(Rest, ABoxThatFallsOnTwoRailsEndsInBoundedWork) {
    for (const double accuracy : {1e-4, 1e-5}) {
        SceneBuilder b(1, accuracy);
        for (const double side : {-0.3, 0.3})
            b.box("rail" + std::to_string(side), {side, -0.5, 0}, {0.2, 1, 6}).fixed = true;
        scene::Body& box = b.box("box", {0.05, 1, 0}, {1, 0.6, 0.8});
        box.restitution = 0.3;
        box.initialAttitude = geometry::fromRotationVector({0, 0, 0.05});
        b.weight("box");
        const Result result = simulate(b.scene);
        EXPECT_LT(result.statistics.steps, 20'000u) << accuracy;
        for (int i = 0; i <= 100 && !result.motion->stop(2); ++i)
            EXPECT_GT(result.motion->at(2, 0.01 * i).position.y(), 0.3 - 1e-4) << accuracy;
    }
}

// Nothing meets: that the one rests is what joins them.
TEST(Rest, ABodyRestsOnOneThatIsHeldInPlaceAndAttitude) {
    SceneBuilder b(1);
    b.box("held", {0, 0, 0}, {1, 1, 1});
    b.hold("held", 0, 2, {{0, 0, 0}});
    scene::Constraint attitude = b.scene.constraints.back();
    attitude.held = scene::Held::attitude;
    b.scene.constraints.push_back(attitude);
    b.box("rests", {0, 1, 0}, {1, 1, 1});
    b.weight("rests");
    const Result result = simulate(b.scene);
    ASSERT_FALSE(result.motion->stop(1));
    EXPECT_EQ(result.motion->at(1, 1).position.y(), 1);
}

// In either order of the lines: what one of them rests on is found first or last.
TEST(Rest, ABodyThatLiesOnOneThatRestsStaysToTheLastBit) {
    for (const bool isLowerFirst : {true, false})
        for (const double e : {0.0, 1.0}) {
            SceneBuilder b(1);
            b.floor();
            for (const bool isLower : {isLowerFirst, !isLowerFirst})
                b.box(isLower ? "lower" : "upper", {isLower ? 0 : 0.1, isLower ? 0.5 : 1.5, 0},
                      {1, 1, 1})
                    .restitution = e;
            b.weight("lower");
            b.weight("upper");
            const Result result = simulate(b.scene);
            expectNoStops(result, b.scene);
            for (const std::size_t body : {1U, 2U}) {
                const Vector end = result.motion->at(body, 1).position;
                EXPECT_EQ(end, result.motion->at(body, 0).position) << isLowerFirst << e;
            }
        }
}

TEST(Rest, ABallThatFallsOnAnotherComesToRestOnIt) {
    SceneBuilder b(3);
    b.floor();
    b.ball("lower", {0, 0.1, 0}).restitution = 0.4;
    b.ball("upper", {0, 1, 0}).restitution = 0.4;
    b.ball("far", {5, 1, 0}).initialVelocity = {0, 0, 1};
    b.weight("lower");
    b.weight("upper");
    const Result result = simulate(b.scene);
    expectNoStops(result, b.scene);
    EXPECT_LT(distance(result.motion->at(2, 3).position, {0, 0.3, 0}), 1e-6);
    EXPECT_LT(distance(result.motion->at(3, 3).position, {5, 1, 3}), 1e-12);
}

TEST(Rest, ABallBetweenClosingWallsEndsWithASentenceInBoundedWork) {
    for (const double e : {1.0, 0.5}) {
        SceneBuilder b(3);
        b.box("left", {0, 0, 0}, {0.2, 2, 2});
        b.box("right", {0, 0, 0}, {0.2, 2, 2});
        b.hold("left", 0, 3, {{-1, 0, 0}, {1, 0, 0}});
        b.hold("right", 0, 3, {{1, 0, 0}, {-1, 0, 0}});
        scene::Body& ball = b.ball("ball", {0, 0, 0});
        ball.restitution = e;
        ball.initialVelocity = {0.3, 0, 0};
        const Result result = simulate(b.scene);
        ASSERT_TRUE(result.motion->stop(2)) << e;
        EXPECT_NEAR(result.motion->stop(2)->time, 1.2, 1e-3); // when 0.2 is left between them
        EXPECT_LT(result.statistics.collisions, 50'000u);
    }
}

} // namespace
} // namespace simulation::testing
