// When does a ball on a slope go beyond its upper edge and come back?
#pragma once

#include "collision/time_of_impact.h"
#include "contacts/rest.h"

#include <vector>

namespace simulation {

struct BearingFace { // of what stands still, under a ball
    const geometry::Part& part;
    const BodyRecord& record;
    const Footing& footing;
};

struct BodyPath { // of a body
    const solution::Histories& histories;
    std::size_t first; // of its unknowns
};

// When a ball that a face bears is farthest beyond a side of it, where it comes back in the same
// piece of its motion: up a slope, over its upper edge and back. Pieces of integrated motion are
// looked at often enough.
void addTurnsBeyond(const BearingFace& bearing, const BodyPath& path, collision::Interval during,
                    std::vector<double>& times);

} // namespace simulation
