#include "oversight/watched_times.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr double leastLength = 1; // of time: limits on steps grow from that of so much
// Of time since the start: before, steps grow from next to nothing, and see what there is.
constexpr double unwatched = 1.0 / 64;
constexpr double firstPart = 1.0 / 16;

} // namespace

// One in the middle half of each cell, by multiples of the golden ratio: what recurs in time cannot
// hide between them. Cells grow by the same ratio.
std::vector<double> WatchedTimes::between(double from, double to) const {
    constexpr double golden = 0.618033988749895;
    const double growth = std::log1p(1 / perTime);
    const double high = to - start_;
    const double low = std::max({from - start_, firstPart * high, unwatched});
    std::vector<double> found;
    if (!(high > low) || !std::isfinite(high))
        return found;
    for (double cell = std::floor(std::log(low) / growth);; ++cell) {
        const double turns = golden * cell;
        const double elapsed = std::exp(growth * (cell + 0.25 + 0.5 * (turns - std::floor(turns))));
        const double t = start_ + elapsed;
        if (!(elapsed < high) || !(t < to))
            return found;
        if (elapsed > low && t > from)
            found.push_back(t);
    }
}

double WatchedTimes::longest(double t) const { return std::max(t - start_, leastLength); }

double WatchedTimes::longestThatSees(double t) const {
    return std::max(t - start_, leastLength) / perTime;
}

} // namespace solution
