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
bool Multipliers::evaluate(Friction friction) {
    const ComponentModel::Conditions& conditions = model_.conditions();
    const std::size_t entries = conditions.matrix.size();
    second_.resize(entries + size());
    f_.evaluate(conditions.second, second_);
    full_.setZero(indexOf(size()), indexOf(size()));
    for (std::size_t k = 0; k < entries; ++k)
        full_(conditions.matrix[k].row, conditions.matrix[k].column) = second_[k];
    rest_ = Eigen::Map<const Eigen::VectorXd>(second_.data() + entries, indexOf(size()));
    own_ = full_.diagonal();
    if (friction == Friction::ofSlip)
        addFriction();
    return full_.allFinite() && rest_.allFinite();
}

// A normal force brings with it the friction of a contact that slips:  f = -coefficient N d.
void Multipliers::addFriction() {
    const std::vector<BoundModel::Disc>& discs = f_.bound()->discs;
    bool isEvaluated = false;
    for (std::size_t k = 0; k < discs.size(); ++k) {
        const BoundModel::Disc& disc = discs[k];
        if (!slips(disc) || disc.sliding == 0)
            continue;
        if (!isEvaluated)
            evaluateGaps();
        isEvaluated = true;
        const InDisc direction = directionOf(k);
        Eigen::VectorXd column = Eigen::VectorXd::Zero(indexOf(size()));
        for (std::size_t i = 0; i < disc.rows.size(); ++i)
            column -= disc.sliding * direction[indexOf(i)] * full_.col(indexOf(disc.rows[i]));
        for (const std::size_t normal : disc.normals)
            full_.col(indexOf(normal)) += column;
    }
}

double Multipliers::validity(std::size_t row) const {
    const std::vector<std::uint32_t>& first = model_.conditions().firstValid;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = first[row]; k < first[row + 1]; ++k)
        least = std::min(least, gaps_[2 * size() + k]);
    return least;
}

Multipliers::InDisc Multipliers::slipOf(const BoundModel::Disc& disc) const {
    InDisc slip(indexOf(disc.rows.size()));
    for (std::size_t i = 0; i < disc.rows.size(); ++i)
        slip[indexOf(i)] = rate(disc.rows[i]);
    return slip;
}

// Near rest the direction in which it began counts, so that the rates of states have no jump there.
Multipliers::InDisc Multipliers::directionOf(std::size_t disc) const {
    constexpr double atRest = 1e-3; // of a resolution, in the unit of time
    const BoundModel::Disc& of = f_.bound()->discs[disc];
    const InDisc began =
        Eigen::Map<const Eigen::Vector3d>(mode_.slips[disc].data()).head(indexOf(of.rows.size()));
    const InDisc slip = slipOf(of);
    if (slip.size() == 1)
        return began;
    const double least = atRest * f_.bound()->laws[of.rows[0]].resolution;
    const InDisc way = (slip.dot(began) < 0 ? -slip : slip) + least * began;
    return way / way.norm();
}

double Multipliers::leewayOf(const BoundModel::Disc& disc) const {
    double normal = 0, square = 0;
    for (const std::size_t row : disc.normals)
        normal += values()[row];
    for (const std::size_t row : disc.rows)
        square += values()[row] * values()[row];
    return disc.sticking * normal - std::sqrt(square);
}

// Without a heap allocation once it was called for as many.
bool Multipliers::factorise(Friction friction) {
    if (!evaluate(friction))
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
        const double own = std::abs(own_[row]);
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
    if (law.disc)
        return 0; // it follows normal forces: addFriction()
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
    if (!factorise(Friction::ofSlip))
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
    putFriction();
    return isKept;
}

// Of discs that slip.
void Multipliers::putFriction() {
    const std::vector<BoundModel::Disc>& discs = f_.bound()->discs;
    for (std::size_t k = 0; k < discs.size(); ++k) {
        const BoundModel::Disc& disc = discs[k];
        if (!slips(disc) || disc.sliding == 0)
            continue;
        double normal = 0;
        for (const std::size_t row : disc.normals)
            normal += values()[row];
        const InDisc direction = directionOf(k);
        for (std::size_t i = 0; i < disc.rows.size(); ++i)
            f_.in()[f_.in().size() - size() + disc.rows[i]] =
                -disc.sliding * normal * direction[indexOf(i)];
    }
}

double Multipliers::secondRate(std::size_t row) const {
    double rate = rest_[indexOf(row)]; // with what stands at bounds
    for (std::size_t k = 0; k < size(); ++k)
        if (mode_.kept[k] == State::inside)
            rate += full_(indexOf(row), indexOf(k)) * values()[k];
    return rate;
}

Multipliers::System Multipliers::systemOf(std::span<const std::size_t> rows, Friction friction) {
    (void)evaluate(friction);
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

void Multipliers::rest(double none, std::span<double> y) const {
    const auto& pushes = model_.conditions().pushes;
    if (std::ranges::all_of(pushes,
                            [&](const auto& push) { return std::abs(y[push.row]) <= none; }))
        for (const ComponentModel::Entry& push : pushes)
            y[push.row] = 0;
}

double Multipliers::fastest(std::span<const double> y) const {
    double most = 0;
    for (const ComponentModel::Entry& push : model_.conditions().pushes)
        most = std::max(most, std::abs(y[push.row]));
    return most;
}

void Multipliers::balance(std::span<const double> y, std::span<double> rates) {
    constexpr double rounding = 1e-13; // of the forces
    const auto& pushes = model_.conditions().pushes;
    if (std::ranges::any_of(pushes, [&](const auto& push) { return y[push.row] != 0; }))
        return;
    evaluateMoves();
    double force = 0;
    for (std::size_t k = 0; k < pushes.size(); ++k)
        force = std::max(force, std::abs(moves_[k] * values()[pushes[k].column]));
    if (std::ranges::all_of(pushes, [&](const auto& push) {
            return std::abs(rates[push.row]) <= rounding * force;
        }))
        for (const ComponentModel::Entry& push : pushes)
            rates[push.row] = 0;
}

void Multipliers::evaluateGaps() {
    gaps_.resize(2 * size() + model_.conditions().firstValid.back());
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
    if (!factorise(Friction::none))
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
    if (!factorise(Friction::none))
        return;
    Eigen::VectorXd by = Eigen::Map<const Eigen::VectorXd>(gaps_.data() + size(), indexOf(size()));
    solve(by);
    findContradictory(y);
    evaluateMoves();
    if (by.allFinite())
        move(model_.conditions().pushes, 0, by, y);
}

} // namespace solution
