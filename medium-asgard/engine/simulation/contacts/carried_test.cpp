// What a table that is driven carries, and when it lets go.
#include "simulation/testing.h"

#include <algorithm>
#include <cmath>

namespace simulation::testing {
namespace {

// Heights of 0.1 sin(12 t) at equally spaced times, with cubic curves between them: the push of a
// body on it jumps at each of these times, and may be negative for less than a thousandth before.
void shake(SceneBuilder& b, const std::string& body, double spacing, double finish) {
    scene::Trajectory trajectory;
    trajectory.name = "shaking";
    const auto height = [](double t) { return 0.1 * std::sin(12 * t); };
    const auto pieces = static_cast<int>(std::round(finish / spacing));
    for (int i = 0; i < pieces; ++i) {
        const double from = i * spacing, to = (i + 1) * spacing;
        const auto slope = [&](int k) {
            const double before = std::max(k - 1, 0) * spacing;
            const double after = std::min(k + 1, pieces) * spacing;
            return (height(after) - height(before)) / (after - before);
        };
        const double third = spacing / 3;
        const double a = height(from), d = height(to);
        trajectory.curves.push_back({.from = from,
                                     .to = to,
                                     .control = {{0, a, 0},
                                                 {0, a + third * slope(i), 0},
                                                 {0, d - third * slope(i + 1), 0},
                                                 {0, d, 0}}});
    }
    b.scene.trajectories.push_back(trajectory);
    scene::Constraint constraint;
    constraint.body = body;
    constraint.trajectory = trajectory.name;
    b.scene.constraints.push_back(constraint);
}

// Against steps so short that each hit and each parting is seen: the ball falls, and where it would
// be in the table it is on it, and no slower.
TEST(Rest, ABallLeavesAShakingTableWhereItsPushVanishes) {
    constexpr double finish = 1, dt = 2e-6, lies = 0.2;
    for (const bool isBall : {true, false})
        for (const double spacing : {0.05, 0.1}) {
            SceneBuilder b(finish);
            b.box("table", {0, 0, 0}, {2, 0.2, 2});
            shake(b, "table", spacing, finish);
            scene::Body& body = isBall ? b.ball("body", {0, 0.25, 0}, 0.1)
                                       : b.box("body", {0, 0.25, 0}, {0.3, 0.2, 0.3});
            body.restitution = 0;
            b.weight("body");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
            double y = 0.25, v = 0, largest = 0, highest = 0;
            for (int i = 1; i * dt < finish; ++i) {
                v -= g * dt;
                y += v * dt;
                const BodyState table = result.motion->at(0, i * dt);
                const double gap = y - table.position.y() - lies;
                if (gap < 0) {
                    y -= gap;
                    v = std::max(v, table.velocity.y());
                }
                highest = std::max(highest, gap);
                if (i % 250 == 0)
                    largest =
                        std::max(largest, std::abs(result.motion->at(1, i * dt).position.y() - y));
            }
            EXPECT_GT(highest, 0.02);
            EXPECT_LT(largest, 1e-3) << isBall << " " << spacing;
        }
}

// By a force that is linear in its place: pieces of the exact motion, which begin as it does.
TEST(Carried, ASpringLiftsABallOffTheFloorFromRest) {
    for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
        SceneBuilder b(3, accuracy);
        b.floor();
        b.ball("load", {0, 0.1, 0}).restitution = 0;
        b.weight("load");
        b.force("load", "0", "200*(0.5-(load.y-0.1))", "0");
        const Result result = simulate(b.scene);
        ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
        const double middle = 0.5 - g / 200, frequency = std::sqrt(200.0);
        for (double t = 0; t < 0.4; t += 0.01) // before it is back on the floor
            EXPECT_NEAR(result.motion->at(1, t).position.y(),
                        0.1 + middle * (1 - std::cos(frequency * t)), 1e-12)
                << accuracy << ", t = " << t;
    }
}

} // namespace
} // namespace simulation::testing
