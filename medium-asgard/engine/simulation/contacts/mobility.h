// How does a body give way at a time, and until when?
//
// Trajectories hold a body, or some of its coordinates, for a while: neither blows nor contacts
// change these. Asked at the finish, what holds to the finish holds there, too.
#pragma once

#include "collision/contact.h"
#include "contacts/colliders.h"
#include "contacts/contact_set.h"

#include <map>

namespace simulation {

using ChangedStates = std::map<std::size_t, BodyState>; // of bodies that an impact just changed

class Mobility {
public:
    // Both must outlive this.
    Mobility(const Colliders& world, const ContactSet& contacts, double finish)
        : world_(world), contacts_(contacts), finish_(finish) {}
    // The motion is wanted for longer than before.
    void lengthen(double finish) { finish_ = finish; }

    // The coordinates of a body that impacts and contacts do not change.
    [[nodiscard]] physics::Held heldOf(std::size_t body, double time) const;
    // Blows can change how the body moves: along an axis along which nothing holds it, or by
    // turning it. A ball that is held in place turns by no blow, since all go through its centre.
    [[nodiscard]] bool canGiveWay(std::size_t body, double time) const;
    // Nothing holds its attitude.
    [[nodiscard]] bool turnsFreely(std::size_t body, double time) const {
        return !world_.equations.bodies[body].heldAt(time).attitude;
    }
    // Nothing holds its place: it gives way along all axes.
    [[nodiscard]] bool isFree(std::size_t body, double time) const;
    // When a trajectory next takes hold of the body, bends or lets go, after `time`, infinity:
    // never; and when one last did, the start if none has.
    [[nodiscard]] double nextPhase(std::size_t body, double time) const;
    [[nodiscard]] double lastPhase(std::size_t body, double time) const;
    // Two free elastic balls never come to rest on each other (side_by_side.h).
    [[nodiscard]] bool hopForEver(std::size_t a, std::size_t b, double time) const;
    // A body in contact lies on what it touches to the limits' gap, and no better: of all that it
    // meets. A body that gives way to nothing, as a floor, stands exactly where it is.
    [[nodiscard]] collision::Slack slack(std::size_t a, std::size_t b, double time) const;

    [[nodiscard]] Placed placed(const solution::Histories& histories, std::size_t body, double time,
                                const ChangedStates& changed = {}) const;
    [[nodiscard]] physics::ImpactBody impactBody(std::size_t body, double time,
                                                 const BodyState& state) const;

private:
    const Colliders& world_;
    const ContactSet& contacts_;
    double finish_;
};

} // namespace simulation
