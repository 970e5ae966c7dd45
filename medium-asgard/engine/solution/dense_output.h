// The polynomials of a step that has no extension of its own, from what is known at its ends.
#pragma once

#include "solution/polynomial.h"

#include <cstddef>
#include <span>
#include <utility>

namespace solution {

// What a step of length h goes through: values and slopes (per unit of time) at both ends.
struct StepEnds {
    double h = 0;
    std::span<const double> start, end, startSlope, endSlope;
};

// Between the values: local error h^2.
void lines(std::span<Coefficients> columns, const StepEnds& ends);
// Cubic Hermite: local error h^4.
void cubics(std::span<Coefficients> columns, const StepEnds& ends);

// A velocity's polynomial, integrated, is a degree better than the position's own; what its end
// lacks to the step's own end goes on a cubic that is flat at both ends. Pairs are (x, v).
void integratePositions(std::span<Coefficients> columns,
                        std::span<const std::pair<std::size_t, std::size_t>> pairs,
                        const StepEnds& ends);

} // namespace solution
