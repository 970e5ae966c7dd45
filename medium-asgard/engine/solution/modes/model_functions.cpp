#include "modes/model_functions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using expression::Decision;
using expression::Node;

const ComponentModel& modelOf(const BoundModel& bound) {
    static const ComponentModel none({0, 0, 0, key::outputs});
    return bound.model ? *bound.model : none;
}

const ComponentModel::Conditions& conditionsOf(const BoundModel& bound) {
    return bound.composed ? bound.composed->conditions : modelOf(bound).conditions();
}

ModelFunctions::ModelFunctions(std::shared_ptr<const BoundModel> bound, const Histories& histories,
                               const Mode& mode)
    : bound_(std::move(bound)), model_(modelOf(*bound_)), mode_(mode),
      inputs_(histories, bound_->inputs),
      in_(model_.symbols().size() + (bound_->composed ? bound_->laws.size() : 0)),
      guards_(model_.function().decisions()) {
    held_.units.resize(model_.directions().parts);
    std::ranges::copy(bound_->constants,
                      in_.begin() + static_cast<std::ptrdiff_t>(model_.variables()));
}

void ModelFunctions::plainRates(double t, std::span<const double> y, std::span<double> out) {
    in_[0] = t;
    double* const in = in_.data() + 1;
    if (y.data() != in)
        for (std::size_t i = 0; i < y.size(); ++i)
            in[i] = y[i];
    if (!inputs_.unknowns().empty())
        putInputs(t);
    if (code_.entry) {
        code_(in_.data(), out.data(), scratch_.data());
    } else {
        model_.function().evaluate(in_, out, scratch_);
        code_ = model_.function().code(scratch_);
    }
}

void ModelFunctions::evaluateGuards() {
    model_.function().guards(symbols(), guards_, scratch_, mode_.decisions);
}

void ModelFunctions::decide(std::vector<Decision>& decisions) {
    model_.function().tape().decide(symbols(), decisions, guards_, scratch_);
}

void ModelFunctions::fill(double t, std::span<const double> y) {
    in_[0] = t;
    if (y.data() != in_.data() + 1)
        std::copy_n(y.data(), y.size(), in_.data() + 1);
    if (!inputs_.unknowns().empty())
        inputs_.values(t, std::span(in_).subspan(1 + states().size()));
}

void ModelFunctions::evaluate(const ComponentModel::Derived& derived, std::span<double> out) {
    evaluate(derived, symbols(), out);
}

void ModelFunctions::evaluate(const ComponentModel::Derived& derived, std::span<const double> in,
                              std::span<double> out) {
    derivedDecisions_.clear();
    for (const ComponentModel::Derived::Source& source : derived.sources)
        derivedDecisions_.push_back(source.decision  ? mode_.decisions[*source.decision]
                                    : source.surface ? Decision{mode_.sides[*source.surface]} *
                                                           source.orientation
                                                     : expression::noBranch);
    if (derivedDecisions_.empty())
        derived.function.evaluate(in, out, scratch_);
    else
        derived.function.evaluate(in, out, scratch_, derivedDecisions_);
}

// d g / dt along given rates of the states, at the point given to fill().
GuardSlope ModelFunctions::guardRate(std::size_t surface, std::span<const double> rates) {
    return slopeOf(model_.gradient(surface).derivatives, rates);
}

GuardSlope ModelFunctions::slopeOf(const ComponentModel::Derived& derivatives,
                                   std::span<const double> rates) {
    const std::size_t variables = model_.variables();
    partial_.resize(variables + 1);
    change_.assign(variables, 1.0);
    evaluate(derivatives, partial_);
    std::copy_n(rates.begin(), states().size(), change_.begin() + 1);
    inputs_.rates(in_[0], std::span(change_).subspan(1 + states().size()));
    GuardSlope slope{0, 0, 0, 0, partial_.back(), true};
    for (std::size_t i = 0; i < variables; ++i) {
        if (partial_[i] == 0)
            continue;
        slope.still = false;
        slope.rate += partial_[i] * change_[i];
        slope.noise += 1e-12 * std::abs(partial_[i] * change_[i]);
        slope.near += 1e-11 * std::abs(partial_[i] * in_[i]);
        slope.least += 4 * std::numeric_limits<double>::epsilon() * std::abs(partial_[i] * in_[i]);
    }
    slope.near += 1e-12 * std::abs(slope.rate) * std::max(1.0, std::abs(in_[0]));
    return slope;
}

double ModelFunctions::guard(std::size_t surface) const {
    const Surface::Member& member = model_.surfaces()[surface].members[0];
    return guards_[member.decision] * member.orientation;
}

double ModelFunctions::valueOf(std::size_t surface) {
    if (model_.surfaces()[surface].whole) {
        partial_.resize(model_.variables() + 1);
        evaluate(model_.gradient(surface).derivatives, partial_);
        return partial_.back();
    }
    evaluateGuards();
    return guard(surface);
}

double ModelFunctions::distance(std::size_t surface) {
    const bool isWhole = model_.surfaces()[surface].whole;
    return valueOf(surface) - (isWhole ? static_cast<double>(mode_.levels[surface]) : 0);
}

void ModelFunctions::measure() {
    const ComponentModel::Directions& directions = model_.directions();
    measures_.resize(2 * directions.parts + directions.ranges.size());
    evaluate(directions.measures, measures_);
}

double ModelFunctions::scaleOf(std::size_t part) const {
    return std::sqrt(measures_[model_.directions().parts + part]);
}

Eigen::VectorXd ModelFunctions::vectorOf(std::size_t direction) const {
    const auto [first, count] = model_.directions().ranges[direction];
    Eigen::VectorXd vector(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
        vector(static_cast<Eigen::Index>(i)) = scaleOf(first + i) * measures_[first + i];
    return vector;
}

std::span<const double> ModelFunctions::inHeld() {
    measure();
    const ComponentModel::Directions& directions = model_.directions();
    const auto parts = measures_.begin(), lengths = parts + 2 * std::ptrdiff_t(directions.parts);
    held_.in = in_;
    held_.in.insert(held_.in.end(), parts, parts + std::ptrdiff_t(directions.parts));
    held_.in.insert(held_.in.end(), lengths, measures_.end());
    for (const std::size_t d : mode_.sticking) {
        const auto [first, count] = directions.ranges[d];
        const double length =
            d == mode_.leaving ? std::max(vectorOf(d).norm(), nextToNothing) : nextToNothing;
        held_.in[in_.size() + directions.parts + d] = length;
        for (std::size_t p = first; p < first + count; ++p)
            held_.in[in_.size() + p] = length * held_.units[p] / scaleOf(p);
    }
    return held_.in;
}

void ModelFunctions::peakCauses(const ComponentModel::PeakFunctions& peaks, double t,
                                std::span<const double> y, std::span<const double> rates,
                                std::span<double> out) {
    fill(t, y);
    inMoving_.assign(symbols().begin(), symbols().end());
    inMoving_.insert(inMoving_.end(), rates.begin(), rates.end());
    inMoving_.resize(inMoving_.size() + model_.inputs());
    inputs_.rates(t, std::span(inMoving_).last(model_.inputs()));
    peaks.causes.evaluate(inMoving_, out, scratch_);
}

void ModelFunctions::peakHeights(double t, std::span<const double> y, std::span<double> out) {
    fill(t, y);
    model_.peaks().heights.evaluate(symbols(), out, scratch_);
}

std::optional<Decision> ModelFunctions::decisionOf(Node switching) const {
    const auto& switches = model_.switches();
    const auto at = std::ranges::lower_bound(switches, switching);
    if (at == switches.end() || *at != switching)
        return std::nullopt;
    return mode_.decisions[static_cast<std::size_t>(at - switches.begin())];
}

std::optional<std::size_t> ModelFunctions::stateOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    if (!place || *place == 0 || *place > states().size())
        return std::nullopt;
    return *place - 1;
}

std::optional<std::size_t> ModelFunctions::inputOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    const std::size_t first = 1 + states().size();
    if (!place || *place < first || *place >= model_.variables())
        return std::nullopt;
    return *place - first;
}

std::optional<double> ModelFunctions::constantOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    if (!place || *place < model_.variables() || *place >= model_.variables() + model_.constants())
        return std::nullopt;
    return in_[*place];
}

std::optional<std::size_t> ModelFunctions::multiplierOf(Node symbol) const {
    const auto place = model_.placeOf(symbol);
    const std::size_t first = model_.variables() + model_.constants();
    if (!place || *place < first)
        return std::nullopt;
    return *place - first;
}

} // namespace solution
