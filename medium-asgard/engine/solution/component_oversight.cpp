// What a component's long steps might pass over; see oversight/
#include "solution/component.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace solution {

namespace {

// Times what a step may err by: what a difference between rates and polynomials does to a value
// until the next watched time. Polynomials between the ends of a step are a little worse than the
// ends.
constexpr double allowed = 10;

} // namespace

// Implicit methods meet rates that are large beside what a step may err by: between watched times
// nothing is held against their polynomials, and what can peak takes steps that see it. For
// explicit ones the limit follows the tolerance, as steps of order 8 do: runs that are compared
// would take the same steps where no error shows, and err by the same.
double Component::longest() const {
    if (!options_.isWatched || options_.fixedStep)
        return infinity;
    if (method_->implicit())
        return equations_->bound()->canPeak ? watched_.longestThatSees(time_)
                                            : watched_.longest(time_);
    return longestPart_ * watched_.longest(time_);
}

// The rates at t are those of the step's polynomials.
bool Component::isFollowed(double t, double h, double spacing) {
    std::vector<double> y(columns_.size()), rates(y.size());
    const double s = (t - time_) / h;
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = evaluate(columns_[i], s);
    ++counts_.evaluations;
    if (!equations_->rates(t, y, rates))
        return false;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double defect = rates[i] - evaluateDerivative(columns_[i], s) / h;
        if (!(std::abs(defect) * std::min(h, spacing) <= allowed * control_.scale(i)))
            return false;
    }
    return true;
}

bool Component::hasCentres() const {
    return options_.isWatched && !options_.fixedStep && equations_->bound()->canPeak &&
           !equations_->model().peaks().ratios.empty();
}

// Times in (origin, until) at which there may be the middle of a peak, however narrow.
std::vector<double> Component::centresIn(std::span<const Coefficients> states, double origin,
                                         double scale, double until) {
    return hasCentres() ? centresOf(equations_->model().peaks(), states, origin, scale, until)
                        : std::vector<double>();
}

std::vector<double> Component::centresOf(const ComponentModel::PeakFunctions& peaks,
                                         std::span<const Coefficients> states, double origin,
                                         double scale, double until) {
    std::vector<double> y(states.size()), rates(states.size());
    const auto valuesAt = [&](double t, std::span<double> values) {
        const double s = (t - origin) / scale;
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] = evaluate(states[i], s);
            rates[i] = evaluateDerivative(states[i], s) / scale;
        }
        equations_->peakCauses(peaks, t, y, rates, values);
    };
    return centresPassed(peaks.ratios, peaks.arePolynomials, valuesAt, origin, until);
}

// Something is so much larger at t than at both ends of the step that its stages need not have seen
// it.
bool Component::towers(double t, double h) {
    constexpr double times = 16;
    const std::size_t heights = equations_->model().peaks().heights.tape().outputs();
    const auto heightsAt = [&](double at) {
        std::vector<double> y(columns_.size()), values(heights);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(columns_[i], (at - time_) / h);
        equations_->peakHeights(at, y, values);
        return values;
    };
    const std::vector<double> before = heightsAt(time_), here = heightsAt(t),
                              after = heightsAt(time_ + h);
    for (std::size_t k = 0; k < here.size(); ++k)
        if (!(std::abs(here[k]) <= times * std::max(std::abs(before[k]), std::abs(after[k]))))
            return true;
    return false;
}

// What peaks by something odd, as the force of a hill that is exp(-u^2) high, is 0 in its middle
// and large beside it: the first such time at the middle or at ever smaller distances from it.
std::optional<double> Component::besideCentre(double middle, double until,
                                              const std::function<bool(double)>& holds) const {
    constexpr double nearer = 0.25;
    constexpr int distances = 22; // down to a 1e-13th of the widest
    if (middle < until && holds(middle))
        return middle;
    double away = std::max(middle - time_, until - middle);
    for (int i = 0; i < distances; ++i, away *= nearer)
        for (const double t : {middle - away, middle + away})
            if (t > time_ && t < until && t != middle && holds(t))
                return t;
    return std::nullopt;
}

// The first time up to `until` in a step of length h at which something may peak that the step has
// not seen. Where it is cut short, by a switch, may be the middle of exp(-abs(t-60)/0.01).
std::optional<double> Component::overlooked(double h, double until) {
    if (!options_.isWatched || options_.fixedStep || !equations_->bound()->canPeak)
        return std::nullopt;
    const double spacing = watched_.spacing(until);
    const bool isSuspect = time_ < suspect_ && suspect_ < until;
    if (!method_->implicit() && (h > spacing || isSuspect))
        for (const double t : watched_.between(time_, until))
            if (!isFollowed(t, h, spacing))
                return t;
    // A step that ends in a middle has one side of the peak, and the next one the other.
    constexpr double further = 0.25;
    const bool seesFurther = until == time_ + h && !equations_->readsInputs();
    std::vector<double> centres =
        centresIn(columns_, time_, h, seesFurther ? until + further * h : until);
    if (until < time_ + h && !equations_->sliding())
        centres.push_back(until);
    const auto isPassedOver = [&](double t) {
        return method_->implicit() ? towers(t, h) : !isFollowed(t, h, spacing);
    };
    for (const double t : centres)
        if (const auto at = besideCentre(t, until, isPassedOver))
            return at;
    // Between two edges may lie what is 0 on both ends.
    for (std::size_t k = 1; method_->implicit() && k < centres.size(); ++k)
        if (const double t = std::midpoint(centres[k - 1], centres[k]);
            t < until && !isFollowed(t, h, spacing))
            return t;
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

// What leaves a surface slowly, as two bodies that touch and are pressed together ever harder, is
// carried across it and back by rounding alone, which shorter steps do not change.
std::optional<Violation> Component::violationOfStep(double to, double h) {
    auto found = violation(time_, to, h, columns_);
    std::vector<double> y(columns_.size());
    for (std::size_t k = 0; found && k < equations_->watches(); ++k) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(columns_[i], (found->time - time_) / h);
        if (!equations_->grazesByRounding(*found, found->time, y))
            break;
        found = violation(time_, to, h, columns_);
    }
    return found;
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
