#include "integrators/diagonally_implicit.h"

#include "dense/dense_output.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr std::size_t mostIterations = 12, mayGrow = 5;
constexpr double mostGrowth = 5, slow = 0.1;
constexpr double far =
    0.1; // of the extent, that what is missing moves something (coupled_stages.h)
constexpr std::size_t fewIterations = 3, manyIterations = 6; // of the dissertation's rule

} // namespace

DiagonallyImplicit::DiagonallyImplicit(const DiagonalTableau& tableau, System& system,
                                       ErrorControl& control, bool fixed)
    : Method(system, control, fixed), tableau_(tableau),
      solver_(std::make_unique<LinearSolver>(system.jacobianPattern())),
      jacobian_(system.jacobianPattern().entries()),
      k_(tableau.b.size(), std::vector<double>(system.size())), base_(system.size()),
      z_(system.size()), at_(system.size()), correction_(system.size()) {
    end_.resize(system.size());
    slope_.resize(system.size());
}

bool DiagonallyImplicit::begin(double t, std::span<const double> y) {
    t_ = t;
    start_.assign(y.begin(), y.end());
    factors_.areMade = afterRejection_ = false;
    rate_ = 1;
    if (!rates(t, y, slope_))
        return false;
    lastSlope_ = slope_;
    return true;
}

bool DiagonallyImplicit::linearizeAt(std::size_t i) {
    for (std::size_t n = 0; n < at_.size(); ++n)
        at_[n] = base_[n] + z_[n];
    ++counts_.jacobians;
    factors_.areMade = false;
    if (!system_.jacobian(t_ + tableau_.c[i] * h_, at_, jacobian_))
        return false;
    ++counts_.factorisations;
    factors_.areMade = solver_->factor(jacobian_, 1 / (h_ * tableau_.diagonal()));
    factors_.step = h_;
    return factors_.areMade;
}

// What z misses of its equation, into correction_; `displacement`: how far that moves something.
bool DiagonallyImplicit::missing(std::size_t i, double& displacement) {
    for (std::size_t n = 0; n < at_.size(); ++n)
        at_[n] = base_[n] + z_[n];
    if (!rates(t_ + tableau_.c[i] * h_, at_, correction_))
        return false;
    const double shift = 1 / (h_ * tableau_.diagonal());
    for (std::size_t n = 0; n < at_.size(); ++n)
        correction_[n] -= shift * z_[n];
    displacement = control_.displacement(correction_, h_);
    return std::isfinite(displacement);
}

// One Newton correction of z; its norm.
double DiagonallyImplicit::correct() {
    solver_->solve(correction_);
    for (std::size_t n = 0; n < at_.size(); ++n)
        z_[n] += correction_[n];
    return control_.norm(correction_);
}

DiagonallyImplicit::Newton DiagonallyImplicit::iterate(std::size_t i, bool full, bool isNew) {
    const double kappa = control_.newtonTolerance();
    const double negligible = std::max(1e-3, control_.newtonNoise(!fixed_)); // whatever the rate
    const double trusted = tableau_.stepByNewton ? infinity : far;
    double last = 0, rate = 1;
    for (iterations_ = 1; iterations_ <= mostIterations; ++iterations_) {
        double displaced = 0;
        if (!missing(i, displaced))
            return Newton::notFinite;
        const bool isSlow = iterations_ > 2 && rate > slow;
        const bool isAnew = full || isSlow || (iterations_ > 1 && factors_.displaced > trusted);
        if (isAnew && !linearizeAt(i))
            return Newton::notFinite;
        if (isAnew || (isNew && iterations_ == 1))
            factors_.displaced = displaced;
        const double size = correct();
        if (!std::isfinite(size))
            return Newton::notFinite;
        if (last > 0) {
            rate = size / last;
            if (rate >= (iterations_ <= mayGrow ? mostGrowth : 1) && size > negligible)
                return Newton::failed;
            rate_ = std::min(rate, 1.0);
        }
        last = size;
        if (factors_.displaced <= trusted &&
            (size <= negligible || (rate < 1 && rate / (1 - rate) * size < kappa)))
            return Newton::converged;
    }
    return Newton::failed;
}

DiagonallyImplicit::Newton DiagonallyImplicit::solveStage(std::size_t i) {
    const double g = h_ * tableau_.diagonal();
    const std::vector<double>& guess = i > 0 ? k_[i - 1] : lastSlope_;
    base_ = start_;
    for (std::size_t j = 0; j < i; ++j)
        for (std::size_t n = 0; n < base_.size(); ++n)
            base_[n] += h_ * tableau_.a[i][j] * k_[j][n];
    for (std::size_t n = 0; n < z_.size(); ++n)
        z_[n] = tableau_.stepByNewton ? start_[n] - base_[n] : g * guess[n];
    const bool keep = factors_.areMade && factors_.step == h_ && rate_ < slow;
    if (!tableau_.stepByNewton && !keep && !linearizeAt(i)) {
        std::fill(z_.begin(), z_.end(), 0.0); // the prediction may lie where f has no value
        if (!linearizeAt(i))
            return Newton::notFinite;
    }
    Newton result = iterate(i, tableau_.stepByNewton, !keep);
    if (result == Newton::failed && !tableau_.stepByNewton) {
        for (std::size_t n = 0; n < z_.size(); ++n)
            z_[n] = start_[n] - base_[n];
        result = iterate(i, true, true);
    }
    for (std::size_t n = 0; n < z_.size(); ++n)
        k_[i][n] = z_[n] / g;
    mostIterations_ = std::max(mostIterations_, iterations_);
    return result;
}

DiagonallyImplicit::Newton DiagonallyImplicit::stages() {
    mostIterations_ = 0;
    for (std::size_t i = 0; i < k_.size(); ++i) {
        if (i == 0 && tableau_.explicitFirst()) {
            k_[0] = slope_;
            continue;
        }
        if (const Newton result = solveStage(i); result != Newton::converged)
            return result;
    }
    return Newton::converged;
}

Attempt DiagonallyImplicit::attempt(double h) {
    h_ = h;
    for (std::size_t n = 0; n < end_.size(); ++n)
        end_[n] = start_[n] + h * lastSlope_[n];
    control_.prepare(end_, h);
    if (const Newton result = stages(); result != Newton::converged) {
        afterRejection_ = true;
        factors_.areMade = false;
        rate_ = 1;
        if (result == Newton::failed)
            return {Attempt::Outcome::notConverged, 0.5 * h};
        return {Attempt::Outcome::notFinite, 0.25 * h};
    }
    end_ = start_;
    for (std::size_t n = 0; n < end_.size(); ++n) {
        double rise = 0;
        for (std::size_t i = 0; i < k_.size(); ++i)
            rise += tableau_.b[i] * k_[i][n];
        end_[n] += h * rise;
    }
    if (fixed_)
        return {Attempt::Outcome::accepted, h};
    return tableau_.stepByNewton ? judgeByNewton() : judge();
}

Attempt DiagonallyImplicit::judgeByNewton() const {
    const double factor = mostIterations_ <= fewIterations    ? 2
                          : mostIterations_ >= manyIterations ? 0.5
                                                              : 1;
    return {Attempt::Outcome::accepted, factor * h_};
}

Attempt DiagonallyImplicit::judge() {
    std::fill(correction_.begin(), correction_.end(), 0.0);
    for (std::size_t i = 0; i < k_.size(); ++i)
        for (std::size_t n = 0; n < correction_.size(); ++n)
            correction_[n] += tableau_.error[i] / tableau_.diagonal() * k_[i][n];
    solver_->solve(correction_);
    control_.prepare(end_, h_);
    const double error = control_.norm(correction_);
    const double exponent = -1 / static_cast<double>(tableau_.errorOrder + 1);
    double factor = std::isfinite(error) ? 0.9 * std::pow(std::max(error, 1e-10), exponent) : 0.2;
    if (!(error <= 1)) {
        afterRejection_ = true;
        return {Attempt::Outcome::errorTooLarge, h_ * std::clamp(factor, 0.2, 0.9)};
    }
    factor = std::clamp(factor, 0.2, afterRejection_ ? 1.0 : 5.0);
    afterRejection_ = false;
    if (factor >= 1 && factor <= 1.2) // keeps the factors
        factor = 1;
    return {Attempt::Outcome::accepted, h_ * factor};
}

// One stage gives no slope at the ends: a line, which is all that its collocation says.
void DiagonallyImplicit::dense(std::span<Coefficients> columns) {
    const bool oneStage = k_.size() == 1;
    const StepEnds ends{.h = h_,
                        .start = start_,
                        .end = end_,
                        .startSlope = tableau_.explicitFirst() ? slope_ : lastSlope_,
                        .endSlope = k_.back()};
    if (oneStage)
        lines(columns, ends);
    else
        cubics(columns, ends);
    integratePositions(columns, system_.integrals(), ends);
}

bool DiagonallyImplicit::proceed(std::span<const double> y) {
    t_ += h_;
    start_.assign(y.begin(), y.end());
    lastSlope_ = k_.back();
    if (tableau_.explicitFirst())
        return rates(t_, y, slope_);
    slope_ = lastSlope_;
    return true;
}

} // namespace solution
