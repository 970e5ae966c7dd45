// The geometry that a shape set describes: parts turned, then moved, as its author wrote them.
#pragma once

#include "geometry/shape.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <variant>

namespace scene {

// The sentence says why there is none (points in one plane), without a full stop. Of many points it
// takes a while: `meanwhile` is called now and then, and may throw to end it.
[[nodiscard]] std::variant<geometry::Shape, std::string>
shapeOf(const ShapeSet& set, const std::function<void()>& meanwhile = {});

} // namespace scene
