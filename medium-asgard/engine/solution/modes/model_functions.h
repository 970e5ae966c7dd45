// The functions of a component's model at one point: a time, values of its states, and those of its
// inputs then. Switches in derivatives take the branches of a mode.
//
// Functions of one point share what is looked up for it, so that the point is put first, by fill().
#pragma once

#include "dense/inputs.h"
#include "equations/bound_model.h"
#include "modes/mode.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace solution {

// The rate of a guard along given rates of the states.
struct GuardSlope {
    double rate;
    double noise; // what rounding may make of a rate of 0
    double near;  // and of a guard of 0, where its root was located
    double least; // and of a guard of 0, where what it reads is exact
    double value; // the guard
    bool still;   // constant on the branches in force, whatever moves
};

class ModelFunctions {
public:
    static constexpr double standing = 1e-12; // on a surface, by the value of its guard
    // The distance of a move off a surface, or off a length of 0, for its direction; its square is
    // still a number.
    static constexpr double nextToNothing = 1e-150;

    // `mode` outlives them, and is the one in force whenever they are asked.
    ModelFunctions(std::shared_ptr<const BoundModel> bound, const Histories& histories,
                   const Mode& mode);

    [[nodiscard]] const std::shared_ptr<const BoundModel>& bound() const { return bound_; }
    [[nodiscard]] const std::vector<std::size_t>& states() const { return bound_->states; }
    [[nodiscard]] Inputs& inputs() { return inputs_; }
    // Values of the model's symbols at the point; then constants, then multipliers.
    [[nodiscard]] std::vector<double>& in() { return in_; }
    [[nodiscard]] const std::vector<double>& in() const { return in_; }
    // Those that the model has: where conditions are composed, it has no multipliers.
    [[nodiscard]] std::span<const double> symbols() const {
        return std::span(in_).first(model_.symbols().size());
    }
    [[nodiscard]] expression::Function::Scratch& scratch() { return scratch_; }

    void fill(double t, std::span<const double> y);
    void putInputs(double t) { inputs_.values(t, std::span(in_).subspan(1 + states().size())); }
    // Rates of a model without switches and held values, whose states may lie in in() already.
    void plainRates(double t, std::span<const double> y, std::span<double> out);
    [[nodiscard]] const expression::Function::Code& code() const { return code_; }

    // Derived expressions, on the branches of the mode.
    void evaluate(const ComponentModel::Derived& derived, std::span<double> out);
    void evaluate(const ComponentModel::Derived& derived, std::span<const double> in,
                  std::span<double> out);
    [[nodiscard]] GuardSlope guardRate(std::size_t surface, std::span<const double> rates);
    [[nodiscard]] GuardSlope slopeOf(const ComponentModel::Derived& derivatives,
                                     std::span<const double> rates);
    // All guards; then of one surface.
    void evaluateGuards();
    [[nodiscard]] double guard(std::size_t surface) const;
    // The branches that the values alone say.
    void decide(std::vector<expression::Decision>& decisions);
    // Of a guard; of floor and ceil their argument.
    [[nodiscard]] double valueOf(std::size_t surface);
    // From the surface; of floor and ceil from their level.
    [[nodiscard]] double distance(std::size_t surface);

    // Parts of directions, the weights of their squares, and lengths; then, of these, of one.
    void measure();
    [[nodiscard]] const std::vector<double>& measures() const { return measures_; }
    [[nodiscard]] double scaleOf(std::size_t part) const;
    [[nodiscard]] Eigen::VectorXd vectorOf(std::size_t direction) const;
    // The mode holds these (held_field.h): the weight of each surface that is slid upon; and by
    // part, the vector that stands for a/|a| where a is held at 0.
    [[nodiscard]] std::vector<double>& weights() { return held_.weights; }
    [[nodiscard]] std::vector<double>& units() { return held_.units; }
    // The values of in() and of the symbols of directions, where the mode holds some.
    [[nodiscard]] std::span<const double> inHeld();

    // The model's peaks (equations/peaks.h): causes and their rates where states have these, and
    // heights.
    void peakCauses(const ComponentModel::PeakFunctions& peaks, double t, std::span<const double> y,
                    std::span<const double> rates, std::span<double> out);
    void peakHeights(double t, std::span<const double> y, std::span<double> out);

    [[nodiscard]] std::optional<expression::Decision> decisionOf(expression::Node switching) const;
    // The kind of a symbol: a state, an input, the value of a constant of this component, or a
    // multiplier.
    [[nodiscard]] std::optional<std::size_t> stateOf(expression::Node symbol) const;
    [[nodiscard]] std::optional<std::size_t> inputOf(expression::Node symbol) const;
    [[nodiscard]] std::optional<double> constantOf(expression::Node symbol) const;
    [[nodiscard]] std::optional<std::size_t> multiplierOf(expression::Node symbol) const;

private:
    std::shared_ptr<const BoundModel> bound_;
    const ComponentModel& model_;
    const Mode& mode_;
    Inputs inputs_;
    expression::Function::Scratch scratch_;
    std::vector<double> in_, guards_;
    std::vector<double> inMoving_;         // symbols, and rates of states and inputs
    std::vector<double> partial_, change_; // of slopes
    std::vector<double> measures_;
    struct Held {
        std::vector<double> weights, units;
        std::vector<double> in; // symbols, with those of directions
    };
    Held held_;
    std::vector<expression::Decision> derivedDecisions_;
    expression::Function::Code code_; // of a plain model, once there is any
};

// The model of bound equations; an empty one where held values are defined by each other.
[[nodiscard]] const ComponentModel& modelOf(const BoundModel& bound);
// The conditions: those of the model, or the composed ones, which have no functions.
[[nodiscard]] const ComponentModel::Conditions& conditionsOf(const BoundModel& bound);

} // namespace solution
