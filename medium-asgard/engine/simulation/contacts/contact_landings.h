// Which pieces of two bodies may land beside the points at which they touch?
//
// A contact that lasts ends where one of them comes down (physics/contact_rows.h, Landing): then
// the bodies touch otherwise.
#pragma once

#include "contacts/contact_sides.h"
#include "contacts/touch_limits.h"

#include <optional>
#include <vector>

namespace simulation {

struct EdgeCrossing { // of an edge with the border of the other's face
    physics::SurfaceGap gap;
    Ends ofBody, ofSupport; // of the two edges, each in its body's frame
};

// Adds them to a place that has its points, and answers those that are crossings.
[[nodiscard]] std::vector<EdgeCrossing> addLandings(const Touch& touch, const Placed& body,
                                                    const Placed& support,
                                                    const std::optional<MotionPlane>& plane,
                                                    physics::ContactPlace& place);
// In a hollow the other vertices, or ends of a capsule, may land on the wall: also those that touch
// and part.
void addLandingsInHollow(const Touch& touch, const Placed& body, const Placed& support,
                         const TouchLimits& limits, physics::ContactPlace& place);

} // namespace simulation
