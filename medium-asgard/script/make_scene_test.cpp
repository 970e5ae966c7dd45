// What each command's options mean, and that no recording, however wrong, breaks the making.
#include "script/make_scene.h"

#include "scene/joint_types.h"
#include "script/reader.h"

#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace script {
namespace {

using scene::Scene;
using scene::Vector;

Scene read(const std::string& text) {
    static Reader reader;
    const ReadResult result = reader.read("shape_set s -desc {-sub {-sphere 1}}\n" + text);
    for (const scene::Diagnostic& diagnostic : result.diagnostics)
        ADD_FAILURE() << diagnostic.message;
    return result.scene;
}

TEST(Body, HasItsDefaults) {
    const scene::Body body = read("body b s").bodies.at(0);
    EXPECT_EQ(body.shape, "s");
    EXPECT_EQ(body.initialPosition, Vector::Zero());
    EXPECT_EQ(body.initialAttitude.coeffs(), scene::Quaternion::Identity().coeffs());
    EXPECT_FALSE(body.mass || body.inertia || body.collisionGroup || body.appearance.color);
    EXPECT_EQ(body.density, 1);
    EXPECT_EQ(body.restitution, 1);
    EXPECT_FALSE(body.fixed);
}

TEST(Body, CountsTurnsThatAnExpressionReads) {
    const Scene scene = read("body a s\nbody b s\nbody c s\nforce -body a -x b.rz\n"
                             "plot p -values {c.rx a.wx}");
    EXPECT_FALSE(scene.bodies[0].countsTurns);
    EXPECT_TRUE(scene.bodies[1].countsTurns);
    EXPECT_TRUE(scene.bodies[2].countsTurns);
}

TEST(Plot, StandsBesideWhatItIsOfWhereTheTextSaysSo) {
    const Scene scene = read("body a s\nplot p -values {a.x} -beside 1\nplot q -values {a.y}\n"
                             "plot r -values {a.z} -beside 0");
    EXPECT_TRUE(scene.plots.at(0).beside);
    EXPECT_FALSE(scene.plots.at(1).beside);
    EXPECT_FALSE(scene.plots.at(2).beside);
}

TEST(Body, TakesARotationVectorOrAQuaternion) {
    const Scene scene = read("body a s -init_rot {0 0 1.5}\nbody b s -init_rot {3 0 0 4}\n"
                             "body c s -init_rot {0 0 0}\nbody d s -init_rot {1e200 0 0 1e200}");
    EXPECT_NEAR(scene.bodies[0].initialAttitude.w(), std::cos(0.75), 1e-15);
    EXPECT_NEAR(scene.bodies[0].initialAttitude.z(), std::sin(0.75), 1e-15);
    EXPECT_NEAR(scene.bodies[1].initialAttitude.w(), 0.6, 1e-15);
    EXPECT_EQ(scene.bodies[2].initialAttitude.w(), 1);
    EXPECT_NEAR(scene.bodies[3].initialAttitude.z(), std::sqrt(0.5), 1e-15);
}

TEST(Body, TurnsByAQuarterThatIsWrittenWithFewDigits) {
    const Scene scene = read("body a s -init_rot {0 -1.5708 0}\nbody b s -init_rot {0 1.571 0}\n"
                             "body c s -init_rot {1.5708 0.1 0}\nbody d s -init_rot {1e-6 0 0}\n"
                             "body e s -init_rot {1.57079 0 0}\n"
                             "shape_set can -desc {-sub {-rot {3.14159 0 0} -cylinder {1 2}}}");
    EXPECT_EQ(scene.bodies[0].initialAttitude.w(), std::cos(std::numbers::pi / 4));
    EXPECT_NEAR(scene.bodies[1].initialAttitude.w(), std::cos(1.571 / 2), 1e-15);
    EXPECT_NEAR(scene.bodies[2].initialAttitude.w(), std::cos(std::hypot(1.5708, 0.1) / 2), 1e-15);
    EXPECT_NEAR(scene.bodies[3].initialAttitude.x(), 5e-7, 1e-18);
    EXPECT_NEAR(scene.bodies[4].initialAttitude.w(), std::cos(1.57079 / 2), 1e-15);
    EXPECT_EQ(scene.shapeSets.back().parts[0].rotation.x(), std::numbers::pi);
}

TEST(Body, TakesPrincipalMomentsOrATensor) {
    const Scene scene = read("body a s -inertia {1 2 3}\nbody b s -inertia {1 2 3 0.1 0.2 0.3}");
    EXPECT_EQ(*scene.bodies[0].inertia, (std::array<double, 6>{1, 2, 3, 0, 0, 0}));
    EXPECT_EQ(*scene.bodies[1].inertia, (std::array<double, 6>{1, 2, 3, 0.1, 0.2, 0.3}));
}

TEST(Body, TakesACentreOfMassAndPartsADensity) {
    const Scene scene =
        read("body a s -mass 2 -inertia {1 2 3} -center {0 -0.3 0}\n"
             "shape_set two -desc {-sub {-box {1 1 1} -density 7} -sub {-pos {2 0 0} "
             "-sphere 1}}");
    EXPECT_EQ(*scene.bodies[0].center, Vector(0, -0.3, 0));
    EXPECT_EQ(scene.shapeSets[1].parts[0].density, 7);
    EXPECT_FALSE(scene.shapeSets[1].parts[1].density);
}

TEST(Colors, AreHexadecimalNamedOrNumbers) {
    const Scene scene =
        read("body a s -color #ff0080\nbody b s -color LightSteelBlue\nbody c s -color {0.5 0 1}");
    EXPECT_EQ(*scene.bodies[0].appearance.color, (scene::Color{1, 0, 128 / 255.0}));
    EXPECT_EQ(*scene.bodies[1].appearance.color,
              (scene::Color{0xb0 / 255.0, 0xc4 / 255.0, 0xde / 255.0}));
    EXPECT_EQ(*scene.bodies[2].appearance.color, (scene::Color{0.5, 0, 1}));
}

TEST(ShapeSet, IsAUnionOfPartsAndOneHullOfAllFaces) {
    const Scene scene = read("shape_set u -transparency 0.5 -desc {\n"
                             "  -sub {-pos {1 2 3} -rot {0 0 1} -color red -box {1 2 3}}\n"
                             "  -face {-color blue {0 0 0} {1 0 0} {0 1 0}}\n"
                             "  -sub {-points {{0 0 0} {1 0 0} {0 1 0} {0 0 1}}}\n"
                             "  -face {-color green {0 0 0} {1 0 0} {0 0 1}}}");
    const scene::ShapeSet& set = scene.shapeSets.at(1);
    ASSERT_EQ(set.parts.size(), 3u);
    EXPECT_EQ(set.appearance.transparency, 0.5);
    EXPECT_EQ(std::get<scene::BoxShape>(set.parts[0].shape).edges, Vector(1, 2, 3));
    EXPECT_EQ(set.parts[0].position, Vector(1, 2, 3));
    EXPECT_EQ(set.parts[0].rotation, Vector(0, 0, 1));
    EXPECT_EQ(std::get<scene::HullShape>(set.parts[1].shape).points.size(), 6u);
    EXPECT_EQ(*set.parts[1].appearance.color, (scene::Color{0, 0, 1})); // the first
    EXPECT_EQ(std::get<scene::HullShape>(set.parts[2].shape).points.size(), 4u);
}

TEST(ShapeSet, HasRoundPartsAndHalfSpaces) {
    const Scene scene = read("shape_set r -desc {\n"
                             "  -sub {-cylinder {1 0} -pos {1 2 3}} -sub {-cone {1 2}}\n"
                             "  -sub {-capsule {0.5 3}} -sub {-ellipsoid {1 2 3}}\n"
                             "  -sub {-color red -plane -rot {0 0 1}}}\n"
                             "body floor r -fixed 1\n"
                             "shape_set disc -desc {-sub {-cylinder {1 0}}}\n"
                             "body d disc -mass 2\n"
                             "trajectory T -points {{0 0 0 0} {10 0 1 0}}\n"
                             "body lift r\nconstrain lift -pos T -rot T");
    const std::vector<scene::Part>& parts = scene.shapeSets.at(1).parts;
    ASSERT_EQ(parts.size(), 5u);
    EXPECT_EQ(std::get<scene::CylinderShape>(parts[0].shape), (scene::CylinderShape{1, 0}));
    EXPECT_EQ(parts[0].position, Vector(1, 2, 3));
    EXPECT_EQ(std::get<scene::ConeShape>(parts[1].shape), (scene::ConeShape{1, 2}));
    EXPECT_EQ(std::get<scene::CapsuleShape>(parts[2].shape), (scene::CapsuleShape{0.5, 3}));
    EXPECT_EQ(std::get<scene::EllipsoidShape>(parts[3].shape).axes, Vector(1, 2, 3));
    EXPECT_TRUE(std::holds_alternative<scene::PlaneShape>(parts[4].shape));
    EXPECT_EQ(parts[4].rotation, Vector(0, 0, 1));
}

TEST(ShapeSet, HasHollowParts) {
    const Scene scene =
        read("shape_set h -desc {-sub {-tube {1 2 3}} -sub {-pos {0 5 0} -bowl {0.5 0.6}}}");
    const std::vector<scene::Part>& parts = scene.shapeSets.back().parts;
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(std::get<scene::TubeShape>(parts[0].shape), (scene::TubeShape{1, 2, 3}));
    EXPECT_EQ(std::get<scene::BowlShape>(parts[1].shape), (scene::BowlShape{0.5, 0.6}));
}

TEST(Force, IsOfOneOfThreeKinds) {
    const Scene scene = read("body b s\ntrajectory T -points {{0 0 0 0} {1 1 1 1}}\n"
                             "force -body b -y {-9.81 * b.mass} -offset {1 0 0} -frame body\n"
                             "force -body b -trajectory T -torque 1\n"
                             "force -body b -gravitational {0 -9.81 0}\n");
    const auto& first = std::get<scene::ComponentForce>(scene.forces.at(0).kind);
    EXPECT_THAT(first.components, testing::ElementsAre("0", "-9.81 * b.mass", "0"));
    EXPECT_EQ(first.frame, scene::Frame::body);
    EXPECT_EQ(*scene.forces[0].offset, Vector(1, 0, 0));
    EXPECT_TRUE(scene.forces[1].couple);
    EXPECT_EQ(std::get<scene::TrajectoryForce>(scene.forces[1].kind).trajectory, "T");
    EXPECT_EQ(std::get<scene::GravitationalForce>(scene.forces[2].kind).acceleration,
              Vector(0, -9.81, 0));
}

TEST(Link, JoinsABodyToABodyAPointOrATrajectory) {
    const Scene scene = read("body a s\nbody b s\ntrajectory T -points {{0 0 0 0} {1 1 1 1}}\n"
                             "link -body1 a -body2 b -offset2 {1 0 0} -tightness 5\n"
                             "link -body1 a -x {sin(t)} -y {b.y} -z 0 -tightness 6 -damping 0\n"
                             "link -body1 a -trajectory T -tightness 7\n");
    EXPECT_EQ(std::get<scene::BodyEnd>(scene.links.at(0).second).body, "b");
    EXPECT_FALSE(scene.links[0].damping);
    EXPECT_EQ(std::get<scene::PointEnd>(scene.links[1].second).coordinates[0], "sin(t)");
    EXPECT_EQ(scene.links[1].damping, 0);
    EXPECT_EQ(std::get<scene::TrajectoryEnd>(scene.links[2].second).trajectory, "T");
}

// The slope at a point is that of the chord between its neighbours; a cubic's inner control points
// lie a third of the interval along the slopes of its ends.
TEST(Joint, HasItsDefaults) {
    const Scene scene = read("body a s\nbody b s\njoint h -type hinge -body1 a\n"
                             "joint f -type fixed -body1 b -body2 a -offset1 {1 2 3}\n"
                             "joint c -type cylindrical -body1 a -body2 b -axis {1 0 0}");
    const scene::Joint& hinge = scene.joints.at(0);
    EXPECT_EQ(hinge.name, "h");
    EXPECT_EQ(hinge.type, scene::JointType::hinge);
    EXPECT_EQ(hinge.body1, "a");
    EXPECT_EQ(hinge.axis, Vector(0, 0, 1));
    EXPECT_FALSE(hinge.body2 || hinge.offset1 || hinge.offset2 || hinge.axis2 || hinge.release);
    ASSERT_EQ(hinge.coordinates.size(), 1u);
    EXPECT_FALSE(hinge.coordinates[0].isGiven || hinge.coordinates[0].lower ||
                 hinge.coordinates[0].motor || hinge.coordinates[0].maxMotor);
    EXPECT_EQ(scene.joints[1].body2, "a");
    EXPECT_EQ(*scene.joints[1].offset1, Vector(1, 2, 3));
    EXPECT_TRUE(scene.joints[1].coordinates.empty());
    EXPECT_EQ(scene.joints[2].coordinates.size(), 2u);
}

TEST(Joint, ReadsTheOptionsOfEachCoordinate) {
    const Scene scene =
        read("body a s\nbody b s\ntrajectory T -points {{0 0 0 0} {1 1 0 0}}\n"
             "joint c -type cylindrical -body1 a -body2 b -axis {1 0 0} -limits1 {-1 {}} "
             "-limit_restitution1 0.5 -motor1 {-2*c.dq1 + b.x} -position2 T -max_motor2 9 "
             "-from1 -0.5 -from2 3\n"
             "joint d -type distance -body1 a -offset2 {0 3 0} -stiffness 4 -rest 2 -damping 1\n"
             "joint h -type hinge -body1 b -speed {c.q2 + sin(t)} -friction 0.5 "
             "-release {hypot(h.fx, h.fy) > 3}\n"
             "joint w -type screw -body1 a -axis {0 1 0} -pitch -0.1 -axis2 {0 1 0}\n"
             "joint r -type distance -body1 b -body2 a\n"
             "plot p -values {h.motor c.dq2 w.tz}");
    const auto& c = scene.joints.at(0).coordinates;
    EXPECT_EQ(c[0].lower, -1);
    EXPECT_FALSE(c[0].upper);
    EXPECT_EQ(c[0].limitRestitution, 0.5);
    EXPECT_EQ(c[0].motor, "-2*c.dq1 + b.x");
    EXPECT_EQ(c[1].position, "T.x");
    EXPECT_EQ(c[1].maxMotor, 9);
    EXPECT_EQ(c[0].from, -0.5);
    EXPECT_EQ(c[1].from, 3);
    const scene::JointCoordinate& spring = scene.joints[1].coordinates.at(0);
    EXPECT_EQ(spring.stiffness, 4);
    EXPECT_EQ(spring.rest, 2);
    EXPECT_EQ(spring.damping, 1);
    EXPECT_FALSE(scene::isRigidDistance(scene.joints[1]));
    EXPECT_EQ(scene.joints[2].coordinates[0].speed, "c.q2 + sin(t)");
    EXPECT_EQ(scene.joints[2].coordinates[0].friction, 0.5);
    EXPECT_EQ(scene.joints[2].release, "hypot(h.fx, h.fy) > 3");
    EXPECT_EQ(scene.joints[3].pitch, -0.1);
    EXPECT_EQ(*scene.joints[3].axis2, Vector(0, 1, 0));
    EXPECT_TRUE(scene::isRigidDistance(scene.joints[4]));
}

TEST(Gear, HoldsASumOfCoordinates) {
    const Scene scene = read("body a s\nbody b s\njoint j -type hinge -body1 a\n"
                             "joint k -type slider -body1 b -axis {1 0 0}\n"
                             "joint c -type cylindrical -body1 a -body2 b -axis {0 1 0}\n"
                             "gear g -joint1 j -joint2 k -ratio 2.5\n"
                             "gear d -joints {j k c.q2} -ratios {1 2 -3} -release {t > 1}");
    using Term = scene::Gear::Term;
    EXPECT_EQ(scene.gears.at(0).terms, (std::vector<Term>{{"j", 0, 1}, {"k", 0, -2.5}}));
    EXPECT_EQ(scene.gears.at(1).terms, (std::vector<Term>{{"j", 0, 1}, {"k", 0, 2}, {"c", 1, -3}}));
    EXPECT_EQ(scene.gears[1].release, "t > 1");
}

TEST(Spring, HasARestLengthAndMayHaveAName) {
    const Scene scene = read("body a s\nbody b s\nspring -body1 a -x 0 -y 1 -z 2 -stiffness 4\n"
                             "spring s -body1 a -offset1 {1 0 0} -body2 b -stiffness 5 -rest 2 "
                             "-damping 3 -pull_only 1\nforce -body a -x {s.length}\n"
                             "plot p -values {s.force}\nlink -body1 a -body2 b -tightness 1");
    const scene::Link &plain = scene.links.at(0), &named = scene.links.at(1);
    ASSERT_TRUE(plain.spring && named.spring);
    EXPECT_EQ(plain.name, "");
    EXPECT_EQ(plain.tightness, 4);
    EXPECT_EQ(plain.damping, 0);
    EXPECT_FALSE(plain.spring->rest || plain.spring->isPullOnly);
    EXPECT_EQ(named.name, "s");
    EXPECT_EQ(named.spring->rest, 2);
    EXPECT_EQ(named.damping, 3);
    EXPECT_TRUE(named.spring->isPullOnly);
    EXPECT_EQ(std::get<scene::BodyEnd>(named.second).body, "b");
    EXPECT_FALSE(scene.links.at(2).spring);
}

TEST(Trajectory, PassesThroughItsPointsWithTheSlopesOfTheChords) {
    const Scene scene = read("trajectory T -points {{0 0 0 0} {1 3 0 0} {3 6 0 3}}");
    const auto& curves = scene.trajectories.at(0).curves;
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].from, 0);
    EXPECT_EQ(curves[1].to, 3);
    const Vector middle(2, 0, 1); // (6 - 0, 0, 3 - 0) / (3 - 0)
    EXPECT_TRUE(curves[0].control[1].isApprox(Vector(1, 0, 0)));
    EXPECT_TRUE(curves[0].control[2].isApprox(Vector(3, 0, 0) - middle / 3));
    EXPECT_TRUE(curves[1].control[1].isApprox(Vector(3, 0, 0) + middle * 2 / 3));
    EXPECT_TRUE(curves[1].control[2].isApprox(Vector(6, 0, 3) - Vector(1.5, 0, 1.5) * 2 / 3));
    EXPECT_EQ(scene.trajectories[0].points.size(), 3u);
}

TEST(Trajectory, OrdersItsCurvesInTime) {
    const Scene scene = read("trajectory T -bezier {{2 3 {1 0 0}} {0 1 {0 0 0} {1 1 1}}}");
    EXPECT_EQ(scene.trajectories.at(0).curves[0].from, 0);
    EXPECT_EQ(scene.trajectories[0].curves[1].control.size(), 1u);
}

TEST(Constraint, HoldsEachComponentByOneTrajectoryAtATime) {
    const std::string start = "body b s\ntrajectory T -points {{0 0 0 0} {1 1 1 1}}\n"
                              "trajectory U -points {{1 0 0 0} {2 1 1 1}}\n";
    EXPECT_EQ(read(start + "constrain b -pos T -rot T\nconstrain b -dpos U").constraints.size(),
              3u);
    EXPECT_EQ(read(start + "constrain b -x T\nconstrain b -dy T -from 0.5").constraints.size(), 2u);
    EXPECT_EQ(
        read(start + "constrain b -x T -to 0.5\nconstrain b -dx T -from 0.5").constraints[0].to,
        0.5);
}

TEST(View, TakesNumbersExpressionsAndTrajectories) {
    const Scene scene = read("body b s\ntrajectory T -points {{0 0 0 0} {1 1 1 1}}\n"
                             "view -center {1 2 3} -scale {1 + t} -rot T -pos {b.x {b.y + 1} 0}\n"
                             "view near -eye T -look {b.x b.y b.z} -up {0 1 0}\n"
                             "view far -scale T");
    const scene::View& first = scene.views.at(0);
    EXPECT_EQ(std::get<Vector>(*first.center), Vector(1, 2, 3));
    EXPECT_EQ(std::get<scene::Expression>(*first.scale), "1 + t");
    EXPECT_EQ(std::get<std::string>(*first.rotation), "T");
    EXPECT_EQ((std::get<std::array<scene::Expression, 3>>(*first.position))[1], "b.y + 1");
    EXPECT_EQ(scene.views[1].name, "near");
    EXPECT_EQ(std::get<scene::Expression>(*scene.views[2].scale), "T.x");
}

TEST(Simulator, HasItsDefaults) {
    const Scene scene = read("simulator -accuracy 1e-6 -method radau5 -collisions 0");
    EXPECT_EQ(scene.simulator.start, 0);
    EXPECT_EQ(scene.simulator.finish, 10);
    EXPECT_FALSE(scene.simulator.firstStep);
    EXPECT_EQ(scene.simulator.accuracy, 1e-6);
    EXPECT_EQ(scene.simulator.method, "radau5");
    EXPECT_FALSE(scene.simulator.collisions);
}

TEST(Expressions, MayNameWhatComesLater) {
    EXPECT_EQ(
        read("body a s\nforce -body a -x {b.x * k}\nbody b s\nparameter k -value 2").bodies.size(),
        2u);
}

// A recording comes from a process that is not trusted: any words in any order.
TEST(MakeScene, SurvivesRandomRecordings) {
    static const std::vector<std::string> words = {"body",
                                                   "instance",
                                                   "force",
                                                   "link",
                                                   "trajectory",
                                                   "constrain",
                                                   "view",
                                                   "lightsource",
                                                   "parameter",
                                                   "plot",
                                                   "simulator",
                                                   "shape_set",
                                                   "-desc",
                                                   "-sub {-sphere 1}",
                                                   "-face",
                                                   "s",
                                                   "b",
                                                   "T",
                                                   "-shape",
                                                   "-body",
                                                   "-body1",
                                                   "-body2",
                                                   "-x",
                                                   "-y",
                                                   "-z",
                                                   "-points",
                                                   "{0 0 0 0} {1 1 1 1}",
                                                   "{0 1 {0 0 0}}",
                                                   "-bezier",
                                                   "-pos",
                                                   "-rot",
                                                   "-dpos",
                                                   "-value",
                                                   "1",
                                                   "-1",
                                                   "1e308",
                                                   "0 0 0",
                                                   "1 2 3",
                                                   "1e308 1e308 1e308",
                                                   "-init_pos",
                                                   "-init_rot",
                                                   "-inertia",
                                                   "-mass",
                                                   "-gravitational",
                                                   "-tightness",
                                                   "b.x + t",
                                                   "((((",
                                                   "",
                                                   "{",
                                                   "\"",
                                                   "\\",
                                                   "\xff\xfe",
                                                   "-values",
                                                   "-labels",
                                                   "-eye",
                                                   "-look",
                                                   "-color",
                                                   "red",
                                                   "#12",
                                                   "-from",
                                                   "-to",
                                                   "t",
                                                   "-ct"};
    const std::string text = "body b s\nforce -body b -x 1\n";
    const Structure structure = structureOf(text);
    std::mt19937 random(5);
    std::size_t elements = 0;
    for (int i = 0; i < 20'000; ++i) {
        Recording recording;
        const std::size_t commands = 1 + random() % 6;
        for (std::size_t k = 0; k < commands; ++k) {
            RecordedCommand command;
            command.offset = random() % 3 == 0 ? random() % 30 : noOffset;
            command.caller = random() % 2 == 0 ? 9 : random();
            command.words.push_back(words[random() % 12]);
            const std::size_t count = random() % 12;
            for (std::size_t w = 0; w < count; ++w)
                command.words.push_back(words[random() % words.size()]);
            recording.commands.push_back(command);
        }
        const MadeScene made = makeScene(text, structure, recording, random() % 2 == 0, {});
        elements += made.scene.bodies.size() + made.scene.trajectories.size();
        for (const scene::Diagnostic& diagnostic : made.diagnostics)
            ASSERT_FALSE(diagnostic.message.empty());
    }
    EXPECT_GT(elements, 100u);
}

} // namespace
} // namespace script
