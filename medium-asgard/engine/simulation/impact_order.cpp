#include "simulation/impact_order.h"

#include <algorithm>
#include <map>
#include <span>

namespace simulation {
namespace {

using Parents = std::map<std::size_t, std::size_t>;

std::size_t rootOf(Parents& parent, std::size_t body) {
    parent.try_emplace(body, body);
    while (parent[body] != body)
        body = parent[body];
    return body;
}

void orderInstant(std::span<Impact> impacts, const std::function<bool(std::size_t)>& isFixed) {
    Parents parent;
    for (const Impact& impact : impacts) {
        if (isFixed(impact.first) || isFixed(impact.second))
            continue;
        const std::size_t a = rootOf(parent, impact.first), b = rootOf(parent, impact.second);
        parent[std::max(a, b)] = std::min(a, b);
    }
    std::ranges::stable_sort(impacts, {}, [&](const Impact& impact) {
        return rootOf(parent, isFixed(impact.first) ? impact.second : impact.first);
    });
}

} // namespace

void putInOrder(std::vector<Impact>& impacts, const std::function<bool(std::size_t)>& isFixed) {
    if (!std::ranges::is_sorted(impacts, {}, &Impact::time)) // they mostly are
        std::ranges::stable_sort(impacts, {}, &Impact::time);
    for (auto from = impacts.begin(); from != impacts.end();) {
        const auto to = std::find_if(
            from, impacts.end(), [&](const Impact& impact) { return impact.time > from->time; });
        if (to - from > 1)
            orderInstant({from, to}, isFixed);
        from = to;
    }
}

} // namespace simulation
