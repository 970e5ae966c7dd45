// Boxes that land, tip and stand on each other.
#include "answers.h"
#include "case_parts.h"

#include <algorithm>
#include <cmath>

namespace bench::contacts {
namespace {

constexpr double g = standardGravity;

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
    constexpr double slope = 0.3, width = 0.2, height = 1;
    Case scene = withFloor("box tips", slope, 1);
    Body block{.name = "block", .size = {width, height, width}};
    block.at = onSlope(slope, 0, height / 2);
    block.angle = slope;
    scene.bodies = {block};
    scene.times = timesTo(0.5, 5);
    const Place edge = onSlope(slope, -width / 2, 0);
    const double arm = std::hypot(width, height) / 2;
    for (const double angle : tippingAngles(width, height, slope, scene.times))
        scene.right.push_back(
            {{edge[0] - arm * std::sin(angle), edge[1] + arm * std::cos(angle), 0}});
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

std::vector<Case> boxCases(bool few) {
    std::vector<Case> all = {boxOnBox(), boxThatTips()};
    for (const int count : {1, 2, 5, 10, 20, 50, 100, 200})
        if (!few || count == 2)
            all.push_back(stack(count));
    if (!few)
        all.push_back(boxesThatFall());
    return all;
}

} // namespace bench::contacts
