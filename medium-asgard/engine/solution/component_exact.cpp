// The least model that answers a component, and how those without an integrator go on; see
// component.h.
#include "solution/closed_form.h"
#include "solution/component.h"

#include "expression/operation.h"

#include <algorithm>
#include <cmath>

namespace solution {

void Component::decideModel() {
    const bool ladder = options_.method == "auto";
    findPlainRate();
    if ((ladder || equations_->states().empty()) && (stepPlainly() || tryClosedForm())) {
        model_ = Model::closedForm;
        counts_.model = "closed-form";
        counts_.method = "exact";
        counts_.why = "polynomials in time";
    } else if (equations_->states().empty()) {
        model_ = Model::held;
        counts_.model = "closed-form";
        counts_.method = "evaluation";
        counts_.why = "held by expressions";
    } else if (ladder && tryLinear()) {
        model_ = Model::linear;
        counts_.model = "linear";
        counts_.method = "exponential";
        counts_.why = "linear, with constant coefficients: exact at the ends of its pieces";
    } else {
        model_ = Model::integrated;
    }
}

bool Component::tryClosedForm() {
    return !equations_->sliding() && closedForm(*equations_, time_, stateValues()).has_value();
}

bool Component::tryLinear() {
    linear_.reset();
    lost_ = 0;
    if (equations_->states().size() > LinearMotion::mostStates || options_.fixedStep)
        return false;
    if (const auto form = linearForm(*equations_, time_))
        linear_ = std::make_unique<LinearMotion>(*form);
    return linear_ != nullptr;
}

// Now and then: does the motion of that piece disappear in what a step may err by? Then a method
// strides over what a stiff spring still trembles by, which has to be followed here. It damps what
// it strides over, and readers may amplify that: what is read stays exact.
bool Component::isUnseen(double h) {
    constexpr std::size_t interval = 512;
    if (isRead_ || history_.size() % interval != 0) // what events throw away does not count
        return false;
    control_.prepare(y_, h);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        double moved = 0;
        for (std::size_t k = 1; k <= maximumDegree; ++k)
            moved += std::abs(columns_[i][k]);
        if (moved > control_.scale(i))
            return false;
    }
    return true;
}

void Component::stepLinear() {
    takeStates(y_);
    columns_.resize(y_.size());
    const bool isLinear = time_ < linear_->until() || tryLinear();
    const double h = isLinear ? linear_->advance(y_, columns_) : 0;
    ++counts_.evaluations;
    // An input's next pieces are not constant, or rounding is too much.
    if (h == 0 || isUnseen(h)) {
        model_ = Model::integrated;
        proposed_ = 0;
        return;
    }
    // Pieces are as long as they are, and times are rounded: what that leaves is carried on, or a
    // million pieces would drift.
    const double ahead = h + lost_;
    const double until = std::min({time_ + ahead, limit_, linear_->until()});
    if (until < time_ + ahead)
        for (std::size_t i = 0; i < y_.size(); ++i)
            y_[i] = evaluate(columns_[i], (until - time_ - lost_) / h);
    append(columns_, h, until);
    lost_ = until < time_ + ahead ? 0 : ahead - (until - time_);
    if (land(until) && time_ >= limit_)
        arrive();
}

void Component::findPlainRate() {
    plainRate_.reset();
    if (unknowns_.size() != 1 || equations_->states().size() != 1 || equations_->watches() > 0 ||
        !quaternions_.empty() || nextPhase_ < infinity)
        return;
    const expression::Node rate = equations_->outputs()[0];
    if (equations_->graph().op(rate) == expression::Op::constant)
        plainRate_ = PlainRate{equations_->graph().value(rate), {}};
    else if (const auto constant = equations_->constantOf(rate))
        plainRate_ = PlainRate{*constant, {}};
    else if (const auto input = equations_->inputOf(rate))
        plainRate_ = PlainRate{0, equations_->inputs().unknowns()[*input]};
}

const Component::PlainRate* Component::plainRate() const {
    return model_ == Model::closedForm && plainRate_ && !stop_ && time_ == infinity ? &*plainRate_
                                                                                    : nullptr;
}

void Component::leave(double t) { counts_.discardedSteps += history_.cut(t); }

void Component::goOn(double origin, std::span<const double> coefficients) {
    while (coefficients.size() > 1 && coefficients.back() == 0)
        coefficients = coefficients.first(coefficients.size() - 1);
    writer_.append({origin, infinity, 1, true, static_cast<std::uint8_t>(coefficients.size())},
                   coefficients);
}

// From t on for ever, when its rate goes on so too.
std::optional<Component::PlainPiece> Component::plainPiece(double t, double value) const {
    PlainPiece piece;
    auto& [row, count, scale] = piece;
    row[0] = value;
    row[1] = plainRate_->constant;
    if (plainRate_->unknown) {
        const Piece rate = histories_.piece(*plainRate_->unknown, t);
        count = rate.coefficients.size() + 1;
        if (rate.until != infinity || rate.origin > t || count > row.size())
            return std::nullopt;
        scale = rate.scale;
        Coefficients shifted;
        std::span<const double> c = rate.coefficients;
        if (rate.origin != t)
            c = shifted = reparametrize(c, (t - rate.origin) / scale, 1);
        for (std::size_t k = 0; k + 1 < count; ++k)
            row[k + 1] = c[k] * scale / static_cast<double>(k + 1);
    }
    while (count > 1 && row[count - 1] == 0)
        --count;
    if (!std::all_of(row.begin(), row.end(), [](double c) { return std::isfinite(c); }))
        return std::nullopt;
    return piece;
}

void Component::append(double t, const PlainPiece& piece) {
    ++counts_.evaluations;
    writer_.append({t, infinity, piece.scale, true, static_cast<std::uint8_t>(piece.count)},
                   std::span(piece.row).first(piece.count));
}

// Bit for bit what backTo(), restart() and stepClosedForm() do, without their anchor.
bool Component::resume(double t, std::optional<double> jump) {
    if (!plainRate() || history_.empty())
        return false;
    const Piece last = history_.piece(history_.size() - 1, 0);
    if (last.origin > t)
        return false;
    const auto piece = plainPiece(t, jump.value_or(last.value(t)));
    if (!piece)
        return false;
    counts_.discardedSteps += history_.cut(t);
    append(t, *piece);
    return true;
}

// What goes on for ever needs no look at its equations: bit for bit what closedForm() makes of it.
bool Component::stepPlainly() {
    if (!plainRate_ || limit_ < infinity || options_.method != "auto")
        return false;
    const auto piece = plainPiece(time_, values_[0]);
    if (!piece)
        return false;
    history_.dropAnchor();
    append(time_, *piece);
    time_ = infinity;
    return true;
}

void Component::stepClosedForm() {
    auto form = closedForm(*equations_, time_, stateValues());
    if (!form || equations_->sliding()) { // an input's next pieces have too high a degree
        model_ = equations_->states().empty() ? Model::held : Model::integrated;
        proposed_ = 0;
        return;
    }
    ++counts_.evaluations;
    for (std::size_t i = 0; i < form->columns.size(); ++i)
        for (const double c : form->columns[i])
            if (!std::isfinite(c)) {
                endWithoutRate(time_, stateValues());
                return;
            }
    double until = std::min(form->until, limit_);
    if (equations_->watches() > 0) { // look for switches over lengths that double
        proposed_ = proposed_ > 0 ? 2 * proposed_ : 1;
        until = std::min(until, time_ + proposed_);
    }
    const auto count = static_cast<std::ptrdiff_t>(equations_->states().size());
    const std::vector<Coefficients> states(form->columns.begin(), form->columns.begin() + count);
    const std::vector<Coefficients> held(form->columns.begin() + count, form->columns.end());
    const auto found = violation(time_, until, form->scale, states);
    if (found && (found->time <= time_ || leaves(*found, form->scale, states))) {
        pass(*found, true);
        return;
    }
    const double to = found ? found->time : until;
    writer_.append({states, time_, form->scale, to}, held);
    if (to == infinity) {
        time_ = to;
        return;
    }
    y_.resize(states.size());
    for (std::size_t i = 0; i < y_.size(); ++i)
        y_[i] = evaluate(states[i], (to - time_) / form->scale);
    if (!land(to))
        return;
    if (found)
        pass(*found, false);
    if (!stop_ && time_ >= limit_)
        arrive();
}

// Held values alone, as polynomials of degree 8 that are halved until they fit. No error is
// estimated of them, so that they fit to rounding; where rounding is worse than one would think,
// which never ends, as well as those that follow states.
void Component::stepHeld() {
    constexpr int patience = 24;
    const double wanted = proposed_ > 0 ? proposed_ : 1;
    double h = wanted, part = 0;
    for (int refused = 0;;) {
        if (part == 0 && (refused == patience || h <= 2 * shortestStep(time_))) {
            part = heldPart;
            h = wanted;
        }
        const double to = time_ + landingOf(options_) * h >= limit_ ? limit_ : time_ + h;
        if (to - time_ <= shortestStep(time_)) {
            const auto culprits = equations_->notFinite(time_ + h, {});
            end(culprits.empty() ? Stop::Reason::stepUnderflow : Stop::Reason::notFinite, culprits,
                "the value that holds " + names(culprits.empty() ? equations_->held() : culprits) +
                    (culprits.empty() ? " changes too fast" : " is not finite"));
            return;
        }
        std::vector<Coefficients> held(equations_->held().size());
        counts_.evaluations += maximumCoefficients;
        const auto found = violation(time_, to, to - time_, {});
        if (found && (found->time <= time_ || leaves(*found, to - time_, {}))) {
            pass(*found, true);
            return;
        }
        const double until = found ? found->time : to;
        if (!fitHeld(until, part, held)) {
            ++counts_.rejectedSteps;
            ++refused;
            h *= 0.5;
            continue;
        }
        ++counts_.steps;
        writer_.append({{}, time_, until - time_, until}, held);
        proposed_ = 2 * h;
        time_ = until;
        takeHeldValues();
        if (stop_)
            return;
        switches_.goOn();
        if (found)
            pass(*found, false);
        if (!stop_ && time_ >= limit_)
            arrive();
        return;
    }
}

} // namespace solution
