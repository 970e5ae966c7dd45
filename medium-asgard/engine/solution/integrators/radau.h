// Radau IIA of order 5: three-stage collocation at c = (4-√6)/10, (4+√6)/10, 1. L-stable, stage
// order 3. After Hairer and Wanner (Solving ODEs II, IV.8); the Newton policy is our own.
//
// With z_i = Y_i - y0 the stages solve  z = h (A x I) f.  T diagonalises A^-1 into one real and one
// complex pair of eigenvalues, so that a Newton iteration costs one real and one complex solve:
//
//     (g/h I - J) dw1 = T^-1 f |1 - g/h w1,        (a + ib)/h I - J    likewise for w2 + i w3
//
// Newton policy (the stiff direction turns with the body, and this is worth a
// factor of 200 in step length):
//     J and LU at the predicted middle of the step, kept while Newton was fast and h stays
//     simplified iterations while they contract by half or better, since factors cost as much as
//         three of them; else a new J at the current middle stage
//     the first 5 corrections may grow up to 5 times; 12 iterations
//     what that does not solve is tried again with a Jacobian for each stage (coupled_stages.h),
//         and longer steps are from then on; then the step is halved, and grows slowly to what
//         failed
//     done when  rate/(1 - rate) |dz| < min(0.03, 5 sqrt(tolerance)),  |.| in units of the
//         tolerance, or when corrections are what rounding of positions does
//     a first step has the J of its start, which may be far stiffer than its stages are, as where
//         friction begins to slip: then stiff directions get next to nothing, again and again, and
//         the rate of the third correction shows it
//
// Dense output: slopes k_i at the stages and k_0 at the start (that of the end of the step before)
// give a polynomial of degree 4; a position with its velocity gets the quintic of both ends'
// position, velocity and acceleration, and the velocity is its derivative.
#pragma once

#include "integrators/coupled_stages.h"
#include "integrators/method.h"

#include <array>
#include <complex>

namespace solution {

class Radau final : public Method {
public:
    Radau(System& system, ErrorControl& control, bool fixed);

    [[nodiscard]] const char* name() const override { return "radau5"; }
    [[nodiscard]] std::size_t order() const override { return 5; }
    [[nodiscard]] bool implicit() const override { return true; }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;

private:
    using Stages = CoupledStages::Stages;
    using Newton = CoupledStages::Outcome;

    void predict();
    [[nodiscard]] bool linearize(double t, std::span<const double> y);
    [[nodiscard]] bool refactor();
    [[nodiscard]] bool linearizeMiddle();
    [[nodiscard]] Newton solveStages();
    [[nodiscard]] Newton solveTogether();
    [[nodiscard]] Newton iterate();
    [[nodiscard]] std::size_t leastCorrections() const {
        return before_.step > 0 || fixed_ ? 1 : 3;
    }
    [[nodiscard]] bool stageRates();
    [[nodiscard]] bool correct(double& size);
    void middle(std::vector<double>& y) const;
    [[nodiscard]] double estimate();
    void removeRounding();
    [[nodiscard]] double denseError();
    [[nodiscard]] Attempt judge(double error);

    std::unique_ptr<LinearSolver> solver_;
    struct Linearized { // the Jacobian, and the factors of the matrices with it
        std::vector<double> jacobian;
        bool isFresh = false, isFactored = false;
        double step = 0; // of the factors
    };
    Linearized linear_;
    struct Together { // steps of which one Jacobian does not solve the stages
        std::unique_ptr<CoupledStages> stages;
        double from = infinity; // steps of this length on are solved so at once
        std::size_t steps = 0;
        double unsolved = infinity; // the last that Newton did not solve, a little forgotten
    };
    Together together_;

    Stages z_, w_, f_;
    struct Before { // the step before, and what it says of this one
        Stages z;
        double step = 0; // 0: none
        std::vector<double> predictedEnd;
    };
    Before before_;
    std::vector<double> at_, error_, errorRates_, endSlope_, startSlope_;
    std::vector<std::complex<double>> pair_;

    struct Iteration {
        std::size_t count = 0;
        double rate = 0; // contraction of the last Newton iteration of the last step
    };
    Iteration newton_;
    struct Controller { // Gustafsson's, which predicts
        bool isFirst = true, isAfterRejection = false;
        double step = 0, error = 1e-2; // accepted last; 0: none
    };
    Controller controller_;
};

} // namespace solution
