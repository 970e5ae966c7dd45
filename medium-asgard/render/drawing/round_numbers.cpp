#include "drawing/round_numbers.h"

#include <cmath>
#include <initializer_list>

namespace render {

double powerBelow(double x) { return std::pow(10, std::floor(std::log10(x) + 1e-12)); }

double roundAbove(double x) {
    const double power = powerBelow(x);
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= x * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

double roundBelow(double x) {
    const double power = powerBelow(x);
    for (const double factor : {5.0, 2.0})
        if (factor * power <= x * (1 + 1e-9))
            return factor * power;
    return power;
}

} // namespace render
