// Steps of a component by an integrator; between them the choice of the method, by cost.
//
// A step that is refused is tried shorter. Where the right-hand side has no value within any
// further step, as that of a root whose argument max() bounds, a switch lies there, or the motion
// ends at the last time at which it has a rate.
#pragma once

#include "stepping/rest_approach.h"
#include "stepping/step_model.h"

#include "integrators/method.h"

#include <memory>

namespace solution {

class ExplicitRungeKutta;

class Integration final : public StepModel {
public:
    explicit Integration(const StepContext& context) : context_(context), rest_(context) {}

    // After an event.
    void begin();
    // The next step begins with a new method: the branches or the motion are others.
    void dropMethod();
    [[nodiscard]] const Method* method() const { return method_.get(); }

    [[nodiscard]] Proposal propose() override;
    [[nodiscard]] Afterwards goOn(std::span<const double> y) override;
    [[nodiscard]] bool looksAhead() const override { return method_ != nullptr; }

    // Steps that are made beside those of other components (side_by_side.h), as propose() would
    // make them: with an explicit method, of a component that nothing watches and that reads no
    // other.
    [[nodiscard]] bool mayGoSideBySide() const;
    [[nodiscard]] bool isInStride() const { return strides_ && method_; }
    [[nodiscard]] ExplicitRungeKutta& stride() const;
    // The end of the next attempt; none: there is more to it, for propose().
    [[nodiscard]] std::optional<double> strideEnd() const;
    // False: no shorter one can be made. Then it is out of stride for propose().
    [[nodiscard]] bool refuseStride(const Attempt& attempt, double h);
    // A step that cannot be made in stride: what becomes of it.
    [[nodiscard]] std::optional<Proposal> refuse(const Attempt& attempt, double h);
    // The polynomials of the accepted step are put here.
    [[nodiscard]] std::span<Coefficients> columns() { return columns_; }
    [[nodiscard]] StepPiece takenStride(double h, double to, double next);
    [[nodiscard]] bool changesAfterStride(double h, double crossing);
    [[nodiscard]] std::optional<Ending> changeMethod();

    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr double stable = 0.9;
    [[nodiscard]] std::unique_ptr<Method> chosenMethod() const;
    [[nodiscard]] std::optional<Ending> beginMethod();
    [[nodiscard]] double longestFirst() const;
    void findTurn();
    [[nodiscard]] std::optional<StepPiece> toStop(const ComponentEquations::Turns::Stop& stop);
    [[nodiscard]] double longest() const;
    [[nodiscard]] bool mayStride() const;
    [[nodiscard]] Proposal review(double to);
    [[nodiscard]] Proposal lookCloser(double at, double h);
    [[nodiscard]] std::optional<Violation> violationOn(const StateCurves& curves);
    [[nodiscard]] bool swings(const StateCurves& curves);
    [[nodiscard]] std::optional<double> endBeforeContact(const StateCurves& curves);
    [[nodiscard]] Ending underflow(Attempt::Outcome outcome, double h) const;
    [[nodiscard]] std::optional<Proposal> acrossSwitch(double h);
    [[nodiscard]] std::optional<Proposal> acrossWay(double across);
    [[nodiscard]] std::optional<Violation> switchesHere() const;
    [[nodiscard]] std::optional<StepPiece> switchHere();
    [[nodiscard]] std::optional<Proposal> toLastRate(double h);
    [[nodiscard]] std::optional<Ending> reconsider();
    [[nodiscard]] double spectralRadius();

    const StepContext& context_;
    RestApproach rest_;
    std::unique_ptr<Method> method_;
    bool mayChange_ = false;          // the method, by cost
    bool strides_ = false;            // as long as it has this method
    double lastLength_ = 0;           // of the step proposed last
    ComponentEquations::Turns turns_; // of slow slips by their friction, where it begins
    double calm_ = stable;            // of the stability that such a step may use
    std::optional<Violation> found_;  // the switch that ends the step proposed last
    std::vector<Coefficients> columns_;
    std::vector<double> y_;
};

} // namespace solution
