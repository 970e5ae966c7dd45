// Bodies that slide, roll, bounce and tip, alone or a few.
#include "case_parts.h"
#include "rods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bench::contacts {
namespace {

constexpr double g = standardGravity;
using Shape = Body::Shape;

Case blockOnSlope(bool slides) {
    const double slope = slides ? 0.3 : 0.5;
    Case scene = withFloor(slides ? "slope slides" : "slope holds", slope, slides ? 0.4 : 0.6);
    Body block{.name = "block", .size = {1, 0.2, 1}};
    block.at = onSlope(slope, 0, 0.1);
    block.angle = slope;
    const double start = slides ? 5 : 0;
    block.velocity = onSlope(slope, start, 0);
    scene.bodies = {block};
    scene.times = timesTo(2, 10);
    const double slowing = g * (std::sin(slope) + scene.friction * std::cos(slope));
    moveAlong(scene, [=](double time) {
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

Case ballThatSlides() {
    constexpr double slope = 0.6, radius = 0.1;
    Case scene = withFloor("ball slides", slope, 0.1);
    scene.bodies = {{.name = "ball",
                     .shape = Shape::ball,
                     .size = {radius, 0, 0},
                     .at = onSlope(slope, 0, radius)}};
    scene.times = timesTo(2, 10);
    const double rate = g * (std::sin(slope) - scene.friction * std::cos(slope));
    moveAlong(scene, [rate](double time) { return -rate * time * time / 2; });
    return scene;
}

Case blockOnCart() {
    Case scene = withFloor("block on cart", 0, 0);
    scene.friction = 0.3;
    constexpr double speed = 4, mass = 1, cartMass = 3;
    scene.bodies = {{.name = "cart", .size = {8, 0.2, 1}, .mass = cartMass, .at = {0, 0.1, 0}},
                    {.name = "block",
                     .size = {0.2, 0.2, 0.2},
                     .mass = mass,
                     .at = {0, 0.3, 0},
                     .velocity = {speed, 0, 0}}};
    scene.times = timesTo(2, 10);
    const double slowing = g * scene.friction, gain = slowing * mass / cartMass;
    const double together = speed / (slowing + gain);
    for (const double time : scene.times) {
        const double t = std::min(time, together), then = gain * together * (time - t);
        scene.right.push_back(centres(scene.bodies));
        scene.right.back()[0][0] += gain * t * t / 2 + then;
        scene.right.back()[1][0] += speed * t - slowing * t * t / 2 + then;
    }
    return scene;
}

// A ball meets the floor, at an instant between steps. Without gravity: the row is of the blow.
Case ballThatBounces(bool sticks) {
    constexpr double radius = 0.1, height = 0.41234, down = 4;
    Case scene = withFloor(sticks ? "bounce sticks" : "bounce slips", 0, 0.2);
    scene.gravity = 0;
    scene.restitution = 0.8;
    const double speed = sticks ? 5 : 1, spin = sticks ? 0 : 50;
    scene.bodies = {{.name = "ball",
                     .shape = Shape::ball,
                     .size = {radius, 0, 0},
                     .at = {0, height + radius, 0},
                     .velocity = {speed, -down, 0},
                     .spin = spin}};
    scene.times = timesTo(0.5, 10);
    const double up = scene.restitution * down, slip = speed + radius * spin;
    // 2/7 of the slip would end it.
    const double after = speed - std::min(2 * slip / 7, scene.friction * (down + up));
    for (const double time : scene.times) {
        const double then = std::max(0.0, time - height / down), t = time - then;
        scene.right.push_back(
            {{speed * t + after * then, radius + height - down * t + up * then, 0}});
    }
    return scene;
}

// Two metres long; its centre and inertia are those of a thin rod.
constexpr double rodLength = 2 * FallingRod::half;
constexpr Place rodMoments{FallingRod::inertia, 1e-3, FallingRod::inertia};

// A box so thin that it tips about an edge as a rod would about its end.
Case rodThatTips(bool back) {
    Case scene = withFloor(back ? "rod slips back" : "rod slips forward", 0, back ? 0.3 : 1);
    constexpr double thin = 0.01; // between the rod and the line from the edge to the centre
    const FallingRod model{.back = scene.friction, .forward = scene.friction};
    const double width = rodLength * std::sin(thin), height = rodLength * std::cos(thin);
    const double angle = model.angle;
    scene.bodies = {{.name = "rod",
                     .size = {width, height, width},
                     .at = {std::sin(angle), std::cos(angle), 0},
                     .angle = -(angle + thin),
                     .moments = rodMoments}};
    scene.times = timesTo(back ? 1.3 : 1.5, 10);
    for (const FallingRod::Pose& pose : model.poses(scene.times))
        scene.right.push_back({{pose.along, std::cos(pose.angle), 0}});
    return scene;
}

Case ladder() {
    constexpr double radius = 0.02, degrees = std::numbers::pi / 180;
    Case scene = withFloor("ladder", 0, 0);
    scene.planes.push_back({.name = "wall", .slope = -std::numbers::pi / 2});
    const FallingRod model{.angle = 20 * degrees, .back = std::numeric_limits<double>::infinity()};
    scene.bodies = {{.name = "ladder",
                     .shape = Shape::capsule,
                     .size = {radius, rodLength, 0},
                     .at = {std::sin(model.angle) + radius, std::cos(model.angle) + radius, 0},
                     .angle = model.angle,
                     .moments = rodMoments}};
    scene.times = timesTo(0.8, 10);
    for (const FallingRod::Pose& pose : model.poses(scene.times))
        scene.right.push_back({{pose.along + radius, std::cos(pose.angle) + radius, 0}});
    return scene;
}

// They stand with friction just over the least, 2 - sqrt(3) between balls and a third of it below.
Case threeBalls() {
    Case scene = withFloor("three balls", 0, 0.09);
    scene.friction = 0.27;
    constexpr double radius = 0.5;
    scene.bodies = {
        {.name = "left", .shape = Shape::ball, .at = {-radius, radius, 0}},
        {.name = "right", .shape = Shape::ball, .at = {radius, radius, 0}},
        {.name = "top", .shape = Shape::ball, .at = {0, radius * (1 + std::numbers::sqrt3), 0}}};
    for (Body& ball : scene.bodies)
        ball.size[0] = radius;
    scene.times = timesTo(1, 4);
    moveAlong(scene, [](double) { return 0; });
    return scene;
}

} // namespace

std::vector<Case> contactCases() {
    return {blockOnSlope(true),
            blockOnSlope(false),
            ballThatRolls(),
            ballThatSlides(),
            blockOnCart(),
            ballThatBounces(true),
            ballThatBounces(false),
            rodThatTips(true),
            rodThatTips(false),
            ladder(),
            threeBalls()};
}

} // namespace bench::contacts
