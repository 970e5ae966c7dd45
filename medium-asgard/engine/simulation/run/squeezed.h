// Which bodies do drives squeeze, where no forces keep contacts at rest any more?
//
// A press that stands on a body and begins to move down hits nothing: it comes with no speed. The
// solver then finds no forces that keep what holds, and here the contacts tell who stands between
// whom (blows: events/crushed.h).
#pragma once

#include "run/run.h"

#include <optional>
#include <string>

namespace simulation {

// A clause. `bodies`: those whose contacts are not kept. None: nothing that is driven presses them
// against something else that does not give way.
[[nodiscard]] std::optional<std::string> squeezedAt(const Problem& problem,
                                                    const ContactLog& contacts,
                                                    const std::vector<std::size_t>& bodies,
                                                    double time);

} // namespace simulation
