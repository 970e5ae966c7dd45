// Which pairs can meet within an interval? Sweep and prune over boxes that hold the motion.
#pragma once

#include "collision/moving_shape.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace collision {

// The axis-aligned box that holds the shape at all times from..to.
[[nodiscard]] geometry::Box boundsDuring(const MovingShape& moving, double from, double to);

using Pair = std::pair<std::size_t, std::size_t>; // first < second

struct Candidates {
    std::vector<Pair> pairs; // in order
    std::size_t tests = 0;   // pairs of boxes compared
};

// Pairs of boxes that overlap and for which mayMeet holds (links, groups, fixed bodies).
[[nodiscard]] Candidates
candidatePairs(const std::vector<geometry::Box>& boxes,
               const std::function<bool(std::size_t, std::size_t)>& mayMeet);

} // namespace collision
