// The instants at which the laws of a motion change, as a list: impacts, contacts that begin, end,
// stick and slip, stops, ropes, brakes and motors, releases (command lines, "simulate --events").
//
// They are read off the motion: its impacts, its ends, and the modes of multipliers, which change
// where the solver located it; switches of expressions off their branches (switch_instants.h).
// A slip that moves surfaces along each other by less than what an open gap is resolved to is none.
// LIMIT: a contact that is no condition (docs/numerics.md, "Rest") is not in the list, and of a
// contact not where its slip turns round.
// LIMIT: in a motion that is put together from parts, contacts with fixed bodies that another part
// shows are missing. No command lists such a motion.
//
// A bouncing that ends in rest has one line for that, and lines of its first 100 impacts; a line
// "omitted" has the number of the others after their names.
#pragma once

#include "motion/computed_motion.h"
#include "scene/connections.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace simulation {

struct ListedInstant {
    double time = 0;
    std::string kind;  // impact, close, open, stick, slip, limit, unlimit, taut, slack, hold, ...
    std::string names; // bodies, then the joint, gear or rope; blanks between
    std::optional<double> impulse = {}; // of an impact
};

// In order of time; one for each pair and kind at one time.
[[nodiscard]] std::vector<ListedInstant> instantsOf(const scene::Scene& scene,
                                                    const Motion& motion);

// The elements that a -release has ended by that time.
[[nodiscard]] scene::Released releasedBy(const scene::Scene& scene, const Motion& motion,
                                         double time);

} // namespace simulation
