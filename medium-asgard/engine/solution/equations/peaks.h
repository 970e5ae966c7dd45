// Which expressions can be next to nothing nearly everywhere, and large in one place, and where?
//
// A peak is narrow, but its argument is not: exp(-((t-60)/0.01)^2) is largest where its exponent
// is, and a step that passes over that changes the sign of the exponent's rate. So signs of such
// centres are watched too, in every step, and the rates are asked for where one is 0, and beside
// it, where what is odd about it peaks.
//
// LIMIT: high powers that are built of low ones, by squaring squares, are not seen to peak: a term
// that acts by one for less than a 25th of the time since the start, from its beginning to its end,
// can lie between two watched times.
#pragma once

#include "expression/graph.h"

#include <span>
#include <vector>

namespace solution {

// A peak within a step that is at most so many times as large as at the step's ends is seen by the
// step's stages.
inline constexpr double seenPeak = 16;

// May these expressions be next to nothing nearly everywhere, and large in one place? Sums,
// products, sines, roots and switches, which are watched by themselves, may not; exponentials,
// quotients and other powers may. Denominators that read attitudes alone are their lengths, which
// stay 1. Where the `values` of the constants are given, a quotient whose denominator stays within
// eight times of its least, whatever all other symbols are, may not peak either: 2 - cos(x)^2.
[[nodiscard]] bool canPeak(const expression::Graph& graph,
                           std::span<const expression::Node> outputs,
                           std::span<const expression::Node> constants,
                           std::span<const expression::Node> attitudes,
                           std::span<const double> values = {});

// A symbol that changes in time, and the symbol of its rate; of the time itself, 1.
struct Moving {
    expression::Node symbol, rate;
};

// Where these expressions may peak, however narrow the peak: where the cause of the peak (an
// exponent, a denominator) is least or most, which is where its rate is 0, or is 0 itself (a pole,
// an edge: tanh((x-700)/w)).
struct Peaks {
    struct Cause { // of time, states, inputs and constants
        expression::Node value;
        expression::Node rate; // of what moves it, too
        double ratio; // to which it must change for a peak to hide; 0: it is an exponent, infinite:
                      // only its own 0 counts, not that of its rate
    };
    std::vector<Cause> causes;
    std::vector<expression::Node> heights; // what peaks
    bool arePolynomials = true;            // the causes, of what moves
};
[[nodiscard]] Peaks peaksOf(expression::Graph& graph, std::span<const expression::Node> outputs,
                            std::span<const expression::Node> constants,
                            std::span<const expression::Node> attitudes,
                            std::span<const Moving> moving);

} // namespace solution
