#include "exact/linear_motion.h"

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

// [level][i]: 1 / (p[i] - p[i - level])
const auto inverseSpan = [] {
    std::array<std::array<double, degree + 1>, degree + 1> inverse{};
    for (std::size_t level = 1; level <= degree; ++level)
        for (std::size_t i = level; i <= degree; ++i)
            inverse[level][i] = 1 / (interpolationPoint[i] - interpolationPoint[i - level]);
    return inverse;
}();

// Newton's divided differences, expanded from the highest.
Coefficients through(const std::array<double, degree + 1>& values) {
    const auto& p = interpolationPoint;
    std::array<double, degree + 1> difference = values;
    for (std::size_t level = 1; level <= degree; ++level)
        for (std::size_t i = degree; i >= level; --i)
            difference[i] = (difference[i] - difference[i - 1]) * inverseSpan[level][i];
    Coefficients result{};
    for (std::size_t i = degree + 1; i-- > 0;) {
        for (std::size_t k = degree; k > 0; --k)
            result[k] = result[k - 1] - p[i] * result[k];
        result[0] = difference[i] - p[i] * result[0];
    }
    return result;
}

// (1 + F)^2 = 1 + 2F + F^2
constexpr auto doubled = [](auto& less1) { less1 = (2 * less1 + less1.lazyProduct(less1)).eval(); };

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
    for (Eigen::Index row = 0; row + 1 < columns; ++row)
        for (Eigen::Index column = 0; column + 1 < columns; ++column)
            if (column != row && m_(row, column) == 1 && m_.row(row).cwiseAbs().sum() == 1)
                rates_.emplace_back(row, column);
    balance();
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

// The last row is 0: the constant 1 keeps its unit.
void LinearMotion::balance() {
    constexpr int rounds = 20;
    unit_ = Vector::Ones(m_.rows());
    bool changes = true;
    for (int round = 0; round < rounds && changes; ++round) {
        changes = false;
        for (Eigen::Index i = 0; i + 1 < m_.rows(); ++i) {
            const double column = m_.col(i).cwiseAbs().sum() - std::abs(m_(i, i));
            const double row = m_.row(i).cwiseAbs().sum() - std::abs(m_(i, i));
            if (!(column > 0 && row > 0) || !std::isfinite(column) || !std::isfinite(row))
                continue;
            const int power = static_cast<int>(std::lround(0.5 * std::log2(row / column)));
            if (power == 0)
                continue;
            changes = true;
            const double unit = std::ldexp(1, power);
            unit_(i) *= unit;
            m_.col(i) *= unit;
            m_.row(i) /= unit;
        }
    }
}

LinearMotion::Precise LinearMotion::exponentials(double h) const {
    constexpr std::size_t terms = 14;
    const double size = (m_ * h).cwiseAbs().rowwise().sum().maxCoeff();
    const int halvings = size > 0.25 ? static_cast<int>(std::ceil(std::log2(size / 0.25))) : 0;
    const PreciseMatrix part = m_.cast<long double>() * std::ldexp(h, -halvings);
    std::array<PreciseMatrix, terms + 1> power; // over the factorial; the first is 1
    power[1] = part;
    for (std::size_t k = 2; k <= terms; ++k)
        power[k] = part.lazyProduct(power[k - 1]) / static_cast<long double>(k);
    const auto at = [&](double point) {
        PreciseMatrix result = power[terms] * point;
        for (std::size_t k = terms; k-- > 1;)
            result = (result + power[k]) * point;
        for (int k = 0; k < halvings; ++k)
            doubled(result);
        return result;
    };
    Precise all;
    std::ranges::transform(interpolationPoint, all.begin(), at);
    std::ranges::transform(checkPoints, all.begin() + points, at);
    return all;
}

const LinearMotion::Propagators& LinearMotion::propagators(int level) {
    if (const auto known = made_.find(level); known != made_.end())
        return known->second;
    if (level < 0)
        return made_.emplace(level, rounded(exponentials(lengthOf(level)))).first->second;
    if (preciseLevel_ < 0 || preciseLevel_ > level) {
        precise_ = exponentials(lengthOf(0));
        preciseLevel_ = 0;
    }
    for (; preciseLevel_ < level; ++preciseLevel_)
        std::ranges::for_each(precise_, doubled);
    return made_.emplace(level, rounded(precise_)).first->second;
}

LinearMotion::Propagators LinearMotion::rounded(const Precise& precise) {
    Propagators result;
    for (std::size_t i = 0; i < points; ++i)
        result.to[i] = precise[i].cast<double>();
    for (std::size_t i = 0; i < checks; ++i)
        result.check[i] = precise[points + i].cast<double>();
    return result;
}

// By what vanishes at both ends.
void LinearMotion::beginAtRates(double h, const Vector& start,
                                std::span<Coefficients> columns) const {
    for (const auto& [place, rate] : rates_) {
        Coefficients& column = columns[static_cast<std::size_t>(place)];
        const double exact = h * m_(place, rate) * start(rate);
        column[2] += column[1] - exact;
        column[1] = exact;
    }
}

double LinearMotion::misfit(int level, const Vector& start, std::span<Coefficients> columns,
                            Vector& end) {
    constexpr double rounding = 1e-13;
    const Propagators& propagators = this->propagators(level);
    std::array<Vector, points> at;
    Vector largest = largest_;
    for (std::size_t i = 0; i < points; ++i) {
        at[i] = start + propagators.to[i].lazyProduct(start);
        largest = largest.cwiseMax(at[i].cwiseAbs());
    }
    for (std::size_t n = 0; n < columns.size(); ++n) {
        std::array<double, points> values{};
        for (std::size_t i = 0; i < points; ++i)
            values[i] = at[i](static_cast<Eigen::Index>(n));
        columns[n] = through(values);
    }
    beginAtRates(lengthOf(level), start, columns);
    double worst = 0;
    for (std::size_t i = 0; i < checks; ++i) {
        const Vector exact = start + propagators.check[i].lazyProduct(start);
        for (std::size_t n = 0; n < columns.size(); ++n) {
            const auto row = static_cast<Eigen::Index>(n);
            const double off = std::abs(evaluate(columns[n], checkPoints[i]) - exact(row));
            const double allowed = rounding * largest(row);
            if (!(off <= allowed))
                return infinity;
            if (off > 0)
                worst = std::max(worst, off / allowed);
        }
    }
    end = at[points - 1];
    largest_ = largest;
    return worst;
}

double LinearMotion::advance(std::span<double> y, std::span<Coefficients> columns) {
    constexpr int mostPatience = 1024, range = 60, shortest = -6;
    Vector start(m_.rows()), end;
    for (std::size_t i = 0; i < y.size(); ++i)
        start(static_cast<Eigen::Index>(i)) = y[i] / unit_(static_cast<Eigen::Index>(i));
    start(m_.rows() - 1) = 1;
    constexpr double twiceAsLong = 400; // the misfit of it, a little over 2^8
    waiting_ = std::max(waiting_ - 1, 0);
    if (level_ < range && (waiting_ == 0 || twiceAsLong * misfit_ < 1))
        ++level_;
    while ((misfit_ = misfit(level_, start, columns, end)) == infinity) {
        if (--level_ < shortest)
            return 0;
        waiting_ = patience_;
        patience_ = std::min(2 * patience_, mostPatience);
    }
    std::erase_if(made_, [this](const auto& made) { return std::abs(made.first - level_) > 1; });
    for (std::size_t i = 0; i < y.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        for (double& coefficient : columns[i])
            coefficient *= unit_(row);
        columns[i][0] = y[i];
        y[i] = end(row) * unit_(row);
    }
    return lengthOf(level_);
}

} // namespace solution
