#include "stepping/memory.h"

#include <algorithm>

namespace solution {

const Memory::Checkpoint& Memory::backTo(double t) {
    while (kept_.size() > 1 && kept_.back().time > t)
        kept_.pop_back();
    return kept_.back();
}

std::size_t Memory::keptBefore(double t) const {
    const auto after = std::ranges::lower_bound(kept_, t, {}, &Checkpoint::time);
    return static_cast<std::size_t>(after - kept_.begin());
}

} // namespace solution
