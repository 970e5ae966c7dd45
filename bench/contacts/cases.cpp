#include "cases.h"

#include "answers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

namespace bench::contacts {
namespace {

constexpr double g = standardGravity;
using Shape = Body::Shape;

std::vector<double> timesTo(double end, int count) {
    std::vector<double> times;
    for (int i = 1; i <= count; ++i)
        times.push_back(end * i / count);
    return times;
}

// `along` metres up the slope, `above` metres over it.
Place onSlope(double slope, double along, double above) {
    return {along * std::cos(slope) - above * std::sin(slope),
            along * std::sin(slope) + above * std::cos(slope), 0};
}

std::vector<Place> centres(const std::vector<Body>& bodies) {
    std::vector<Place> places;
    places.reserve(bodies.size());
    for (const Body& body : bodies)
        places.push_back(body.at);
    return places;
}

Case withFloor(std::string name, double slope, double friction) {
    Case scene;
    scene.name = std::move(name);
    scene.floor = true;
    scene.slope = slope;
    scene.friction = friction;
    return scene;
}

// All bodies move along the slope by the same distance.
void moveAlong(Case& scene, const std::function<double(double)>& distance) {
    for (const double time : scene.times) {
        const Place by = onSlope(scene.slope, distance(time), 0);
        std::vector<Place> places = centres(scene.bodies);
        for (Place& place : places)
            for (std::size_t a = 0; a < 3; ++a)
                place[a] += by[a];
        scene.right.push_back(std::move(places));
    }
}

Case blockOnSlope(bool slides) {
    Case scene = slides ? withFloor("slope slides", 0.3, 0.4) : withFloor("slope holds", 0.5, 0.6);
    Body block{.name = "block", .size = {1, 0.2, 1}};
    block.at = onSlope(scene.slope, 0, 0.1);
    block.angle = scene.slope;
    const double start = slides ? 5 : 0;
    block.velocity = onSlope(scene.slope, start, 0);
    scene.bodies = {block};
    scene.times = timesTo(2, 10);
    const double slowing = g * (std::sin(scene.slope) + scene.friction * std::cos(scene.slope));
    moveAlong(scene, [&](double time) {
        const double t = std::min(time, start / slowing);
        return start * t - slowing * t * t / 2;
    });
    return scene;
}

Case ballThatRolls() {
    Case scene = withFloor("ball rolls", 0, 0.25);
    constexpr double speed = 3;
    scene.bodies = {{.name = "ball",
                     .shape = Shape::ball,
                     .size = {0.1, 0, 0},
                     .at = {0, 0.1, 0},
                     .velocity = {speed, 0, 0}}};
    scene.times = timesTo(1, 10);
    const double slowing = g * scene.friction;
    moveAlong(scene, [&](double time) {
        const double t = std::min(time, 2 * speed / (7 * slowing));
        return speed * t - slowing * t * t / 2 + (speed - slowing * t) * (time - t);
    });
    return scene;
}

Case boxOnBox() {
    Case scene = withFloor("box on box", 0, 0.5);
    constexpr double height = 0.5;
    scene.bodies = {{.name = "lower", .size = {1, 1, 1}, .at = {0, 0.5, 0}},
                    {.name = "upper", .size = {1, 1, 1}, .at = {0, 1.5 + height, 0}}};
    scene.times = timesTo(1, 10);
    for (const double time : scene.times) {
        scene.right.push_back(centres(scene.bodies));
        scene.right.back()[1][1] -= std::min(height, g * time * time / 2);
    }
    return scene;
}

Case stack(int count) {
    Case scene = withFloor("stack " + std::to_string(count), 0, 0.5);
    for (int i = 0; i < count; ++i)
        scene.bodies.push_back(
            {.name = "b" + std::to_string(i), .size = {1, 1, 1}, .at = {0, 0.5 + i, 0}});
    scene.times = timesTo(1, 4);
    moveAlong(scene, [](double) { return 0; });
    return scene;
}

Case boxThatTips() {
    Case scene = withFloor("box tips", 0.3, 1);
    constexpr double width = 0.2, height = 1;
    Body block{.name = "block", .size = {width, height, width}};
    block.at = onSlope(scene.slope, 0, height / 2);
    block.angle = scene.slope;
    scene.bodies = {block};
    scene.times = timesTo(0.5, 5);
    const Place edge = onSlope(scene.slope, -width / 2, 0);
    const double arm = std::hypot(width, height) / 2;
    for (const double angle : tippingAngles(width, height, scene.slope, scene.times))
        scene.right.push_back(
            {{edge[0] - arm * std::sin(angle), edge[1] + arm * std::cos(angle), 0}});
    return scene;
}

Case chain(int count) {
    Case scene;
    scene.name = "chain " + std::to_string(count);
    scene.collide = false;
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(
            {.name = "r" + std::to_string(i), .size = {1, 0.1, 0.1}, .at = {i + 0.5, 0, 0}});
        scene.joints.push_back({.body1 = i, .body2 = i - 1, .at = {static_cast<double>(i), 0, 0}});
    }
    scene.times = timesTo(1, 4);
    scene.right = chainPlaces(count, scene.times);
    return scene;
}

Case sliderCrank() {
    const SliderCrank model;
    Case scene;
    scene.name = "slider-crank";
    scene.collide = false;
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
                    {.type = Joint::Type::slider, .body1 = 2, .body2 = -1, .at = pose.at[2]}};
    scene.times = timesTo(1, 10);
    scene.right = model.places(scene.times);
    return scene;
}

Case car() {
    Case scene = withFloor("car", 0.2, 1);
    constexpr double radius = 0.3, chassis = 10, wheel = 1;
    Body body{.name = "chassis", .size = {2, 0.4, 1}, .mass = chassis};
    body.at = onSlope(scene.slope, 0, 0.5);
    body.angle = scene.slope;
    scene.bodies = {body};
    for (const double along : {-0.7, 0.7})
        for (const double across : {-0.6, 0.6}) {
            const int index = static_cast<int>(scene.bodies.size());
            Place at = onSlope(scene.slope, along, radius);
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
    const double rate = g * std::sin(scene.slope) * mass / (mass + 4 * 0.4 * wheel);
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

// A wall of 100 boxes, each over the gap between two below: all begin to fall at once, a gap above
// each other. What lands stays, since it stands on what has landed before.
Case boxesThatFall() {
    Case scene = withFloor("100 boxes", 0, 0.5);
    constexpr double gap = 0.05, spacing = 1.1;
    for (int row = 0, count = 16; scene.bodies.size() < 100; ++row, --count)
        for (int i = 0; i < count; ++i)
            scene.bodies.push_back(
                {.name = "b" + std::to_string(scene.bodies.size()),
                 .size = {1, 1, 1},
                 .at = {spacing * (i - 0.5 * (count - 1)), 0.5 + row + gap * (row + 1), 0}});
    scene.times = timesTo(1, 10);
    for (const double time : scene.times) {
        scene.right.push_back(centres(scene.bodies));
        for (Place& place : scene.right.back())
            place[1] = std::max(std::floor(place[1]) + 0.5, place[1] - g * time * time / 2);
    }
    return scene;
}

} // namespace

std::vector<Place> Body::balls() const {
    if (shape == Shape::box)
        return {};
    if (shape == Shape::ball)
        return {{0, 0, 0}};
    std::vector<Place> centres;
    for (const double side : {-size[2], size[2]})
        for (int i = 0; i < feet; ++i) { // the first one straight below
            const double angle = (2.0 * i / feet - 0.5) * std::numbers::pi;
            centres.push_back({size[1] * std::cos(angle), size[1] * std::sin(angle), side});
        }
    return centres;
}

Place Body::inertia() const {
    const double ball = 0.4 * size[0] * size[0];
    if (shape == Shape::ball)
        return {mass * ball, mass * ball, mass * ball};
    if (shape == Shape::feet) {
        const double ring = size[1] * size[1], across = size[2] * size[2];
        const double tilting = mass * (ball + ring / 2 + across);
        return {tilting, tilting, mass * (ball + ring)};
    }
    const auto of = [&](double a, double b) { return mass / 12 * (a * a + b * b); };
    return {of(size[1], size[2]), of(size[0], size[2]), of(size[0], size[1])};
}

std::vector<Case> allCases(bool few) {
    std::vector<Case> all = {
        blockOnSlope(false), blockOnSlope(true), ballThatRolls(), boxOnBox(),
        boxThatTips(),       sliderCrank(),      car(),           walkingMachine()};
    for (const int count : {1, 2, 5, 10, 20, 50, 100, 200})
        if (!few || count == 2)
            all.push_back(stack(count));
    if (!few)
        all.push_back(boxesThatFall());
    for (const int count : {2, 5, 20, 50, 200})
        if (!few || count == 2)
            all.push_back(chain(count));
    return all;
}

double worstDistance(const Case& scene, const std::vector<std::vector<Place>>& places) {
    if (places.size() != scene.right.size())
        return std::numeric_limits<double>::quiet_NaN();
    double worst = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            const Place &is = places[i][b], &should = scene.right[i][b];
            const double d = std::hypot(is[0] - should[0], is[1] - should[1], is[2] - should[2]);
            if (!(d <= worst)) // what is not a number stays
                worst = d;
        }
    return worst;
}

} // namespace bench::contacts
