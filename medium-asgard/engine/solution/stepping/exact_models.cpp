#include "stepping/exact_models.h"

#include <algorithm>
#include <cmath>

namespace solution {

bool ClosedFormModel::applies() const {
    ComponentEquations& equations = context_.equations();
    return !equations.sliding() &&
           closedForm(equations, context_.time(), context_.states()).has_value();
}

Proposal ClosedFormModel::propose() {
    ComponentEquations& equations = context_.equations();
    const double from = context_.time();
    auto form = closedForm(equations, from, context_.states());
    if (!form || equations.sliding()) // an input's next pieces have too high a degree
        return NextModel{};
    form_ = std::move(*form);
    ++context_.counts.evaluations;
    for (const Coefficients& column : form_.columns)
        for (const double c : column)
            if (!std::isfinite(c))
                return context_.endingWithoutRate(from, context_.states());
    double until = std::min(form_.until, context_.limit());
    if (equations.watches() > 0) { // look for switches over lengths that double
        double& length = context_.progress.proposed;
        length = length > 0 ? 2 * length : 1;
        until = std::min(until, from + length);
    }
    const std::size_t count = equations.states().size();
    const std::span<const Coefficients> all = form_.columns;
    StateCurves curves{all.first(count), from, form_.scale, until};
    found_ = context_.violationOn(curves);
    if (found_ && context_.passesAtOnce(*found_, curves))
        return SwitchAtOnce{*found_};
    if (found_)
        curves.until = found_->time;
    StepPiece piece{
        .curves = curves, .held = all.subspan(count), .crossing = found_ ? &*found_ : nullptr};
    if (curves.until < infinity) {
        y_.resize(count);
        curves.at(curves.until, y_);
        piece.end = y_;
    }
    return piece;
}

bool LinearModel::applies() {
    motion_.reset();
    lost_ = 0;
    if (context_.equations().states().size() > LinearMotion::mostStates ||
        context_.options.fixedStep)
        return false;
    if (const auto form = linearForm(context_.equations(), context_.time()))
        motion_ = std::make_unique<LinearMotion>(*form);
    return motion_ != nullptr;
}

// Now and then: a method strides over the trembling of a stiff spring that has to be followed here.
// It damps what it strides over, and readers may amplify that: a motion that is read stays exact.
bool LinearModel::isUnseen(double h) {
    constexpr std::size_t interval = 512;
    // Steps that events throw away do not count.
    if (context_.progress.isRead || context_.history.size() % interval != 0)
        return false;
    ErrorControl& control = context_.control();
    control.prepare(y_, h);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        double moved = 0;
        for (std::size_t k = 1; k <= maximumDegree; ++k)
            moved += std::abs(columns_[i][k]);
        if (moved > control.scale(i))
            return false;
    }
    return true;
}

Proposal LinearModel::propose() {
    const double from = context_.time();
    context_.progress.take(context_.equations().states(), y_);
    columns_.resize(y_.size());
    const bool isLinear = from < motion_->until() || applies();
    const double h = isLinear ? motion_->advance(y_, columns_) : 0;
    ++context_.counts.evaluations;
    // An input's next pieces are not constant, or rounding is too much.
    if (h == 0 || isUnseen(h))
        return NextModel{};
    // Pieces are as long as they are, and times are rounded: what that leaves is carried on, or a
    // million pieces would drift.
    const double ahead = h + lost_;
    const double until = std::min({from + ahead, context_.limit(), motion_->until()});
    if (until < from + ahead)
        for (std::size_t i = 0; i < y_.size(); ++i)
            y_[i] = evaluate(columns_[i], (until - from - lost_) / h);
    lost_ = until < from + ahead ? 0 : ahead - (until - from);
    return StepPiece{.curves = {columns_, from, h, until}, .end = y_};
}

bool RestModel::applies() const {
    const ComponentEquations& equations = context_.equations();
    return context_.progress.isStill && !context_.options.fixedStep && !equations.readsInputs() &&
           !equations.model().readsTime();
}

// A guard is what it is here for ever: one look at it is enough.
Proposal RestModel::propose() {
    const ComponentEquations& equations = context_.equations();
    const std::vector<double>& values = context_.progress.values;
    const auto constants = [&](std::span<const std::size_t> places, auto& columns) {
        columns.assign(places.size(), Coefficients{});
        for (std::size_t i = 0; i < places.size(); ++i)
            columns[i][0] = values[places[i]];
    };
    constants(equations.states(), columns_);
    constants(equations.held(), held_);
    const double from = context_.time();
    StateCurves curves{columns_, from, 1, std::min(from + 1, context_.limit())};
    if (context_.violationOn(curves))
        return NextModel{};
    curves.until = context_.limit();
    return StepPiece{.curves = curves, .held = held_, .kind = StepPiece::Kind::atRest};
}

// No error is estimated of them, so that they fit to rounding; where rounding is worse than one
// would think, which never ends, as well as those that follow states.
Proposal HeldModel::propose() {
    constexpr int patience = 24;
    ComponentEquations& equations = context_.equations();
    double& proposed = context_.progress.proposed;
    const double from = context_.time(), limit = context_.limit();
    const double wanted = proposed > 0 ? proposed : 1;
    double h = wanted, part = 0;
    for (int refused = 0;; ++refused, h *= 0.5, ++context_.counts.rejectedSteps) {
        if (part == 0 && (refused == patience || h <= 2 * shortestStep(from))) {
            part = heldPart;
            h = wanted;
        }
        const double to = from + landingOf(context_.options) * h >= limit ? limit : from + h;
        if (to - from <= shortestStep(from)) {
            const auto culprits = equations.notFinite(from + h, {});
            const bool isFinite = culprits.empty();
            return Ending{
                isFinite ? Stop::Reason::stepUnderflow : Stop::Reason::notFinite, culprits,
                "the value that holds " + context_.names(isFinite ? equations.held() : culprits) +
                    (isFinite ? " changes too fast" : " is not finite")};
        }
        held_.assign(equations.held().size(), {});
        context_.counts.evaluations += maximumCoefficients;
        StateCurves curves{{}, from, to - from, to};
        found_ = context_.violationOn(curves);
        if (found_ && context_.passesAtOnce(*found_, curves))
            return SwitchAtOnce{*found_};
        const double until = found_ ? found_->time : to;
        curves = {{}, from, until - from, until};
        if (!PieceWriter::fit(curves, values_, part * context_.tolerance, held_))
            continue;
        proposed = 2 * h;
        return StepPiece{.curves = curves,
                         .end = std::span<const double>(),
                         .held = held_,
                         .kind = StepPiece::Kind::step,
                         .crossing = found_ ? &*found_ : nullptr};
    }
}

} // namespace solution
