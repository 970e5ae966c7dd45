// Steps of scales that people read.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace charts {

// The smallest of 1, 2, 5 times a power of ten that is at least x.
[[nodiscard]] inline double roundStep(double x) {
    const double power = std::pow(10, std::floor(std::log10(std::max(x, 1e-300))));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= x)
            return factor * power;
    return 10 * power;
}

// The multiples of a step from one value to another. Counted, and at most a hundred: far from zero
// a step may be less than what numbers tell apart there.
[[nodiscard]] inline std::vector<double> multiplesOf(double step, double from, double to) {
    std::vector<double> all;
    const double first = std::ceil(from / step - 1e-9);
    for (int i = 0; i < 100 && (first + i) * step <= to + 1e-9 * step; ++i)
        all.push_back((first + i) * step);
    return all;
}

// How many digits tell values apart that differ by a step.
[[nodiscard]] inline int digitsFor(double value, double step) {
    constexpr int usual = 6, most = 17;
    if (!(step > 0) || !(std::abs(value) > 0) || !std::isfinite(value / step))
        return usual;
    return std::clamp(1 + static_cast<int>(std::ceil(std::log10(std::abs(value) / step))), usual,
                      most);
}

} // namespace charts
