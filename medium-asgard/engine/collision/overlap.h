// Do two convex parts share volume? For the warning that a union counts it twice.
#pragma once

#include "geometry/shape.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace collision {

// Pairs of parts that overlap by more than 1e-9 of the smaller one's size; touching is fine.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>>
overlappingParts(const geometry::Shape& shape);

} // namespace collision
