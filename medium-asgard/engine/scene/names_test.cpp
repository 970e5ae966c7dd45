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
    return scene;
}

// [wrong bytes] message | suggestion
std::string diagnosis(const std::string& text, Reading reading = Reading::state) {
    Scene scene = sceneWithNames();
    if (reading == Reading::positions) {
        scene.links.resize(1);
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
        {"rod.x", "[rod.x] no body or trajectory is named \"rod\" | did you mean \"rod1.x\"?"},
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

TEST(Names, WhatMayBeReadDependsOnTheElement) {
    EXPECT_EQ(diagnosis("rod1.px(1, 0, 0) + path.x", Reading::positions), "right");
    EXPECT_EQ(diagnosis("rod1.dx", Reading::positions),
              "[rod1.dx] a link's point may read positions, not velocities");
    EXPECT_EQ(diagnosis("rod1.pdx(0,0,0)", Reading::positions),
              "[rod1.pdx] a link's point may read positions, not velocities");
    EXPECT_EQ(diagnosis("scene.energy + events.collisions", Reading::quantities), "right");
    EXPECT_EQ(
        diagnosis("scene.enrgy", Reading::quantities),
        "[scene.enrgy] there is no quantity \"scene.enrgy\" | did you mean \"scene.energy\"?");
}

TEST(Names, EveryExpressionOfASceneIsChecked) {
    Scene scene = sceneWithNames();
    scene.forces.resize(1);
    scene.forces[0].kind = ComponentForce{{"1+", "0", "bad1"}};
    scene.links.resize(1);
    scene.links[0].second = PointEnd{{"0", "bad2", "0"}};
    scene.views.resize(1);
    scene.views[0].position = std::array<Expression, 3>{"t", "bad3", "0"};
    scene.views[0].scale = Expression("bad4");
    scene.plots.resize(1);
    scene.plots[0].values = {"t", "bad5"};
    std::string found;
    for (const ExpressionFault& fault : checkExpressions(scene))
        found += fault.place.option + '[' + std::to_string(fault.place.index) + "] ";
    EXPECT_EQ(found, "-x[0] -z[0] -y[0] -pos[1] -scale[0] -values[1] ");
}

} // namespace
} // namespace scene
