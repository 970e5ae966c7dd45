#include "integrators/coupled_stages.h"

#include <algorithm>
#include <cmath>

namespace solution {

CoupledStages::CoupledStages(System& system, const ErrorControl& control, const Nodes& nodes,
                             const Weights& weights)
    : system_(system), control_(control), nodes_(nodes), weights_(weights),
      jacobians_(count * system.jacobianPattern().entries()), at_(system.size()),
      rates_(system.size()), missing_(count * system.size()) {
    for (std::size_t stage = 0; stage < count; ++stage)
        for (std::size_t column = 0; column < system.size(); ++column)
            addColumn(system.jacobianPattern(), stage, column);
    matrix_.resize(entries_.size());
    solver_ = std::make_unique<LinearSolver>(pattern_);
}

void CoupledStages::add(std::size_t row, const Entry& entry) {
    pattern_.rows.push_back(static_cast<int>(row));
    entries_.push_back(entry);
}

// Rows in order: what the stages before take of this one, its own block, what those after take.
void CoupledStages::addColumn(const Pattern& jacobian, std::size_t stage, std::size_t column) {
    const std::size_t n = jacobian.size(), first = stage * jacobian.entries();
    for (std::size_t other = 0; other < stage; ++other)
        add(other * n + column, {.weight = weights_[other][stage], .jacobian = none});
    const double own = weights_[stage][stage];
    bool isSeen = false;
    for (int k = jacobian.columnStarts[column]; k < jacobian.columnStarts[column + 1]; ++k) {
        const auto entry = static_cast<std::size_t>(k);
        const auto row = static_cast<std::size_t>(jacobian.rows[entry]);
        if (row > column && !isSeen)
            add(stage * n + column, {.weight = own, .jacobian = none});
        isSeen = isSeen || row >= column;
        add(stage * n + row, {.weight = row == column ? own : 0, .jacobian = first + entry});
    }
    if (!isSeen)
        add(stage * n + column, {.weight = own, .jacobian = none});
    for (std::size_t other = stage + 1; other < count; ++other)
        add(other * n + column, {.weight = weights_[other][stage], .jacobian = none});
    pattern_.columnStarts.push_back(static_cast<int>(pattern_.rows.size()));
}

void CoupledStages::place(std::size_t stage) {
    for (std::size_t n = 0; n < at_.size(); ++n)
        at_[n] = step_.y[n] + (*step_.z)[stage][n];
}

// Jacobians of all stages where they are now. The solver takes shift I - matrix.
bool CoupledStages::linearize() {
    const std::size_t entries = jacobians_.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
        place(i);
        ++counts_.jacobians;
        if (!system_.jacobian(step_.t + nodes_[i] * step_.h, at_,
                              std::span(jacobians_).subspan(i * entries, entries)))
            return false;
    }
    for (std::size_t k = 0; k < entries_.size(); ++k)
        matrix_[k] = (entries_[k].jacobian == none ? 0 : jacobians_[entries_[k].jacobian]) -
                     entries_[k].weight / step_.h;
    ++counts_.factorisations;
    return solver_->factor(matrix_, 0.0);
}

// What the stages miss of their equations; `displacement`: how far that moves something within the
// step, over the extent.
bool CoupledStages::missing(double& displacement) {
    const std::size_t size = at_.size();
    displacement = 0;
    for (std::size_t i = 0; i < count; ++i) {
        place(i);
        ++counts_.evaluations;
        if (!system_.rates(step_.t + nodes_[i] * step_.h, at_, rates_))
            return false;
        for (std::size_t n = 0; n < size; ++n) {
            double slope = 0;
            for (std::size_t j = 0; j < count; ++j)
                slope += weights_[i][j] * (*step_.z)[j][n];
            rates_[n] -= slope / step_.h;
            missing_[i * size + n] = rates_[n];
        }
        displacement = std::max(displacement, control_.displacement(rates_, step_.h));
    }
    return std::isfinite(displacement);
}

// One correction of all stages; its norm.
double CoupledStages::correct(Stages& z) {
    ++counts_.iterations;
    solver_->solve(missing_);
    const std::size_t size = at_.size();
    double largest = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t n = 0; n < size; ++n) {
            const double change = missing_[i * size + n];
            z[i][n] += change;
            const double scaled = std::abs(change) / control_.scale(n);
            if (!(scaled <= largest)) // a NaN stays
                largest = std::isnan(scaled) ? infinity : scaled;
        }
    return largest;
}

CoupledStages::Outcome CoupledStages::solve(double t, double h, std::span<const double> y,
                                            Stages& z, bool isFixed, std::size_t leastIterations) {
    constexpr std::size_t mostIterations = 12, mayGrow = 5, mostStalls = 2;
    constexpr double mostGrowth = 10, slow = 0.1, far = 0.1;
    step_.t = t;
    step_.h = h;
    step_.y = y;
    step_.z = &z;
    counts_ = {};
    const double kappa = control_.newtonTolerance(), noise = control_.newtonNoise(!isFixed);
    double last = 0, rate = 1;
    double least = infinity, displacedThere = 0; // where the Jacobian stands
    std::size_t stalls = 0;
    for (std::size_t iteration = 1; iteration <= mostIterations; ++iteration) {
        double displaced = 0;
        if (!missing(displaced))
            return Outcome::notFinite;
        stalls += displaced > far && displaced > 0.5 * least ? 1 : 0;
        if (stalls > mostStalls) // rounding keeps them there
            return Outcome::failed;
        least = std::min(least, displaced);
        if (iteration == 1 || displacedThere > far || rate > slow) {
            if (!linearize())
                return Outcome::notFinite;
            displacedThere = displaced;
        }
        const double size = correct(z);
        if (!std::isfinite(size))
            return Outcome::notFinite;
        const double mostNow = iteration <= mayGrow ? mostGrowth : 1;
        if (last > 0 && size >= noise && size >= mostNow * last)
            return Outcome::failed;
        rate = std::max(last > 0 ? size / last : 1, displacedThere);
        last = size;
        const bool isSmall =
            iteration >= leastIterations && rate < 1 && rate / (1 - rate) * size < kappa;
        if (displacedThere <= far && (size == 0 || (iteration > 2 && size < noise) || isSmall))
            return Outcome::converged;
    }
    return Outcome::failed;
}

} // namespace solution
