// How the exact motions are integrated: Gragg's method of order 16, in long double.
#pragma once

#include "integrators.h"

#include <cmath>
#include <vector>

namespace bench::contacts {

using Real = long double;

// gbsStep for a number of unknowns that only the scene knows.
template <class F> void extrapolate(const F& f, Real h, std::vector<Real>& y) {
    constexpr int columns = 8;
    static constexpr auto weights = extrapolationWeights<Real, columns>();
    std::vector<Real> slope0(y.size()), slope(y.size()), before, now(y.size()), sum(y.size(), 0);
    f(y, slope0);
    for (int j = 0; j < columns; ++j) {
        const int substeps = 2 * (j + 1);
        const Real step = h / Real(substeps);
        before = y;
        for (std::size_t i = 0; i < y.size(); ++i)
            now[i] = y[i] + step * slope0[i];
        for (int m = 1; m < substeps; ++m) {
            f(now, slope);
            for (std::size_t i = 0; i < y.size(); ++i) {
                const Real next = before[i] + 2 * step * slope[i];
                before[i] = now[i];
                now[i] = next;
            }
        }
        for (std::size_t i = 0; i < y.size(); ++i)
            sum[i] += weights[static_cast<std::size_t>(j)] * now[i];
    }
    y = sum;
}

// The state at each time, by steps of at most `step`.
template <class F>
std::vector<std::vector<Real>> along(const F& f, std::vector<Real> y, Real step,
                                     const std::vector<double>& times) {
    std::vector<std::vector<Real>> states;
    Real now = 0;
    for (const double time : times) {
        const long steps = std::lround(std::ceil((time - now) / step));
        const Real h = (time - now) / static_cast<Real>(steps);
        for (long i = 0; i < steps; ++i)
            extrapolate(f, h, y);
        now = time;
        states.push_back(y);
    }
    return states;
}

// Goes on by `h`, or only to the instant at which event(y), at first positive, is 0; returns how
// far it went.
template <class F, class E>
Real extrapolateUntil(const F& f, Real h, std::vector<Real>& y, const E& event) {
    const std::vector<Real> begin = y;
    const auto goOn = [&](Real by) {
        y = begin;
        extrapolate(f, by, y);
        return event(y) > 0;
    };
    if (goOn(h))
        return h;
    Real low = 0, high = h;
    for (int round = 0; round < 64; ++round) {
        const Real middle = (low + high) / 2;
        (goOn(middle) ? low : high) = middle;
    }
    goOn(high);
    return high;
}

} // namespace bench::contacts
