#include "modes/held_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using complementarity::State;

namespace {

constexpr double noPivot = 1e-13; // of 1, of what is left of a scaled condition that others make
// Where laws have shared the forces: what less tilt than that tells of them is rounding.
constexpr double noPivotOfShares = 1e-10;
constexpr double noPivotOfFaces = 1e-9; // where faces lie on each other with a tilt (elimination.h)
// Contacts are redundant as a rule, and a dense factorization that finds their rank costs most.
constexpr double many = 3e6;

Eigen::Index count(std::size_t i) { return static_cast<Eigen::Index>(i); }

} // namespace

void HeldConditions::makePlan() {
    plan_.terms.clear();
    plan_.entries.clear();
    plan_.indices.clear();
    plan_.isSparse = false;
    plan_.isMade = true;
    constexpr auto none = std::numeric_limits<Elimination::Index>::max();
    std::vector<Elimination::Index> placeOf(mode_.kept.size(), none);
    for (std::size_t i = 0; i < plan_.rows.size(); ++i)
        placeOf[plan_.rows[i]] = static_cast<Elimination::Index>(i);
    for (std::size_t k = 0; k < conditions_.matrix.size(); ++k) {
        const auto [row, column] = conditions_.matrix[k];
        if (placeOf[row] != none && placeOf[column] != none)
            plan_.terms.push_back({.entry = k, .place = {placeOf[row], placeOf[column]}});
    }
    std::vector<Elimination::Place> places;
    std::ranges::transform(plan_.terms, std::back_inserter(places), &Term::place);
    plan_.hasContacts = std::ranges::any_of(
        plan_.rows, [this](std::size_t row) { return bound_.laws[row].leaving.has_value(); });
    const double dense = worthEliminating(plan_.rows.size());
    std::vector<Elimination::Index> patches;
    for (const std::size_t row : plan_.rows)
        patches.push_back(bound_.laws[row].patch.value_or(Elimination::noPatch));
    plan_.hasFaces = std::ranges::any_of(patches, [&](Elimination::Index patch) {
        return patch != Elimination::noPatch && std::ranges::count(patches, patch) > 3;
    });
    plan_.isSparse = elimination_.plan(plan_.rows.size(), places,
                                       plan_.hasContacts ? std::max(dense, many) : dense);
    if (!plan_.isSparse)
        return;
    elimination_.setPatches(patches);
    for (const Term& term : plan_.terms) {
        plan_.entries.push_back(static_cast<Elimination::Index>(term.entry));
        plan_.indices.push_back(elimination_.indexOf(term.place));
    }
}

void HeldConditions::followMode() {
    std::size_t held = 0;
    bool isSame = plan_.isMade;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        if (holds(row)) {
            isSame = isSame && held < plan_.rows.size() && plan_.rows[held] == row;
            ++held;
        }
    if (isSame && held == plan_.rows.size())
        return;
    plan_.rows.clear();
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        if (holds(row))
            plan_.rows.push_back(row);
    makePlan();
}

bool HeldConditions::eliminate(std::span<const double> values) {
    const std::span<double> into = elimination_.values();
    std::ranges::fill(into, 0);
    for (std::size_t k = 0; k < plan_.indices.size(); ++k)
        into[plan_.indices[k]] = values[plan_.entries[k]];
    if (!elimination_.factorise(plan_.hasContacts ? Elimination::Take::all
                                                  : Elimination::Take::regular))
        return false;
    findKernel(values);
    return true;
}

void HeldConditions::findKernel(std::span<const double> values) {
    const std::size_t n = plan_.rows.size(), idle = elimination_.dependent().size();
    redundancy_.kernel.resize(count(n), count(idle));
    if (idle == 0)
        return;
    for (std::size_t k = 0; k < idle; ++k)
        elimination_.kernel(k, {redundancy_.kernel.col(count(k)).data(), n});
    redundancy_.inRooms = rooms_.cwiseInverse().asDiagonal() * redundancy_.kernel;
    redundancy_.normal.compute(redundancy_.inRooms.transpose() * redundancy_.inRooms);
    redundancy_.values.clear();
    scale_.setOnes(count(n));
    for (const Term& term : plan_.terms) {
        const double value = values[term.entry];
        redundancy_.values.push_back(value);
        if (term.place.row == term.place.column && value != 0)
            scale_[term.place.row] = 1 / std::sqrt(std::abs(value));
    }
}

Eigen::VectorXd HeldConditions::left() const {
    if (way_ != Way::sparse)
        return dense_.matrix * answer_ - right_;
    Eigen::VectorXd left = Eigen::VectorXd::Zero(answer_.size());
    for (std::size_t k = 0; k < redundancy_.values.size(); ++k) {
        const auto& [row, column] = plan_.terms[k].place;
        left[row] += redundancy_.values[k] * answer_[column];
    }
    return scale_.cwiseProduct(left) - right_;
}

void HeldConditions::putMatrix(std::span<const double> values) {
    const Eigen::Index n = count(plan_.rows.size());
    dense_.matrix.setZero(n, n);
    scale_.setOnes(n);
    for (const Term& term : plan_.terms) {
        const auto [row, column] = term.place;
        const double value = dense_.matrix(row, column) = values[term.entry];
        if (row == column && value != 0)
            scale_[row] = 1 / std::sqrt(std::abs(value));
    }
    dense_.matrix = scale_.asDiagonal() * dense_.matrix * scale_.asDiagonal();
}

void HeldConditions::takeRooms() {
    rooms_.setOnes(count(plan_.rows.size()));
    if (!mode_.share.rooms.empty())
        for (std::size_t i = 0; i < plan_.rows.size(); ++i)
            rooms_[count(i)] = mode_.share.rooms[plan_.rows[i]];
}

bool HeldConditions::factorise(std::span<const double> values, const Off& off) {
    followMode();
    takeRooms();
    way_ = Way::sparse;
    // Forces that laws have shared are none of those that the tilt of faces makes.
    const bool isShared = !mode_.share.forces.empty();
    if (plan_.isSparse && !isShared && eliminate(values))
        return true;
    const double none = isShared ? noPivotOfShares : plan_.hasFaces ? noPivotOfFaces : noPivot;
    return factoriseDense(values, none, off);
}

bool HeldConditions::factoriseClosely(std::span<const double> values) {
    return factoriseDense(values, noPivot, {});
}

bool HeldConditions::factoriseDense(std::span<const double> values, double none, const Off& off) {
    way_ = Way::dense;
    putMatrix(values);
    if (!dense_.matrix.allFinite())
        return false;
    dense_.lu.compute(dense_.matrix);
    const auto hasLess = [this](double pivot) {
        return !(dense_.lu.matrixLU().diagonal().cwiseAbs().array() > pivot).all();
    };
    if (off && hasLess(leastPivot)) {
        const double way = off();
        if (way * way > none)
            none = std::min(way * way, leastPivot);
    }
    if (hasLess(none))
        way_ = Way::least;
    if (way_ == Way::least) {
        dense_.least.setThreshold(none);
        dense_.least.compute(dense_.matrix);
        findIdle();
    }
    return true;
}

namespace {

std::string forcesOf(std::size_t rows) {
    return rows == 1 ? "the force of 1 condition is"
                     : "the forces of " + std::to_string(rows) + " conditions are";
}

} // namespace

std::string howEliminated(std::size_t rows, std::size_t multiplications) {
    return rows == 0 ? ""
                     : forcesOf(rows) + " solved for one after the other, with " +
                           std::to_string(multiplications) +
                           (multiplications == 1 ? " multiplication" : " multiplications") +
                           " (of a full matrix " +
                           std::to_string(rows * (rows + 1) * (rows - 1) / 6) + ")";
}

std::string HeldConditions::how() const {
    const std::size_t n = plan_.rows.size();
    if (n == 0)
        return "";
    if (!isRegular())
        return forcesOf(n) + " the shortest of those that keep them";
    if (way_ == Way::dense)
        return forcesOf(n) + " solved for together";
    return howEliminated(n, elimination_.multiplications());
}

void HeldConditions::findIdle() {
    const Eigen::Index free = dense_.matrix.rows() - dense_.least.rank();
    dense_.idle.resize(dense_.matrix.rows(), free);
    if (free == 0)
        return;
    dense_.idle = dense_.least.colsPermutation() *
                  Eigen::MatrixXd(dense_.least.matrixZ().transpose().rightCols(free));
    dense_.inRooms.compute(scale_.cwiseQuotient(rooms_).asDiagonal() * dense_.idle);
}

// Of the m = S y with  A y = right,  A scaled by S, the one next to what is wanted: the shortest y,
// and of what leaves A y as it is the part that brings m nearer.
Eigen::MatrixXd HeldConditions::leastSolutions(const Eigen::MatrixXd& right,
                                               const Eigen::MatrixXd& wanted) const {
    Eigen::MatrixXd y = dense_.least.solve(right);
    if (dense_.idle.cols() > 0)
        y -= dense_.idle * dense_.inRooms.solve(rooms_.cwiseInverse().asDiagonal() *
                                                (scale_.asDiagonal() * y - wanted));
    return y;
}

void HeldConditions::solve(Eigen::Ref<Eigen::VectorXd> rates, std::span<const double> wanted) {
    const std::size_t n = plan_.rows.size();
    right_.resize(count(n));
    wanted_.setZero(count(n));
    for (std::size_t i = 0; i < n; ++i) {
        right_[count(i)] = -rates[count(plan_.rows[i])];
        if (!wanted.empty())
            wanted_[count(i)] = wanted[plan_.rows[i]];
    }
    rates.setZero();
    if (way_ == Way::sparse) {
        answer_ = right_;
        elimination_.solve({answer_.data(), n});
        if (redundancy_.kernel.cols() > 0) {
            answer_ -= redundancy_.kernel *
                       redundancy_.normal.solve(redundancy_.inRooms.transpose() *
                                                (answer_ - wanted_).cwiseQuotient(rooms_));
            right_ = scale_.cwiseProduct(right_);
        }
        for (std::size_t i = 0; i < n; ++i)
            rates[count(plan_.rows[i])] = answer_[count(i)];
        return;
    }
    right_ = scale_.cwiseProduct(right_);
    if (way_ == Way::dense)
        answer_ = dense_.lu.solve(right_);
    else
        answer_ = leastSolutions(right_, wanted_);
    for (std::size_t i = 0; i < n; ++i)
        rates[count(plan_.rows[i])] = scale_[count(i)] * answer_[count(i)];
}

void HeldConditions::solveEach(Eigen::Ref<Eigen::MatrixXd> rates) {
    if (way_ == Way::sparse) {
        for (Eigen::Index i = 0; i < rates.cols(); ++i)
            solve(rates.col(i));
        return;
    }
    const Eigen::Index n = count(plan_.rows.size());
    Eigen::MatrixXd right(n, rates.cols());
    for (Eigen::Index i = 0; i < n; ++i)
        right.row(i) = -scale_[i] * rates.row(count(plan_.rows[static_cast<std::size_t>(i)]));
    const Eigen::MatrixXd answers =
        way_ == Way::dense ? Eigen::MatrixXd(dense_.lu.solve(right))
                           : leastSolutions(right, Eigen::MatrixXd::Zero(n, rates.cols()));
    rates.setZero();
    for (Eigen::Index i = 0; i < n; ++i)
        rates.row(count(plan_.rows[static_cast<std::size_t>(i)])) = scale_[i] * answers.row(i);
}

} // namespace solution
