// The ground of a scene: a discreet grid under everything, and the plane of shadows.
//
// Shadows fall straight down, on the grid's plane or, where a scene has a floor of its own (a
// large level face of something that never moves), on that.
#pragma once

#include "render/extent.h"
#include "render/frame.h"
#include "render/lines.h"
#include "render/solids.h"

#include <optional>

namespace render {

// The plane under everything.
[[nodiscard]] Plane groundOf(const Extent& extent, const Frame& frame);

// The largest level face that never moves, if it is large enough to be a floor.
struct Floor {
    std::size_t solid; // index into the solids given
    Plane plane;
};
[[nodiscard]] std::optional<Floor> floorOf(std::span<const Solid> solids, const Extent& extent,
                                           const Frame& frame, Solids& meshes);

// A grid on the ground, its cell a round length, fading towards its rim.
void addGrid(Lines& lines, const Extent& extent, const Frame& frame, double strength);

} // namespace render
