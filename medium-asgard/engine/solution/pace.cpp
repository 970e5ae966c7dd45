#include "solution/pace.h"

#include "dense/polynomial.h"
#include "stepping/work_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace solution {

namespace {

// Fewer are soon done: a burst of them may be all there is.
constexpr std::size_t patience = 524'288;

} // namespace

std::size_t EventPaces::rootOf(std::size_t u) const {
    if (u >= parents_.size())
        return u;
    while (parents_[u] != u)
        u = parents_[u] = parents_[parents_[u]];
    return u;
}

std::size_t EventPaces::unite(std::span<const std::size_t> unknowns) {
    const std::size_t last = *std::ranges::max_element(unknowns);
    for (std::size_t u = parents_.size(); u <= last; ++u) {
        parents_.push_back(u);
        islands_.emplace_back();
    }
    const std::size_t root = rootOf(unknowns[0]);
    for (const std::size_t u : unknowns) {
        const std::size_t other = rootOf(u);
        if (other == root)
            continue;
        parents_[other] = root;
        if (islands_[other].events == 0)
            continue;
        const double latest = std::max(islands_[root].last, islands_[other].last);
        const std::size_t atLatest =
            islands_[root].eventsAt(latest) + islands_[other].eventsAt(latest);
        const std::size_t alone = islands_[root].events;
        const Island joined = alone == 0 ? islands_[other] : Island{};
        const std::size_t events = alone + islands_[other].events;
        islands_[root] = joined;
        islands_[root].events = events;
        islands_[root].last = latest;
        islands_[root].atLast = atLatest;
    }
    return root;
}

void EventPaces::join(std::span<const std::size_t> unknowns) { (void)unite(unknowns); }

double EventPaces::hopelessFrom(double time, std::span<const std::size_t> unknowns) const {
    if (unknowns.empty())
        return infinity;
    const std::size_t root = rootOf(unknowns[0]);
    if (root >= islands_.size())
        return infinity;
    const Island& island = islands_[root];
    const std::size_t events = island.events + 1;
    if (events < patience || (events & (events - 1)) != 0 || island.quarter == never)
        return infinity;
    for (const std::size_t u : unknowns) {
        const std::size_t other = rootOf(u);
        if (other != root && other < islands_.size() && islands_[other].events > 0)
            return infinity; // two paces that were not one
    }
    return farthestFinish(events, {.start = start_,
                                   .first = island.quarter,
                                   .second = island.half,
                                   .third = island.third,
                                   .now = time});
}

std::size_t EventPaces::atOnce(double time, std::span<const std::size_t> unknowns) const {
    std::size_t most = unknowns.empty() ? nobody_.eventsAt(time) : 0;
    for (const std::size_t u : unknowns)
        if (const std::size_t root = rootOf(u); root < islands_.size())
            most = std::max(most, islands_[root].eventsAt(time));
    return most;
}

void EventPaces::note(double time, std::span<const std::size_t> unknowns) {
    if (unknowns.empty())
        return nobody_.note(time);
    beyond_ = std::min(beyond_, hopelessFrom(time, unknowns));
    islands_[unite(unknowns)].note(time);
}

void EventPaces::Island::note(double time) {
    atLast = eventsAt(time) + 1;
    last = time;
    const std::size_t n = ++events;
    if ((n & (n - 1)) == 0) {
        quarter = half;
        half = time;
    } else if (n % 3 == 0 && (n / 3 & (n / 3 - 1)) == 0) { // 3/4 of the next power of 2
        third = time;
    }
}

// hopelessFrom() looks at powers of 2.
std::size_t EventPaces::Island::plainAhead() const {
    return std::bit_ceil(std::max(events + 1, patience)) - events - 1;
}

EventPaces::Island* EventPaces::plainIsland(std::span<const std::size_t> unknowns) {
    const std::size_t root = rootOf(unknowns[0]);
    if (root >= islands_.size())
        return nullptr;
    for (const std::size_t u : unknowns.subspan(1))
        if (rootOf(u) != root)
            return nullptr;
    return islands_[root].plainAhead() > 0 ? &islands_[root] : nullptr;
}

std::vector<std::size_t> EventPaces::islandOf(std::size_t unknown) const {
    std::vector<std::size_t> found;
    const std::size_t root = rootOf(unknown);
    for (std::size_t u = 0; u < parents_.size(); ++u)
        if (rootOf(u) == root)
            found.push_back(u);
    return found;
}

} // namespace solution
