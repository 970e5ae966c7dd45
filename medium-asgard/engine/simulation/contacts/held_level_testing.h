// For tests: a body that a trajectory holds in place and that loads and blows are not to turn, and
// motions that go on.
#pragma once

#include "simulation/testing.h"

namespace simulation::testing {

// Its attitude stays as at the start; see SceneBuilder::hold() for its place.
inline void holdLevel(SceneBuilder& b, const std::string& body, double from, double to) {
    scene::Trajectory level;
    level.name = "attitude of " + body;
    level.curves.push_back({.from = from, .to = to, .control = {{0, 0, 0}}});
    b.scene.trajectories.push_back(level);
    scene::Constraint attitude;
    attitude.body = body;
    attitude.trajectory = level.name;
    attitude.held = scene::Held::attitude;
    b.scene.constraints.push_back(attitude);
}

inline void expectNoStops(const Result& result, const scene::Scene& scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        EXPECT_FALSE(result.motion->stop(i)) << result.motion->stop(i)->sentence;
}

} // namespace simulation::testing
