// Why no impulses part the bodies of a cluster: those that are pressed between others that go on.
#pragma once

#include "events/impact_cluster.h"
#include "physics/crushing.h"

#include <optional>
#include <set>
#include <span>
#include <string>

namespace simulation {

struct Crushed {
    std::string sentence;         // a clause
    std::set<std::size_t> bodies; // of the scene, that would be crushed
};
// `found`, which is not empty: among these bodies of the scene and these conditions.
[[nodiscard]] Crushed crushedBy(const scene::Scene& scene,
                                const physics::EquationsOfMotion& equations,
                                const physics::Crushing& found, std::span<const std::size_t> bodies,
                                std::span<const physics::ImpactRow> joints);
// `contacts`: of the bodies of the cluster. None: they have room (physics/crushing.h), where their
// sides slip or grip, and there must be another reason.
[[nodiscard]] std::optional<Crushed> crushedIn(const Instant& instant, const ImpactCluster& cluster,
                                               std::span<const physics::ImpactContact> contacts,
                                               std::span<const physics::ImpactBody> before,
                                               physics::Sides sides);

} // namespace simulation
