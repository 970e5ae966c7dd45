// Which bodies do drives squeeze, where no forces keep contacts at rest any more?
//
// A press that stands on a body and begins to move down hits nothing: it comes with no speed. The
// solver then finds no forces that keep what holds. Here the accelerations that drives and
// trajectories want just then take the place of a blow's velocities: bodies are crushed where no
// change of the others lets the contacts part (physics/crushing.h; blows: events/crushed.h).
//
// LIMIT: friction is not looked at, nor a drive whose speed begins to change slower than in
// proportion to the time; the sentence of the solver stays there.
#pragma once

#include "run/run.h"

#include <optional>
#include <string>

namespace simulation {

// A clause. `bodies`: those whose contacts are not kept. None: nothing that is driven presses them
// against something else that does not give way.
[[nodiscard]] std::optional<std::string>
squeezedAt(const Problem& problem, const solution::Histories& histories, const ContactLog& contacts,
           const std::vector<std::size_t>& bodies, double time);

} // namespace simulation
