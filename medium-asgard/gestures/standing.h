// Whether a new body is inside of others, the place on level ground where it stands beside them,
// and where bodies stand whose shape gets another size.
//
// LIMIT: to cylinders, cones and ellipsoids a tube or a bowl counts as if it were full
// (collision/hollow_separation.h): in a large one there is no room, and they stand where they are
// wanted.
#pragma once

#include "editing/value_edit.h"
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

// A shape that is moved level, along `out` or against it, until it touches that body: out of it, or
// back to it. None: not within the reach of both.
[[nodiscard]] std::optional<Vector> touchingBeside(const render::Drawing& drawing,
                                                   const geometry::Shape& shape,
                                                   const geometry::Pose& wanted, std::size_t body,
                                                   const Vector& out);

// A shape there is inside of a body, where these begin, but for that one.
[[nodiscard]] bool isInsideOfOthers(const scene::Scene& scene, const geometry::Shape& shape,
                                    const geometry::Pose& pose, std::size_t but);

// Once a shape set has these parts, a body of that shape stands as it did at the start: on the
// grid, or on a side of another body that looks up, however oblique; and so does what stands on it.
// The places that this takes; none: all may stay. What joints, ropes or paths hold stays.
[[nodiscard]] std::vector<editing::Wish> standingStill(const scene::Scene& scene,
                                                       std::size_t shapeSet,
                                                       const std::vector<scene::Part>& parts);

} // namespace gestures
