#include "simulation/side_by_side.h"

namespace simulation {

namespace {

constexpr double parted = 8; // depths
constexpr std::size_t manyHops = 1000;

} // namespace

double SideBySide::depth(const Pair& pair) const {
    const auto found = pairs_.find(pair);
    return found == pairs_.end() ? 0 : found->second.depth;
}

bool SideBySide::sink(const Pair& pair, double least, double most) {
    double& depth = pairs_[pair].depth;
    depth += least;
    if (depth <= most)
        return true;
    pairs_.erase(pair);
    return false;
}

bool SideBySide::hop(const Pair& pair) {
    const auto found = pairs_.find(pair);
    return found == pairs_.end() || ++found->second.hops < manyHops;
}

void SideBySide::look(const Pair& pair, double gap) {
    const auto found = pairs_.find(pair);
    if (found != pairs_.end() && gap > parted * found->second.depth)
        pairs_.erase(found);
}

} // namespace simulation
