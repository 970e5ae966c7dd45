#include "solution/linear_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace solution {

namespace {

constexpr std::size_t degree = 7;
constexpr double checkPoints[] = {0.09, 0.31, 0.6, 0.93};

// Chebyshev's extremes for degree 7 on [0, 1], both ends included.
const std::array<double, degree + 1> interpolationPoint = [] {
    std::array<double, degree + 1> p{};
    for (std::size_t i = 0; i <= degree; ++i)
        p[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / degree);
    p[degree] = 1;
    return p;
}();

// Newton's divided differences, expanded from the highest.
Coefficients through(const std::array<double, degree + 1>& values) {
    const auto& p = interpolationPoint;
    std::array<double, degree + 1> difference = values;
    for (std::size_t level = 1; level <= degree; ++level)
        for (std::size_t i = degree; i >= level; --i)
            difference[i] = (difference[i] - difference[i - 1]) / (p[i] - p[i - level]);
    Coefficients result{};
    for (std::size_t i = degree + 1; i-- > 0;) {
        for (std::size_t k = degree; k > 0; --k)
            result[k] = result[k - 1] - p[i] * result[k];
        result[0] = difference[i] - p[i] * result[0];
    }
    return result;
}

} // namespace

// The first length comes from the spectral radius, by the growth of A's powers.
LinearMotion::LinearMotion(const LinearForm& form) : until_(form.until) {
    const auto columns = static_cast<Eigen::Index>(
        std::llround(0.5 * (1 + std::sqrt(1 + 4 * static_cast<double>(form.matrix.size())))));
    m_ = Matrix::Zero(columns, columns);
    for (Eigen::Index row = 0; row + 1 < columns; ++row)
        for (Eigen::Index column = 0; column < columns; ++column)
            m_(row, column) = form.matrix[static_cast<std::size_t>(row * columns + column)];
    largest_ = Vector::Zero(columns);
    constexpr double shortEnough = 0.25;
    Matrix power = m_.topLeftCorner(columns - 1, columns - 1);
    double logarithm = 0; // of what was divided out of the power
    for (int doubling = 1; doubling <= 4; ++doubling) {
        const double size = power.norm();
        if (!(size > 0) || !std::isfinite(size))
            return;
        power /= size;
        logarithm = 2 * (logarithm + std::log(size));
        power = (power * power).eval();
    }
    const double size = power.norm();
    if (size > 0)
        base_ = shortEnough / std::exp((logarithm + std::log(size)) / 16);
}

double LinearMotion::lengthOf(int level) const { return std::ldexp(base_, level); }

LinearMotion::Matrix LinearMotion::exponential(double h) const {
    constexpr int terms = 14;
    const double size = (m_ * h).cwiseAbs().rowwise().sum().maxCoeff();
    const int halvings = size > 0.25 ? static_cast<int>(std::ceil(std::log2(size / 0.25))) : 0;
    const Matrix part = m_ * std::ldexp(h, -halvings);
    const Matrix one = Matrix::Identity(m_.rows(), m_.cols());
    Matrix result = one;
    for (int k = terms; k > 0; --k)
        result = one + (part * result).eval() / k;
    for (int k = 0; k < halvings; ++k)
        result = (result * result).eval();
    return result;
}

const LinearMotion::Propagators& LinearMotion::propagators(int level) {
    const auto [place, isNew] = made_.try_emplace(level);
    if (isNew) {
        const double h = lengthOf(level);
        for (std::size_t i = 0; i < points; ++i)
            place->second.to[i] = exponential(interpolationPoint[i] * h);
        for (std::size_t i = 0; i < checks; ++i)
            place->second.check[i] = exponential(checkPoints[i] * h);
    }
    return place->second;
}

bool LinearMotion::fits(const Propagators& propagators, const Vector& start,
                        std::span<Coefficients> columns, Vector& end) {
    constexpr double rounding = 1e-13;
    std::array<Vector, points> at;
    Vector largest = largest_;
    for (std::size_t i = 0; i < points; ++i) {
        at[i] = propagators.to[i] * start;
        largest = largest.cwiseMax(at[i].cwiseAbs());
    }
    for (std::size_t n = 0; n < columns.size(); ++n) {
        std::array<double, points> values{};
        for (std::size_t i = 0; i < points; ++i)
            values[i] = at[i](static_cast<Eigen::Index>(n));
        columns[n] = through(values);
    }
    for (std::size_t i = 0; i < checks; ++i) {
        const Vector exact = propagators.check[i] * start;
        for (std::size_t n = 0; n < columns.size(); ++n) {
            const auto row = static_cast<Eigen::Index>(n);
            const double off = std::abs(evaluate(columns[n], checkPoints[i]) - exact(row));
            if (!(off <= rounding * largest(row)))
                return false;
        }
    }
    end = at[points - 1];
    largest_ = largest;
    return true;
}

double LinearMotion::advance(std::span<double> y, std::span<Coefficients> columns) {
    constexpr int mostPatience = 1024, range = 60, shortest = -6;
    Vector start(m_.rows()), end;
    for (std::size_t i = 0; i < y.size(); ++i)
        start(static_cast<Eigen::Index>(i)) = y[i];
    start(m_.rows() - 1) = 1;
    if (waiting_ > 0)
        --waiting_;
    else if (level_ < range)
        ++level_;
    while (!fits(propagators(level_), start, columns, end)) {
        if (--level_ < shortest)
            return 0;
        waiting_ = patience_;
        patience_ = std::min(2 * patience_, mostPatience);
    }
    for (std::size_t i = 0; i < y.size(); ++i) {
        y[i] = end(static_cast<Eigen::Index>(i));
        columns[i][0] = start(static_cast<Eigen::Index>(i));
    }
    return lengthOf(level_);
}

} // namespace solution
