// The ropes of a scene at a time, as lines: straight from point to point, in arcs around wheels.
//
// A rope that is longer than it measures sags in its longest span, towards the ground; one with
// drums, which wind it, is drawn straight. A rope that measures more than its length is one that
// was released, and is not drawn.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace render {

using geometry::Vector;

struct RopeLine {
    std::size_t rope = 0;        // index into Scene::ropes
    std::vector<Vector> corners; // world
};

// `up`: away from the ground.
[[nodiscard]] std::vector<RopeLine> ropeLinesOf(const scene::Scene& scene,
                                                const simulation::Motion* motion, double time,
                                                const Vector& up);

// The end of a rope at a time: where its last point is, which way its last span leads there, and
// what the rope measures at the start. None of a closed rope, and of one that drums wind.
struct RopeEnd {
    Vector at, direction;
    double measured = 0;
};
[[nodiscard]] std::optional<RopeEnd> ropeEndOf(const scene::Scene& scene,
                                               const simulation::Motion* motion, std::size_t rope,
                                               double time);

// The points of ropes that stand in the world.
[[nodiscard]] std::vector<Vector> ropeAnchorsOf(const scene::Scene& scene);

} // namespace render
