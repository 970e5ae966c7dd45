#include "model/numbering.h"

#include <algorithm>

namespace model {

std::vector<int> Counters::step(const std::string& counter) {
    std::vector<Levels>& scopes = counters_[counter];
    if (scopes.empty())
        scopes.push_back({0});
    Levels& levels = scopes.back();
    ++levels.back();
    const std::size_t first = levels.size() - std::min(levels.size(), deepestLevel);
    const std::vector<int> path(levels.begin() + static_cast<std::ptrdiff_t>(first), levels.end());
    levels.push_back(0);
    return path;
}

void Counters::leaveStep(const std::string& counter) { counters_[counter].back().pop_back(); }
void Counters::restart(const std::string& counter) { counters_[counter].push_back({0}); }

// A counter that nothing counts is none: so equal states are equal, wherever they come from.
void Counters::leaveRestart(const std::string& counter) {
    const auto of = counters_.find(counter);
    of->second.pop_back();
    if (of->second.empty())
        counters_.erase(of);
}

} // namespace model
