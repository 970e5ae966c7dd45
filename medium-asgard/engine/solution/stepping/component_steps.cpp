// How a component steps, and passes its switches; see component.h and solver.h.
#include "stepping/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

std::optional<std::size_t> Component::waitsFor() {
    // A model in closed form, and the choice of a first step, look at one piece of each input.
    const bool single = !(models_.current() && models_.current()->looksAhead());
    const double until =
        single ? infinity : progress_.time + landingOf(around_.options) * progress_.proposed;
    return boundary_.find(around_.histories, equations_->inputs().unknowns(),
                          {progress_.time, until, single});
}

void Component::step() {
    if (endsBeforeStep())
        return;
    equations_->inputs().window(boundary_.limit());
    if (stepOverSliver())
        return;
    if (!models_.current()) {
        plainRate_.reset();
        if (unknowns_.size() == 1 && progress_.quaternions.empty() &&
            boundary_.phasesUntil() == infinity)
            plainRate_ = plainRateOf(*equations_);
        models_.decide(stepPlainly());
    }
    if (stop_ || progress_.time == infinity)
        return;
    take(models_.current()->propose());
}

bool Component::endsBeforeStep() {
    if (boundary_.ends() && boundary_.limit() <= progress_.time) {
        end(Stop::Reason::inputEnded, {},
            context_.names({0}) + " reads " + around_.set->unknowns[*boundary_.ends()].name +
                ", whose motion ended");
        stop_->culprits.push_back(*boundary_.ends());
    } else if (history()->size() > around_.options.maximumSteps) { // without steps thrown away
        end(Stop::Reason::tooManySteps, {},
            context_.names({0}) + " took more than " +
                std::to_string(around_.options.maximumSteps) + " steps up to here");
    }
    return stop_.has_value();
}

// Rounding left a sliver of time before the boundary: nothing moves in it.
bool Component::stepOverSliver() {
    const double limit = boundary_.limit();
    if (limit - progress_.time > shortestStep(progress_.time))
        return false;
    const std::vector<double> y = states();
    std::vector<Coefficients> still(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i)
        still[i][0] = y[i];
    accept({.curves = {still, progress_.time, 1, limit}});
    return true;
}

// A motion that goes on for ever needs no look at its equations.
bool Component::stepPlainly() {
    if (!plainRate_ || boundary_.limit() < infinity || around_.options.method != "auto")
        return false;
    const auto piece =
        plainPiece(*plainRate_, around_.histories, progress_.time, progress_.values[0]);
    if (!piece)
        return false;
    writer_.history()->dropAnchor();
    ++counts_.evaluations;
    writer_.append(piece->stepFrom(progress_.time), piece->numbers());
    progress_.time = infinity;
    return true;
}

// ---------------------------------------------------------------------------------------------
// Proposals of models

void Component::take(const Proposal& proposal) {
    if (const auto* piece = std::get_if<StepPiece>(&proposal)) {
        accept(*piece);
    } else if (const auto* at = std::get_if<SwitchAtOnce>(&proposal)) {
        pass(at->violation, true);
    } else if (const auto* ending = std::get_if<Ending>(&proposal)) {
        end(*ending);
    } else if (std::holds_alternative<NextModel>(proposal)) {
        models_.next();
        progress_.proposed = 0;
    }
}

// Every step of every model comes here.
void Component::accept(const StepPiece& piece) {
    write(piece);
    std::span<const double> y;
    if (piece.end) {
        y = *piece.end;
        if (!land(y))
            return;
    }
    if (piece.crossing) {
        pass(*piece.crossing, false);
    } else if (piece.endsAnew) {
        settle(piece.next);
    } else if (piece.end) {
        const auto afterwards = models_.current()->goOn(y);
        if (const auto* violation = std::get_if<Violation>(&afterwards))
            pass(*violation, false);
        else if (const auto* ending = std::get_if<Ending>(&afterwards))
            end(*ending);
    }
    if (!stop_ && progress_.time >= boundary_.limit() && progress_.time < infinity)
        arrive();
}

void Component::write(const StepPiece& piece) {
    if (piece.kind == StepPiece::Kind::nothing)
        return;
    using enum StepPiece::Kind;
    if (piece.kind == step || piece.kind == integrated)
        ++counts_.steps;
    if (piece.kind == integrated || piece.kind == atRest) {
        ++counts_.integratedSteps;
        counts_.integratedFrom = std::min(counts_.integratedFrom, progress_.time);
    }
    if (piece.held)
        writer_.append(piece.curves, *piece.held);
    else
        writer_.append(piece.curves, models_.held(), heldPart * context_.tolerance);
    progress_.time = piece.curves.until;
}

// The states are y here, and y what they become when quaternions are normalized and conditions are
// kept. False: the motion ends.
bool Component::land(std::span<const double>& y) {
    progress_.put(equations_->states(), y);
    progress_.normalize();
    if (!progress_.quaternions.empty() || !equations_->multipliers().empty()) {
        progress_.take(equations_->states(), progress_.ended);
        equations_->project(progress_.time, progress_.ended);
        endWhereContradictory();
        progress_.put(equations_->states(), progress_.ended);
        y = progress_.ended;
    }
    takeHeldValues();
    if (stop_ || overflows(y))
        return false;
    memory_.now.control.observe(y);
    equations_->lookNoMoreBeyond();
    switches_.goOn();
    return true;
}

bool Component::overflows(std::span<const double> y) {
    for (std::size_t i = 0; i < y.size(); ++i)
        if (!(std::abs(y[i]) <= largestValue)) {
            const std::vector<std::size_t> culprit = {equations_->states()[i]};
            end(Stop::Reason::overflow, culprit, context_.names(culprit) + " grows over 1e100");
            return true;
        }
    return false;
}

void Component::arrive() {
    if (progress_.time >= boundary_.phasesUntil()) {
        openRegime(true);
        if (!stop_) {
            begin();
            endWhereApart(equations_->apart());
        }
    } else if (boundary_.restarts()) {
        begin();
        endWhereApart(equations_->farApart());
    }
    // The end of an input is reported by the next step, which cannot be made.
}

void Component::takeStride(double h, double to, double next) {
    accept(models_.integration().takenStride(h, to, next));
}

void Component::endStride(const Attempt& attempt, double h) {
    if (const auto proposal = models_.integration().refuse(attempt, h))
        take(*proposal);
}

void Component::changeMethodAfterStride() {
    if (const auto ending = models_.integration().changeMethod())
        end(*ending);
}

// ---------------------------------------------------------------------------------------------
// Switches

void Component::pass(const Violation& violation, bool immediate) {
    const auto giveUp = [&](bool isEndless) {
        if (const auto bounded = equations_->boundedOf(violation); !bounded.empty()) {
            const std::string names = context_.names(bounded);
            return isEndless
                       ? end(Stop::Reason::bounds, bounded,
                             "no forces of " + names +
                                 " were found that last: what they hold opens, closes or slips "
                                 "without end, and no time goes on")
                       : end(Stop::Reason::unheld, bounded,
                             "no forces of " + names + " keep all that is to hold here");
        }
        const std::vector<std::size_t> flipping = equations_->guards().unknownsOf(violation);
        end(Stop::Reason::decisions, flipping.empty() ? std::vector<std::size_t>{0} : flipping,
            "expressions that switch with " + switchingWith(violation) +
                " switch to and fro here and no time goes on: each branch leads back into the "
                "other, and no motion between them was found");
    };
    ++counts_.switches;
    if (immediate) {
        if (switches_.addAtOnce() > 8 * equations_->watches() + 8)
            return giveUp(true);
    } else {
        switches_.add(progress_.time, equations_->guards().surfacesOf(violation));
        if (switches_.isEndless(progress_.time))
            return giveUp(true);
    }
    std::vector<double> y = states();
    equations_->inputs().window(infinity);
    equations_->forgetApart();
    if ((immediate || !comesToRest(y)) &&
        equations_->solver().cross(violation, progress_.time, y, passing(violation, immediate)) ==
            ComponentEquations::Crossing::impossible)
        return giveUp(false);
    endWhereApart(equations_->farApart());
    progress_.put(equations_->states(), y);
    takeHeldValues();
    releaseConditions();
    // Of the forces of contacts most are as they were; behind a stop, or the switch of an
    // expression, all may be others.
    const bool hasContacts = std::ranges::any_of(
        equations_->bound()->laws, [](const auto& law) { return law.leaving.has_value(); });
    settle(hasContacts ? progress_.proposed : 0);
}

// On other branches from here on; `next`: how long the next step may be, 0: not known.
void Component::settle(double next) {
    if (stop_)
        return;
    models_.forget();
    progress_.proposed = next;
    writer_.beginAnew();
    memory_.keep(progress_.time);
    placeAnchor();
}

std::string Component::switchingWith(const Violation& violation) const {
    const std::vector<std::size_t> own = equations_->guards().unknownsOf(violation);
    std::string text = own.empty() ? "" : context_.names(own);
    for (const std::size_t unknown : equations_->guards().inputsOf(violation))
        text += (text.empty() ? "" : ", ") + around_.set->unknowns[unknown].name;
    return text.empty() ? "the time" : text;
}

// On all surfaces about which it swung, where that is no farther away than the error that a step
// may have. Or on those that it passes in turn about a point where all of them meet: a motion that
// a switching curve leads to its end goes to and fro there by what counts as standing on a surface.
bool Component::comesToRest(std::vector<double>& y) {
    const double time = progress_.time, since = boundary_.phasesFrom();
    const bool shrinks = switches_.swingsShrink(time, since);
    if (!shrinks && !switches_.goesToAndFro(time, since))
        return false;
    const std::vector<std::size_t> surfaces = switches_.surfacesOfLast();
    if (surfaces.size() < 2 || (!shrinks && !equations_->solver().standsOn(surfaces, time, y)))
        return false;
    ErrorControl& control = memory_.now.control;
    control.prepare(y, time - switches_.timeOfLast());
    std::vector<double> reach(y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
        reach[i] = control.scale(i);
    if (!equations_->solver().holdOn(surfaces, time, reach, y))
        return false;
    switches_.rest(time);
    return true;
}

// Across, unless that went to and fro without time going on; or hardly, where rounding crosses a
// surface that the motion touches. Near such a place it stays on it only once: a motion that comes
// back to its surface at ever shorter intervals has no motion beyond their end.
ComponentEquations::Passing Component::passing(const Violation& violation, bool immediate) {
    using enum ModeSolver::Passing;
    const double time = progress_.time;
    const std::size_t patience = context_.patience(), atOnce = switches_.atOnce();
    if (immediate && violation.time > time)
        return leaves;
    if (immediate && atOnce == patience + 1)
        return solved;
    if (immediate)
        return atOnce > 2 * patience ? stays : atOnce > patience ? stands : across;
    if (!switches_.hasSwitched(time) || switches_.swingsShrink(time, boundary_.phasesFrom()) ||
        switches_.hasStayedNear(time))
        return across;
    switches_.stay(time);
    return stays;
}

} // namespace solution
