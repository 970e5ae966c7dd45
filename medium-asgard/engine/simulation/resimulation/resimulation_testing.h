// Scenes that are edited in tests, and the motion of an edit beside that of a run from scratch.
#pragma once

#include "resimulation/resimulation.h"
#include "simulation/testing.h"

#include <memory>
#include <string>

namespace simulation::testing {

inline std::shared_ptr<const scene::Scene> shared(const scene::Scene& scene) {
    return std::make_shared<const scene::Scene>(scene);
}

// Balls that fly beside each other, ten apart, each with a drag of its own.
inline SceneBuilder row(int count) {
    SceneBuilder b(2, 1e-4);
    for (int i = 0; i < count; ++i) {
        const std::string name = "ball" + std::to_string(i);
        b.ball(name, {10.0 * i, 0, 0}).initialVelocity = {0, 1, 0};
        b.force(name, "0", "-0.3*" + name + ".dy*abs(" + name + ".dy)", "0"); // steps are made
    }
    return b;
}

// The motion of an update, which must be that of simulate().
inline Result updated(Resimulation& kept, const scene::Scene& scene) {
    Result result = kept.update(shared(scene));
    const Result scratch = simulate(scene);
    EXPECT_EQ(result.motion->impacts().size(), scratch.motion->impacts().size());
    EXPECT_EQ(result.motion->errorEstimate(), scratch.motion->errorEstimate());
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        EXPECT_EQ(rows(*result.motion, b), rows(*scratch.motion, b)) << scene.bodies[b].name;
    return result;
}

} // namespace simulation::testing
