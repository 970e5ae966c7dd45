// A car and a walking machine.
#include "answers.h"
#include "case_parts.h"

#include <cmath>
#include <string>

namespace bench::contacts {
namespace {

constexpr double g = standardGravity;
using Shape = Body::Shape;

Case car() {
    constexpr double slope = 0.2, radius = 0.3, chassis = 10, wheel = 1;
    Case scene = withFloor("car", slope, 1);
    Body body{.name = "chassis", .size = {2, 0.4, 1}, .mass = chassis};
    body.at = onSlope(slope, 0, 0.5);
    body.angle = slope;
    scene.bodies = {body};
    for (const double along : {-0.7, 0.7})
        for (const double across : {-0.6, 0.6}) {
            const int index = static_cast<int>(scene.bodies.size());
            Place at = onSlope(slope, along, radius);
            at[2] = across;
            scene.bodies.push_back({.name = "wheel" + std::to_string(index),
                                    .shape = Shape::ball,
                                    .size = {radius, 0, 0},
                                    .mass = wheel,
                                    .at = at});
            scene.joints.push_back({.body1 = index, .body2 = 0, .at = at});
        }
    scene.times = timesTo(2, 10);
    const double mass = chassis + 4 * wheel;
    const double rate = g * std::sin(slope) * mass / (mass + 4 * 0.4 * wheel);
    moveAlong(scene, [&](double time) { return -rate * time * time / 2; });
    return scene;
}

Case walkingMachine() {
    const Walker model;
    Case scene = withFloor("walking machine", 0, 1);
    const double height = model.leg + model.foot, edge = model.trunk;
    scene.bodies = {{.name = "legs",
                     .shape = Shape::feet,
                     .size = {model.foot, model.leg, model.track},
                     .feet = model.legs,
                     .mass = model.wheelMass,
                     .at = {0, height, 0},
                     .velocity = {-height * model.rate, 0, 0},
                     .spin = model.rate},
                    {.name = "trunk",
                     .size = {edge, edge, edge},
                     .mass = model.trunkMass,
                     .at = {0, height - model.hang, 0},
                     .velocity = {-height * model.rate, 0, 0}}};
    scene.joints = {{.body1 = 1, .body2 = 0, .at = scene.bodies[0].at, .couple = model.couple}};
    scene.times = timesTo(2, 10);
    scene.right = model.places(scene.times);
    return scene;
}

} // namespace

std::vector<Case> machineCases() { return {car(), walkingMachine()}; }

} // namespace bench::contacts
