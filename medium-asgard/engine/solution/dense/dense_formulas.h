// The formulas of dense_output.h for numbers of any kind: of one step, and of several steps side by
// side (lanes.h), with the same bits.
#pragma once

#include "dense/correction.h"
#include "dense/polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace solution::formulas {

// The root of by what part `third` is less than `first`; 1 where it is not.
inline double decay(double first, double third) {
    return first > third ? std::sqrt(third / first) : 1;
}

template <class Real> using Column = std::array<Real, maximumCoefficients>;

// Values and slopes of one unknown at both ends of a step of length h.
template <class Real> struct Ends { Real start, end, startSlope, endSlope; };

template <class Real> inline Column<Real> cubic(const Ends<Real>& y, const Real& h) {
    const Real rise = y.end - y.start;
    const Real first = h * y.startSlope, last = h * y.endSlope;
    return {y.start, first, 3 * rise - 2 * first - last, first + last - 2 * rise};
}

inline double chosen(bool first, double x, double y) { return first ? x : y; }

// By how much a place rises: by the velocity, where both agree but for rounding of the place, which
// would show in the velocity, divided by h. (Friction watches velocities of 1e-12 of a size in a
// second.)
template <class Real> inline Real riseOf(const Real& start, const Real& end, const Real& bySpeed) {
    using std::abs, std::max;
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    const Real rise = end - start, ulp = rounding * max(abs(start), abs(end));
    return chosen(abs(rise - bySpeed) <= 2 * ulp, bySpeed, rise);
}

// Of a place whose ends are x, with its velocity's.
template <class Real>
inline Column<Real> quintic(const Real& start, const Real& end, const Ends<Real>& v,
                            const Real& h) {
    const Real v0 = h * v.start, v1 = h * v.end;
    const Real a0 = h * h * v.startSlope, a1 = h * h * v.endSlope;
    const Real rise = riseOf(start, end, Real((v0 + v1) / 2 + (a0 - a1) / 12));
    return {start,
            v0,
            a0 / 2,
            10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
            -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
            6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1};
}

template <class Real>
inline void differentiate(const Column<Real>& place, Column<Real>& velocity, const Real& h) {
    const Real inverse = 1 / h;
    for (std::size_t power = 1; power < maximumDegree; ++power)
        velocity[power] = static_cast<double>(power + 1) * place[power + 1] * inverse;
}

template <class Real> inline CorrectionBasisOf<Real> correctionBasis(const Real& r) {
    CorrectionBasisOf<Real> basis{};
    basis.ratio = r;
    basis.reach = 1 + r;
    const Real u = -r * basis.reach, du = 1 + 2 * r, inverse = 1 / u;
    basis.square = inverse * inverse;
    basis.squareSlope = 2 * u * du;
    basis.cube = basis.square * inverse;
    basis.cubeSlope = 3 * u * u * du;
    basis.cubeBend = 6 * u * du * du - 6 * u * u;
    return basis;
}

template <class Real>
inline CorrectionOf<Real> quinticCorrection(const Column<Real>& place, const Real& before,
                                            const Real& velocity, const Real& acceleration,
                                            const CorrectionBasisOf<Real>& basis) {
    using std::abs, std::max, std::min;
    const Real r = basis.ratio, reach = basis.reach;
    Real value = 0, slope = 0, bend = 0; // of the quintic at -r; bend: half the second derivative
    for (std::size_t k = 6; k-- > 0;) {
        bend = bend * -r + slope;
        slope = slope * -r + value;
        value = value * -r + place[k];
    }
    const Real d0 = before - value, d1 = velocity - slope, d2 = acceleration - 2 * bend;
    CorrectionOf<Real> c{};
    c.terms[0] = d0 * basis.cube;
    c.terms[1] = (d1 - basis.cubeSlope * c.terms[0]) * basis.cube;
    c.terms[2] =
        (d2 - basis.cubeBend * c.terms[0] - 2 * basis.cubeSlope * c.terms[1]) * (0.5 * basis.cube);
    constexpr double largest = 1.0 / 64, steepest = 0.0537; // of w in [0, 1]
    const Real first = abs(c.terms[0]), second = abs(c.terms[1]) * reach;
    const Real third = abs(c.terms[2]) * reach * reach;
    const Real falls = decay(first, third);
    const Real left = min(Real(1), 2 * falls) * max(third, falls * second);
    const Real whole = first + second + third;
    c.left = largest * left;
    c.whole = largest * whole;
    c.leftSlope = steepest * left;
    c.wholeSlope = steepest * whole;
    return c;
}

template <class Real>
inline CorrectionOf<Real> cubicCorrection(const Column<Real>& column, const Real& before,
                                          const Real& slopeBefore,
                                          const CorrectionBasisOf<Real>& basis) {
    using std::abs;
    const Real r = basis.ratio, reach = basis.reach;
    const Real value = column[0] - r * (column[1] - r * (column[2] - r * column[3]));
    const Real slope = column[1] - r * (2 * column[2] - 3 * r * column[3]);
    CorrectionOf<Real> c{};
    c.terms[0] = (before - value) * basis.square;
    c.terms[1] = (slopeBefore - slope - basis.squareSlope * c.terms[0]) * basis.square;
    constexpr double largest = 1.0 / 16;
    c.left = largest * abs(c.terms[1]) * reach;
    c.whole = largest * abs(c.terms[0]) + c.left;
    return c;
}

template <class Real>
inline void addToQuintic(Column<Real>& column, const CorrectionOf<Real>& correction,
                         const Real& ratio) {
    const auto& c = correction.terms;
    const Real g0 = c[0] + ratio * (c[1] + ratio * c[2]), g1 = c[1] + 2 * ratio * c[2], g2 = c[2];
    column[3] += g0;
    column[4] += g1 - 3 * g0;
    column[5] += g2 - 3 * g1 + 3 * g0;
    column[6] += 3 * g1 - 3 * g2 - g0;
    column[7] += 3 * g2 - g1;
    column[8] -= g2;
}

template <class Real>
inline void addToCubic(Column<Real>& column, const CorrectionOf<Real>& correction,
                       const Real& ratio) {
    const Real g1 = correction.terms[1], g0 = correction.terms[0] + ratio * g1;
    column[2] += g0;
    column[3] += g1 - 2 * g0;
    column[4] += g0 - 2 * g1;
    column[5] += g1;
}

} // namespace solution::formulas
