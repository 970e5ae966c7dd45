#include "integrators/step_doubling.h"

#include "dense/dense_output.h"

#include <algorithm>
#include <cmath>

namespace solution {

StepDoubling::StepDoubling(std::unique_ptr<Method> inner, System& system, ErrorControl& control)
    : Method(system, control, false), inner_(std::move(inner)), error_(system.size()),
      first_(system.size()), second_(system.size()) {}

// firstStep() counts its evaluations here, everything else is counted within.
void StepDoubling::takeCounts() {
    counts_ = inner_->counts();
    counts_.evaluations += firstSteps_;
}

bool StepDoubling::startInner() {
    innerAtStart_ = true;
    const bool finite = inner_->begin(t_, start_);
    takeCounts();
    return finite;
}

bool StepDoubling::begin(double t, std::span<const double> y) {
    t_ = t;
    start_.assign(y.begin(), y.end());
    if (!startInner())
        return false;
    slope_.assign(inner_->slope().begin(), inner_->slope().end());
    return true;
}

Attempt StepDoubling::refuse(const Attempt& attempt) {
    takeCounts();
    return {attempt.outcome, std::min(attempt.next, 0.5 * h_)};
}

Attempt StepDoubling::attempt(double h) {
    using enum Attempt::Outcome;
    h_ = h;
    firstSteps_ = counts_.evaluations - inner_->counts().evaluations;
    if (!innerAtStart_ && !startInner())
        return {notFinite, 0.25 * h};
    if (const Attempt whole = inner_->attempt(h); whole.outcome != accepted)
        return refuse(whole);
    whole_.assign(inner_->state().begin(), inner_->state().end());
    if (const Attempt half = inner_->attempt(0.5 * h); half.outcome != accepted)
        return refuse(half);
    inner_->dense(first_);
    middle_.assign(inner_->state().begin(), inner_->state().end());
    innerAtStart_ = false;
    if (!inner_->proceed(middle_))
        return refuse({notFinite, 0.25 * h});
    if (const Attempt half = inner_->attempt(0.5 * h); half.outcome != accepted)
        return refuse(half);
    inner_->dense(second_);
    end_.assign(inner_->state().begin(), inner_->state().end());
    takeCounts();
    const double p = static_cast<double>(order()), gain = std::pow(2, p) - 1;
    for (std::size_t n = 0; n < end_.size(); ++n)
        error_[n] = (end_[n] - whole_[n]) / gain;
    control_.prepare(end_, h);
    const double error = control_.norm(error_);
    const double factor =
        std::isfinite(error) ? 0.9 * std::pow(std::max(error, 1e-10), -1 / (p + 1)) : 0.2;
    if (!(error <= 1))
        return {errorTooLarge, h * std::clamp(factor, 0.2, 0.9)};
    return {accepted, h * std::clamp(factor, 0.2, 5.0)};
}

void StepDoubling::dense(std::span<Coefficients> columns) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        const double y0 = start_[n], m = middle_[n] - y0, r = end_[n] - y0;
        if (order() <= 2) {
            columns[n] = {y0, 4 * m - r, 2 * r - 4 * m};
            continue;
        }
        // By powers of s: the slopes are those of a polynomial over the whole step.
        const double d0 = 2 * evaluateDerivative(first_[n], 0),
                     dm = 2 * evaluateDerivative(second_[n], 0),
                     d1 = 2 * evaluateDerivative(second_[n], 1);
        columns[n] = {y0,
                      d0,
                      16 * m + 7 * r - 6 * d0 - 8 * dm - d1,
                      -32 * m - 34 * r + 13 * d0 + 32 * dm + 5 * d1,
                      16 * m + 52 * r - 12 * d0 - 40 * dm - 8 * d1,
                      -24 * r + 4 * d0 + 16 * dm + 4 * d1};
    }
    const StepEnds ends{.h = h_, .start = start_, .end = end_, .startSlope = {}, .endSlope = {}};
    integratePositions(columns, system_.integrals(), ends);
}

bool StepDoubling::proceed(std::span<const double> y) {
    t_ += h_;
    start_.assign(y.begin(), y.end());
    innerAtStart_ = true;
    const bool finite = inner_->proceed(y);
    takeCounts();
    slope_.assign(inner_->slope().begin(), inner_->slope().end());
    return finite;
}

} // namespace solution
