// Which handles a scene has, and how long their arrows are.
#include "framing/test_scenes.h"
#include "handles/handles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace render {
namespace {

const scene::Color red{0.9, 0.1, 0.1}, blue{0.1, 0.2, 0.9}, green{0.1, 0.8, 0.2};

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

// One would not know what they belong to.
TEST(Handles, HiddenBodiesHaveNone) {
    scene::Scene scene;
    for (const double x : {0.0, 3.0})
        addBody(scene, sphere(1), {x, 0, 0}, red);
    const std::string first = scene.bodies[0].name, second = scene.bodies[1].name;
    for (const std::string& body : {first, second})
        scene.forces.push_back(
            {body, false, std::nullopt, scene::GravitationalForce{{0, -10, 0}}, {}, {}});
    addJoint(scene, scene::JointType::hinge, {1, 0, 0});
    addJoint(scene, scene::JointType::ball, {1, 0, 0}).body2 = second;
    scene.links.emplace_back().first.body = first;
    scene.links.back().second = scene::BodyEnd{second, {}};
    Display display;
    display.positionHandles = display.forceHandles = display.jointHandles = display.linkHandles =
        true;
    const auto count = [&](std::set<std::string> hidden) {
        display.hidden = std::make_shared<const std::set<std::string>>(std::move(hidden));
        return Handles(scene, nullptr).at(0, display).handles.size();
    };
    // Places, weights, the hinge with its axis, the ball, the link.
    EXPECT_EQ(count({}), 2U + 4 + 2 + 1 + 2);
    EXPECT_EQ(count({first}), 1U + 2 + 0 + 1 + 2); // what joins it to the other is seen
    EXPECT_EQ(count({first, second}), 0U);
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

// Those that are written, where they are now: a hinge's around it, a slider's along it.
TEST(Handles, LimitsOfJointsHaveTheirs) {
    scene::Scene scene;
    addBody(scene, sphere(1), {3, 0, 0}, red);
    scene::Joint& hinge = addJoint(scene, scene::JointType::hinge, {-1, 0, 0});
    hinge.coordinates.resize(1);
    hinge.coordinates[0].lower = 0;
    hinge.coordinates[0].upper = M_PI / 2;
    scene::Joint& slider = addJoint(scene, scene::JointType::slider, {0, 0, 0});
    slider.axis = {0, 1, 0};
    slider.coordinates.resize(1);
    slider.coordinates[0].upper = 2.5;
    slider.coordinates[0].from = 0.5;
    Display display;
    display.jointHandles = true;
    std::vector<Handle> limits = Handles(scene, nullptr).at(0, display).handles;
    std::erase_if(limits, [](const Handle& one) { return one.kind != HandleKind::jointLimit; });
    ASSERT_EQ(limits.size(), 3U);
    const auto way = [&](std::size_t i) { return Vector(limits[i].place - Vector(2, 0, 0)); };
    EXPECT_LT((way(0).normalized() - Vector(1, 0, 0)).norm(), 1e-9);
    EXPECT_LT((way(1).normalized() - Vector(0, 1, 0)).norm(), 1e-9);
    EXPECT_EQ(limits[1].part, 1U);
    EXPECT_LT((limits[2].place - Vector(3, 2, 0)).norm(), 1e-9);
    EXPECT_EQ(limits[2].part, 1U);
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

// While one edits: an arrow that is dragged stays under the hand.
TEST(Handles, ArrowsKeepTheirScaleUnlessTheyLeaveThePictureOrGetTooShort) {
    const auto scales = [](double velocity, const std::optional<ArrowScales>& before) {
        scene::Scene scene;
        scene.bodies.emplace_back().name = "b";
        scene.bodies[0].initialVelocity = {velocity, 0, 0};
        return Handles(scene, nullptr, before).scales();
    };
    const ArrowScales first = scales(10, std::nullopt);
    EXPECT_NE(scales(14, std::nullopt).velocity, first.velocity);
    for (const double near : {14.0, 9.0, 2.0, 0.0})
        EXPECT_EQ(scales(near, first).velocity, first.velocity) << near;
    for (const double far : {100.0, 0.01})
        EXPECT_EQ(scales(far, first).velocity, scales(far, std::nullopt).velocity) << far;
}

} // namespace
} // namespace render
