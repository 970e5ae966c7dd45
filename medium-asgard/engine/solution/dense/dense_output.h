// The polynomials of a step that has no extension of its own, from what is known at its ends.
#pragma once

#include "dense/correction.h"
#include "dense/polynomial.h"

#include <cstddef>
#include <span>
#include <utility>

namespace solution {

// The ends of a step of length h: values and slopes (per unit of time) at both.
struct StepEnds {
    double h = 0;
    std::span<const double> start, end, startSlope, endSlope;
};

// Between the values: local error h^2.
void lines(std::span<Coefficients> columns, const StepEnds& ends);
// Cubic Hermite: local error h^4.
void cubics(std::span<Coefficients> columns, const StepEnds& ends);
void cubics(std::span<Coefficients> columns, const StepEnds& ends,
            std::span<const std::size_t> places);

// Quintic Hermite for positions, from place, velocity and acceleration at both ends, and its
// derivative for their velocities: local errors h^6 and h^5. Pairs are (x, v).
void quintics(std::span<Coefficients> columns,
              std::span<const std::pair<std::size_t, std::size_t>> pairs, const StepEnds& ends);

// The start of the step before, which makes those polynomials better for nothing.
struct StepBefore {
    double ratio = 0; // its length over the step's; 0: there is none
    std::span<const double> start, startSlope;
};

using Correction = CorrectionOf<double>;
// Differences over much shorter steps magnify what the steps err by; much longer ones say little.
inline constexpr double leastRatio = 0.3, largestRatio = 4;
[[nodiscard]] bool usable(const StepBefore& before);
using CorrectionBasis = CorrectionBasisOf<double>;
[[nodiscard]] CorrectionBasis correctionBasis(double ratio);
[[nodiscard]] Correction quinticCorrection(const Coefficients& place, double before,
                                           double velocity, double acceleration,
                                           const CorrectionBasis& basis);
[[nodiscard]] Correction cubicCorrection(const Coefficients& column, double before, double slope,
                                         const CorrectionBasis& basis);
void addToQuintic(Coefficients& column, const Correction& correction, double ratio);
void addToCubic(Coefficients& column, const Correction& correction, double ratio);
// The velocity's polynomial from its position's; the value at the start stays.
void differentiate(const Coefficients& place, Coefficients& velocity, double h);

// A velocity's polynomial, integrated, is a degree better than the position's own; the difference
// of its end to the step's own end goes on a cubic that is flat at both ends. Pairs are (x, v).
void integratePositions(std::span<Coefficients> columns,
                        std::span<const std::pair<std::size_t, std::size_t>> pairs,
                        const StepEnds& ends);
// By how much, at most, the derivative of such a position is another than its velocity.
[[nodiscard]] double ownEndMoves(const Coefficients& place, const Coefficients& velocity, double h);

} // namespace solution
