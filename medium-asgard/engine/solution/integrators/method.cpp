#include "integrators/method.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// The shortest time in which some unknown changes by its own size. A velocity that starts at rest
// has no size: then by what would move its position by the extent.
double timeScale(const ErrorControl& control, std::span<const double> rates) {
    double shortest = infinity;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const double rate = std::abs(rates[i]);
        if (rate == 0)
            continue;
        if (control.magnitude(i) > 0)
            shortest = std::min(shortest, control.magnitude(i) / rate);
        else if (control.extent() > 0)
            shortest = std::min(shortest, std::sqrt(control.extent() / rate));
    }
    return shortest;
}

} // namespace

// After Hairer, Norsett and Wanner (Solving ODEs I, II.4), with time scales in place of |y|/|f|:
// a hundredth of the time scale of y, then what the change of f over that allows.
double Method::firstStep(double limit) {
    const double scale = timeScale(control_, slope_);
    double h = std::min(scale < infinity ? 0.01 * scale : 1e-3, limit);
    std::vector<double> y(start_), f(start_.size());
    for (int tries = 0; tries < 60; ++tries) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = start_[i] + h * slope_[i];
        if (rates(t_ + h, y, f))
            break;
        h *= 0.25;
    }
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = start_[i] + 0.5 * h * (slope_[i] + f[i]);
    control_.prepare(y, h);
    double change = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double d = std::abs(f[i] - slope_[i]) / h * control_.tolerance() / control_.scale(i);
        change = std::max(change, d); // about |y''| over the size of y
    }
    const double exponent = 1.0 / static_cast<double>(order());
    const double bend = std::sqrt(2 / std::max(change, 1e-30)); // when y'' has moved y by its size
    const double wanted = bend * std::pow(control_.tolerance(), exponent);
    return std::min({std::isfinite(wanted) ? wanted : h, 100 * h, limit});
}

} // namespace solution
