#include "solution/event_islands.h"

#include <algorithm>

namespace solution {

std::size_t EventIslands::islandNumber(std::size_t u) const {
    if (u >= parents_.size())
        return u;
    while (parents_[u] != u)
        u = parents_[u] = parents_[parents_[u]];
    return u;
}

std::size_t EventIslands::unite(std::span<const std::size_t> unknowns) {
    const std::size_t last = *std::ranges::max_element(unknowns);
    for (std::size_t u = parents_.size(); u <= last; ++u) {
        parents_.push_back(u);
        islands_.emplace_back();
    }
    const std::size_t root = islandNumber(unknowns[0]);
    for (const std::size_t u : unknowns) {
        const std::size_t other = islandNumber(u);
        if (other == root)
            continue;
        parents_[other] = root;
        const double latest = std::max(islands_[root].last, islands_[other].last);
        const std::size_t atLatest =
            islands_[root].eventsAt(latest) + islands_[other].eventsAt(latest);
        islands_[root] = {.last = latest, .atLast = atLatest};
    }
    return root;
}

std::size_t EventIslands::atOnce(double time, std::span<const std::size_t> unknowns) const {
    std::size_t most = unknowns.empty() ? nobody_.eventsAt(time) : 0;
    for (const std::size_t u : unknowns)
        if (const std::size_t root = islandNumber(u); root < islands_.size())
            most = std::max(most, islands_[root].eventsAt(time));
    return most;
}

void EventIslands::note(double time, std::span<const std::size_t> unknowns) {
    (unknowns.empty() ? nobody_ : islands_[unite(unknowns)]).note(time);
}

} // namespace solution
