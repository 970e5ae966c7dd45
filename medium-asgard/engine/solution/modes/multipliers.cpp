#include "modes/multipliers.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr double isNone = 1e-11; // of 1, of what is left of a scaled condition that others make

} // namespace

bool Multipliers::factorise() {
    const ComponentModel::Conditions& conditions = model_.conditions();
    const auto n = static_cast<Eigen::Index>(size());
    const std::size_t entries = conditions.matrix.size();
    second_.resize(entries + size());
    f_.evaluate(conditions.second, second_);
    matrix_.setZero(n, n);
    for (std::size_t k = 0; k < entries; ++k)
        matrix_(conditions.matrix[k].row, conditions.matrix[k].column) = second_[k];
    rest_ = Eigen::Map<const Eigen::VectorXd>(second_.data() + entries, n);
    scale_ = matrix_.diagonal().cwiseAbs().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    scale_ = (matrix_.diagonal().array() == 0).select(1, scale_);
    matrix_ = scale_.asDiagonal() * matrix_ * scale_.asDiagonal();
    if (!matrix_.allFinite() || !rest_.allFinite())
        return false;
    lu_.compute(matrix_);
    isRegular_ = lu_.matrixLU().diagonal().cwiseAbs().minCoeff() > isNone;
    if (!isRegular_) {
        least_.setThreshold(isNone);
        least_.compute(matrix_);
    }
    return true;
}

void Multipliers::solve(Eigen::Ref<Eigen::VectorXd> rates) const {
    rates = -scale_.cwiseProduct(rates);
    rates = isRegular_ ? Eigen::VectorXd(lu_.solve(rates)) : Eigen::VectorXd(least_.solve(rates));
    rates = scale_.cwiseProduct(rates);
}

bool Multipliers::isSolved(const Eigen::VectorXd& m, const Eigen::VectorXd& wanted) const {
    constexpr double rounding = 1e-7;
    const Eigen::VectorXd scaled = m.cwiseQuotient(scale_);
    const Eigen::VectorXd error = matrix_ * scaled + scale_.cwiseProduct(wanted);
    const double size = scale_.cwiseProduct(wanted).cwiseAbs().maxCoeff();
    return error.cwiseAbs().maxCoeff() <= rounding * std::max(size, 1e-100);
}

bool Multipliers::solve() {
    if (size() == 0)
        return true;
    if (!factorise())
        return false;
    Eigen::VectorXd m = rest_;
    solve(m);
    std::ranges::copy(m, f_.in().end() - std::ptrdiff_t(size()));
    return m.allFinite() && (isRegular_ || isSolved(m, rest_));
}

void Multipliers::evaluateGaps() {
    gaps_.resize(2 * size());
    f_.evaluate(model_.conditions().gaps, gaps_);
}

// Adds entries times `by` to the states.
void Multipliers::move(std::span<const ComponentModel::Entry> entries, std::size_t first,
                       const Eigen::VectorXd& by, std::span<double> y) const {
    for (std::size_t k = 0; k < entries.size(); ++k)
        y[entries[k].row] += moves_[first + k] * by(entries[k].column);
}

// Answers with the largest scaled gap that there was.
double Multipliers::moveOntoGaps(double t, std::span<double> y) {
    const ComponentModel::Conditions& conditions = model_.conditions();
    f_.fill(t, y);
    evaluateGaps();
    if (!factorise())
        return 0;
    const auto n = static_cast<Eigen::Index>(size());
    Eigen::VectorXd by = Eigen::Map<const Eigen::VectorXd>(gaps_.data(), n);
    const double largest = by.cwiseAbs().maxCoeff();
    if (largest == 0)
        return 0;
    solve(by);
    moves_.resize(conditions.pushes.size() + conditions.shifts.size());
    f_.evaluate(conditions.moves, moves_);
    if (by.allFinite())
        move(conditions.shifts, conditions.pushes.size(), by, y);
    return largest;
}

void Multipliers::project(double t, std::span<double> y) {
    constexpr int most = 8;
    const ComponentModel::Conditions& conditions = model_.conditions();
    if (size() == 0)
        return;
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most; ++round) { // until rounding lets it shrink no more
        const double gap = moveOntoGaps(t, y);
        if (gap == 0 || !(gap < 0.1 * last))
            break;
        last = gap;
    }
    f_.fill(t, y);
    evaluateGaps();
    if (!factorise())
        return;
    Eigen::VectorXd by =
        Eigen::Map<const Eigen::VectorXd>(gaps_.data() + size(), static_cast<Eigen::Index>(size()));
    solve(by);
    moves_.resize(conditions.pushes.size() + conditions.shifts.size());
    f_.evaluate(conditions.moves, moves_);
    if (by.allFinite())
        move(conditions.pushes, 0, by, y);
}

} // namespace solution
