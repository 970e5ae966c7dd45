// Error control for a method that has no estimate of its own: each step is taken whole and again in
// halves. The halves are kept; the difference over 2^p - 1 estimates their error.
//
// Dense output goes through the start, the middle and the end: a parabola up to order 2, the
// quintic that has their slopes too above.
#pragma once

#include "integrators/method.h"

namespace solution {

class StepDoubling final : public Method {
public:
    // `inner` accepts every step that it can compute (fixed).
    StepDoubling(std::unique_ptr<Method> inner, System& system, ErrorControl& control);

    [[nodiscard]] const char* name() const override { return inner_->name(); }
    [[nodiscard]] std::size_t order() const override { return inner_->order(); }
    [[nodiscard]] bool implicit() const override { return inner_->implicit(); }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;

private:
    [[nodiscard]] bool startInner();
    [[nodiscard]] Attempt refuse(const Attempt& attempt);
    void takeCounts();

    std::unique_ptr<Method> inner_;
    bool innerAtStart_ = true;
    std::vector<double> whole_, middle_, error_;
    std::vector<Coefficients> first_, second_; // of the halves
    std::size_t firstSteps_ = 0;               // evaluations that firstStep() made
};

} // namespace solution
