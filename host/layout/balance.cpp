#include "layout/balance.h"

#include <algorithm>
#include <limits>

namespace layout {

std::size_t secondPage(const std::vector<Portion>& portions, bool goesOn, double pageHeight) {
    const std::size_t count = portions.size();
    std::vector<double> least(count + 1, 0); // of all from there on
    std::vector<std::size_t> next(count + 1, count);
    for (std::size_t first = count; first-- > 0;) {
        least[first] = std::numeric_limits<double>::infinity();
        double height = 0;
        for (std::size_t last = first; last < count; ++last) {
            const Portion& one = portions[last];
            if (last > first)
                height += std::max(portions[last - 1].after, one.before);
            height += one.height;
            if (height > pageHeight && last > first)
                break;
            const double empty = std::max(0.0, 1 - height / pageHeight);
            const bool isOpen = goesOn && last + 1 == count;
            const double cost =
                1 + portions[first].cost + (isOpen ? 0 : empty * empty) + least[last + 1];
            if (cost <= least[first]) { // of two alike the fuller page
                least[first] = cost;
                next[first] = last + 1;
            }
        }
    }
    return count == 0 ? 0 : next[0];
}

} // namespace layout
