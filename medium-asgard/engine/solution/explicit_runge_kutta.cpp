#include "solution/explicit_runge_kutta.h"

#include "solution/dense_output.h"

#include <algorithm>
#include <cmath>

namespace solution {

ExplicitRungeKutta::ExplicitRungeKutta(const Tableau& tableau, System& system,
                                       ErrorControl& control, bool fixed)
    : Method(system, control, fixed), tableau_(tableau),
      k_(tableau.a.size(), std::vector<double>(system.size())), at_(system.size()),
      stiffAt_(system.size()), lost_(system.size()), lostNext_(system.size()),
      error_(system.size()), secondError_(system.size()) {
    start_.resize(system.size());
    end_.resize(system.size());
    slope_.resize(system.size());
}

bool ExplicitRungeKutta::begin(double t, std::span<const double> y) {
    t_ = t;
    h_ = 0;
    start_.assign(y.begin(), y.end());
    previousError_ = 1e-4;
    afterRejection_ = false;
    stabilityUsed_ = 0;
    std::fill(lost_.begin(), lost_.end(), 0.0);
    return rates(t, y, slope_);
}

// The increment is summed before it is added, and what that addition rounds away at the end of a
// step is added to the next increment (Kahan): far from the origin a position keeps its last bits.
bool ExplicitRungeKutta::stage(std::size_t i, std::span<double> at) {
    std::fill(at.begin(), at.end(), 0.0);
    for (std::size_t j = 0; j < tableau_.a[i].size(); ++j) {
        const double weight = h_ * tableau_.a[i][j];
        if (weight == 0)
            continue;
        const std::vector<double>& k = k_[j];
        for (std::size_t n = 0; n < at.size(); ++n)
            at[n] += weight * k[n];
    }
    const bool last = i == tableau_.stages;
    for (std::size_t n = 0; n < at.size(); ++n) {
        const double increment = last ? at[n] + lost_[n] : at[n];
        at[n] = start_[n] + increment;
        if (last)
            lostNext_[n] = increment - (at[n] - start_[n]);
    }
    return rates(t_ + tableau_.c[i] * h_, at, k_[i]);
}

Attempt ExplicitRungeKutta::attempt(double h) {
    h_ = h;
    k_[0] = slope_;
    for (std::size_t i = 1; i <= tableau_.stages; ++i) {
        std::vector<double>& at = i == tableau_.stages       ? end_
                                  : i == tableau_.stiffStage ? stiffAt_
                                                             : at_;
        if (!stage(i, at)) {
            afterRejection_ = true;
            return {Attempt::Outcome::notFinite, 0.25 * h};
        }
    }
    if (fixed_)
        return {Attempt::Outcome::accepted, h};
    control_.prepare(end_, h);
    return judge(errorNorm());
}

double ExplicitRungeKutta::errorNorm() {
    const auto sum = [this](const std::vector<double>& weights, std::vector<double>& out) {
        std::fill(out.begin(), out.end(), 0.0);
        for (std::size_t i = 0; i < weights.size(); ++i)
            if (weights[i] != 0)
                for (std::size_t n = 0; n < out.size(); ++n)
                    out[n] += h_ * weights[i] * k_[i][n];
    };
    sum(tableau_.error, error_);
    if (!tableau_.secondError.empty()) {
        sum(tableau_.secondError, secondError_);
        for (std::size_t n = 0; n < error_.size(); ++n)
            if (error_[n] != 0)
                error_[n] *= std::abs(error_[n]) / std::hypot(error_[n], 0.1 * secondError_[n]);
    }
    return control_.norm(error_);
}

Attempt ExplicitRungeKutta::judge(double error) {
    const double p = static_cast<double>(tableau_.order);
    if (!(error <= 1)) {
        afterRejection_ = true;
        const double factor = std::isfinite(error) ? 0.9 * std::pow(error, -1 / p) : 0.2;
        return {Attempt::Outcome::errorTooLarge, h_ * std::clamp(factor, 0.2, 0.9)};
    }
    const double e = std::max(error, 1e-10);
    double factor = 0.9 * std::pow(e, -0.7 / p) * std::pow(previousError_, 0.4 / p);
    factor = std::clamp(factor, 0.2, afterRejection_ ? 1.0 : 6.0);
    previousError_ = std::max(error, 1e-4);
    afterRejection_ = false;
    estimateStiffness();
    return {Attempt::Outcome::accepted, h_ * factor};
}

void ExplicitRungeKutta::estimateStiffness() {
    stabilityUsed_ = 0;
    if (tableau_.stabilityLimit == 0)
        return;
    double dk = 0, dy = 0;
    for (std::size_t n = 0; n < end_.size(); ++n) {
        const double scale = control_.scale(n);
        const double k = (k_[tableau_.stages][n] - k_[tableau_.stiffStage][n]) / scale;
        const double y = (end_[n] - stiffAt_[n]) / scale;
        dk += k * k;
        dy += y * y;
    }
    if (dy > 0)
        stabilityUsed_ = h_ * std::sqrt(dk / dy) / tableau_.stabilityLimit;
}

void ExplicitRungeKutta::dense(std::span<Coefficients> columns) {
    // Stages of dense output alone. Where one is not finite, the line through both ends' slopes
    // that a cubic gives must do.
    bool complete = true;
    for (std::size_t i = tableau_.stages + 1; i < tableau_.a.size() && complete; ++i)
        complete = stage(i, at_);
    for (std::size_t n = 0; n < columns.size(); ++n) {
        Coefficients& column = columns[n];
        column = {};
        column[0] = start_[n];
        if (complete && !tableau_.dense.empty()) {
            for (std::size_t i = 0; i < tableau_.dense.size(); ++i)
                for (std::size_t power = 0; power < tableau_.dense[i].size(); ++power)
                    column[power + 1] += h_ * tableau_.dense[i][power] * k_[i][n];
        }
    }
    const StepEnds ends{.h = h_,
                        .start = start_,
                        .end = end_,
                        .startSlope = slope_,
                        .endSlope = k_[tableau_.stages]};
    if (!complete || tableau_.dense.empty())
        cubics(columns, ends);
    integratePositions(columns, system_.integrals(), ends);
}

bool ExplicitRungeKutta::proceed(std::span<const double> y) {
    t_ += h_;
    const bool same = std::equal(y.begin(), y.end(), end_.begin());
    for (std::size_t n = 0; n < y.size(); ++n)
        lost_[n] = y[n] == end_[n] ? lostNext_[n] : 0;
    start_.assign(y.begin(), y.end());
    if (same) {
        slope_ = k_[tableau_.stages];
        return true;
    }
    return rates(t_, y, slope_);
}

} // namespace solution
