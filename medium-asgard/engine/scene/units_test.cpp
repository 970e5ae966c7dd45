// Units of expressions, and the words for what they read.
#include "scene/units.h"

#include <gtest/gtest.h>

namespace scene {
namespace {

Scene measuredScene() {
    Scene scene;
    scene.bodies.emplace_back().name = "b";
    scene.bodies.emplace_back().name = "c";
    scene.trajectories.emplace_back().name = "path";
    scene.parameters.emplace_back().name = "g";
    for (const auto& [name, type] : {std::pair{"pin", JointType::hinge},
                                     {"rail", JointType::slider},
                                     {"tube", JointType::cylindrical}}) {
        scene.joints.emplace_back().name = name;
        scene.joints.back().type = type;
    }
    scene.links.emplace_back().name = "coil";
    scene.links.back().spring.emplace();
    scene.ropes.emplace_back().name = "string";
    scene.contacts.emplace_back().name = "touch";
    return scene;
}

TEST(Units, AnExpressionHasTheUnitThatFollowsFromItsNames) {
    const Scene scene = measuredScene();
    const Units units(scene);
    const std::pair<const char*, const char*> table[] = {
        {"t", "s"},
        {"b.x", "m"},
        {"b.dx", "m/s"},
        {"b.rz", "rad"},
        {"b.wz", "rad/s"},
        {"b.qw", ""},
        {"b.mass", "kg"},
        {"b.ixx", "kg m²"},
        {"b.px(1, 0, 0)", "m"},
        {"b.pdy(1, 0, 0)", "m/s"},
        {"pin.q", "rad"},
        {"pin.dq", "rad/s"},
        {"pin.motor", "N m"},
        {"pin.tz", "N m"},
        {"rail.q", "m"},
        {"rail.motor", "N"},
        {"tube.q1", "rad"},
        {"tube.q2", "m"},
        {"coil.length", "m"},
        {"coil.force", "N"},
        {"string.tension", "N"},
        {"touch.n", "N"},
        {"touch.slip", "m/s"},
        {"touch.state", ""},
        {"scene.energy", "J"},
        {"scene.px", "kg m/s"},
        {"events.collisions", ""},
        // sums, products, functions
        {"b.x - c.x", "m"},
        {"b.x + 1", "m"},
        {"-b.x", "m"},
        {"hypot(b.dx, b.dy, b.dz)", "m/s"},
        {"sqrt(b.x^2 + b.y^2)", "m"},
        {"atan2(b.x - (0), 3 - b.y)", "rad"},
        {"0.5 * b.mass * b.dx^2", "J"},
        {"0.5*(b.mass*hypot(b.dx, b.dy)^2 + b.ixx*b.wz^2)", "J"},
        {"b.ixx*b.wz^2", "J"},
        {"b.wz * b.x + b.dx", "m/s"},
        {"pin.motor * pin.dq", "W"},
        {"coil.force / coil.length", "N/m"},
        {"b.x / b.dx", "s"},
        {"1 / t", "1/s"},
        {"b.x / c.x", ""},
        {"sin(b.rz)", ""},
        {"b.x > 0 ? b.x : 0", "m"},
        {"max(b.x, 0)", "m"},
        // nobody knows
        {"g", ""},
        {"path.x", ""},
        {"b.x + g", ""},
        {"9.81 * b.mass * b.y", ""}, // 9.81 is an acceleration here
        {"100 * b.x", ""},           // centimetres
        {"b.x + b.dx", ""},
        {"sqrt(b.x)", ""},
        {"nobody.x", ""},
        {"b.x +", ""},
        {"3", ""}};
    for (const auto& [expression, unit] : table)
        EXPECT_EQ(units.of(expression), unit) << expression;
}

TEST(Units, ANameHasWords) {
    const Scene scene = measuredScene();
    const Units units(scene);
    const std::pair<const char*, const char*> table[] = {
        {"t", "time"},
        {"b.x", "x of b"},
        {"b.dy", "velocity along y of b"},
        {"b.wz", "angular velocity about z of b"},
        {"b.rz", "angle about z of b"},
        {"b.mass", "mass of b"},
        {"pin.q", "angle of pin"},
        {"rail.q", "distance of rail"},
        {"tube.dq2", "rate of the distance 2 of tube"},
        {"pin.fx", "force along x of pin"},
        {"coil.length", "length of coil"},
        {"touch.n", "normal force of touch"},
        {"touch.fx", "force along x of touch"},
        {"path.dx", "dx of path"},
        {"scene.energy", "energy"},
        {"events.collisions", "collisions"},
        {"g", ""},
        {"b.x + 1", ""},
        {"nobody.x", ""}};
    for (const auto& [expression, words] : table)
        EXPECT_EQ(units.wordsOf(expression), words) << expression;
}

} // namespace
} // namespace scene
