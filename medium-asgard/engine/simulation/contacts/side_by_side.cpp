#include "contacts/side_by_side.h"

#include <algorithm>
#include <cmath>

namespace simulation {

namespace {

constexpr double parted = 8; // depths
constexpr solution::AccumulationLaw ofHops{.most = 3000};

bool goesOn(solution::AccumulationMonitor::Verdict verdict) {
    return verdict == solution::AccumulationMonitor::Verdict::goesOn;
}

} // namespace

double SideBySide::depth(const Pair& pair) const {
    const auto found = pairs_.find(pair);
    return found == pairs_.end() ? 0 : found->second.depth;
}

bool SideBySide::sink(const Pair& pair, double deeper, double way, const Now& now) {
    State& state = pairs_[pair];
    state.depth += deeper;
    state.way = way;
    state.push = now.push;
    state.since = now.time;
    return goesOn(state.sinks.add(now.time, ofHops));
}

// A push that has ended meanwhile counts where they have not parted in between: that takes longer.
double SideBySide::speedOfPush(const Pair& pair, const Now& now) const {
    constexpr double longest = 3; // what a constant push takes, by half
    const auto found = pairs_.find(pair);
    if (found == pairs_.end())
        return 0;
    const State& state = found->second;
    const bool isStraight = (now.time - state.since) * -now.rate <= longest * state.way;
    const double push = std::max({now.push, isStraight ? state.push : 0, 0.0});
    return std::sqrt(2 * push * state.way);
}

bool SideBySide::hop(const Pair& pair, double time) {
    const auto found = pairs_.find(pair);
    return found == pairs_.end() || goesOn(found->second.hops.add(time, ofHops));
}

void SideBySide::look(const Pair& pair, double gap) {
    const auto found = pairs_.find(pair);
    if (found != pairs_.end() && gap > parted * found->second.depth)
        pairs_.erase(found);
}

} // namespace simulation
