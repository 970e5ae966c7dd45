// Is the finish farther away than anybody waits for?
//
// A component with n steps, or events, n a power of two, that needs more than a billion of them at
// the pace of the last quarter, and at that of all, never gets there. Where the last quarters grew
// evenly, they go on growing so. Only the pace counts, not the finish: `beyond` is the earliest
// finish that would have been hopeless, so that one knows of another finish whether it is.
#pragma once

#include <cstddef>

namespace solution {

// When there had been a quarter, a half and three quarters of n steps, and all of them.
struct Quarters {
    double start = 0, first = 0, second = 0, third = 0, now = 0;
};
// The finish beyond which more than a billion would be needed.
[[nodiscard]] double farthestFinish(std::size_t n, const Quarters& quarters);

} // namespace solution
