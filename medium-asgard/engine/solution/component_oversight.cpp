// What a component's long steps might pass over; see oversight.h.
#include "solution/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// Times what a step may err by: what a difference between rates and polynomials does to a value
// until the next watched time. Polynomials between the ends of a step are a little worse than the
// ends.
constexpr double allowed = 10;

} // namespace

// Implicit methods meet rates that are large beside what a step may err by: nothing is held against
// their polynomials, and what can peak takes steps that see it.
double Component::longest() const {
    if (!options_.isWatched || options_.fixedStep)
        return infinity;
    return method_->implicit() && equations_->bound()->canPeak ? watched_.longestThatSees(time_)
                                                               : watched_.longest(time_);
}

// The first watched time in a step of length h at which the rates are not those of its polynomials.
std::optional<double> Component::overlooked(double h, double until) {
    const double spacing = watched_.spacing(until);
    const bool isSuspect = time_ < suspect_ && suspect_ < until;
    if (!options_.isWatched || options_.fixedStep || method_->implicit() ||
        !equations_->bound()->canPeak || (h <= spacing && !isSuspect))
        return std::nullopt;
    std::vector<double> y(columns_.size()), rates(y.size());
    for (const double t : watched_.between(time_, until)) {
        const double s = (t - time_) / h;
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(columns_[i], s);
        ++counts_.evaluations;
        if (!equations_->rates(t, y, rates))
            return t;
        for (std::size_t i = 0; i < y.size(); ++i) {
            const double defect = rates[i] - evaluateDerivative(columns_[i], s) / h;
            if (!(std::abs(defect) * std::min(h, spacing) <= allowed * control_.scale(i)))
                return t;
        }
    }
    return std::nullopt;
}

void Component::lookCloser(double at, double h) {
    ++counts_.rejectedSteps;
    suspect_ = at;
    proposed_ = 0.5 * h;
    keepCounts();
    if (proposed_ > shortestStep(time_))
        return;
    std::vector<double> rates(columns_.size());
    stopAtUnderflow(equations_->rates(at, stateValues(), rates) ? Attempt::Outcome::errorTooLarge
                                                                : Attempt::Outcome::notFinite,
                    h);
}

// A motion that starts on a surface, or next to it, and leaves it by less than a step may err by:
// polynomials cross it there and back, and shorter steps do not. Where rates amplify what
// polynomials may err by, they tell nothing.
bool Component::isInvented(const Violation& found, double h) {
    constexpr int patience = 16;
    if (options_.fixedStep || method_->implicit() || invented_ >= patience ||
        0.5 * h <= shortestStep(time_))
        return false;
    std::vector<double> y(columns_.size());
    const double s = (found.time - time_) / h;
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = evaluate(columns_[i], s);
    if (found.time <= time_) { // what a switch put on the wrong side is not there by an error
        std::vector<double> values(equations_->watches());
        equations_->watch(time_, y, values);
        if (std::ranges::any_of(found.watches, [&](std::size_t k) { return values[k] < 0; }))
            return false;
    }
    if (!equations_->contradicts(found, found.time, y))
        return false;
    ++invented_;
    return true;
}

} // namespace solution
