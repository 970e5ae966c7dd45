// A box that falls into a V of two walls. For tests.
#pragma once

#include "simulation/testing.h"

#include <array>
#include <cmath>

namespace simulation::testing {

struct Fall {
    double width = 1, height = 1, restitution = 0, tilt = 0, beside = 0, above = 0;
    std::array<double, 2> slopes{}; // of the left wall, which falls to the right, and the right one
    std::array<double, 2> lean{};   // the tilt's other components; the plane's integration has none
    double depth = 0.7;
};
inline constexpr double finish = 1.5;
inline constexpr int times = 500; // at which motions are compared

inline Result solved(const Fall& fall, double accuracy) {
    SceneBuilder b(finish, accuracy);
    for (const int side : {-1, 1}) { // the walls meet at the origin
        const double angle = side * fall.slopes[side < 0 ? 0 : 1];
        const Vector up = side * Vector(std::cos(angle), std::sin(angle), 0);
        const Vector out(-std::sin(angle), std::cos(angle), 0);
        scene::Body& wall = b.box(side < 0 ? "left" : "right", 2 * up - out / 2, {6, 1, 6});
        wall.fixed = true;
        wall.initialAttitude = geometry::fromRotationVector({0, 0, angle});
    }
    scene::Body& box =
        b.box("box", {fall.beside, fall.above, 0}, {fall.width, fall.height, fall.depth});
    box.restitution = fall.restitution;
    box.initialAttitude = geometry::fromRotationVector({fall.lean[0], fall.lean[1], fall.tilt});
    b.weight("box");
    return simulate(b.scene);
}

} // namespace simulation::testing
