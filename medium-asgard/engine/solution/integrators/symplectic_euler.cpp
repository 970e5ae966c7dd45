#include "integrators/symplectic_euler.h"

#include "dense/dense_output.h"

namespace solution {

SymplecticEuler::SymplecticEuler(System& system, ErrorControl& control)
    : Method(system, control, true), at_(system.size()), rates_(system.size()) {
    end_.resize(system.size());
    slope_.resize(system.size());
}

bool SymplecticEuler::begin(double t, std::span<const double> y) {
    t_ = t;
    start_.assign(y.begin(), y.end());
    return rates(t, y, slope_);
}

Attempt SymplecticEuler::attempt(double h) {
    h_ = h;
    for (std::size_t n = 0; n < end_.size(); ++n)
        end_[n] = start_[n] + h * slope_[n];
    at_ = end_;
    for (const std::size_t n : system_.configuration())
        at_[n] = start_[n];
    if (!rates(t_ + h, at_, rates_))
        return {Attempt::Outcome::notFinite, 0.25 * h};
    for (const std::size_t n : system_.configuration())
        end_[n] = start_[n] + h * rates_[n];
    return {Attempt::Outcome::accepted, h};
}

void SymplecticEuler::dense(std::span<Coefficients> columns) {
    const StepEnds ends{.h = h_, .start = start_, .end = end_, .startSlope = {}, .endSlope = {}};
    lines(columns, ends);
    integratePositions(columns, system_.integrals(), ends);
}

bool SymplecticEuler::proceed(std::span<const double> y) {
    t_ += h_;
    start_.assign(y.begin(), y.end());
    return rates(t_, y, slope_);
}

} // namespace solution
