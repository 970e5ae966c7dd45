// An instant of a motion at which bodies may meet: what they are like there.
#pragma once

#include "contacts/colliders.h"
#include "contacts/contact_set.h"
#include "contacts/mobility.h"
#include "meetings/encounter_search.h"

#include <algorithm>
#include <optional>
#include <span>

namespace simulation {

struct Instant {
    const Colliders& world;
    const ContactSet& contacts;
    const Mobility& mobility;
    const EncounterSearch& search;
    const solution::Histories& histories;
    double time = 0;

    [[nodiscard]] BodyState stateOf(std::size_t body) const {
        return simulation::stateOf(world.records[body], histories, time);
    }
    [[nodiscard]] Acceleration accelerationOf(std::size_t body) const {
        return simulation::accelerationOf(world.records[body], histories, time);
    }
    [[nodiscard]] Placed placed(std::size_t body, const ChangedStates& changed = {}) const {
        return mobility.placed(histories, body, time, changed);
    }
    [[nodiscard]] physics::ImpactBody impactBody(std::size_t body) const;

    // Blows can change how it moves; givesWay() is known at once of what flies.
    [[nodiscard]] bool canGiveWay(std::size_t body) const {
        return mobility.canGiveWay(body, time);
    }
    [[nodiscard]] bool givesWay(std::size_t body) const {
        return search.isFollowed(body) || canGiveWay(body);
    }
    [[nodiscard]] bool areFreeBalls(const Pair& pair) const;
    // When a trajectory next takes hold of one of them, bends or lets go.
    [[nodiscard]] double nextPhase(const Pair& pair) const {
        return std::min(mobility.nextPhase(pair.first, time),
                        mobility.nextPhase(pair.second, time));
    }

    // In which these move, also as a blow has changed them, and nothing drives them out of it.
    [[nodiscard]] std::optional<MotionPlane> planeOf(std::span<const std::size_t> bodies,
                                                     const ChangedStates& changed = {}) const;
    // The speeds that enter.
    [[nodiscard]] double speedOf(const Pair& pair) const;
    // Nearer than this they touch at an impact: it is as far off as coordinates and times are
    // resolved, too.
    [[nodiscard]] double contactTolerance(const Pair& pair) const;
    // The unknowns of those of the two that can give way.
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const Pair& pair) const;

private:
    [[nodiscard]] bool isDrivenAlong(std::size_t body, int axis) const;
    [[nodiscard]] bool sleepsAcross(std::size_t body, int axis) const;
    [[nodiscard]] std::optional<double> placeAlong(std::span<const std::size_t> bodies,
                                                   int axis) const;
    [[nodiscard]] bool isAnyChangedAcross(std::span<const std::size_t> bodies,
                                          const ChangedStates& changed, int axis) const;
};

} // namespace simulation
