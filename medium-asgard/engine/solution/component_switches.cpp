// Where a component's switches are passed, and what becomes of it there; see component.h and
// component_equations.h.
#include "solution/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

std::optional<Violation> Component::violation(double from, double to, double scale,
                                              std::span<const Coefficients> columns) {
    if (equations_->watches() == 0)
        return std::nullopt;
    const double origin = from;
    std::vector<double> y(columns.size());
    const auto watch = [&](double t, std::span<double> values) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(columns[i], (t - origin) / scale);
        equations_->watch(t, y, values);
    };
    // What switches for a moment only is looked at in its middle.
    const ComponentModel::PeakFunctions& peaks = equations_->model().guardPeaks();
    std::vector<double> ends;
    if (!peaks.ratios.empty())
        ends = centresOf(peaks, columns, from, scale, to);
    ends.push_back(to);
    for (const double end : ends) {
        if (auto found = firstViolation(equations_->watches(), watch, from, end))
            return found;
        from = end;
    }
    return std::nullopt;
}

void Component::pass(const Violation& violation, bool immediate) {
    const auto giveUp = [&] {
        const std::vector<std::size_t> flipping = equations_->unknownsOf(violation);
        end(Stop::Reason::decisions, flipping.empty() ? std::vector<std::size_t>{0} : flipping,
            "expressions that switch with " + switchingWith(violation) +
                " switch to and fro here and no time goes on: each branch leads back into the "
                "other, and no motion between them was found");
    };
    ++counts_.switches;
    if (immediate) {
        if (switches_.addAtOnce() > 8 * equations_->watches() + 8)
            return giveUp();
    } else {
        switches_.add(time_, equations_->surfacesOf(violation));
        if (switches_.isEndless(time_))
            return giveUp();
    }
    std::vector<double> y = stateValues();
    equations_->inputs().window(infinity);
    if ((immediate || !comesToRest(y)) &&
        equations_->cross(violation, time_, y, passing(violation, immediate)) ==
            ComponentEquations::Crossing::impossible)
        return giveUp();
    setStates(y);
    takeHeldValues();
    settle();
}

// At time_, which may be the limit too.
void Component::passWhereItIs(const Violation& violation) {
    pass(violation, false);
    if (!stop_ && time_ >= limit_)
        arrive();
}

// On other branches from here on.
void Component::settle() {
    if (stop_)
        return;
    keepCounts();
    model_ = Model::undecided;
    proposed_ = 0;
    writer_.beginAnew();
    remember();
    placeAnchor();
}

std::string Component::switchingWith(const Violation& violation) const {
    const std::vector<std::size_t> own = equations_->unknownsOf(violation);
    std::string text = own.empty() ? "" : names(own);
    for (const std::size_t unknown : equations_->inputsOf(violation))
        text += (text.empty() ? "" : ", ") + set_->unknowns[unknown].name;
    return text.empty() ? "the time" : text;
}

// On all surfaces about which it swung, where that is no farther away than a step may err by. Or on
// those that it passes in turn about a point where all of them meet: what a switching curve leads
// to its end goes to and fro there by what counts as standing on a surface.
bool Component::comesToRest(std::vector<double>& y) {
    const bool shrinks = switches_.swingsShrink(time_, phasesFrom_);
    if (!shrinks && !switches_.goesToAndFro(time_, phasesFrom_))
        return false;
    const std::vector<std::size_t> surfaces = switches_.surfacesOfLast();
    if (surfaces.size() < 2 || (!shrinks && !equations_->standsOn(surfaces, time_, y)))
        return false;
    control_.prepare(y, time_ - switches_.timeOfLast());
    std::vector<double> reach(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        reach[i] = control_.scale(i);
    if (!equations_->holdOn(surfaces, time_, reach, y))
        return false;
    switches_.rest(time_);
    return true;
}

// Across, unless that went to and fro without time going on; or hardly, where rounding crosses a
// surface that the motion touches. Near such a place it stays on it only once: what comes back to
// its surface at ever shorter intervals has no motion beyond their end.
ComponentEquations::Passing Component::passing(const Violation& violation, bool immediate) {
    using enum ComponentEquations::Passing;
    if (immediate && violation.time > time_)
        return leaves;
    if (immediate && switches_.atOnce() == patience() + 1)
        return solved;
    if (immediate)
        return switches_.atOnce() > 2 * patience() ? stays
               : switches_.atOnce() > patience()   ? stands
                                                   : across;
    if (!switches_.hasSwitched(time_) || switches_.swingsShrink(time_, phasesFrom_) ||
        switches_.hasStayedNear(time_))
        return across;
    switches_.stay(time_);
    return stays;
}

// The motion stood on a surface at time_, and has left it within the step that ends in `found`: the
// side on which it is then holds from time_ on. Where that was tried in vain it stays.
bool Component::leaves(const Violation& found, double scale,
                       std::span<const Coefficients> columns) {
    if (switches_.atOnce() > 2 * patience() || switches_.staysAt(time_))
        return false;
    std::vector<double> y(columns.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = evaluate(columns[i], (found.time - time_) / scale);
    return equations_->looksAhead(found, found.time, y);
}

// A branch that has no value beyond its end, as that of a root whose argument max() bounds, lets no
// step look across. Within some of the shortest steps of its end the motion goes on along its rates
// to beyond it.
bool Component::stepAcross(double h) {
    constexpr double steps = 8;
    const double across = std::min(steps * h, limit_ - time_);
    std::vector<double> y = stateValues(), slopes(y.size());
    std::vector<double> here(equations_->watches()), beyond(here.size());
    if (here.empty() || !equations_->rates(time_, y, slopes))
        return false;
    equations_->watch(time_, y, here);
    std::vector<Coefficients> line(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i) {
        line[i][0] = y[i];
        line[i][1] = across * slopes[i];
        y[i] += line[i][1];
    }
    const double to = time_ + across;
    if (equations_->rates(to, y, slopes))
        return false;
    equations_->watch(to, y, beyond);
    Violation violation{.time = to, .watches = {}};
    for (std::size_t k = 0; k < here.size(); ++k)
        if (here[k] >= 0 && beyond[k] < 0)
            violation.watches.push_back(k);
    if (violation.watches.empty())
        return false;
    append(line, across, to);
    y_ = y;
    if (!land(to))
        return true;
    passWhereItIs(violation);
    return true;
}

// A step may end beyond a switch by so little that it counts as before it. Where the old branch has
// no value there, the switch is passed.
bool Component::passByRounding() {
    const std::vector<double> y = stateValues();
    std::vector<double> values(equations_->watches()), slopes(y.size());
    if (values.empty() || equations_->rates(time_, y, slopes))
        return false;
    equations_->watch(time_, y, values);
    Violation violation{.time = time_, .watches = {}};
    for (std::size_t k = 0; k < values.size(); ++k)
        if (values[k] < 0)
            violation.watches.push_back(k);
    if (violation.watches.empty())
        return false;
    passWhereItIs(violation);
    return true;
}

// What has no rate from some time on, as sqrt(1-t), goes along its rates to the last time at which
// it has one: the motion up to there needs no value beyond.
bool Component::reachLastRate(double h) {
    const std::vector<double> y = stateValues();
    std::vector<double> slopes(y.size()), rates(y.size());
    if (!equations_->rates(time_, y, slopes))
        return false;
    y_.resize(y.size());
    const auto hasRates = [&](double t) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y_[i] = y[i] + (t - time_) * slopes[i];
        return equations_->rates(t, y_, rates);
    };
    double last = time_, beyond = std::min(time_ + h, limit_);
    if (hasRates(beyond) || equations_->slidingFailed())
        return false;
    for (double t = last + 0.5 * (beyond - last); last < t && t < beyond;
         t = last + 0.5 * (beyond - last))
        (hasRates(t) ? last : beyond) = t;
    if (last <= time_ || !hasRates(last))
        return false;
    const double way = last - time_;
    control_.prepare(y, h);
    std::vector<Coefficients> line(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i) {
        line[i][0] = y[i];
        line[i][1] = way * slopes[i];
        if (!(std::abs(line[i][1]) <= control_.scale(i)))
            return false;
    }
    append(line, way, last);
    keepCounts();
    (void)land(last);
    return true;
}

} // namespace solution
