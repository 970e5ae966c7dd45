// Where bodies are, and how far they reach.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace render {

using geometry::Vector;

struct Ball {
    Vector center;
    double radius = 0;
};

// The body's parts lie in the hull of these, in its shape's frame.
[[nodiscard]] std::vector<Ball> outlineOf(const scene::Scene& scene, const scene::Body& body);

// The part is round about its y and shows no turn about it.
[[nodiscard]] bool isRoundAboutY(const scene::Part& part);
// The unit vector along the axis that the whole body is round about, in its shape's frame. None: it
// has no such axis, or is a ball.
[[nodiscard]] std::optional<Vector> axisOf(const scene::Scene& scene, const scene::Body& body);

// Pose of the shape's own frame: from the motion, else where the body starts.
[[nodiscard]] geometry::Pose poseOf(const scene::Scene& scene, const simulation::Motion* motion,
                                    std::size_t body, double time);

} // namespace render
