// Equations of motion against equations derived by hand.
#include "physics/equations_of_motion.h"

#include "physics/testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace physics {
namespace {

using testing::ballAndRod;
using testing::equation;
using testing::unknown;

// The entries of the attitude's rotation matrix, times what they stand for below.
const std::string two = "2/(rod.qw^2 + rod.qx^2 + rod.qy^2 + rod.qz^2)";
const std::string r11 = "(1 - " + two + "*(rod.qy^2 + rod.qz^2))";
const std::string r12 = "(" + two + "*(rod.qx*rod.qy - rod.qw*rod.qz))";
const std::string r13 = "(" + two + "*(rod.qx*rod.qz + rod.qw*rod.qy))";
const std::string r21 = "(" + two + "*(rod.qx*rod.qy + rod.qw*rod.qz))";
const std::string r22 = "(1 - " + two + "*(rod.qx^2 + rod.qz^2))";
const std::string r23 = "(" + two + "*(rod.qy*rod.qz - rod.qw*rod.qx))";
const std::string r31 = "(" + two + "*(rod.qx*rod.qz - rod.qw*rod.qy))";

scene::Force weight(const std::string& body) {
    scene::Force force;
    force.body = body;
    force.kind = scene::GravitationalForce{{0, -9.81, 0}};
    return force;
}

std::string readBy(const EquationsOfMotion& motion, std::string_view name) {
    std::vector<Node> nodes;
    for (const expression::Phase& phase : unknown(motion, name).phases)
        nodes.push_back(phase.given.value_or(phase.derivative));
    std::string names;
    for (const Node symbol : symbolsOf(motion.set.graph, nodes))
        names += motion.set.graph.name(symbol) + ' ';
    return names;
}

TEST(Equations, OfABallisticSphere) {
    scene::Scene scene = ballAndRod();
    scene.forces = {weight("ball")};
    const EquationsOfMotion motion(scene);
    ASSERT_EQ(motion.faults, std::vector<std::string>{});
    EXPECT_EQ(motion.set.unknowns.size(), 26u);
    EXPECT_EQ(equation(motion, "ball.x"), "ball.dx");
    EXPECT_EQ(equation(motion, "ball.dx"), "0");
    EXPECT_EQ(equation(motion, "ball.dy"), "-9.81"); // the weight's mass cancels to the last bit
    EXPECT_EQ(equation(motion, "ball.wx"), "0");
    EXPECT_EQ(
        equation(motion, "ball.qw"),
        testing::asPrinted(motion, "-0.5*(ball.qx*ball.wx + ball.qy*ball.wy + ball.qz*ball.wz)"));
    EXPECT_EQ(
        equation(motion, "ball.qx"),
        testing::asPrinted(motion, "0.5*(ball.qw*ball.wx + (ball.wy*ball.qz - ball.wz*ball.qy))"));
    EXPECT_EQ(equation(motion, "rod.qx"),
              testing::asPrinted(motion, "0.5*(rod.qw*rod.w1 + (rod.qy*rod.w3 - rod.qz*rod.w2))"));
}

// Equal moments about the second and third axis: the spin about the first is constant.
TEST(Equations, OfAFreeSymmetricTopHaveNoTermThatCancels) {
    const EquationsOfMotion motion(ballAndRod());
    EXPECT_EQ(equation(motion, "rod.w1"), "0");
    EXPECT_EQ(equation(motion, "rod.w2"), testing::asPrinted(motion, "0.6*(rod.w1*rod.w3)"));
    EXPECT_EQ(equation(motion, "rod.w3"), testing::asPrinted(motion, "-0.6*(rod.w1*rod.w2)"));
}

TEST(Equations, OfAForceThatActsOffTheCentreOfABox) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("rod", "0", "6", "0")};
    scene.forces[0].offset = Vector(1, 0, 0);
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "rod.dy"), "2");
    // (1 0 0) x R'(0 6 0): nothing about the first axis
    EXPECT_EQ(equation(motion, "rod.w1"), "0");
    EXPECT_EQ(equation(motion, "rod.w2"),
              testing::asPrinted(motion, "0.6*(rod.w1*rod.w3) - 6*" + r23 + "/1.25"));
    EXPECT_EQ(equation(motion, "rod.w3"),
              testing::asPrinted(motion, "-0.6*(rod.w1*rod.w2) + 6*" + r22 + "/1.25"));
}

// Dissertation 5.2.1, Figure 5.8: two bodies that attract each other along X only.
TEST(Equations, OfAnAttractionAlongXCoupleOnlyX) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "2*(rod.x - ball.x)", "0", "0"),
                    testing::force("rod", "2*(ball.x - rod.x)", "0*rod.y", "0")};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.dx"), "rod.x - ball.x");
    EXPECT_EQ(readBy(motion, "ball.dx"), "ball.x rod.x ");
    EXPECT_EQ(readBy(motion, "rod.dx"), "ball.x rod.x ");
    for (const char* free : {"ball.dy", "ball.dz", "rod.dy", "rod.dz", "ball.wx", "rod.w1"})
        EXPECT_EQ(readBy(motion, free), "") << free;
}

TEST(Equations, OfALinkBetweenACentreAndAPoint) {
    scene::Scene scene = ballAndRod();
    scene::Link link;
    link.first = {"ball", std::nullopt};
    link.second = scene::PointEnd{{"1000000", "0", "sin(t)"}};
    link.tightness = 50; // critical: 2 sqrt(50*2) = 20
    scene.links = {link};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.dx"),
              testing::asPrinted(motion, "(-50*(ball.x - 1000000) - 20*ball.dx)/2"));
    EXPECT_EQ(equation(motion, "ball.dy"),
              testing::asPrinted(motion, "(-50*ball.y - 20*ball.dy)/2"));
    EXPECT_EQ(equation(motion, "ball.dz"),
              testing::asPrinted(motion, "(-50*(ball.z - sin(t)) - 20*(ball.dz - cos(t)))/2"));
    EXPECT_EQ(equation(motion, "ball.wx"), "0");
}

TEST(Equations, OfALinkBetweenTwoBodies) {
    scene::Scene scene = ballAndRod();
    scene::Link link;
    link.first = {"ball", std::nullopt};
    link.second = scene::BodyEnd{"rod", Vector(-1, 0, 0)};
    link.tightness = 30; // reduced mass 6/5: 2 sqrt(30*1.2) = 12
    scene.links = {link};
    const EquationsOfMotion motion(scene);
    ASSERT_EQ(motion.links.size(), 1u);
    EXPECT_DOUBLE_EQ(motion.links[0].damping, 12);
    // First the difference of the centres, then the arm.
    EXPECT_EQ(print(motion.set.graph, motion.links[0].extension[0]),
              testing::asPrinted(motion, "ball.x - rod.x + " + r11));
    EXPECT_EQ(print(motion.set.graph, motion.links[0].extension[1]),
              testing::asPrinted(motion, "ball.y - rod.y + " + r21));
    // Point velocity of the rod: R (w x (-1 0 0)) = R (0, -w3, w2)
    EXPECT_EQ(
        print(motion.set.graph, motion.links[0].speed[0]),
        testing::asPrinted(motion, "ball.dx - rod.dx + (" + r12 + "*rod.w3 - " + r13 + "*rod.w2)"));
}

TEST(Equations, OfAThrusterFixedToTheBody) {
    scene::Scene scene = ballAndRod();
    scene::Force thruster = testing::force("rod", "3", "0", "0");
    std::get<scene::ComponentForce>(thruster.kind).frame = scene::Frame::body;
    thruster.offset = Vector(0, -0.5, 0);
    scene.forces = {thruster};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "rod.dx"), testing::asPrinted(motion, "3*" + r11 + "/3"));
    EXPECT_EQ(equation(motion, "rod.dy"), testing::asPrinted(motion, "3*" + r21 + "/3"));
    EXPECT_EQ(equation(motion, "rod.dz"), testing::asPrinted(motion, "3*" + r31 + "/3"));
    // (0 -0.5 0) x (3 0 0) = (0 0 1.5), the same at every attitude
    EXPECT_EQ(equation(motion, "rod.w3"), testing::asPrinted(motion, "-0.6*(rod.w1*rod.w2) + 1.2"));
}

TEST(Equations, OfACoupleTurnAboutTheCentreAndMakeNoForce) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "0", "0", "4"), testing::force("rod", "0", "0", "5")};
    for (scene::Force& force : scene.forces) {
        force.couple = true;
        force.offset = Vector(7, 7, 7); // only where it is drawn
    }
    std::get<scene::ComponentForce>(scene.forces[1].kind).frame = scene::Frame::body;
    scene.bodies[0].inertia = {0.2, 0.2, 0.2, 0, 0, 0};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(equation(motion, "ball.dx") + equation(motion, "ball.dz"), "00");
    EXPECT_EQ(equation(motion, "ball.wz"), "20");
    EXPECT_EQ(equation(motion, "rod.dx") + equation(motion, "rod.dz"), "00");
    EXPECT_EQ(equation(motion, "rod.w3"), testing::asPrinted(motion, "-0.6*(rod.w1*rod.w2) + 4"));
}

TEST(Equations, NamesReadMassInertiaPointsAndParameters) {
    scene::Scene scene = ballAndRod();
    scene.parameters.resize(1);
    scene.parameters[0].name = "k";
    scene.parameters[0].value = 7;
    scene.forces = {testing::force("ball", "ball.mass*rod.mass*k", "rod.px(1, 0, 0) - rod.x",
                                   "ball.wx + rod.ixy")};
    const EquationsOfMotion motion(scene);
    ASSERT_EQ(motion.faults, std::vector<std::string>{});
    EXPECT_EQ(equation(motion, "ball.dx"), "21");
    EXPECT_EQ(equation(motion, "ball.dy"),
              testing::asPrinted(motion, "(rod.x + " + r11 + " - rod.x)/2"));
    EXPECT_EQ(equation(motion, "ball.dz"), "ball.wx/2");
}

TEST(Equations, WorldAngularVelocityOfABoxIsItsOwnTurnedOut) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "rod.wx", "0", "0")};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(readBy(motion, "ball.dx"), "rod.qw rod.qx rod.qy rod.qz rod.w1 rod.w2 rod.w3 ");
}

TEST(Equations, AFixedBodyIsConstantsAndHasNoUnknowns) {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].fixed = true;
    scene.bodies[1].initialPosition = {5, 0, 0};
    scene::Link link;
    link.first = {"ball", std::nullopt};
    link.second = scene::BodyEnd{"rod", Vector(-1, 0, 0)};
    link.tightness = 50; // the fixed one counts as infinite: 2 sqrt(50*2)
    scene.links = {link};
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(motion.set.unknowns.size(), 13u);
    EXPECT_EQ(equation(motion, "ball.dx"),
              testing::asPrinted(motion, "(-50*(ball.x - 5 + 1) - 20*ball.dx)/2"));
}

// Thirteen unknowns of which only the attitude's four read each other.
TEST(Equations, OfAFreeBodySplitIntoScalars) {
    const EquationsOfMotion motion(ballAndRod());
    for (const char* name : {"ball.x", "ball.y", "ball.z"})
        EXPECT_EQ(readBy(motion, name), "ball.d" + std::string(name).substr(5) + ' ');
    for (const char* name : {"ball.dx", "ball.dy", "ball.dz", "ball.wx", "ball.wy", "ball.wz"})
        EXPECT_EQ(readBy(motion, name), "");
}

// Of points all of which are corners: thousands of questions which of them sees which triangle.
scene::ShapeSet roundHull(const std::string& name, int points) {
    scene::HullShape hull;
    for (int i = 0; i < points; ++i) {
        const double height = (2.0 * i + 1) / points - 1, turn = 2.4 * i;
        const double radius = std::sqrt(1 - height * height);
        hull.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), height);
    }
    scene::ShapeSet set;
    set.name = name;
    set.parts.resize(1);
    set.parts[0].shape = hull;
    return set;
}

TEST(Equations, AskWhileTheyMakeAHullAndShareOneThatIsMade) {
    scene::Scene scene = ballAndRod();
    scene.shapeSets[0] = roundHull("ball1", 1000);
    std::size_t asked = 0;
    const auto count = [&] { ++asked; };
    EXPECT_TRUE(EquationsOfMotion(scene, count).faults.empty());
    EXPECT_GT(asked, 5u);
    scene::ShapeReader shapes(count);
    (void)shapes.of(scene.shapeSets[0]);
    const std::size_t once = std::exchange(asked, 0);
    EXPECT_GT(once, 5u);
    EXPECT_TRUE(EquationsOfMotion(scene, count, &shapes).faults.empty());
    EXPECT_EQ(asked, 0u);
}

TEST(Equations, TellWhatEachUnknownMeasures) {
    const EquationsOfMotion motion(ballAndRod());
    EXPECT_EQ(unknown(motion, "rod.y").lengthPerUnit, 1);
    EXPECT_EQ(unknown(motion, "rod.dy").lengthPerUnit, 0);
    EXPECT_NEAR(unknown(motion, "rod.qx").lengthPerUnit, 2 * std::sqrt(1.5), 1e-15);
    EXPECT_EQ(motion.set.unknowns[*unknown(motion, "rod.dz").integralOf].name, "rod.z");
    EXPECT_EQ(motion.set.quaternions.size(), 2u);
    EXPECT_EQ(motion.set.unknowns[motion.set.quaternions[1][0]].name, "rod.qw");
}

// A hammer: a head of 8 at x = 1 and a handle of 2 at x = 0, both cubes of edge 1.
TEST(Equations, PartsWithDensitiesOfTheirOwnMakeMassAndCentre) {
    scene::Scene scene;
    scene::ShapeSet set = testing::box("hammer", {1, 1, 1});
    set.parts.push_back(set.parts[0]);
    set.parts[1].position = {1, 0, 0};
    set.parts[1].density = 8;
    scene.shapeSets = {set};
    scene::Body body;
    body.name = "b";
    body.shape = "hammer";
    body.density = 2;
    scene.bodies = {body, body};
    scene.bodies[1].name = "c";
    scene.bodies[1].mass = 5;
    const EquationsOfMotion motion(scene);
    const BodyMass &own = motion.bodies[0].mass, &scaled = motion.bodies[1].mass;
    EXPECT_NEAR(own.mass, 10, 1e-13);
    EXPECT_LT((own.centroid - Vector(0.8, 0, 0)).norm(), 1e-15);
    // Cubes: m/6 each; parallel axes: 2 * 0.8² + 8 * 0.2² = 1.6.
    EXPECT_NEAR(own.inertia(0, 0), 10.0 / 6, 1e-13);
    EXPECT_NEAR(own.inertia(1, 1), 10.0 / 6 + 1.6, 1e-13);
    EXPECT_NEAR(own.radius, std::sqrt(1.3 * 1.3 + 0.5), 1e-13);
    EXPECT_NEAR(scaled.mass, 5, 1e-13);
    EXPECT_NEAR(scaled.inertia(1, 1), (10.0 / 6 + 1.6) / 2, 1e-13);
}

TEST(Equations, ACentreOfMassMayBeGiven) {
    scene::Scene scene = ballAndRod();
    scene.bodies[1].inertia = {{1, 2, 3, 0, 0, 0}};
    scene.bodies[1].center = Vector(0.25, 0, 0);
    scene.bodies[1].initialPosition = {1, 1, 0};
    scene.bodies[1].initialAttitude = geometry::fromRotationVector({0, 0, std::numbers::pi / 2});
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(motion.bodies[1].mass.centroid, Vector(0.25, 0, 0));
    EXPECT_EQ(motion.bodies[1].mass.inertia(2, 2), 3);
    EXPECT_LT((motion.bodies[1].start.position - Vector(1, 1.25, 0)).norm(), 1e-15);
    EXPECT_NEAR(motion.bodies[1].mass.radius, std::sqrt(1.25 * 1.25 + 0.5), 1e-13);
}

TEST(Equations, StartAtTheCentreOfMassWithTheSpinAlongTheBodysAxes) {
    scene::Scene scene = ballAndRod();
    scene.shapeSets[1].parts[0].position = {1, 0, 0}; // the reference point is an end of the rod
    scene.bodies[1].initialPosition = {10, 0, 0};
    scene.bodies[1].initialAttitude = geometry::fromRotationVector({0, 0, std::acos(0.)});
    scene.bodies[1].initialAngularVelocity = {0, 3, 0};
    const EquationsOfMotion motion(scene);
    EXPECT_NEAR(unknown(motion, "rod.x").initial, 10, 1e-15);
    EXPECT_NEAR(unknown(motion, "rod.y").initial, 1, 1e-15);
    EXPECT_NEAR(unknown(motion, "rod.w1").initial, 3, 1e-15);
    EXPECT_NEAR(unknown(motion, "rod.w2").initial, 0, 1e-15);
    EXPECT_NEAR(unknown(motion, "rod.qz").initial, std::sqrt(0.5), 1e-15);
}

TEST(Equations, AWorldStateAndTheUnknownsSayTheSame) {
    const EquationsOfMotion motion(ballAndRod());
    BodyValues given{Vector(1, 2, 3), Vector(4, 5, 6), geometry::fromRotationVector({1, -2, 0.5}),
                     Vector(7, 8, 9)};
    for (const BodyMotion& body : motion.bodies) {
        const BodyValues back = body.valuesOf(body.unknownsOf(given));
        EXPECT_EQ(back.position, given.position);
        EXPECT_EQ(back.velocity, given.velocity);
        EXPECT_LT(back.attitude.angularDistance(given.attitude), 1e-15);
        EXPECT_LT((back.angularVelocity - given.angularVelocity).norm(), 1e-14);
    }
}

TEST(Equations, FaultsOfExpressionsAreSentences) {
    scene::Scene scene = ballAndRod();
    scene.forces = {testing::force("ball", "1+", "0", "nobody.x")};
    scene.forces[0].source.line = 12;
    const EquationsOfMotion motion(scene);
    EXPECT_EQ(
        motion.faults,
        (std::vector<std::string>{
            "line 12: -x of a force on \"ball\": expected a value, and the expression ends here",
            "line 12: -z of a force on \"ball\": nothing is named "
            "\"nobody\""}));
}

} // namespace
} // namespace physics
