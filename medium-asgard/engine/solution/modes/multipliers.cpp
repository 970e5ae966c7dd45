#include "modes/multipliers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using complementarity::State;

namespace {

constexpr double isNone = 1e-11; // of 1, of what is left of a scaled condition that others make

Eigen::Index indexOf(std::size_t i) { return static_cast<Eigen::Index>(i); }

} // namespace

// All conditions at the point.
bool Multipliers::evaluate() {
    const ComponentModel::Conditions& conditions = model_.conditions();
    const std::size_t entries = conditions.matrix.size();
    second_.resize(entries + size());
    f_.evaluate(conditions.second, second_);
    full_.setZero(indexOf(size()), indexOf(size()));
    for (std::size_t k = 0; k < entries; ++k)
        full_(conditions.matrix[k].row, conditions.matrix[k].column) = second_[k];
    rest_ = Eigen::Map<const Eigen::VectorXd>(second_.data() + entries, indexOf(size()));
    return full_.allFinite() && rest_.allFinite();
}

bool Multipliers::factorise() {
    if (!evaluate())
        return false;
    active_.clear();
    for (std::size_t row = 0; row < size(); ++row)
        if (mode_.kept[row] == State::inside)
            active_.push_back(row);
    if (active_.empty())
        return true;
    matrix_ = active_.size() == size() ? full_ : Eigen::MatrixXd(full_(active_, active_));
    scale_ = matrix_.diagonal().cwiseAbs().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    scale_ = (matrix_.diagonal().array() == 0).select(1, scale_);
    matrix_ = scale_.asDiagonal() * matrix_ * scale_.asDiagonal();
    lu_.compute(matrix_);
    isRegular_ = lu_.matrixLU().diagonal().cwiseAbs().minCoeff() > isNone;
    if (!isRegular_) {
        least_.setThreshold(isNone);
        least_.compute(matrix_);
    }
    return true;
}

double Multipliers::bound(std::size_t row) const {
    const BoundModel::Law& law = f_.bound()->laws[row];
    return mode_.kept[row] == State::high ? law.high : law.low;
}

void Multipliers::solve(Eigen::Ref<Eigen::VectorXd> rates) const {
    if (active_.empty()) {
        rates.setZero();
        return;
    }
    Eigen::VectorXd m = -scale_.cwiseProduct(Eigen::VectorXd(rates(active_)));
    m = isRegular_ ? Eigen::VectorXd(lu_.solve(m)) : Eigen::VectorXd(least_.solve(m));
    rates.setZero();
    rates(active_) = scale_.cwiseProduct(m);
}

bool Multipliers::isSolved(const Eigen::VectorXd& m, const Eigen::VectorXd& wanted) const {
    constexpr double rounding = 1e-7;
    if (isRegular_ || active_.empty())
        return true;
    const Eigen::VectorXd scaled = Eigen::VectorXd(m(active_)).cwiseQuotient(scale_);
    const Eigen::VectorXd right = scale_.cwiseProduct(Eigen::VectorXd(wanted(active_)));
    const double error = (matrix_ * scaled + right).cwiseAbs().maxCoeff();
    return error <= rounding * std::max(right.cwiseAbs().maxCoeff(), 1e-100);
}

bool Multipliers::solve() {
    if (size() == 0)
        return true;
    if (!factorise())
        return false;
    Eigen::VectorXd wanted = rest_;
    if (active_.size() < size())
        for (std::size_t row = 0; row < size(); ++row)
            if (mode_.kept[row] != State::inside && bound(row) != 0)
                wanted += bound(row) * full_.col(indexOf(row));
    Eigen::VectorXd m = wanted;
    solve(m);
    const bool isKept = m.allFinite() && isSolved(m, wanted);
    for (std::size_t row = 0; row < size(); ++row)
        if (mode_.kept[row] != State::inside)
            m[indexOf(row)] = bound(row);
    std::ranges::copy(m, f_.in().end() - std::ptrdiff_t(size()));
    return isKept;
}

double Multipliers::secondRate(std::size_t row) const {
    const Eigen::Map<const Eigen::VectorXd> m(values().data(), indexOf(size()));
    return full_.row(indexOf(row)).dot(m) + rest_[indexOf(row)];
}

Multipliers::System Multipliers::systemOf(std::span<const std::size_t> rows) {
    (void)evaluate();
    const std::vector<std::size_t> chosen(rows.begin(), rows.end());
    Eigen::VectorXd rest = rest_;
    for (std::size_t row = 0; row < size(); ++row)
        if (std::ranges::find(rows, row) == rows.end() && mode_.kept[row] != State::inside &&
            bound(row) != 0)
            rest += bound(row) * full_.col(indexOf(row));
    return {full_(chosen, chosen), rest(chosen)};
}

void Multipliers::push(std::span<const std::size_t> rows, const Eigen::VectorXd& impulses,
                       std::span<double> y) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(indexOf(size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        by[indexOf(rows[i])] = impulses[indexOf(i)];
    evaluateMoves();
    move(model_.conditions().pushes, 0, by, y);
}

void Multipliers::evaluateGaps() {
    gaps_.resize(2 * size());
    f_.evaluate(model_.conditions().gaps, gaps_);
}

void Multipliers::evaluateMoves() {
    const ComponentModel::Conditions& conditions = model_.conditions();
    moves_.resize(conditions.pushes.size() + conditions.shifts.size());
    f_.evaluate(conditions.moves, moves_);
}

// Adds entries times `by` to the states.
void Multipliers::move(std::span<const ComponentModel::Entry> entries, std::size_t first,
                       const Eigen::VectorXd& by, std::span<double> y) const {
    for (std::size_t k = 0; k < entries.size(); ++k)
        y[entries[k].row] += moves_[first + k] * by(entries[k].column);
}

// Answers with the largest gap that there was.
double Multipliers::moveOntoGaps(double t, std::span<double> y) {
    const ComponentModel::Conditions& conditions = model_.conditions();
    f_.fill(t, y);
    evaluateGaps();
    if (!factorise())
        return 0;
    double largest = 0;
    for (const std::size_t row : active_)
        largest = std::max(largest, std::abs(gaps_[row]));
    if (largest == 0)
        return 0;
    Eigen::VectorXd by = Eigen::Map<const Eigen::VectorXd>(gaps_.data(), indexOf(size()));
    solve(by);
    evaluateMoves();
    if (by.allFinite())
        move(conditions.shifts, conditions.pushes.size(), by, y);
    return largest;
}

void Multipliers::project(double t, std::span<double> y) {
    constexpr int most = 8;
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
    Eigen::VectorXd by = Eigen::Map<const Eigen::VectorXd>(gaps_.data() + size(), indexOf(size()));
    solve(by);
    evaluateMoves();
    if (by.allFinite())
        move(model_.conditions().pushes, 0, by, y);
}

} // namespace solution
