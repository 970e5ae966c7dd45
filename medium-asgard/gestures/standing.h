// The place on level ground where a new body stands beside the others, inside of none.
//
// LIMIT: a tube, a ring or a bowl counts as if it were full: in a large one there is no room, and a
// new body stands where it is wanted.
#pragma once

#include "gestures/picking.h"
#include "surroundings/grid.h"

#include <optional>

namespace gestures {

// The nearest one by whole steps along the axes of the ground; `wanted` itself where that is free.
// `step`: the least; it is a tenth of the shape's width at least. None: there is no room within a
// few widths.
[[nodiscard]] std::optional<Vector> standingFree(const render::Drawing& drawing,
                                                 const geometry::Shape& shape,
                                                 const geometry::Pose& wanted,
                                                 const render::GroundPlane& ground, double step);

} // namespace gestures
