// Which model steps a component now? The least one that answers it (step_model.h).
#pragma once

#include "stepping/exact_models.h"
#include "stepping/integration.h"

namespace solution {

// The values of a component's held unknowns.
class HeldUnknowns final : public HeldValues {
public:
    explicit HeldUnknowns(const StepContext& context) : context_(context) {}
    [[nodiscard]] bool valuesAt(double t, std::span<const double> y,
                                std::span<double> out) override {
        return context_.equations().heldValues(t, y, out);
    }
    [[nodiscard]] std::vector<double> peaksOn(const StateCurves& curves) override {
        return context_.oversight.centresIn(context_.equations(), curves);
    }

private:
    const StepContext& context_;
};

class StepModels {
public:
    explicit StepModels(const StepContext& context)
        : context_(context), held_(context), closedForm_(context), linear_(context), rest_(context),
          values_(context, held_), integration_(context) {}

    // None: it is to be decided.
    [[nodiscard]] StepModel* current() const { return current_; }
    // After an event; after a switch.
    void begin();
    void forget();
    // `isPlain`: the motion goes on for ever in one piece, which was written.
    void decide(bool isPlain);
    // The model that takes over where the current one cannot go on.
    void next();

    [[nodiscard]] bool isClosedForm() const { return current_ == &closedForm_; }
    [[nodiscard]] HeldValues& held() { return held_; }
    [[nodiscard]] Integration& integration() { return integration_; }
    [[nodiscard]] const Integration& integration() const { return integration_; }
    [[nodiscard]] std::size_t bytes() const { return linear_.bytes() + integration_.bytes(); }

private:
    void take(StepModel& model, const char* name, const char* method, const char* why);
    void takeRest();

    const StepContext& context_;
    HeldUnknowns held_;
    ClosedFormModel closedForm_;
    LinearModel linear_;
    RestModel rest_;
    HeldModel values_;
    Integration integration_;
    StepModel* current_ = nullptr;
};

} // namespace solution
