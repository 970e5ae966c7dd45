#include "motion/lost_hops.h"

#include <algorithm>

namespace simulation {

void LostHops::add(const LostHop& hop) {
    const auto isHigher = [&](const LostHop& known) {
        return known.body == hop.body && known.height >= hop.height;
    };
    if (hop.height > 0 && std::ranges::none_of(hops_, isHigher))
        hops_.push_back(hop);
}

std::vector<LostHop> LostHops::upTo(double time) const {
    std::vector<LostHop> hops = hops_;
    std::erase_if(hops, [time](const LostHop& hop) { return hop.time > time; });
    return hops;
}

} // namespace simulation
