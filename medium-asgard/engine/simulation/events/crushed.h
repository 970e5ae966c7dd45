// Why no impulses part the bodies of a cluster: those that are pressed between others that go on.
#pragma once

#include "events/impact_cluster.h"

#include <span>
#include <string>

namespace simulation {

// A clause; "": they have room (physics/crushing.h), and there must be another reason.
[[nodiscard]] std::string crushedIn(const Instant& instant, const ImpactCluster& cluster,
                                    std::span<const physics::ImpactBody> before);

} // namespace simulation
