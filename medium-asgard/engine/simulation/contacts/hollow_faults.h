// What is not modelled of tubes and bowls: it ends a motion with a sentence.
//
// A ball that is as wide as a hollow touches the hollow's rim along a circle. Cylinders, cones and
// ellipsoids meet the hull of a hollow part, as if a lid lay on the mouth. While two parts are in
// contact no search looks for their next impact: a vertex that lands on the wall is a condition of
// the contact (contact_places.h), and an edge that comes to the rim is not. So the depth of one in
// the other is looked at after each step (WallWatch).
#pragma once

#include "contacts/contact_set.h"
#include "surfaces/placed.h"

namespace simulation {

enum class HollowFault { wideBall, closedMouth };
// Where two bodies touch, or overlap; `tolerance` as for touchesOf().
[[nodiscard]] std::optional<HollowFault> hollowFaultOf(const Placed& first, const Placed& second,
                                                       double tolerance);

class WallWatch {
public:
    explicit WallWatch(const Colliders& world);

    struct Crossing {
        double time = 0;
        Pair bodies;
    };
    using PlacedAt = std::function<Placed(std::size_t body, double time)>;
    // The first time up to `until` at which one of two bodies in contact is in the wall of the
    // other, deeper than what counts as touching. What was looked at is not looked at again.
    [[nodiscard]] std::optional<Crossing> first(const ContactSet& contacts, double until,
                                                const PlacedAt& placedAt);
    // The motion is another from there on.
    void cut(double time) { looked_ = std::min(looked_, time); }

private:
    const Colliders& world_;
    bool hasHollow_ = false;
    double looked_; // up to then
};

} // namespace simulation
