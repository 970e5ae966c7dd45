#include "solution/awakening.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// Of a velocity that jumps beside larger ones: as good as none.
constexpr double rounding = 1e-14;

// How fast a jump moves points: comparable between velocities and spins. Infinite: a position.
double magnitude(const Network& network, std::size_t unknown, double value) {
    const expression::Unknown& u = network.set->unknowns[unknown];
    if (u.lengthPerUnit > 0)
        return value == 0 ? 0 : infinity;
    const bool turns = !u.integralOf && !network.options.extents.empty();
    return std::abs(value) * (turns ? network.options.extents[unknown] : 1);
}

} // namespace

std::vector<std::size_t> roused(const Network& network, double time,
                                std::span<const Changes::Jump> jumps) {
    std::vector<std::size_t> roused;
    if (std::ranges::none_of(jumps, [&network](const Changes::Jump& jump) {
            return network.zero.contains(jump.unknown) && jump.value != 0;
        }))
        return roused;
    double largest = 0;
    for (const auto& jump : jumps)
        if (network.set->unknowns[jump.unknown].lengthPerUnit == 0)
            largest = std::max(
                {largest, magnitude(network, jump.unknown, jump.value),
                 magnitude(network, jump.unknown, network.histories.value(jump.unknown, time))});
    for (const auto& jump : jumps)
        if (network.zero.contains(jump.unknown) && jump.value != 0 &&
            !(magnitude(network, jump.unknown, jump.value) <= rounding * largest))
            roused.push_back(jump.unknown);
    return roused;
}

bool sleepsOn(const Network& network, const Changes::Equation& change) {
    const auto& given = change.phase.given;
    const expression::Graph& graph = network.set->graph;
    return network.zero.contains(change.unknown) && given &&
           graph.op(*given) == expression::Op::constant && graph.value(*given) == 0;
}

std::vector<std::size_t> wake(Network& network, const Event& event, const Changes& changes) {
    const std::vector<std::size_t> moved = roused(network, event.time, changes.jumps);
    if (moved.empty() && changes.equations.empty())
        return {};
    std::vector<std::size_t> changed;
    for (const auto& change : changes.equations)
        if (!sleepsOn(network, change))
            changed.push_back(change.unknown);
    std::vector<std::size_t> woken = network.zero.wake(*network.set, event.time, moved, changed);
    std::erase_if(woken, [&network](std::size_t u) { return network.isUnread(u); });
    return woken;
}

} // namespace solution
