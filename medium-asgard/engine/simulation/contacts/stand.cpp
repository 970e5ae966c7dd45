#include "contacts/stand.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace simulation {

std::vector<Stand::Arc> Stand::arcsBeside() const {
    std::vector<std::pair<double, bool>> round; // angles in order, and who carries
    for (std::size_t k = 0; k < carries.size(); ++k)
        round.emplace_back(angles[k], carries[k] != 0);
    std::ranges::sort(round);
    std::vector<Arc> between, beside;
    for (std::size_t k = 0; k < round.size(); ++k) {
        const bool isLast = k + 1 == round.size();
        const auto& [from, carriesFrom] = round[k];
        const auto& [to, carriesTo] = round[isLast ? 0 : k + 1];
        const Arc arc{from, to - from + (isLast ? 2 * std::numbers::pi : 0)};
        if (carriesFrom && carriesTo)
            between.push_back(arc);
        else if (carriesFrom || carriesTo)
            beside.push_back(arc);
    }
    return between.empty() ? beside : between;
}

bool Stand::tipsEarly() const {
    constexpr double shortest = 1e-4;
    const auto count = std::ranges::count_if(carries, [](char one) { return one != 0; });
    if (count == 0 || count > 2)
        return false;
    if (isAcrossBorder)
        return isOnFew;
    return std::ranges::any_of(arcsBeside(), [](const Arc& arc) { return arc.width > shortest; });
}

} // namespace simulation
