#include "motion/impact_order.h"

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

void putInOrder(Impacts& impacts, const std::function<bool(std::size_t)>& isFixed) {
    if (impacts.isStrictlyOrdered()) // they mostly are
        return;
    std::vector<Impact> list = impacts.all();
    std::ranges::stable_sort(list, {}, &Impact::time);
    for (auto from = list.begin(); from != list.end();) {
        const auto to = std::find_if(
            from, list.end(), [&](const Impact& impact) { return impact.time > from->time; });
        if (to - from > 1)
            orderInstant({from, to}, isFixed);
        from = to;
    }
    impacts = Impacts(std::move(list));
}

} // namespace simulation
