// Which of the unknowns that stayed 0 does an event wake (equations/zero_states.h)?
#pragma once

#include "solution/network.h"

#include <span>
#include <vector>

namespace solution {

// Those that its jumps move. An impact is computed in three dimensions; what its rounding leaves
// out of the plane moves nothing.
[[nodiscard]] std::vector<std::size_t> roused(const Network& network, double time,
                                              std::span<const Changes::Jump> jumps);
// An equation that gives 0 to what was 0 all the time: a row that ends.
[[nodiscard]] bool sleepsOn(const Network& network, const Changes::Equation& change);
// All that no longer stays 0, since the event moves it or its new equations do; in order.
[[nodiscard]] std::vector<std::size_t> wake(Network& network, const Event& event,
                                            const Changes& changes);

} // namespace solution
