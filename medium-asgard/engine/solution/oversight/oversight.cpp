#include "oversight/oversight.h"

#include "oversight/peak_centres.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace solution {

namespace {

// Times the error that a step may have: what a difference between rates and polynomials does to a
// value until the next watched time. Polynomials between the ends of a step are a little worse than
// the ends.
constexpr double allowed = 10;

// A step of length h = step.curves.scale, as its checks see it.
class Check {
public:
    Check(const ReviewedStep& step, ComponentEquations& equations, const ErrorControl& control,
          double spacing, std::size_t& evaluations)
        : curves_(step.curves), equations_(equations), control_(control), spacing_(spacing),
          evaluations_(evaluations) {}

    // The rates at t are those of the step's polynomials.
    [[nodiscard]] bool isFollowed(double t) {
        const double h = curves_.scale;
        std::vector<double> y(curves_.columns.size()), rates(y.size());
        const double s = (t - curves_.origin) / h;
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(curves_.columns[i], s);
        ++evaluations_;
        if (!equations_.rates(t, y, rates))
            return false;
        for (std::size_t i = 0; i < y.size(); ++i) {
            const double defect = rates[i] - evaluateDerivative(curves_.columns[i], s) / h;
            if (!(std::abs(defect) * std::min(h, spacing_) <= allowed * control_.scale(i)))
                return false;
        }
        return true;
    }

    // Something is so much larger at t than at both ends of the step that its stages need not have
    // seen it.
    [[nodiscard]] bool towers(double t) {
        constexpr double times = 16;
        const std::vector<double> before = heightsAt(curves_.origin), here = heightsAt(t),
                                  after = heightsAt(curves_.origin + curves_.scale);
        for (std::size_t k = 0; k < here.size(); ++k)
            if (!(std::abs(here[k]) <= times * std::max(std::abs(before[k]), std::abs(after[k]))))
                return true;
        return false;
    }

    // An odd peak, as the force of a hill that is exp(-u^2) high, is 0 in its middle and large
    // beside it: the first such time at the middle or at ever smaller distances from it.
    [[nodiscard]] std::optional<double>
    besideCentre(double middle, const std::function<bool(double)>& holds) const {
        constexpr double nearer = 0.25;
        constexpr int distances = 22; // down to a 1e-13th of the widest
        const double from = curves_.origin, until = curves_.until;
        if (middle < until && holds(middle))
            return middle;
        double away = std::max(middle - from, until - middle);
        for (int i = 0; i < distances; ++i, away *= nearer)
            for (const double t : {middle - away, middle + away})
                if (t > from && t < until && t != middle && holds(t))
                    return t;
        return std::nullopt;
    }

private:
    [[nodiscard]] std::vector<double> heightsAt(double t) {
        const std::size_t heights = equations_.model().peaks().heights.tape().outputs();
        std::vector<double> y(curves_.columns.size()), values(heights);
        curves_.at(t, y);
        equations_.functions().peakHeights(t, y, values);
        return values;
    }

    const StateCurves& curves_;
    ComponentEquations& equations_;
    const ErrorControl& control_;
    double spacing_;
    std::size_t& evaluations_;
};

} // namespace

std::vector<double> centresOf(ComponentEquations& equations,
                              const ComponentModel::PeakFunctions& peaks,
                              const StateCurves& curves) {
    const auto [states, origin, scale, until] = curves;
    std::vector<double> y(states.size()), rates(states.size());
    const auto valuesAt = [&, states = states, origin = origin,
                           scale = scale](double t, std::span<double> values) {
        const double s = (t - origin) / scale;
        for (std::size_t i = 0; i < y.size(); ++i) {
            y[i] = evaluate(states[i], s);
            rates[i] = evaluateDerivative(states[i], s) / scale;
        }
        equations.functions().peakCauses(peaks, t, y, rates, values);
    };
    return centresPassed(peaks.ratios, peaks.arePolynomials, valuesAt, origin, until);
}

// The limit of explicit steps follows the tolerance, as steps of order 8 do: runs that are compared
// would take the same steps where no error shows, and err by the same.
Oversight::Oversight(const How& how)
    : how_(how), watched_(how.start),
      longestPart_(std::pow(std::min(how.tolerance, 1.0), 1.0 / 8)) {}

// Implicit methods meet rates that are large beside the error that a step may have: between watched
// times nothing is held against their polynomials, and equations that can peak take steps that see
// the peaks.
double Oversight::longest(double t, const ComponentEquations& equations, bool isImplicit) const {
    if (!how_.isWatched || how_.isFixed)
        return infinity;
    if (isImplicit)
        return equations.bound()->canPeak ? watched_.longestThatSees(t) : watched_.longest(t);
    return longestPart_ * watched_.longest(t);
}

bool Oversight::hasCentres(const ComponentEquations& equations) const {
    return how_.isWatched && !how_.isFixed && equations.bound()->canPeak &&
           !equations.model().peaks().ratios.empty();
}

void Oversight::prepare(double t, const ComponentEquations& equations, bool isImplicit,
                        ErrorControl& control) const {
    if (hasCentres(equations) && !isImplicit)
        control.countSpeedsOver(watched_.spacing(t));
}

std::vector<double> Oversight::centresIn(ComponentEquations& equations,
                                         const StateCurves& curves) const {
    return hasCentres(equations) ? centresOf(equations, equations.model().peaks(), curves)
                                 : std::vector<double>();
}

std::optional<double> Oversight::verdict(const ReviewedStep& step, ComponentEquations& equations,
                                         ErrorControl& control, std::size_t& evaluations) {
    if (step.found && isInvented(step, equations)) {
        suspect_ = step.curves.origin;
        return suspect_;
    }
    if (step.passesAtOnce)
        return std::nullopt;
    if (const auto at = overlooked(step, equations, control, evaluations)) {
        control.countSpeedsOver(watched_.spacing(*at));
        suspect_ = *at;
        return suspect_;
    }
    invented_ = 0;
    return std::nullopt;
}

// A motion that starts on a surface, or next to it, and leaves it by less than a step may err by:
// polynomials cross it there and back, and shorter steps do not. Where rates amplify the errors of
// polynomials, they tell nothing.
bool Oversight::isInvented(const ReviewedStep& step, ComponentEquations& equations) {
    constexpr int patience = 16;
    const StateCurves& curves = step.curves;
    if (how_.isFixed || step.isImplicit || invented_ >= patience ||
        0.5 * curves.scale <= step.shortest)
        return false;
    const Violation& found = *step.found;
    std::vector<double> y(curves.columns.size());
    curves.at(found.time, y);
    if (found.time <= curves.origin) { // a switch that put it on the wrong side is no error
        std::vector<double> values(equations.watches());
        equations.guards().watch(curves.origin, y, values);
        if (std::ranges::any_of(found.watches, [&](std::size_t k) { return values[k] < 0; }))
            return false;
    }
    if (!equations.guards().contradicts(found, found.time, y))
        return false;
    ++invented_;
    return true;
}

// The first time up to its end at which something may peak that the step has not seen. Where it is
// cut short, by a switch, may be the middle of exp(-abs(t-60)/0.01).
std::optional<double> Oversight::overlooked(const ReviewedStep& step, ComponentEquations& equations,
                                            const ErrorControl& control,
                                            std::size_t& evaluations) const {
    if (!how_.isWatched || how_.isFixed || !equations.bound()->canPeak)
        return std::nullopt;
    const double from = step.curves.origin, h = step.curves.scale, until = step.curves.until;
    const double spacing = watched_.spacing(until);
    const bool isSuspect = from < suspect_ && suspect_ < until;
    Check check(step, equations, control, spacing, evaluations);
    if (!step.isImplicit && (h > spacing || isSuspect))
        for (const double t : watched_.between(from, until))
            if (!check.isFollowed(t))
                return t;
    // A step that ends in a middle has one side of the peak, and the next one the other.
    constexpr double further = 0.25;
    const bool seesFurther = until == from + h && !equations.readsInputs();
    StateCurves seen = step.curves;
    if (seesFurther)
        seen.until = until + further * h;
    std::vector<double> centres = centresIn(equations, seen);
    if (until < from + h && !equations.sliding())
        centres.push_back(until);
    const auto isPassedOver = [&](double t) {
        return step.isImplicit ? check.towers(t) : !check.isFollowed(t);
    };
    for (const double t : centres)
        if (const auto at = check.besideCentre(t, isPassedOver))
            return at;
    // Between two edges may lie something that is 0 on both ends.
    for (std::size_t k = 1; step.isImplicit && k < centres.size(); ++k)
        if (const double t = std::midpoint(centres[k - 1], centres[k]);
            t < until && !check.isFollowed(t))
            return t;
    return std::nullopt;
}

} // namespace solution
