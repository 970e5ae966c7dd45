// Models that need no integrator: polynomials in time, linear motion, rest, and held values alone.
#pragma once

#include "exact/linear_motion.h"
#include "stepping/step_model.h"

#include <memory>

namespace solution {

class ClosedFormModel final : public StepModel {
public:
    explicit ClosedFormModel(const StepContext& context) : context_(context) {}
    // It can step from here.
    [[nodiscard]] bool applies() const;
    [[nodiscard]] Proposal propose() override;

private:
    const StepContext& context_;
    ClosedForm form_;
    std::optional<Violation> found_; // the switch that ends its last piece
    std::vector<double> y_;
};

// y' = A y + b. It yields where the motion disappears in the error that a step may have, unless
// other components read it.
class LinearModel final : public StepModel {
public:
    explicit LinearModel(const StepContext& context) : context_(context) {}
    [[nodiscard]] bool applies();
    [[nodiscard]] Proposal propose() override;
    [[nodiscard]] std::size_t bytes() const { return motion_ ? motion_->bytes() : 0; }

private:
    [[nodiscard]] bool isUnseen(double h);

    const StepContext& context_;
    std::unique_ptr<LinearMotion> motion_;
    double lost_ = 0; // by the rounding of times, of the time to which linear motion has come
    std::vector<double> y_;
    std::vector<Coefficients> columns_;
};

// Rates that read neither time nor other components are 0 for ever where they are 0 once: bodies
// that lie on each other stay until an event, or the end of a phase.
class RestModel final : public StepModel {
public:
    explicit RestModel(const StepContext& context) : context_(context) {}
    // The component has just begun anew.
    [[nodiscard]] bool applies() const;
    [[nodiscard]] Proposal propose() override;

private:
    const StepContext& context_;
    std::vector<Coefficients> columns_, held_;
};

// Held values, as polynomials of degree 8 over steps that are halved until they fit.
class HeldModel final : public StepModel {
public:
    HeldModel(const StepContext& context, HeldValues& values)
        : context_(context), values_(values) {}
    [[nodiscard]] Proposal propose() override;

private:
    const StepContext& context_;
    HeldValues& values_;
    std::optional<Violation> found_; // the switch that ends its last piece
    std::vector<Coefficients> held_;
};

} // namespace solution
