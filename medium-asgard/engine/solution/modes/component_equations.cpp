#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Decision;
using expression::Node;

namespace {

// Of a component whose held values are defined by each other: nothing.
const ComponentModel& noModel() {
    static const ComponentModel none({0, 0, key::outputs});
    return none;
}

} // namespace

ComponentEquations::ComponentEquations(std::shared_ptr<const BoundModel> bound,
                                       const Histories& histories)
    : bound_(std::move(bound)), model_(bound_->model ? *bound_->model : noModel()),
      inputs_(histories, bound_->inputs), in_(model_.symbols().size()),
      out_(model_.outputs().size()), base_(out_.size()), other_(out_.size()),
      guards_(model_.function().decisions()), mode_(model_),
      wasPassed_(model_.surfaces().size(), 0), units_(model_.directions().parts),
      isPlain_(mode_.decisions.empty() && bound_->held.empty() && bound_->loop.empty() &&
               model_.directions().ranges.empty()),
      readsInputs_(!bound_->inputs.empty()) {
    std::ranges::copy(bound_->constants,
                      in_.begin() + static_cast<std::ptrdiff_t>(model_.variables()));
}

void ComponentEquations::fill(double t, std::span<const double> y) {
    in_[0] = t;
    for (std::size_t i = 0; i < y.size(); ++i)
        in_[1 + i] = y[i];
    if (!inputs_.unknowns().empty())
        inputs_.values(t, std::span(in_).subspan(1 + states().size()));
}

// A state that lies on a surface of its own is moved off it, to its side, by next to nothing: what
// is written v/abs(v) is then the sign that it means, and v abs(v) is still 0.
void ComponentEquations::evaluate(std::span<double> out) {
    bool isMoved = false;
    if (!mode_.decisions.empty())
        for (const auto& [surface, state] : model_.ownGuards())
            if (in_[1 + state] == 0 && mode_.sides[surface] != Mode::onSurface) {
                in_[1 + state] = mode_.sides[surface] * nextToNothing;
                isMoved = true;
            }
    evaluateOutputs(out);
    if (!isMoved)
        return;
    for (const auto& [surface, state] : model_.ownGuards())
        if (std::abs(in_[1 + state]) == nextToNothing)
            in_[1 + state] = 0;
    for (double& rate : out)
        if (std::abs(rate) <= vanishing)
            rate = 0;
}

namespace {

bool areFinite(std::span<const double> values) {
    double zero = 0; // no number as soon as one of them is not finite
    for (const double x : values)
        zero += 0 * x;
    return zero == 0;
}

} // namespace

bool ComponentEquations::rates(double t, std::span<const double> y, std::span<double> out) {
    if (isPlain_) {
        in_[0] = t;
        double* const in = in_.data() + 1;
        if (y.data() != in)
            for (std::size_t i = 0; i < y.size(); ++i)
                in[i] = y[i];
        if (readsInputs_)
            putInputs(t);
        if (code_.entry) {
            code_(in_.data(), out.data(), scratch_.data());
        } else {
            model_.function().evaluate(in_, out, scratch_);
            code_ = model_.function().code(scratch_);
        }
        return areFinite(out);
    }
    fill(t, y);
    slidingFailed_ = sliding() && !weigh();
    if (slidingFailed_)
        return false;
    if (!sliding()) {
        evaluate(out_);
        if (mode_.looksBeyond && !areFinite(out_))
            evaluateWhereItIs();
    }
    for (std::size_t i = 0; i < states().size(); ++i)
        out[i] = out_[i];
    return areFinite(out_);
}

void ComponentEquations::evaluateWhereItIs() {
    const std::vector<expression::Decision> held = mode_.decisions;
    model_.function().tape().decide(in_, mode_.decisions, guards_, scratch_);
    if (mode_.decisions != held)
        evaluateOutputs(out_);
    mode_.decisions = held;
}

bool ComponentEquations::lookBeyond(double t, std::span<const double> y) {
    if (mode_.looksBeyond || sliding())
        return false;
    fill(t, y);
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s)
        mode_.looksBeyond = mode_.looksBeyond || (isOnSide(s) && std::abs(guard(s)) <= standing);
    return mode_.looksBeyond;
}

bool ComponentEquations::heldValues(double t, std::span<const double> y, std::span<double> out) {
    fill(t, y);
    if (mode_.sticking.empty() || !weigh())
        evaluate(out_);
    std::copy(out_.begin() + static_cast<std::ptrdiff_t>(states().size()), out_.end(), out.begin());
    return std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); });
}

void ComponentEquations::peakCauses(const ComponentModel::PeakFunctions& peaks, double t,
                                    std::span<const double> y, std::span<const double> rates,
                                    std::span<double> out) {
    fill(t, y);
    inMoving_.assign(in_.begin(), in_.end());
    inMoving_.insert(inMoving_.end(), rates.begin(), rates.end());
    inMoving_.resize(inMoving_.size() + model_.inputs());
    inputs_.rates(t, std::span(inMoving_).last(model_.inputs()));
    peaks.causes.evaluate(inMoving_, out, scratch_);
}

void ComponentEquations::peakHeights(double t, std::span<const double> y, std::span<double> out) {
    fill(t, y);
    model_.peaks().heights.evaluate(in_, out, scratch_);
}

std::vector<std::size_t> ComponentEquations::notFinite(double t, std::span<const double> y) {
    fill(t, y);
    evaluate(out_);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < out_.size(); ++i)
        if (!std::isfinite(out_[i]))
            found.push_back(i < states().size() ? states()[i] : held()[i - states().size()]);
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<Decision> ComponentEquations::decisionOf(Node switching) const {
    const auto& switches = model_.switches();
    const auto at = std::ranges::lower_bound(switches, switching);
    if (at == switches.end() || *at != switching)
        return std::nullopt;
    return mode_.decisions[static_cast<std::size_t>(at - switches.begin())];
}

std::optional<std::size_t> ComponentEquations::stateOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    if (!place || *place == 0 || *place > states().size())
        return std::nullopt;
    return *place - 1;
}

std::optional<std::size_t> ComponentEquations::inputOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    const std::size_t first = 1 + states().size();
    if (!place || *place < first || *place >= model_.variables())
        return std::nullopt;
    return *place - first;
}

std::optional<double> ComponentEquations::constantOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    if (!place || *place < model_.variables())
        return std::nullopt;
    return in_[*place];
}

} // namespace solution
