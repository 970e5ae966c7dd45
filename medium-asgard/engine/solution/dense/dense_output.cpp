#include "dense/dense_output.h"

#include "dense/dense_formulas.h"

#include <cmath>

namespace solution {

void lines(std::span<Coefficients> columns, const StepEnds& ends) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        columns[n] = {};
        columns[n][0] = ends.start[n];
        columns[n][1] = ends.end[n] - ends.start[n];
    }
}

namespace {

formulas::Ends<double> endsOf(const StepEnds& ends, std::size_t n) {
    return {ends.start[n], ends.end[n], ends.startSlope[n], ends.endSlope[n]};
}

} // namespace

void cubics(std::span<Coefficients> columns, const StepEnds& ends) {
    for (std::size_t n = 0; n < columns.size(); ++n)
        columns[n] = formulas::cubic(endsOf(ends, n), ends.h);
}

void cubics(std::span<Coefficients> columns, const StepEnds& ends,
            std::span<const std::size_t> places) {
    for (const std::size_t n : places)
        columns[n] = formulas::cubic(endsOf(ends, n), ends.h);
}

void quintics(std::span<Coefficients> columns,
              std::span<const std::pair<std::size_t, std::size_t>> pairs, const StepEnds& ends) {
    for (const auto& [x, v] : pairs) {
        columns[x] = formulas::quintic(ends.start[x], ends.end[x], endsOf(ends, v), ends.h);
        columns[v] = {ends.start[v]};
        differentiate(columns[x], columns[v], ends.h);
    }
}

void differentiate(const Coefficients& place, Coefficients& velocity, double h) {
    formulas::differentiate(place, velocity, h);
}

bool usable(const StepBefore& before) {
    return before.ratio >= leastRatio && before.ratio <= largestRatio;
}

CorrectionBasis correctionBasis(double ratio) { return formulas::correctionBasis(ratio); }

Correction quinticCorrection(const Coefficients& place, double before, double velocity,
                             double acceleration, const CorrectionBasis& basis) {
    return formulas::quinticCorrection(place, before, velocity, acceleration, basis);
}

Correction cubicCorrection(const Coefficients& column, double before, double slope,
                           const CorrectionBasis& basis) {
    return formulas::cubicCorrection(column, before, slope, basis);
}

void addToQuintic(Coefficients& column, const Correction& correction, double ratio) {
    formulas::addToQuintic(column, correction, ratio);
}

void addToCubic(Coefficients& column, const Correction& correction, double ratio) {
    formulas::addToCubic(column, correction, ratio);
}

void integratePositions(std::span<Coefficients> columns,
                        std::span<const std::pair<std::size_t, std::size_t>> pairs,
                        const StepEnds& ends) {
    for (const auto& [x, v] : pairs) {
        Coefficients integral{};
        integral[0] = ends.start[x];
        double sum = ends.start[x];
        for (std::size_t power = 0; power < maximumDegree; ++power) {
            integral[power + 1] = ends.h * columns[v][power] / static_cast<double>(power + 1);
            sum += integral[power + 1];
        }
        const double lack = ends.end[x] - sum;
        integral[2] += 3 * lack;
        integral[3] -= 2 * lack;
        columns[x] = integral;
    }
}

// 6 lack s (1-s) / h, where 3 lack is what was added to the square.
double ownEndMoves(const Coefficients& place, const Coefficients& velocity, double h) {
    return std::abs(place[2] - h * velocity[1] / 2) / (2 * h);
}

} // namespace solution
