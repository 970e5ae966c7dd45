// Steps of scales that people read.
#pragma once

#include <algorithm>
#include <cmath>

namespace views {

// The smallest of 1, 2, 5 times a power of ten that is at least x.
[[nodiscard]] inline double roundStep(double x) {
    const double power = std::pow(10, std::floor(std::log10(std::max(x, 1e-12))));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= x)
            return factor * power;
    return 10 * power;
}

} // namespace views
