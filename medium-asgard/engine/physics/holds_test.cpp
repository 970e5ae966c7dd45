// What trajectories hold, as phases of the unknowns.
#include "physics/equations_of_motion.h"

#include "physics/testing.h"

#include <gtest/gtest.h>

namespace physics {
namespace {

using testing::equation;

scene::Trajectory trajectory(const std::string& name, std::vector<scene::BezierCurve> curves) {
    scene::Trajectory made;
    made.name = name;
    made.curves = std::move(curves);
    return made;
}

scene::Constraint constrain(scene::Held held, const std::string& name) {
    scene::Constraint made;
    made.body = "ball";
    made.held = held;
    made.trajectory = name;
    return made;
}

// "path" goes from (1 0 0) to (3 0 0) in 2..4, is away, then stands at (7 8 9) in 6..8.
scene::Scene heldBall(scene::Held held) {
    scene::Scene scene = testing::ballAndRod();
    scene.trajectories = {trajectory(
        "path", {{2, 4, {Vector(1, 0, 0), Vector(3, 0, 0)}}, {6, 8, {Vector(7, 8, 9)}}})};
    scene.constraints = {constrain(held, "path")};
    scene.forces = {testing::force("ball", "2", "0", "0")};
    return scene;
}

TEST(Holds, APositionIsGivenInItsIntervalsAndFreeBetweenThem) {
    const EquationsOfMotion motion(heldBall(scene::Held::position));
    ASSERT_EQ(motion.faults, std::vector<std::string>{});
    EXPECT_EQ(equation(motion, "ball.x"), "ball.dx"
                                          " | from 2: = 1 + (t - 2), rate 1"
                                          " | from 4 at 1 + (t - 2): ball.dx"
                                          " | from 6: = 7, rate 0"
                                          " | from 8 at 7: ball.dx");
    EXPECT_EQ(equation(motion, "ball.dx"), "1"
                                           " | from 2: = 1, rate 0"
                                           " | from 4 at 1: 1"
                                           " | from 6: = 0, rate 0"
                                           " | from 8 at 0: 1");
    EXPECT_EQ(equation(motion, "ball.wx"), "0"); // what is not held goes on
    EXPECT_EQ(motion.breakpoints, (std::vector<double>{2, 4, 6, 8}));
}

TEST(Holds, FromAndToHoldThroughoutWithTheValueContinuedInStraightLines) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.constraints[0].from = 1;
    scene.constraints[0].to = 9;
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.x"), "ball.dx"
                                          " | from 1: = 1 + (t - 2), rate 1"
                                          " | from 4: = 3 + (t - 4), rate 1"
                                          " | from 6: = 7, rate 0"
                                          " | from 9 at 7: ball.dx");
}

TEST(Holds, AVelocityIsGivenAndThePositionIsItsIntegral) {
    const EquationsOfMotion motion(heldBall(scene::Held::velocity));
    EXPECT_EQ(equation(motion, "ball.x"), "ball.dx");
    EXPECT_EQ(equation(motion, "ball.dx"), "1"
                                           " | from 2: = 1 + (t - 2), rate 1"
                                           " | from 4 at 1 + (t - 2): 1"
                                           " | from 6: = 7, rate 0"
                                           " | from 8 at 7: 1");
}

TEST(Holds, OneComponentTakesTheTrajectorysFirstAndLeavesTheOthers) {
    const EquationsOfMotion motion(heldBall(scene::Held::y));
    EXPECT_EQ(equation(motion, "ball.x"), "ball.dx");
    EXPECT_EQ(equation(motion, "ball.y").substr(0, 46),
              "ball.dy | from 2: = 1 + (t - 2), rate 1 | from");
    const Held& held = motion.bodies[0].heldAt(3);
    EXPECT_FALSE(held.position[0]);
    EXPECT_TRUE(held.position[1]);
    EXPECT_FALSE(held.attitude);
    EXPECT_FALSE(motion.bodies[0].heldAt(5).position[1]);
    EXPECT_FALSE(motion.bodies[0].heldAt(-100).position[1]);
}

TEST(Holds, WhatWasOverAtTheStartLeavesNoTrace) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.simulator.start = 4;
    EXPECT_EQ(equation(EquationsOfMotion(scene), "ball.x"),
              "ball.dx | from 6: = 7, rate 0 | from 8 at 7: ball.dx");
}

TEST(Holds, TwoTrajectoriesOnOneThingAtOneTimeAreAFault) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.constraints.push_back(constrain(scene::Held::dx, "path"));
    EXPECT_EQ(EquationsOfMotion(scene).faults,
              (std::vector<std::string>{"body \"ball\": two trajectories hold its position at one "
                                        "time, from t = 2 on"}));
    scene.constraints[1].from = 4;
    scene.constraints[1].to = 6;
    EXPECT_EQ(EquationsOfMotion(scene).faults, std::vector<std::string>{});
}

// About a fixed axis everything is in closed form: half angles, and w = the angle's rate.
TEST(Holds, AnAttitudeIsTheRotationVectorsAndItsSpinTheExactRate) {
    scene::Scene scene = testing::ballAndRod();
    scene.trajectories = {trajectory("turn", {{0, 2, {Vector(0, 0, 0), Vector(0, 0, 3)}}})};
    scene.constraints = {constrain(scene::Held::attitude, "turn")};
    scene.constraints[0].body = "rod";
    const EquationsOfMotion motion(scene);
    const std::vector<double> state(motion.set.unknowns.size(), 0.);
    for (const double t : {0., 1e-9, 0.03, 0.1, 1., 1.999}) {
        const auto given = [&](const char* name) {
            const auto& phases = testing::unknown(motion, name).phases;
            return testing::valueOf(motion, *phases.front().given, state, t);
        };
        EXPECT_NEAR(given("rod.qw"), std::cos(0.75 * t), 1e-15) << t;
        EXPECT_NEAR(given("rod.qz"), std::sin(0.75 * t), 1e-15) << t;
        EXPECT_NEAR(given("rod.w3"), 1.5, 1e-14) << t;
        EXPECT_NEAR(given("rod.w1"), 0, 1e-15) << t;
    }
}

Quaternion attitudeAt(const EquationsOfMotion& motion, const std::string& body, double t) {
    const auto given = [&](const char* entry) {
        const auto& phases = testing::unknown(motion, body + entry).phases;
        const std::vector<double> state(motion.set.unknowns.size(), 0.);
        return testing::valueOf(motion, *phases.front().given, state, t);
    };
    return {given(".qw"), given(".qx"), given(".qy"), given(".qz")};
}

// A curve that turns about a moving axis, through angle 0: the given spin is the rate of the given
// attitude, along the world's axes for the ball and along its own for the rod.
TEST(Holds, TheSpinOfARotationCurveIsTheRateOfItsAttitude) {
    scene::Scene scene = testing::ballAndRod();
    scene.trajectories = {trajectory(
        "turn",
        {{-1, 1, {Vector(1, 2, -1), Vector(-1, 0.5, 1), Vector(0, -2, 0), Vector(1, 1, 1)}}})};
    scene.constraints = {constrain(scene::Held::attitude, "turn"),
                         constrain(scene::Held::attitude, "turn")};
    scene.constraints[1].body = "rod";
    const EquationsOfMotion motion(scene);
    for (const std::string body : {"ball", "rod"})
        for (const double t : {-0.9, -0.3, -0.02, 0., 0.2, 0.7}) {
            const double h = 1e-6;
            const Quaternion before = attitudeAt(motion, body, t - h),
                             after = attitudeAt(motion, body, t + h);
            EXPECT_NEAR(after.norm(), 1, 1e-15);
            const Quaternion turn =
                body == "rod" ? before.conjugate() * after : after * before.conjugate();
            const Vector measured = geometry::toRotationVector(turn) / (2 * h);
            const char* spins[2][3] = {{"ball.wx", "ball.wy", "ball.wz"},
                                       {"rod.w1", "rod.w2", "rod.w3"}};
            for (int i = 0; i < 3; ++i) {
                const auto& phase =
                    testing::unknown(motion, spins[body == "rod"][i]).phases.front();
                const std::vector<double> state(motion.set.unknowns.size(), 0.);
                const double w = testing::valueOf(motion, *phase.given, state, t);
                EXPECT_NEAR(w, measured[i], 1e-8) << body << ' ' << t;
                const double later = testing::valueOf(motion, *phase.given, state, t + h);
                const double earlier = testing::valueOf(motion, *phase.given, state, t - h);
                EXPECT_NEAR(testing::valueOf(motion, phase.derivative, state, t),
                            (later - earlier) / (2 * h), 1e-6)
                    << body << ' ' << t;
            }
        }
}

TEST(Holds, AnAngularVelocityIsTheWorldsForEveryBody) {
    scene::Scene scene = testing::ballAndRod();
    scene.trajectories = {trajectory("spin", {{0, 1, {Vector(1, 2, 3)}}})};
    scene.constraints = {constrain(scene::Held::angularVelocity, "spin"),
                         constrain(scene::Held::angularVelocity, "spin")};
    scene.constraints[1].body = "rod";
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.wy"), "= 2, rate 0 | from 1 at 2: 0");
    // R' (1 2 3), read at a quarter turn about z: world x is the body's -y
    std::vector<double> state(motion.set.unknowns.size(), 0.);
    const std::size_t q = motion.bodies[1].unknown(qw);
    state[q] = state[q + 3] = std::sqrt(0.5);
    const auto given = [&](const char* name) {
        return testing::valueOf(motion, *testing::unknown(motion, name).phases[0].given, state, 0);
    };
    EXPECT_NEAR(given("rod.w1"), 2, 1e-15);
    EXPECT_NEAR(given("rod.w2"), -1, 1e-15);
    EXPECT_NEAR(given("rod.w3"), 3, 1e-15);
}

// The reference point is held; the centre of mass, one length along the body's x, swings about it.
TEST(Holds, AHeldPositionIsTheReferencePoints) {
    scene::Scene scene = testing::ballAndRod();
    scene.shapeSets[0].parts[0].position = {1, 0, 0};
    scene.trajectories = {trajectory("path", {{0, 4, {Vector(5, 0, 0), Vector(9, 0, 0)}}})};
    scene.constraints = {constrain(scene::Held::position, "path")};
    const EquationsOfMotion motion(scene);
    std::vector<double> state(motion.set.unknowns.size(), 0.);
    const double angle = 0.7, spin = 2;
    state[qw] = std::cos(angle / 2);
    state[qz] = std::sin(angle / 2);
    state[w3] = spin;
    const auto given = [&](const char* name) {
        return testing::valueOf(motion, *testing::unknown(motion, name).phases[0].given, state, 1);
    };
    const auto rate = [&](const char* name) {
        return testing::valueOf(motion, testing::unknown(motion, name).phases[0].derivative, state,
                                1);
    };
    EXPECT_NEAR(given("ball.x"), 6 + std::cos(angle), 1e-15);
    EXPECT_NEAR(given("ball.y"), std::sin(angle), 1e-15);
    EXPECT_NEAR(given("ball.dx"), 1 - spin * std::sin(angle), 1e-15);
    EXPECT_NEAR(given("ball.dy"), spin * std::cos(angle), 1e-15);
    EXPECT_NEAR(rate("ball.dx"), -spin * spin * std::cos(angle), 1e-14); // centripetal
    EXPECT_NEAR(rate("ball.dy"), -spin * spin * std::sin(angle), 1e-14);
}

// --- trajectories in expressions ------------------------------------------------------------

TEST(Trajectories, InExpressionsAreChosenByTimeAndContinuedStraight) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.constraints.clear();
    scene.forces = {testing::force("ball", "path.x", "path.dx", "0")};
    const EquationsOfMotion motion(scene);
    const std::pair<double, std::pair<double, double>> rows[] = {
        {0, {-1, 1}}, {2, {1, 1}},   {3, {2, 1}},
        {4, {3, 1}},  {5, {4, 1}}, // the gap goes straight on
        {6, {7, 0}},  {7.5, {7, 0}}, {100, {7, 0}}};
    const std::vector<double> state(motion.set.unknowns.size(), 0.);
    for (const auto& [t, expected] : rows) {
        const Contribution& force = motion.contributions[0];
        EXPECT_DOUBLE_EQ(testing::valueOf(motion, force.force[0], state, t), expected.first) << t;
        EXPECT_DOUBLE_EQ(testing::valueOf(motion, force.force[1], state, t), expected.second) << t;
    }
}

// The breakpoints are known beforehand: phases, and no choice by time for a step to search.
TEST(Trajectories, InForcesMakePhasesWithOnePieceEach) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.constraints.clear();
    scene.forces = {testing::force("ball", "4*path.x", "2*path.dx*ball.y", "rod.z")};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.dx"),
              "2*(1 + (t - 2)) | from 4: 2*(3 + (t - 4)) | from 6: 14");
    EXPECT_EQ(equation(motion, "ball.dy"), "ball.y | from 6: 0");
    EXPECT_EQ(equation(motion, "ball.dz"), "rod.z/2");
    EXPECT_EQ(equation(motion, "rod.dx"), "0");
    EXPECT_EQ(motion.breakpoints, (std::vector<double>{2, 4, 6, 8}));
    EXPECT_EQ(motion.bodies[0].held.size(), 1u);
}

TEST(Trajectories, OfAThousandPiecesAreReadQuickly) {
    scene::Scene scene = heldBall(scene::Held::position);
    scene.constraints.clear();
    scene.trajectories[0].curves.clear();
    for (int i = 0; i < 1000; ++i)
        scene.trajectories[0].curves.push_back(
            {i * 1., i + 1., {Vector(i % 7, 0, 1), Vector(i % 3, 1, i), Vector(0, i % 5, 2)}});
    scene.forces = {testing::force("ball", "sin(path.x)*path.dz", "path.y", "path.z*ball.x")};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(testing::unknown(motion, "ball.dx").phases.size(), 1001u);
    EXPECT_LT(motion.set.graph.size(), 100'000u); // linear in the pieces
}

TEST(Trajectories, OfAnyDegreePassThroughTheirEndsAndKeepInsideTheirPolygon) {
    for (const std::size_t degree : {1u, 2u, 3u, 8u, 9u, 30u}) {
        scene::BezierCurve curve{10, 14, {}};
        for (std::size_t i = 0; i <= degree; ++i)
            curve.control.emplace_back(i % 2 ? 1. : -1., static_cast<double>(i), 3.);
        Graph g;
        const Node t = g.symbol("t");
        const auto pieces = piecesOf(g, t, trajectory("path", {curve}));
        ASSERT_EQ(pieces.size(), 3u);
        for (const double time : {10., 11.3, 14.}) {
            const auto at = [&](std::size_t i) {
                const Node n = substitute(g, pieces[1].value[i], {{t.index, g.constant(time)}});
                return g.value(n);
            };
            const double u = (time - 10) / 4, n = static_cast<double>(degree);
            // Alternating -1 and 1 are -(1 - 2u)^n; evenly spaced points are linear.
            EXPECT_NEAR(at(0), -std::pow(1 - 2 * u, n), 1e-13) << degree << ' ' << time;
            EXPECT_NEAR(at(1), n * u, 1e-12) << degree << ' ' << time;
            EXPECT_EQ(at(2), 3) << degree;
        }
    }
}

// A hold beside the centre of mass is no hinge.
TEST(Holds, WhatIsHeldBesideItsCentreTurnsByNoBlow) {
    scene::Scene scene = heldBall(scene::Held::position);
    EXPECT_FALSE(unyieldingAt(EquationsOfMotion(scene), 0, 3).attitude);
    scene.shapeSets[0].parts[0].position = {0.1, 0, 0};
    EXPECT_TRUE(unyieldingAt(EquationsOfMotion(scene), 0, 3).attitude);
    EXPECT_FALSE(unyieldingAt(EquationsOfMotion(scene), 0, 5).attitude); // it is away
    scene.constraints[0].held = scene::Held::velocity;                   // that of the centre
    EXPECT_FALSE(unyieldingAt(EquationsOfMotion(scene), 0, 3).attitude);
}

} // namespace
} // namespace physics
