#include "modes/held_conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using complementarity::State;

namespace {

constexpr double noPivot = 1e-13; // of 1, of what is left of a scaled condition that others make
// A dense multiplication costs less than a sparse one, and a dense factorization something besides.
constexpr double cost = 4, besides = 500;

Eigen::Index count(std::size_t i) { return static_cast<Eigen::Index>(i); }

} // namespace

void HeldConditions::makePlan(std::vector<std::size_t> slipping) {
    plan_.isMade = true;
    plan_.slipping = std::move(slipping);
    plan_.terms.clear();
    plan_.ofFriction.clear();
    constexpr auto none = std::numeric_limits<Elimination::Index>::max();
    std::vector<Elimination::Index> placeOf(mode_.kept.size(), none);
    for (std::size_t i = 0; i < plan_.rows.size(); ++i)
        placeOf[plan_.rows[i]] = static_cast<Elimination::Index>(i);
    std::vector<Elimination::Place> places;
    for (std::size_t k = 0; k < conditions_.matrix.size(); ++k) {
        const auto [row, column] = conditions_.matrix[k];
        if (placeOf[row] == none)
            continue;
        if (placeOf[column] != none)
            plan_.terms.push_back({.entry = k, .place = {placeOf[row], placeOf[column]}});
        const auto& disc = bound_.laws[column].disc;
        if (!disc || std::ranges::find(plan_.slipping, *disc) == plan_.slipping.end())
            continue;
        for (const std::size_t normal : bound_.discs[*disc].normals)
            if (placeOf[normal] != none)
                plan_.ofFriction.push_back(
                    {.entry = k, .place = {placeOf[row], placeOf[normal]}, .friction = column});
    }
    for (const std::vector<Term>* terms : {&plan_.terms, &plan_.ofFriction})
        std::ranges::transform(*terms, std::back_inserter(places), &Term::place);
    const auto n = static_cast<double>(plan_.rows.size());
    plan_.isSparse = elimination_.plan(plan_.rows.size(), places, n * n * n / 3 / cost + besides);
    for (std::vector<Term>* terms : {&plan_.terms, &plan_.ofFriction})
        for (Term& term : *terms)
            term.index = plan_.isSparse ? elimination_.indexOf(term.place) : 0;
}

void HeldConditions::findScales(std::span<const double> matrix) {
    scale_.setOnes(count(plan_.rows.size()));
    for (const Term& term : plan_.terms)
        if (const auto& [row, column] = conditions_.matrix[term.entry]; row == column) {
            const double own = std::abs(matrix[term.entry]);
            if (own > 0)
                scale_[term.place.row] = 1 / std::sqrt(own);
        }
}

template <class Put>
void HeldConditions::assemble(std::span<const double> matrix, std::span<const double> friction,
                              const Put& put) const {
    for (const Term& term : plan_.terms)
        put(term, scale_[term.place.row] * scale_[term.place.column] * matrix[term.entry]);
    for (const Term& term : plan_.ofFriction)
        put(term, scale_[term.place.row] * scale_[term.place.column] * friction[term.friction] *
                      matrix[term.entry]);
}

void HeldConditions::factorise(std::span<const double> matrix, std::span<const double> friction) {
    const auto holds = [this](std::size_t row) { return mode_.kept[row] == State::inside; };
    std::size_t held = 0;
    bool isSame = plan_.isMade;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        if (holds(row)) {
            isSame = isSame && held < plan_.rows.size() && plan_.rows[held] == row;
            ++held;
        }
    std::vector<std::size_t> slipping;
    if (!friction.empty())
        for (std::size_t disc = 0; disc < bound_.discs.size(); ++disc)
            if (mode_.kept[bound_.discs[disc].rows[0]] == State::low)
                slipping.push_back(disc);
    if (!isSame || held != plan_.rows.size() || slipping != plan_.slipping) {
        plan_.rows.clear();
        for (std::size_t row = 0; row < mode_.kept.size(); ++row)
            if (holds(row))
                plan_.rows.push_back(row);
        makePlan(std::move(slipping));
    }
    findScales(matrix);
    if (plan_.isSparse) {
        std::ranges::fill(elimination_.values(), 0);
        assemble(matrix, friction, [values = elimination_.values()](const Term& term, double x) {
            values[term.index] += x;
        });
        way_ = Way::sparse;
        if (elimination_.factorise())
            return;
    }
    const Eigen::Index n = count(held);
    matrix_.setZero(n, n);
    assemble(matrix, friction, [this](const Term& term, double x) {
        matrix_(term.place.row, term.place.column) += x;
    });
    lu_.compute(matrix_);
    way_ = Way::dense;
    for (Eigen::Index i = 0; i < n; ++i)
        if (!(std::abs(lu_.matrixLU()(i, i)) > noPivot))
            way_ = Way::least;
    if (way_ == Way::least) {
        least_.setThreshold(noPivot);
        least_.compute(matrix_);
    }
}

// The shortest m = S y of those with  A y = right,  A scaled by S: the shortest y, and of what
// leaves A y as it is the part that shortens m.
Eigen::VectorXd HeldConditions::leastSolution() const {
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

void HeldConditions::solve(Eigen::Ref<Eigen::VectorXd> rates) {
    const Eigen::Index n = count(plan_.rows.size());
    right_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i)
        right_[i] = -scale_[i] * rates[count(plan_.rows[static_cast<std::size_t>(i)])];
    if (way_ == Way::sparse) {
        answer_ = right_;
        elimination_.solve({answer_.data(), plan_.rows.size()});
    } else if (n > 0) {
        answer_ = way_ == Way::dense ? Eigen::VectorXd(lu_.solve(right_)) : leastSolution();
    }
    rates.setZero();
    for (Eigen::Index i = 0; i < n; ++i)
        rates[count(plan_.rows[static_cast<std::size_t>(i)])] = scale_[i] * answer_[i];
}

} // namespace solution
