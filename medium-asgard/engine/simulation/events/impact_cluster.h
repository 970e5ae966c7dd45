// All contacts of one instant that are connected by bodies that can give way: one impact.
#pragma once

#include "contacts/in_plane.h"
#include "events/instant.h"
#include "physics/impact.h"

#include <array>
#include <optional>
#include <vector>

namespace simulation {

inline constexpr double landing = 1e-8; // of the parts' size: a corner that touches

struct ImpactCluster {
    std::vector<std::size_t> bodies;              // indices into the scene's
    std::vector<physics::ImpactContact> contacts; // with indices into `bodies`
    // By contact, of its first and its second: the radius of the sphere that touches; 0: a
    // flat part. A sphere's gap follows its centre, whatever its surface does under it.
    std::vector<std::array<double, 2>> radii;
    std::vector<physics::ImpactContact> corners; // of the patches
    std::vector<std::size_t> contactOf;          // by corner
    std::size_t patches = 0;                     // how many numbers of patches are in use
    std::optional<MotionPlane> plane;            // in which all points are
    std::vector<physics::ImpactRow> joints;      // between these bodies

    // Of a contact: the bodies in the scene, in its own order.
    [[nodiscard]] Pair pairOf(const physics::ImpactContact& contact) const {
        return {bodies[contact.first], bodies[contact.second]};
    }
};

// All that touches the two that hit each other or is joined with them, and what touches that.
[[nodiscard]] ImpactCluster clusterAt(const Instant& instant, const Pair& hit);
[[nodiscard]] std::vector<physics::ImpactBody> bodiesOf(const Instant& instant,
                                                        const ImpactCluster& cluster);
// The two have a contact at which they hit each other.
[[nodiscard]] bool touch(const Instant& instant, const Pair& pair);

} // namespace simulation
