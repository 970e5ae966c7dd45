#include "motion/impacts.h"

#include <algorithm>

namespace simulation {

bool Impacts::isStrictlyOrdered() const {
    return std::ranges::adjacent_find(*all_, [](const Impact& one, const Impact& next) {
               return one.time >= next.time;
           }) == all_->end();
}

void ImpactRecord::add(const Impact& impact, double found) {
    auto place = recorded_.end();
    if (!recorded_.empty() && recorded_.back().impact.time > impact.time)
        place = std::ranges::upper_bound(recorded_, impact.time, {},
                                         [](const Recorded& one) { return one.impact.time; });
    recorded_.insert(place, {impact, found});
}

Impacts ImpactRecord::upTo(double until) const {
    std::vector<Impact> taken;
    taken.reserve(recorded_.size());
    for (const Recorded& recorded : recorded_)
        if (recorded.found <= until) {
            taken.push_back(recorded.impact);
            taken.back().time = std::min(taken.back().time, until);
        }
    return Impacts(std::move(taken));
}

bool ImpactRecord::haveMet(const std::pair<std::size_t, std::size_t>& pair, double since) const {
    return std::ranges::any_of(recorded_, [&](const Recorded& recorded) {
        const Impact& impact = recorded.impact;
        return recorded.found > since && std::pair<std::size_t, std::size_t>(
                                             std::minmax(impact.first, impact.second)) == pair;
    });
}

std::size_t ImpactRecord::bytesBefore(double t) const {
    std::size_t before = recorded_.size();
    if (!recorded_.empty() && recorded_.back().impact.time >= t) {
        const auto after = std::ranges::lower_bound(
            recorded_, t, {}, [](const Recorded& recorded) { return recorded.impact.time; });
        before = static_cast<std::size_t>(after - recorded_.begin());
    }
    return before * (sizeof(Recorded) + sizeof(Impact));
}

} // namespace simulation
