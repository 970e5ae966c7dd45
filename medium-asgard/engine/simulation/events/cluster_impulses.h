// Which impulses does a cluster get, and which hops of it are the last?
//
// A patch gets one impulse at its centre. Where it then sinks in at a corner, corners take part: of
// plastic contacts from the start, since nothing of them parts at one corner because another was
// hit; what was pushed at a face and rests against it does not turn. Of others after the impulse
// at the centre. The law of impact itself is physics/impact.h.
#pragma once

#include "events/impact_cluster.h"

#include <span>
#include <vector>

namespace simulation {

struct Closing {
    double rate = 0; // of the gap; negative: they approach
    double speeds = 0;
};
[[nodiscard]] Closing closingAt(const physics::ImpactContact& corner,
                                std::span<const physics::ImpactBody> bodies);
[[nodiscard]] bool sinksIn(const physics::ImpactContact& corner,
                           std::span<const physics::ImpactBody> bodies);

// The hit would go on sinking in: as a bar on a held centre that is driven flat against a wall,
// where nothing about it can turn.
[[nodiscard]] bool cannotPart(const Instant& instant, const Pair& pair);

// Of a patch one end of which hits much faster than the other, as where what rattles itself flat
// hits with its ends in turn, the blow is at that end.
void aimAtFastest(ImpactCluster& cluster, std::span<const physics::ImpactBody> bodies);

// The contacts with an impulse are those of the cluster, to which corners may be added.
[[nodiscard]] physics::ImpactResult resolve(ImpactCluster& cluster,
                                            const std::vector<physics::ImpactBody>& before);

} // namespace simulation
