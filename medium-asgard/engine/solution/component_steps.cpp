// How a component steps; see component.h and solver.h.
#include "integrators/methods.h"
#include "solution/component.h"
#include "solution/pace.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// A step crosses at most so many joints of an input: dense output is only as smooth as its joints
// allow, and upstream components need not be solved far beyond what anyone asked for.
constexpr std::size_t mostJoints = 8;

} // namespace

// ---------------------------------------------------------------------------------------------
// How far may the next step go?

std::optional<std::size_t> Component::waitsFor() {
    limit_ = nextPhase_;
    limitRestarts_ = false;
    ends_.reset();
    // A model in closed form, and the choice of a first step, look at one piece of each input.
    const bool single = model_ != Model::integrated || !method_;
    const double target = single ? infinity : time_ + landingOf(options_) * proposed_;
    const std::vector<std::size_t>& read = equations_->inputs().unknowns();
    lookedAt_.resize(read.size());
    for (std::size_t i = 0; i < read.size(); ++i)
        if (const auto waiting = look(read[i], target, single ? 1 : mostJoints, lookedAt_[i]))
            return waiting;
    return std::nullopt;
}

// `near`: the input's step that holds the time, where it is looked for first.
std::optional<std::size_t> Component::look(std::size_t unknown, double target, std::size_t joints,
                                           std::size_t& near) {
    const History& input = *histories_.place(unknown, time_).history;
    const auto mayEndAt = [this](double t, bool restarts) {
        if (t < limit_ || (t == limit_ && restarts)) {
            limit_ = t;
            limitRestarts_ = restarts;
            ends_.reset();
        }
    };
    std::size_t passed = 0;
    near = input.find(time_, near);
    for (std::size_t i = near; i + 1 < input.size(); ++i) {
        const History::Step next = input.step(i + 1);
        if (next.origin <= time_)
            continue;
        if (next.fresh || ++passed == joints) {
            mayEndAt(next.origin, next.fresh);
            return std::nullopt;
        }
        if (next.origin >= std::min(limit_, target))
            return std::nullopt;
    }
    const double until = input.until();
    if (histories_.stop(unknown)) {
        if (until < limit_) {
            mayEndAt(until, false);
            ends_ = unknown;
        }
        return std::nullopt;
    }
    if (joints == 1 && until > time_) { // its one piece is known
        mayEndAt(until, false);
        return std::nullopt;
    }
    // Beyond the target, not just to it: an event there must be known before the step is made.
    if (until <= time_ || (until < limit_ && until <= target))
        return unknown;
    return std::nullopt;
}

// ---------------------------------------------------------------------------------------------
// One step

void Component::step() {
    if (ends_ && limit_ <= time_) {
        end(Stop::Reason::inputEnded, {},
            names({0}) + " reads " + set_->unknowns[*ends_].name + ", whose motion ended");
        stop_->culprits.push_back(*ends_);
        return;
    }
    if (history_.size() > options_.maximumSteps) { // what events threw away does not count
        end(Stop::Reason::tooManySteps, {},
            names({0}) + " took more than " + std::to_string(options_.maximumSteps) +
                " steps up to here");
        return;
    }
    if (isHopeless()) {
        end(Stop::Reason::tooLong, {},
            names({0}) + " changes so fast that the finish is more than a billion steps away");
        return;
    }
    equations_->inputs().window(limit_);
    if (limit_ - time_ <= shortestStep(time_)) { // a sliver that rounding left
        const std::vector<double> y = stateValues();
        std::vector<Coefficients> still(y.size(), Coefficients{});
        for (std::size_t i = 0; i < y.size(); ++i)
            still[i][0] = y[i];
        append(still, 1, limit_);
        time_ = limit_;
        arrive();
        return;
    }
    if (model_ == Model::undecided)
        decideModel();
    if (stop_ || time_ == infinity)
        return;
    if (model_ == Model::closedForm)
        stepClosedForm();
    else if (model_ == Model::linear)
        stepLinear();
    else if (model_ == Model::held)
        stepHeld();
    else
        integrate();
}

// Looked at after so many steps, twice, four times as many, and so on.
bool Component::isPaceDue() const {
    constexpr std::size_t least = 16'384;
    const std::size_t n = history_.size();
    return n >= least && (n & (n - 1)) == 0;
}

// A motion by itself, on equations that never change, has one pace. Others may change theirs: there
// as many steps are made first as a burst is likely to need.
bool Component::isHopeless() {
    constexpr std::size_t burst = 2'097'152;
    const std::size_t n = history_.size();
    if (!isPaceDue())
        return false;
    const bool mayChange = nextPhase_ < infinity || !equations_->model().surfaces().empty() ||
                           equations_->hasDirections() || !equations_->inputs().unknowns().empty();
    if (mayChange && n < burst)
        return false;
    const auto at = [this](std::size_t step) { return history_.step(step).origin; };
    const double beyond = farthestFinish(n, {.start = at(0),
                                             .first = at(n / 4),
                                             .second = at(n / 2),
                                             .third = at(3 * n / 4),
                                             .now = time_});
    hopelessBeyond_ = std::min(hopelessBeyond_, beyond);
    return options_.finish > beyond;
}

// ---------------------------------------------------------------------------------------------
// Integration

std::unique_ptr<Method> Component::chooseMethod() {
    const bool choose = options_.method == "auto";
    const std::string name = !choose ? options_.method : choice_.implicit() ? "radau5" : "dop853";
    return makeMethod(name, *equations_, control_, options_.fixedStep.has_value());
}

// Where rates are next to 0 by chance, as those of a rectified drive, they say nothing of how long
// a step may be: the steps before do.
double Component::longestFirst() const {
    constexpr std::size_t asked = 8;
    constexpr double times = 16;
    double longest = 0;
    for (std::size_t k = history_.size(); k-- > 0 && k + asked >= history_.size();)
        if (const auto step = history_.step(k); step.until > step.origin) // no anchor
            longest = std::max(longest, step.scale);
    return longest > 0 ? times * longest : infinity;
}

bool Component::beginMethod() {
    method_ = chooseMethod();
    const bool quadrature = equations_->states().size() == 1 && !equations_->readsStates();
    counts_.method = method_->name();
    counts_.order = method_->order();
    counts_.model = method_->implicit() ? "implicit" : quadrature ? "quadrature" : "explicit";
    mayChange_ = options_.method == "auto" && counts_.model != "quadrature";
    counts_.why = options_.method != "auto" ? "asked for"
                  : method_->implicit()     ? "stiffness bounds explicit steps"
                  : quadrature              ? "a function of time and of what is solved upstream"
                                            : "explicit steps cost less than implicit ones";
    const std::vector<double> y = stateValues();
    if (!method_->begin(time_, y)) {
        endWithoutRate(time_, y);
        return false;
    }
    if (options_.fixedStep)
        proposed_ = *options_.fixedStep;
    else if (proposed_ == 0)
        proposed_ = options_.firstStep.value_or(
            method_->firstStep(std::min(limit_ - time_, longestFirst())));
    strides_ = mayStride();
    return true;
}

void Component::integrate() {
    if (equations_->hasDirections() && reachesRest())
        return;
    if (!method_ && !beginMethod())
        return;
    if (hasCentres() && !method_->implicit())
        control_.countSpeedsOver(watched_.spacing(time_));
    for (;;) { // every refusal shortens the step, until it cannot be
        const double wanted =
            std::max(std::min({proposed_, longest(), restsAfter_}), shortestStep(time_));
        const bool lands = time_ + landingOf(options_) * wanted >= limit_;
        const double to = lands ? limit_ : time_ + wanted;
        const double h = to - time_;
        const Attempt attempt = method_->attempt(h);
        if (attempt.outcome != Attempt::Outcome::accepted) {
            if (!refuse(attempt, h))
                return;
            continue;
        }
        proposed_ = attempt.next;
        if (options_.fixedStep && restsAfter_ < infinity)
            proposed_ = *options_.fixedStep;
        if (lands && h < wanted)
            proposed_ = std::max(proposed_, options_.fixedStep ? *options_.fixedStep : wanted);
        finish(to);
        return;
    }
}

// False: no shorter step can be made from here as things are.
bool Component::refuse(const Attempt& attempt, double h) {
    ++counts_.rejectedSteps;
    if (attempt.outcome == Attempt::Outcome::notConverged)
        ++counts_.unconvergedSteps;
    const bool isWithout = attempt.outcome == Attempt::Outcome::notFinite;
    // Steps of fixed length too come to the end of a branch that has no value beyond it.
    const bool comesToEnd = isWithout && equations_->watches() > 0;
    if (comesToEnd && equations_->lookBeyond(time_, stateValues())) {
        proposed_ = h;
        return true;
    }
    const double next = options_.fixedStep ? (comesToEnd ? h / 4 : h) : attempt.next;
    if (next > shortestStep(time_) && next < h) {
        proposed_ = next;
        return true;
    }
    if (!(comesToEnd && (passByRounding() || stepAcross(h))) &&
        !(isWithout && !options_.fixedStep && reachLastRate(h)))
        stopAtUnderflow(attempt.outcome, h);
    return false;
}

void Component::stopAtUnderflow(Attempt::Outcome outcome, double h) {
    std::vector<double> y = stateValues(), slopes(y.size());
    const bool here = equations_->rates(time_, y, slopes);
    if (outcome == Attempt::Outcome::notFinite) {
        for (std::size_t i = 0; here && i < y.size(); ++i)
            y[i] += h * slopes[i];
        endWithoutRate(time_ + h, y);
        return;
    }
    std::size_t fastest = 0;
    for (std::size_t i = 1; i < y.size(); ++i)
        if (std::abs(slopes[i]) / control_.scale(i) >
            std::abs(slopes[fastest]) / control_.scale(fastest))
            fastest = i;
    const std::vector<std::size_t> culprit = {equations_->states()[fastest]};
    const bool unsolved = outcome == Attempt::Outcome::notConverged;
    end(unsolved ? Stop::Reason::notConverged : Stop::Reason::stepUnderflow, culprit,
        unsolved ? "the implicit equations of a step cannot be solved for " + names(culprit)
                 : "error control needs steps too short to resolve for " + names(culprit));
}

// The right-hand side has no value at t, y: which, or is it that nothing slides?
void Component::endWithoutRate(double t, std::span<const double> y) {
    std::vector<double> slopes(y.size());
    const bool finite = equations_->rates(t, y, slopes);
    if (!finite && equations_->slidingFailed()) {
        end(Stop::Reason::decisions, equations_->states(),
            "the motion can follow neither branch of the expressions that switch with " +
                names(equations_->states()) + ", nor a mean of the branches");
        return;
    }
    auto culprits = equations_->notFinite(t, y);
    if (culprits.empty())
        culprits = equations_->states();
    end(Stop::Reason::notFinite, culprits,
        names(culprits) + (culprits.size() > 1 ? " have" : " has") + " no finite rate");
}

void Component::finish(double to) {
    const double h = to - time_;
    columns_.resize(equations_->states().size());
    method_->dense(columns_);
    const auto found = violationOfStep(to, h);
    if (found && isInvented(*found, h)) {
        lookCloser(time_, h);
        return;
    }
    if (found && (found->time <= time_ || leaves(*found, h, columns_))) {
        pass(*found, true);
        return;
    }
    const double until = found ? found->time : to;
    if (const auto at = overlooked(h, until)) {
        control_.countSpeedsOver(watched_.spacing(*at));
        lookCloser(*at, h);
        return;
    }
    invented_ = 0;
    ++counts_.steps;
    ++counts_.integratedSteps;
    counts_.integratedFrom = std::min(counts_.integratedFrom, time_);
    y_.assign(method_->state().begin(), method_->state().end());
    if (found)
        for (std::size_t i = 0; i < y_.size(); ++i)
            y_[i] = evaluate(columns_[i], (until - time_) / h);
    append(columns_, h, until);
    if (!land(until))
        return;
    if (found) {
        passWhereItIs(*found);
        return;
    }
    if (!method_->proceed(y_)) {
        if (!passByRounding())
            endWithoutRate(time_, y_);
        return;
    }
    reconsider(h);
    if (time_ >= limit_)
        arrive();
}

// The states are y_ at `to`. False: the motion ends there.
bool Component::land(double to) {
    time_ = to;
    setStates(y_);
    normalize();
    takeHeldValues();
    if (stop_ || overflows())
        return false;
    if (!quaternions_.empty())
        takeStates(y_);
    control_.observe(y_);
    equations_->lookNoMoreBeyond();
    switches_.goOn();
    return true;
}

bool Component::overflows() {
    for (std::size_t i = 0; i < y_.size(); ++i)
        if (!(std::abs(y_[i]) <= largestValue)) {
            const std::vector<std::size_t> culprit = {equations_->states()[i]};
            end(Stop::Reason::overflow, culprit, names(culprit) + " grows over 1e100");
            return true;
        }
    return false;
}

void Component::arrive() {
    if (time_ >= nextPhase_) {
        openRegime(true);
        if (!stop_)
            begin();
    } else if (limitRestarts_) {
        begin();
    }
    // The end of an input is reported by the next step, which cannot be made.
}

// ---------------------------------------------------------------------------------------------
// Stiffness

void Component::reconsider(double h) {
    if (!mayChange_)
        return;
    const bool wasTrial = choice_.isTrial();
    if (choice_.changesAfter(*method_, h, control_.crossing()) ||
        (choice_.wantsSpectralRadius() && choice_.changesFor(spectralRadius(), h)))
        changeMethod();
    else if (wasTrial && !choice_.isTrial()) // it was won
        remember();
}

// Power iteration on the Jacobian, from a fixed vector; the mean growth of the last rounds, since
// complex pairs turn.
double Component::spectralRadius() {
    constexpr int rounds = 24, counted = 8;
    const Pattern& pattern = equations_->jacobianPattern();
    std::vector<double> entries(pattern.entries());
    if (!equations_->jacobian(time_, stateValues(), entries))
        return 0;
    std::vector<double> x(pattern.size()), image(pattern.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = 1 + 0.1 * static_cast<double>(i % 7);
    double growth = 0;
    for (int round = 0; round < rounds; ++round) {
        std::fill(image.begin(), image.end(), 0.0);
        for (std::size_t column = 0; column < x.size(); ++column)
            for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k) {
                const auto entry = static_cast<std::size_t>(k);
                image[static_cast<std::size_t>(pattern.rows[entry])] += entries[entry] * x[column];
            }
        double before = 0, after = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            before += x[i] * x[i];
            after += image[i] * image[i];
        }
        if (!(after > 0) || !std::isfinite(after))
            return 0;
        if (round >= rounds - counted)
            growth += 0.5 * std::log(after / before) / counted;
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] = image[i] / std::sqrt(after);
    }
    return std::exp(growth);
}

void Component::changeMethod() {
    keepCounts();
    remember();
    equations_->inputs().window(infinity);
    const double h = proposed_;
    if (beginMethod())
        proposed_ = h;
}

} // namespace solution
