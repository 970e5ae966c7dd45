// Polynomials of low degree on an interval: the one form in which solved motion is kept.
//
//   value(t) = sum of coefficients[k] s^k,   s = (t - origin) / scale
//
// Whatever method made them, values, derivatives and bounds of an unknown are read from here.
// Bounds come from the Bernstein coefficients of the part asked for, whose hull holds the curve.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace solution {

inline constexpr std::size_t maximumDegree = 8;
inline constexpr std::size_t maximumCoefficients = maximumDegree + 1;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

using Coefficients = std::array<double, maximumCoefficients>; // unused ones are zero

struct Interval {
    double low = 0, high = 0;
};

// As many as a polynomial has, at most maximumCoefficients.
class CoefficientList {
public:
    CoefficientList() : size_(0) {}
    explicit CoefficientList(std::size_t size) : size_(size) {} // to be written
    explicit CoefficientList(std::span<const double> numbers) : size_(numbers.size()) {
        std::copy_n(numbers.begin(), size_, numbers_.begin());
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const double* begin() const { return numbers_.data(); }
    [[nodiscard]] const double* end() const { return numbers_.data() + size_; }
    [[nodiscard]] double operator[](std::size_t power) const { return numbers_[power]; }
    [[nodiscard]] double& operator[](std::size_t power) { return numbers_[power]; }

private:
    std::array<double, maximumCoefficients> numbers_; // those from size_ on have no value
    std::size_t size_;
};

// One polynomial piece of one unknown, valid for origin <= t <= until.
struct Piece {
    double origin = 0, until = infinity, scale = 1;
    CoefficientList coefficients;

    [[nodiscard]] double value(double t) const;
    [[nodiscard]] double derivative(double t) const;
    [[nodiscard]] double secondDerivative(double t) const;
    // Holds every value for from <= t <= to.
    [[nodiscard]] Interval bounds(double from, double to) const;
    // Holds every derivative for from <= t <= to.
    [[nodiscard]] Interval derivativeBounds(double from, double to) const;
};

[[nodiscard]] inline double evaluate(std::span<const double> coefficients, double s) {
    double result = 0;
    for (std::size_t k = coefficients.size(); k-- > 0;)
        result = result * s + coefficients[k];
    return result;
}
[[nodiscard]] double evaluateDerivative(std::span<const double> coefficients, double s);

// The same curve with s = a + b r as a polynomial in r.
[[nodiscard]] Coefficients reparametrize(std::span<const double> coefficients, double a, double b);

[[nodiscard]] Interval hull(std::span<const double> coefficients, double from, double to);

// The first s in (from, to] at which the polynomial has changed to the sign opposite to `side`, in
// the sense of isolating intervals: [low, high] with one change of sign, high - low at most
// `resolution`. None: it certainly keeps its side, or touches zero without crossing.
[[nodiscard]] std::optional<Interval> firstCrossing(std::span<const double> coefficients, int side,
                                                    double from, double to, double resolution);

// Points and matrix of interpolation of degree 8 on [0, 1]: Chebyshev's extremes, ends included.
[[nodiscard]] const std::array<double, maximumCoefficients>& interpolationPoints();
[[nodiscard]] Coefficients interpolate(std::span<const double> valuesAtPoints);

} // namespace solution
