// Whether a new body is inside of others, and the place on level ground where it stands beside
// them.
//
// LIMIT: to cylinders, cones and ellipsoids a tube or a bowl counts as if it were full
// (collision/hollow_separation.h): in a large one there is no room, and they stand where they are
// wanted.
#pragma once

#include "gestures/picking.h"
#include "surroundings/grid.h"

#include <optional>

namespace gestures {

// The nearest one by whole steps along the axes of the ground; `wanted` itself where that is free.
// `step`: the least; it is a tenth of the shape's width at least. None: there is no room within two
// widths and a half.
[[nodiscard]] std::optional<Vector> standingFree(const render::Drawing& drawing,
                                                 const geometry::Shape& shape,
                                                 const geometry::Pose& wanted,
                                                 const render::GroundPlane& ground, double step);

// A shape there is inside of a body, where these begin, but for that one.
[[nodiscard]] bool isInsideOfOthers(const scene::Scene& scene, const geometry::Shape& shape,
                                    const geometry::Pose& pose, std::size_t but);

} // namespace gestures
