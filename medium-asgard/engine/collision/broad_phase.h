// Where can a moving shape be within an interval? Bodies whose boxes stay apart cannot meet;
// box_tree.h finds those that do not.
#pragma once

#include "collision/moving_shape.h"

#include <cstddef>
#include <utility>

namespace collision {

// The axis-aligned box that holds the shape at all times from..to. One with a half space is
// everywhere: then the box ends at coordinates of `everywhere`.
inline constexpr double everywhere = 1e60;
[[nodiscard]] geometry::Box boundsDuring(const MovingShape& moving, double from, double to);

using Pair = std::pair<std::size_t, std::size_t>; // first < second

} // namespace collision
