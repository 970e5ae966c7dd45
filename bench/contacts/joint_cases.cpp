// Bodies on joints that touch nothing.
#include "answers.h"
#include "bricard.h"
#include "case_parts.h"
#include "rods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace bench::contacts {
namespace {

Case onJoints(std::string name) {
    Case scene;
    scene.name = std::move(name);
    scene.collide = false;
    return scene;
}

Case rodOnStop() {
    const StoppedRod model;
    Case scene = onJoints("rod on stop");
    scene.restitution = model.rebound;
    scene.bodies = {{.name = "rod",
                     .size = {1, 0.1, 0.1},
                     .at = {0.5, 0, 0},
                     .moments = Place{1e-3, 1.0 / 12, 1.0 / 12}}};
    scene.joints = {{.body1 = 0, .body2 = -1, .least = -std::numbers::pi / 2}};
    scene.times = timesTo(2.5, 10);
    for (const double angle : model.angles(scene.times))
        scene.right.push_back({{std::cos(angle) / 2, std::sin(angle) / 2, 0}});
    return scene;
}

Case sliderCrank(bool held) {
    const SliderCrank model;
    Case scene = onJoints(held ? "slider-crank held" : "slider-crank");
    scene.gravity = 0;
    const SliderCrank::Pose pose = model.pose(model.angle);
    const double t = model.thickness;
    scene.bodies = {{.name = "crank", .size = {model.crank, t, t}, .mass = model.crankMass},
                    {.name = "rod", .size = {model.rod, t, t}, .mass = model.rodMass},
                    {.name = "piston", .size = {0.04, 0.04, 0.04}, .mass = model.pistonMass}};
    for (std::size_t i = 0; i < 3; ++i) {
        scene.bodies[i].at = pose.at[i];
        for (std::size_t a = 0; a < 3; ++a)
            scene.bodies[i].velocity[a] = model.rate * pose.velocity[i][a];
    }
    scene.bodies[0].angle = model.angle;
    scene.bodies[0].spin = model.rate;
    scene.bodies[1].angle = static_cast<double>(pose.rodAngle);
    scene.bodies[1].spin = model.rate * static_cast<double>(pose.rodRate);
    scene.joints = {{.body1 = 0, .body2 = -1, .at = {0, 0, 0}},
                    {.body1 = 1, .body2 = 0, .at = {2 * pose.at[0][0], 2 * pose.at[0][1], 0}},
                    {.body1 = 2, .body2 = 1, .at = pose.at[2]},
                    {.type = Joint::Type::slider,
                     .body1 = 2,
                     .body2 = -1,
                     .at = pose.at[2],
                     .axis = {1, 0, 0}}};
    if (held)
        scene.joints[0].speed = model.rate;
    scene.times = timesTo(1, 10);
    scene.right = held ? model.placesHeld(scene.times) : model.places(scene.times);
    return scene;
}

Case bricard() {
    Case scene = onJoints("Bricard");
    for (int i = 0; i < 5; ++i) {
        const auto rod = static_cast<std::size_t>(i);
        scene.bodies.push_back({.name = std::string(1, static_cast<char>('a' + i)),
                                .size = Bricard::edges(rod),
                                .at = Bricard::centre(rod)});
        scene.joints.push_back(
            {.body1 = i, .body2 = i - 1, .at = Bricard::hinges[rod], .axis = Bricard::axes[rod]});
    }
    scene.joints.push_back(
        {.body1 = 4, .body2 = -1, .at = Bricard::hinges[5], .axis = Bricard::axes[5]});
    scene.times = timesTo(5, 10);
    scene.right = Bricard::places(scene.times);
    return scene;
}

// A disc on a wire that turns it back, and a dry couple that brakes it: half swings about
// +-couple/stiffness, each 2 couple/stiffness shorter. The wire is beside the centre, so that the
// centre moves; without gravity that changes nothing.
Case torsionPendulum() {
    constexpr double stiffness = 4, couple = 0.5, start = 2.1, arm = 0.5, inertia = 1;
    constexpr double around = inertia - arm * arm; // of mass 1, about the centre
    Case scene = onJoints("torsion pendulum");
    scene.gravity = 0;
    scene.bodies = {{.name = "plate",
                     .size = {1.5, 1.5, 0.1},
                     .at = {arm, 0, 0},
                     .moments = Place{around, around, around}}};
    scene.joints = {
        {.body1 = 0, .body2 = -1, .stiffness = stiffness, .rest = -start, .dryCouple = couple}};
    scene.times = timesTo(14, 20);
    constexpr double lag = couple / stiffness, half = std::numbers::pi / 2; // s, of a half swing
    for (const double time : scene.times) {
        const int swing = std::min(7, static_cast<int>(time / half));
        const double since = std::min(time - swing * half, half);
        const double size = start - lag - 2 * lag * swing, way = swing % 2 == 0 ? 1 : -1;
        const double angle = way * (lag + size * std::cos(2 * since)) - start;
        scene.right.push_back({{arm * std::cos(angle), arm * std::sin(angle), 0}});
    }
    return scene;
}

Case chain(int count) {
    Case scene = onJoints("chain " + std::to_string(count));
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(
            {.name = "r" + std::to_string(i), .size = {1, 0.1, 0.1}, .at = {i + 0.5, 0, 0}});
        scene.joints.push_back({.body1 = i, .body2 = i - 1, .at = {static_cast<double>(i), 0, 0}});
    }
    scene.times = timesTo(1, 4);
    scene.right = chainPlaces(count, scene.times);
    return scene;
}

} // namespace

std::vector<Case> jointCases() {
    return {rodOnStop(), sliderCrank(true), bricard(), torsionPendulum(), sliderCrank(false)};
}

std::vector<Case> chainCases(bool few) {
    std::vector<Case> all;
    for (const int count : {2, 5, 20, 50, 200})
        if (!few || count == 2)
            all.push_back(chain(count));
    return all;
}

} // namespace bench::contacts
