#include "solution/dense_output.h"

#include <algorithm>
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

Coefficients cubic(const StepEnds& ends, std::size_t n) {
    const double rise = ends.end[n] - ends.start[n];
    const double first = ends.h * ends.startSlope[n], last = ends.h * ends.endSlope[n];
    return {ends.start[n], first, 3 * rise - 2 * first - last, first + last - 2 * rise};
}

} // namespace

void cubics(std::span<Coefficients> columns, const StepEnds& ends) {
    for (std::size_t n = 0; n < columns.size(); ++n)
        columns[n] = cubic(ends, n);
}

void cubics(std::span<Coefficients> columns, const StepEnds& ends,
            std::span<const std::size_t> places) {
    for (const std::size_t n : places)
        columns[n] = cubic(ends, n);
}

void quintics(std::span<Coefficients> columns,
              std::span<const std::pair<std::size_t, std::size_t>> pairs, const StepEnds& ends) {
    const double h = ends.h;
    for (const auto& [x, v] : pairs) {
        const double rise = ends.end[x] - ends.start[x];
        const double v0 = h * ends.start[v], v1 = h * ends.end[v];
        const double a0 = h * h * ends.startSlope[v], a1 = h * h * ends.endSlope[v];
        columns[x] = {ends.start[x],
                      v0,
                      a0 / 2,
                      10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                      -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
                      6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1};
        columns[v] = {ends.start[v]};
        differentiate(columns[x], columns[v], h);
    }
}

void differentiate(const Coefficients& place, Coefficients& velocity, double h) {
    const double inverse = 1 / h;
    for (std::size_t power = 1; power < maximumDegree; ++power)
        velocity[power] = static_cast<double>(power + 1) * place[power + 1] * inverse;
}

// Differences over much shorter steps magnify what the steps err by; much longer ones say little.
bool usable(const StepBefore& before) { return before.ratio >= 0.3 && before.ratio <= 4; }

CorrectionBasis::CorrectionBasis(double r) : ratio(r), reach(1 + r) {
    const double u = -r * reach, du = 1 + 2 * r, inverse = 1 / u;
    square = inverse * inverse;
    squareSlope = 2 * u * du;
    cube = square * inverse;
    cubeSlope = 3 * u * u * du;
    cubeBend = 6 * u * du * du - 6 * u * u;
}

Correction quinticCorrection(const Coefficients& place, double before, double velocity,
                             double acceleration, const CorrectionBasis& basis) {
    const double r = basis.ratio, reach = basis.reach;
    double value = 0, slope = 0, bend = 0; // of the quintic at -r; bend: half the second derivative
    for (std::size_t k = 6; k-- > 0;) {
        bend = bend * -r + slope;
        slope = slope * -r + value;
        value = value * -r + place[k];
    }
    const double d0 = before - value, d1 = velocity - slope, d2 = acceleration - 2 * bend;
    Correction c;
    c.terms[0] = d0 * basis.cube;
    c.terms[1] = (d1 - basis.cubeSlope * c.terms[0]) * basis.cube;
    c.terms[2] =
        (d2 - basis.cubeBend * c.terms[0] - 2 * basis.cubeSlope * c.terms[1]) * (0.5 * basis.cube);
    constexpr double largest = 1.0 / 64, steepest = 0.0537; // of w in [0, 1]
    const double first = std::abs(c.terms[0]), second = std::abs(c.terms[1]) * reach;
    const double third = std::abs(c.terms[2]) * reach * reach;
    const double decay = first > third ? std::sqrt(third / first) : 1;
    const double left = std::min(1.0, 2 * decay) * std::max(third, decay * second);
    const double whole = first + second + third;
    c.left = largest * left;
    c.whole = largest * whole;
    c.leftSlope = steepest * left;
    c.wholeSlope = steepest * whole;
    return c;
}

Correction cubicCorrection(const Coefficients& column, double before, double slopeBefore,
                           const CorrectionBasis& basis) {
    const double r = basis.ratio, reach = basis.reach;
    const double value = column[0] - r * (column[1] - r * (column[2] - r * column[3]));
    const double slope = column[1] - r * (2 * column[2] - 3 * r * column[3]);
    Correction c;
    c.terms[0] = (before - value) * basis.square;
    c.terms[1] = (slopeBefore - slope - basis.squareSlope * c.terms[0]) * basis.square;
    constexpr double largest = 1.0 / 16;
    c.left = largest * std::abs(c.terms[1]) * reach;
    c.whole = largest * std::abs(c.terms[0]) + c.left;
    return c;
}

void addToQuintic(Coefficients& column, const Correction& correction, double ratio) {
    const auto& c = correction.terms;
    const double g0 = c[0] + ratio * (c[1] + ratio * c[2]), g1 = c[1] + 2 * ratio * c[2], g2 = c[2];
    column[3] += g0;
    column[4] += g1 - 3 * g0;
    column[5] += g2 - 3 * g1 + 3 * g0;
    column[6] += 3 * g1 - 3 * g2 - g0;
    column[7] += 3 * g2 - g1;
    column[8] -= g2;
}

void addToCubic(Coefficients& column, const Correction& correction, double ratio) {
    const double g1 = correction.terms[1], g0 = correction.terms[0] + ratio * g1;
    column[2] += g0;
    column[3] += g1 - 2 * g0;
    column[4] += g0 - 2 * g1;
    column[5] += g1;
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

} // namespace solution
