#include "stepping/work_estimate.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr double most = 1e9;

// Of quarters that follow each other; 1: they do not grow evenly.
double growthOf(double a, double b, double c) {
    constexpr double least = 1e-3, alike = 2, fast = 0.25;
    const double early = b / a - 1, late = c / b - 1;
    if (late > fast)
        return 1 + late;
    if (!(early > least && late > least) || early > alike * late || late > alike * early)
        return 1;
    return 1 + std::min(early, late);
}

} // namespace

double farthestFinish(std::size_t n, const Quarters& quarters) {
    const double last = quarters.now - quarters.third;
    const double growth =
        growthOf(quarters.second - quarters.first, quarters.third - quarters.second, last);
    const double left = 4 * most / static_cast<double>(n); // quarters
    const double ahead = growth > 1
                             ? last * growth * std::expm1(left * std::log(growth)) / (growth - 1)
                             : last * left;
    const double all = most / static_cast<double>(n) * (quarters.now - quarters.start);
    return quarters.now + std::max(ahead, all);
}

} // namespace solution
