// Values and points of a scene that do not change with time.
#pragma once

#include "motion/motion.h"
#include "scene/names.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace render {

using geometry::Vector;

// The value of an expression of numbers, parameters and masses; none: it changes, or is not known.
[[nodiscard]] std::optional<double> constantValue(const scene::Scene& scene,
                                                  const simulation::Motion* motion,
                                                  const std::string& expression);
// For several of one scene: with its names.
[[nodiscard]] std::optional<double> constantValue(const scene::Names& names,
                                                  const scene::Scene& scene,
                                                  const simulation::Motion* motion,
                                                  const std::string& expression);

// A point of the world that a scene gives by numbers, parameters and masses; none: it changes.
[[nodiscard]] std::optional<Vector> standingPoint(const scene::Scene& scene,
                                                  const simulation::Motion* motion,
                                                  const scene::PointEnd& end);

// Those that springs end at.
[[nodiscard]] std::vector<Vector> anchorsOf(const scene::Scene& scene,
                                            const simulation::Motion* motion);

} // namespace render
