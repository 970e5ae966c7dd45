// The outline of a shape by lines, for the picture of a body that is not there
// yet.
#pragma once

#include "geometry/shape.h"
#include "scene/scene.h"

#include <vector>

namespace gestures {

// Each a line through its points, in the shape's frame. LIMIT: a hull is
// outlined by its box, a plane by a square of it.
[[nodiscard]] std::vector<std::vector<geometry::Vector>>
wireframeOf(const std::vector<scene::Part>& parts);

} // namespace gestures
