#include "scene/names.h"

#include <gtest/gtest.h>

namespace scene {
namespace {

Scene sceneWithNames() {
    Scene scene;
    scene.bodies.resize(2);
    scene.bodies[0].name = "rod1";
    scene.bodies[1].name = "ball";
    scene.trajectories.resize(1);
    scene.trajectories[0].name = "path";
    scene.parameters.resize(1);
    scene.parameters[0].name = "height";
    scene.joints.resize(3);
    scene.joints[0].name = "pin";
    scene.joints[0].type = JointType::hinge;
    scene.joints[1].name = "tube";
    scene.joints[1].type = JointType::cylindrical;
    scene.joints[2].name = "weld";
    scene.gears.resize(1);
    scene.gears[0].name = "teeth";
    scene.links.resize(2); // a link, which has no name, and a spring
    scene.links[1].name = "cord";
    return scene;
}

// [wrong bytes] message | suggestion
std::string diagnosis(const std::string& text, Reading reading = Reading::state) {
    Scene scene = sceneWithNames();
    if (reading == Reading::positions) {
        scene.links[0].second = PointEnd{{text, "0", "0"}};
    } else if (reading == Reading::quantities) {
        scene.plots.resize(1);
        scene.plots[0].values = {text};
    } else {
        scene.forces.resize(1);
        scene.forces[0].kind = ComponentForce{{text, "0", "0"}};
    }
    const auto faults = checkExpressions(scene);
    if (faults.empty())
        return "right";
    const ExpressionFault& fault = faults.front();
    return "[" + text.substr(fault.from, fault.to - fault.from) + "] " + fault.message +
           (fault.suggestion.empty() ? "" : " | " + fault.suggestion);
}

TEST(Names, OfTimeParametersBodiesAndTrajectoriesAreRight) {
    for (const char* text :
         {"t", "height*2", "pi", "rod1.x + rod1.wz*rod1.qw", "ball.mass/ball.ixx",
          "path.x - path.dz", "rod1.px(0.5, 0, height)", "ball.pdz(0, 0, sin(t))"})
        EXPECT_EQ(diagnosis(text), "right") << text;
}

TEST(Names, FaultsNameTheWordAndWhatWasMeant) {
    const std::pair<const char*, const char*> rows[] = {
        {"2*heigth", "[heigth] nothing is named \"heigth\" | did you mean \"height\"?"},
        {"rod.x", "[rod.x] nothing is named \"rod\" | did you mean \"rod1.x\"?"},
        {"1 + rod1.massa", "[rod1.massa] a body has no quantity \"massa\" | did you mean "
                           "\"rod1.mass\"?"},
        {"rod1", "[rod1] \"rod1\" is a body, and an expression reads numbers | write rod1.x, or "
                 "another of its quantities"},
        {"path.q", "[path.q] a trajectory has no quantity \"q\" | there are x y z dx dy dz"},
        {"path.mass",
         "[path.mass] a trajectory has no quantity \"mass\" | there are x y z dx dy dz"},
        {"height.x", "[height.x] \"height\" is a parameter: its name alone is its value"},
        {"rod1.px", "[rod1.px] rod1.px wants a point of the body | write rod1.px(ox, oy, oz)"},
        {"rod1.px(1, 2)", "[rod1.px] rod1.px takes three arguments, not 2"},
        {"rod1.x(1)", "[rod1.x] rod1.x takes no arguments"},
        {"foo(1)", "[foo] there is no function \"foo\""},
        {"snh(1)", "[snh] there is no function \"snh\" | did you mean \"sinh\"?"},
        {"scene.energy", "[scene.energy] scene.energy can be charted and printed, and is no name "
                         "in a scene's expressions"},
    };
    for (const auto& [text, expected] : rows)
        EXPECT_EQ(diagnosis(text), expected) << text;
}

TEST(Names, OfJointsDependOnTheirType) {
    EXPECT_EQ(diagnosis("pin.q + pin.dq + tube.q1 + tube.dq2"), "right");
    EXPECT_EQ(diagnosis("pin.q + tube.q2", Reading::positions), "right");
    EXPECT_EQ(diagnosis("pin.motor + tube.motor2 + weld.fx + tube.tz", Reading::quantities),
              "right");
    EXPECT_EQ(diagnosis("pin.dq", Reading::positions),
              "[pin.dq] positions may be read here, and no velocities");
    EXPECT_EQ(diagnosis("tube.q"), "[tube.q] a cylindrical joint has no quantity \"q\" | there are "
                                   "q1 dq1 motor1 q2 dq2 motor2 fx fy fz tx ty tz px py pz");
    EXPECT_EQ(diagnosis("weld.q"), "[weld.q] a fixed joint has no quantity \"q\" | there are fx fy "
                                   "fz tx ty tz px py pz");
    EXPECT_EQ(diagnosis("pin"), "[pin] \"pin\" is a joint, and an expression reads numbers | "
                                "write pin.q, or another of its quantities");
    for (const std::string name : {"pin.motor", "pin.fx", "weld.tz"})
        EXPECT_EQ(diagnosis(name), "[" + name + "] " + name +
                                       " is a force, which plots, --quantities and -release may "
                                       "read, and no other expression");
    EXPECT_EQ(diagnosis("teeth.q"), "[teeth.q] \"teeth\" is a gear, which has no quantities | its "
                                    "joints have q and dq");
}

TEST(Names, SayWhichCoordinateIsMeant) {
    const Names names(sceneWithNames());
    const auto found = [&](const char* name) {
        return std::get<JointName>(names.find(name, std::nullopt, Reading::quantities));
    };
    EXPECT_EQ(found("tube.dq2").joint, 1u);
    EXPECT_EQ(found("tube.dq2").quantity, JointQuantity::dq);
    EXPECT_EQ(found("tube.dq2").coordinate, 1u);
    EXPECT_EQ(found("tube.motor1").quantity, JointQuantity::motor);
    EXPECT_EQ(found("tube.motor1").coordinate, 0u);
    EXPECT_EQ(found("tube.ty").quantity, JointQuantity::ty);
    EXPECT_EQ(found("weld.fz").quantity, JointQuantity::fz);
    EXPECT_EQ(found("tube.px").quantity, JointQuantity::px);
    EXPECT_EQ(found("weld.pz").quantity, JointQuantity::pz);
    EXPECT_EQ(diagnosis("weld.pz - pin.px"), "right"); // also where forces are not read
}

TEST(Names, OfSpringsAreTheirLengthAndForce) {
    EXPECT_EQ(diagnosis("2*cord.length"), "right");
    EXPECT_EQ(diagnosis("cord.force", Reading::quantities), "right");
    EXPECT_EQ(diagnosis("cord.force"), "[cord.force] cord.force is a force, which plots, "
                                       "--quantities and -release may read, and no other "
                                       "expression");
    EXPECT_EQ(diagnosis("cord.length", Reading::positions),
              "[cord.length] positions may be read here, and no lengths of springs");
    EXPECT_EQ(diagnosis("cord.x"),
              "[cord.x] a spring has no quantity \"x\" | there are length and force");
    EXPECT_EQ(diagnosis("cord"), "[cord] \"cord\" is a spring, and an expression reads numbers | "
                                 "write cord.length, or another of its quantities");
}

TEST(Names, WhatMayBeReadDependsOnTheElement) {
    EXPECT_EQ(diagnosis("rod1.px(1, 0, 0) + path.x", Reading::positions), "right");
    EXPECT_EQ(diagnosis("rod1.dx", Reading::positions),
              "[rod1.dx] positions may be read here, and no velocities");
    EXPECT_EQ(diagnosis("rod1.pdx(0,0,0)", Reading::positions),
              "[rod1.pdx] positions may be read here, and no velocities");
    EXPECT_EQ(diagnosis("scene.energy + events.collisions", Reading::quantities), "right");
    EXPECT_EQ(
        diagnosis("scene.enrgy", Reading::quantities),
        "[scene.enrgy] there is no quantity \"scene.enrgy\" | did you mean \"scene.energy\"?");
}

TEST(Names, EveryExpressionOfASceneIsChecked) {
    Scene scene = sceneWithNames();
    scene.forces.resize(1);
    scene.forces[0].kind = ComponentForce{{"1+", "0", "bad1"}};
    scene.links[0].second = PointEnd{{"0", "bad2", "0"}};
    scene.joints[1].coordinates.resize(2);
    scene.joints[1].coordinates[1].speed = "bad6";
    scene.joints[1].release = "pin.fx + bad7";
    scene.views.resize(1);
    scene.views[0].position = std::array<Expression, 3>{"t", "bad3", "0"};
    scene.views[0].scale = Expression("bad4");
    scene.plots.resize(1);
    scene.plots[0].values = {"t", "bad5"};
    std::string found;
    for (const ExpressionFault& fault : checkExpressions(scene))
        found += fault.place.option + '[' + std::to_string(fault.place.index) + "] ";
    EXPECT_EQ(found, "-x[0] -z[0] -y[0] -speed2[0] -release[0] -pos[1] -scale[0] -values[1] ");
}

} // namespace
} // namespace scene
