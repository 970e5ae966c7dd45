#include "modes/multipliers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using complementarity::State;

namespace {

constexpr double isNone = 1e-13; // of 1, of what is left of a scaled condition that others make

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

// Without a heap allocation once it was called for as many.
bool Multipliers::factorise() {
    if (!evaluate())
        return false;
    active_.clear();
    for (std::size_t row = 0; row < size(); ++row)
        if (mode_.kept[row] == State::inside)
            active_.push_back(row);
    const Eigen::Index n = indexOf(active_.size());
    if (n == 0)
        return true;
    scale_.resize(n);
    matrix_.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index row = indexOf(active_[static_cast<std::size_t>(i)]);
        const double own = std::abs(full_(row, row));
        scale_[i] = own > 0 ? 1 / std::sqrt(own) : 1;
    }
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            matrix_(i, j) = scale_[i] * scale_[j] *
                            full_(indexOf(active_[static_cast<std::size_t>(i)]),
                                  indexOf(active_[static_cast<std::size_t>(j)]));
    lu_.compute(matrix_);
    isRegular_ = true;
    for (Eigen::Index i = 0; i < n; ++i)
        isRegular_ = isRegular_ && std::abs(lu_.matrixLU()(i, i)) > isNone;
    if (!isRegular_) {
        least_.setThreshold(isNone);
        least_.compute(matrix_);
    }
    return true;
}

// The shortest m = S y of those with  A y = right,  A scaled by S: the shortest y, and of what
// leaves A y as it is the part that shortens m.
Eigen::VectorXd Multipliers::leastSolution() const {
    Eigen::VectorXd y = least_.solve(right_);
    const Eigen::Index free = y.size() - least_.rank();
    if (free == 0)
        return y;
    const Eigen::MatrixXd idle =
        least_.colsPermutation() * Eigen::MatrixXd(least_.matrixZ().transpose().rightCols(free));
    const Eigen::MatrixXd forces = scale_.asDiagonal() * idle;
    y -= idle * forces.colPivHouseholderQr().solve(scale_.cwiseProduct(y));
    return y;
}

double Multipliers::bound(std::size_t row) const {
    if (mode_.kept[row] == Mode::gone)
        return 0;
    const BoundModel::Law& law = f_.bound()->laws[row];
    return mode_.kept[row] == State::high ? law.high : law.low;
}

void Multipliers::solve(Eigen::Ref<Eigen::VectorXd> rates) {
    const Eigen::Index n = indexOf(active_.size());
    right_.resize(n);
    answer_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i)
        right_[i] = -scale_[i] * rates[indexOf(active_[static_cast<std::size_t>(i)])];
    if (n > 0 && isRegular_)
        answer_ = lu_.solve(right_);
    else if (n > 0)
        answer_ = leastSolution();
    rates.setZero();
    for (Eigen::Index i = 0; i < n; ++i)
        rates[indexOf(active_[static_cast<std::size_t>(i)])] = scale_[i] * answer_[i];
}

bool Multipliers::isSolved(const Eigen::VectorXd& m, const Eigen::VectorXd& wanted) {
    constexpr double rounding = 1e-7;
    if (isRegular_ || active_.empty())
        return true;
    const Eigen::VectorXd scaled = Eigen::VectorXd(m(active_)).cwiseQuotient(scale_);
    const Eigen::VectorXd right = scale_.cwiseProduct(Eigen::VectorXd(wanted(active_)));
    const Eigen::VectorXd errors = (matrix_ * scaled + right).cwiseAbs();
    const double most = rounding * std::max(right.cwiseAbs().maxCoeff(), 1e-100);
    contradictory_.clear();
    for (std::size_t i = 0; i < active_.size(); ++i)
        if (!(errors[indexOf(i)] <= most))
            contradictory_.push_back(active_[i]);
    return contradictory_.empty();
}

void Multipliers::findApart() {
    constexpr double few = 1e3, many = 1e7; // of the resolution
    for (const std::size_t row : active_) {
        const BoundModel::Law& law = f_.bound()->laws[row];
        const double gap = law.isBounded() ? 0 : std::abs(gaps_[row]);
        for (const auto& [most, list] : {std::pair(few, &apart_), std::pair(many, &farApart_)})
            if (gap > most * law.resolution && std::ranges::find(*list, row) == list->end())
                list->push_back(row);
    }
}

// What is left of rates after the velocities that were just solved for, where it is more than a
// resolution in the unit of time and than rounding of the velocities.
void Multipliers::findContradictory(std::span<const double> y) {
    constexpr double rounding = 1e-9;
    if (isRegular_ || active_.empty())
        return;
    double fastest = 0;
    for (const ComponentModel::Entry& push : model_.conditions().pushes)
        fastest = std::max(fastest, std::abs(y[push.row]));
    const Eigen::VectorXd left = (matrix_ * answer_ - right_).cwiseQuotient(scale_);
    for (std::size_t i = 0; i < active_.size(); ++i) {
        const double most = std::max(f_.bound()->laws[active_[i]].resolution, rounding * fastest);
        if (std::abs(left[indexOf(i)]) > most)
            contradictory_.push_back(active_[i]);
    }
}

bool Multipliers::solve() {
    if (size() == 0)
        return true;
    if (!factorise())
        return false;
    if (active_.size() < size())
        for (std::size_t row = 0; row < size(); ++row)
            if (mode_.kept[row] != State::inside && bound(row) != 0)
                rest_ += bound(row) * full_.col(indexOf(row));
    found_ = rest_;
    solve(found_);
    const bool isKept = found_.allFinite() && isSolved(found_, rest_);
    for (std::size_t row = 0; row < size(); ++row)
        f_.in()[f_.in().size() - size() + row] =
            mode_.kept[row] == State::inside ? found_[indexOf(row)] : bound(row);
    return isKept;
}

double Multipliers::secondRate(std::size_t row) const {
    double rate = rest_[indexOf(row)]; // with what stands at bounds
    for (std::size_t k = 0; k < size(); ++k)
        if (mode_.kept[k] == State::inside)
            rate += full_(indexOf(row), indexOf(k)) * values()[k];
    return rate;
}

Multipliers::System Multipliers::systemOf(std::span<const std::size_t> rows) {
    (void)evaluate();
    const std::vector<std::size_t> chosen(rows.begin(), rows.end());
    Eigen::VectorXd rest = rest_;
    for (std::size_t row = 0; row < size(); ++row) {
        if (std::ranges::find(rows, row) != rows.end())
            continue;
        const Eigen::Index i = indexOf(row);
        double value = 0;
        if (mode_.kept[row] != State::inside)
            value = bound(row);
        else if (!f_.bound()->laws[row].isOnSecondRates)
            value = -rest_[i] / full_(i, i);
        if (value != 0)
            rest += value * full_.col(i);
    }
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
    contradictory_.clear();
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most; ++round) { // until rounding lets it shrink no more
        const double gap = moveOntoGaps(t, y);
        if (round == 0)
            findApart();
        if (gap == 0 || !(gap < 0.5 * last))
            break;
        last = gap;
    }
    f_.fill(t, y);
    evaluateGaps();
    if (!factorise())
        return;
    Eigen::VectorXd by = Eigen::Map<const Eigen::VectorXd>(gaps_.data() + size(), indexOf(size()));
    solve(by);
    findContradictory(y);
    evaluateMoves();
    if (by.allFinite())
        move(model_.conditions().pushes, 0, by, y);
}

} // namespace solution
