// How far has a component come, and what are its values there?
#pragma once

#include "stepping/options.h"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace solution {

// A step that would end within a hundredth of its length before its limit is stretched to it; one
// of fixed length only over rounding.
[[nodiscard]] inline double landingOf(const Options& options) {
    return options.fixedStep ? 1 + 1e-9 : 1.01;
}

inline constexpr double heldPart = 1e-3; // of the tolerance, that polynomials of held values err by

// Below this a step does not move time by more than rounding.
[[nodiscard]] inline double shortestStep(double t) {
    return 4 * std::numeric_limits<double>::epsilon() * std::abs(t) +
           std::numeric_limits<double>::min();
}

struct Progress {
    double time = 0;
    std::vector<double> values; // of all unknowns at `time`
    std::vector<double> ended;  // of the states, with quaternions normalized at the last step's end
    double proposed = 0;        // length of the next step; 0: not known yet
    bool isStill = false;       // all rates were 0 where it began anew last
    bool isRead = true;         // by other components, which its trembling may move
    // Places of the four parts of quaternions, without parts that stay 0.
    std::vector<std::vector<std::size_t>> quaternions;

    // Of the unknowns at these places.
    [[nodiscard]] std::vector<double> at(std::span<const std::size_t> places) const {
        std::vector<double> y(places.size());
        take(places, y);
        return y;
    }
    void take(std::span<const std::size_t> places, std::vector<double>& y) const {
        y.resize(places.size());
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = values[places[i]];
    }
    void put(std::span<const std::size_t> places, std::span<const double> y) {
        for (std::size_t i = 0; i < y.size(); ++i)
            values[places[i]] = y[i];
    }
    // Quaternions become as long as 1.
    void normalize();
};

} // namespace solution
