// Explicit Runge-Kutta methods, from tables.
//
//   k_i = f(t + c_i h, y + h sum_j a_ij k_j)       y1 = y + h sum_i b_i k_i
//
// Stages after the first `stages` belong to dense output alone and are computed only for accepted
// steps; stage number `stages` is f(t + h, y1), the first of the next step. Error estimates are
// sums of k_i; with two of them (Hairer's 853) the estimate is e1^2 / sqrt(e1^2 + 0.01 e2^2).
// Dense output: y(s) = y + h sum_i B_i(s) k_i. Where it needs stages of its own, they are computed
// only for steps whose ends, with the start of the step before, do not say enough.
//
// Without an estimate of its own a method needs StepDoubling. Step control: PI (exponents 0.7/p and
// 0.4/p), factors 1/5 to 6. Stiffness: |lambda| = |k_a - k_b| / |Y_a - Y_b| of the last two stages
// at t + h. Sources: Dormand and Prince 1980; Hairer, Norsett, Wanner, Solving ODEs I, II.5, II.6,
// IV.2.
#pragma once

#include "dense/dense_output.h"
#include "dense/weighted_sum.h"
#include "integrators/direct_step.h"
#include "integrators/method.h"
#include "integrators/tableau.h"

namespace solution {

// Of what a step may err by, what the polynomials between its ends may; more of it where the guess
// is some ten times too large.
struct BetweenEnds {
    static constexpr double allowed = 0.5, allowedSpeed = 1, pessimism = 8;
    // Of what a velocity may err by, what it may move by to be its position's derivative: then
    // history keeps one of them.
    static constexpr double ownEnd = 0.1;
};

class ExplicitRungeKutta final : public Method {
public:
    ExplicitRungeKutta(const Tableau& tableau, System& system, ErrorControl& control, bool fixed);

    [[nodiscard]] const Tableau& tableau() const { return tableau_; }
    [[nodiscard]] const char* name() const override { return tableau_.name; }
    [[nodiscard]] std::size_t order() const override { return tableau_.order; }
    [[nodiscard]] bool implicit() const override { return false; }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;
    [[nodiscard]] double stabilityUsed() const override { return stabilityUsed_; }
    [[nodiscard]] double stabilityLimit() const override {
        return tableau_.stabilityLimit > 0 ? tableau_.stabilityLimit : Method::stabilityLimit();
    }

private:
    friend class AlikeSteps; // which makes its steps beside those of others
    // All stages of a step; of so many unknowns, or of any number (0).
    template <std::size_t Size> [[nodiscard]] bool makeStages();
    template <std::size_t Size> [[nodiscard]] bool stage(std::size_t i, double* at);
    void finishStages(std::size_t size);
    [[nodiscard]] std::optional<bool> makeDirectly(DirectStep::Make make);
    [[nodiscard]] bool makeAllStages();
    [[nodiscard]] bool makeStagesBeyond();
    using Stages = bool (ExplicitRungeKutta::*)();
    [[nodiscard]] static Stages stagesFor(std::size_t size);
    [[nodiscard]] double* slopesOf(std::size_t stage) { return k_.data() + stage * size_; }
    [[nodiscard]] StepEnds ends();
    [[nodiscard]] bool endsSuffice(std::span<const Coefficients> columns);
    [[nodiscard]] bool correct(std::span<Coefficients> columns);
    [[nodiscard]] bool extend(std::span<Coefficients> columns);
    [[nodiscard]] double errorNorm();
    [[nodiscard]] Attempt judge(double error);
    void estimateStiffness();

    const Tableau& tableau_;
    std::size_t size_;
    Stages stages_;         // makeStages() for this size
    DirectStep direct_;     // the same, where rates are machine code
    std::vector<double> k_; // slopes of all stages, one after the other
    std::vector<double> at_, stiffAt_, sum_;
    struct Lost { // to rounding, by the state at the start and at the end
        std::vector<double> start, end;
    };
    Lost lost_;
    std::vector<std::size_t>
        unpaired_;  // neither positions nor velocities of which the other is known
    struct Before { // the start of the step before, and its length; 0: none
        std::vector<double> state, slope;
        double step = 0;
    };
    Before before_;
    std::vector<Correction> corrections_;
    struct Controller {
        std::vector<double> error, secondError;
        double previousLogarithm = 0; // of the error before
        bool isAfterRejection = false;
    };
    Controller controller_;
    double stabilityUsed_ = 0;
};

} // namespace solution
