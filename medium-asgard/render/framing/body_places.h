// Where bodies are, and how far they reach.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <cstddef>
#include <vector>

namespace render {

using geometry::Vector;

struct Ball {
    Vector center;
    double radius = 0;
};

// The body's parts lie in the hull of these, in its shape's frame.
[[nodiscard]] std::vector<Ball> outlineOf(const scene::Scene& scene, const scene::Body& body);

// Pose of the shape's own frame: from the motion, else where the body starts.
[[nodiscard]] geometry::Pose poseOf(const scene::Scene& scene, const simulation::Motion* motion,
                                    std::size_t body, double time);

} // namespace render
