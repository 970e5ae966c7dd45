#include "dense/polynomial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace solution {

namespace {

using Bernstein = std::array<double, maximumCoefficients>;

double binomial(std::size_t n, std::size_t k) {
    double result = 1;
    for (std::size_t i = 0; i < k; ++i)
        result = result * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return result;
}

struct BernsteinTable {
    double weight[maximumCoefficients][maximumCoefficients] = {}; // C(j,k) / C(n,k)
};

const BernsteinTable& bernsteinTable(std::size_t degree) {
    static const std::array<BernsteinTable, maximumCoefficients> tables = [] {
        std::array<BernsteinTable, maximumCoefficients> all;
        for (std::size_t n = 0; n <= maximumDegree; ++n)
            for (std::size_t j = 0; j <= n; ++j)
                for (std::size_t k = 0; k <= j; ++k)
                    all[n].weight[j][k] = binomial(j, k) / binomial(n, k);
        return all;
    }();
    return tables[degree];
}

// b_j = sum over k <= j of C(j,k)/C(n,k) a_k, for the polynomial on [0, 1].
Bernstein bernstein(std::span<const double> coefficients) {
    Bernstein result{};
    const BernsteinTable& table = bernsteinTable(coefficients.size() - 1);
    for (std::size_t j = 0; j < coefficients.size(); ++j)
        for (std::size_t k = 0; k <= j; ++k)
            result[j] += table.weight[j][k] * coefficients[k];
    return result;
}

std::span<const double> used(const Coefficients& c, std::size_t count) {
    return std::span<const double>(c).first(count);
}

Coefficients derivativeCoefficients(std::span<const double> coefficients) {
    Coefficients result{};
    for (std::size_t k = 1; k < coefficients.size(); ++k)
        result[k - 1] = static_cast<double>(k) * coefficients[k];
    return result;
}

} // namespace

double evaluateDerivative(std::span<const double> coefficients, double s) {
    double result = 0;
    for (std::size_t k = coefficients.size(); k-- > 1;)
        result = result * s + static_cast<double>(k) * coefficients[k];
    return result;
}

Coefficients reparametrize(std::span<const double> coefficients, double a, double b) {
    Coefficients result{};
    const std::size_t n = coefficients.size();
    std::copy(coefficients.begin(), coefficients.end(), result.begin());
    // Taylor's shift by repeated synthetic division.
    if (a != 0)
        for (std::size_t i = 0; i + 1 < n; ++i)
            for (std::size_t k = n - 1; k-- > i;)
                result[k] += a * result[k + 1];
    double power = 1;
    for (std::size_t k = 1; k < n; ++k)
        result[k] *= (power *= b);
    return result;
}

Interval hull(std::span<const double> coefficients, double from, double to) {
    const std::size_t n = coefficients.size();
    const Coefficients part = reparametrize(coefficients, from, to - from);
    const Bernstein b = bernstein(used(part, n));
    const auto [low, high] = std::minmax_element(b.begin(), b.begin() + static_cast<long>(n));
    // The coefficients and the values read from the whole curve are rounded; the hull is widened by
    // what that can amount to.
    const double reach = std::max(std::abs(from), std::abs(to));
    double magnitude = 0, power = 1;
    for (std::size_t k = 0; k < n; ++k, power *= reach)
        magnitude += std::abs(part[k]) + std::abs(coefficients[k]) * power;
    const double slack = 16 * std::numeric_limits<double>::epsilon() * magnitude;
    return {*low - slack, *high + slack};
}

std::optional<Interval> firstCrossing(std::span<const double> coefficients, int side, double from,
                                      double to, double resolution) {
    std::vector<Interval> open{{from, to}};
    while (!open.empty()) {
        const Interval part = open.back();
        open.pop_back();
        const Coefficients here = reparametrize(coefficients, part.low, part.high - part.low);
        const Bernstein b = bernstein(used(here, coefficients.size()));
        const bool mayCross =
            std::any_of(b.begin(), b.begin() + static_cast<long>(coefficients.size()),
                        [side](double x) { return x * side < 0; });
        if (!mayCross)
            continue;
        if (part.high - part.low <= resolution) {
            if (evaluate(coefficients, part.high) * side < 0)
                return part;
            continue;
        }
        const double middle = part.low + 0.5 * (part.high - part.low);
        open.push_back({middle, part.high});
        open.push_back({part.low, middle});
    }
    return std::nullopt;
}

const std::array<double, maximumCoefficients>& interpolationPoints() {
    static const auto points = [] {
        std::array<double, maximumCoefficients> p{};
        for (std::size_t i = 0; i <= maximumDegree; ++i)
            p[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / maximumDegree);
        p[maximumDegree / 2] = 0.5;
        return p;
    }();
    return points;
}

Coefficients interpolate(std::span<const double> valuesAtPoints) {
    // Newton's divided differences, expanded from the highest.
    const auto& p = interpolationPoints();
    Coefficients difference{};
    std::copy(valuesAtPoints.begin(), valuesAtPoints.end(), difference.begin());
    for (std::size_t level = 1; level <= maximumDegree; ++level)
        for (std::size_t i = maximumDegree; i >= level; --i)
            difference[i] = (difference[i] - difference[i - 1]) / (p[i] - p[i - level]);
    Coefficients result{};
    for (std::size_t i = maximumCoefficients; i-- > 0;) {
        for (std::size_t k = maximumDegree; k > 0; --k)
            result[k] = result[k - 1] - p[i] * result[k];
        result[0] = difference[i] - p[i] * result[0];
    }
    return result;
}

double Piece::value(double t) const { return evaluate(coefficients, (t - origin) / scale); }

double Piece::derivative(double t) const {
    return evaluateDerivative(coefficients, (t - origin) / scale) / scale;
}

double Piece::secondDerivative(double t) const {
    const Coefficients d = derivativeCoefficients(coefficients);
    return evaluateDerivative(used(d, coefficients.size()), (t - origin) / scale) / (scale * scale);
}

Interval Piece::bounds(double from, double to) const {
    return hull(coefficients, (from - origin) / scale, (to - origin) / scale);
}

Interval Piece::derivativeBounds(double from, double to) const {
    const Coefficients d = derivativeCoefficients(coefficients);
    const Interval h =
        hull(used(d, coefficients.size()), (from - origin) / scale, (to - origin) / scale);
    return {h.low / scale, h.high / scale};
}

} // namespace solution
