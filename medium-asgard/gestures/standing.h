// The place on level ground where a new body stands beside the others, inside of none.
//
// LIMIT: a tube or a bowl counts as if it were full.
#pragma once

#include "gestures/picking.h"
#include "surroundings/grid.h"

#include <optional>

namespace gestures {

// The nearest one, by whole steps along an axis of the ground; `wanted` itself where that is free.
// None: there is no room near.
[[nodiscard]] std::optional<Vector> standingFree(const render::Drawing& drawing,
                                                 const geometry::Shape& shape,
                                                 const geometry::Pose& wanted,
                                                 const render::GroundPlane& ground, double step);

} // namespace gestures
