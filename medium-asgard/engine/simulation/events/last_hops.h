// Which hops are the last? Where bouncing would end after infinitely many hops, or balls are pushed
// onto each other, the contact gets a plastic impact.
#pragma once

#include "events/impact_cluster.h"
#include "motion/lost_hops.h"

#include <span>
#include <vector>

namespace simulation {

struct LastHops {
    // The longest time in which the hops that were cut off would have ended; negative: none was.
    double settling = -1;
    std::vector<LostHop> lost; // of bodies that can give way
};

// A hop lower than the rest height is the last: its contact gets a plastic impact, and all the hops
// that would have followed are over after 2 u / a (1 - e), where u is the first one's speed and a
// the acceleration that pushes the bodies together. Of a patch that holds of all its corners: an
// edge that rocks hops at its ends, and its middle need not approach at all. If all that hit hop
// for the last time, the contacts at rest beside them take the blow without rebound, too. Where
// something hits higher, none is the last: a blow that passes through them throws what it reaches,
// as through contacts at rest.
[[nodiscard]] LastHops softenLastHops(const Instant& instant, ImpactCluster& cluster,
                                      std::span<const physics::ImpactBody> bodies);

// Balls that go side by side and only hop by their own push move on as one (side_by_side.h). Where
// something hits that comes faster, all is an impact as any other.
void pressTogether(const Instant& instant, ImpactCluster& cluster,
                   std::span<const physics::ImpactBody> bodies);

// The least hop of the two that counts, as a part of a radius.
[[nodiscard]] double hopHeightOf(const Colliders& world, const Pair& pair);
// Hops of this height are no hops, for bodies of this least radius, at this sum of radii and
// distances from the origin.
[[nodiscard]] double lastHopHeight(double hopHeight, double radius, double reach, double slack = 0);

} // namespace simulation
