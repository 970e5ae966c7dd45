// Diagonally implicit Runge-Kutta methods, from tables: each stage is solved by itself.
//
//   Y_i = y + h sum_{j<i} a_ij k_j + h g k_i       y1 = y + h sum_i b_i k_i
//
// All implicit stages have the same g, so that one factorisation of I/(h g) - J serves them all; a
// first stage with a_11 = 0 is explicit. Newton works on z = h g k_i, whose last value is the slope
// too: an evaluation there would multiply what Newton left by the stiffness.
//
// Newton policy as Radau's (radau.h): J at the predicted stage, simplified iterations while they
// contract by 0.1 or better, else a new J at the current value; corrections may grow at first; none
// counts whose Jacobian stands where links are far stretched (coupled_stages.h). When
// that fails, once more from the start's value with a new J for each iteration.
// With `stepByNewton` there is no error control: the step follows the number of iterations, as
// dissertation 5.2 has it (halved when Newton fails or takes many, doubled when it takes few),
// with a new J for each iteration and the start's value as the first guess.
//
// The estimate of a pair is smoothed by (I/(h g) - J)^-1, so that stiff components do not rule it.
// Sources: Hairer and Wanner, Solving ODEs II, IV.6 and IV.8; Hosea and Shampine 1996.
#pragma once

#include "integrators/linear_solver.h"
#include "integrators/method.h"

namespace solution {

struct DiagonalTableau {
    const char* name;
    std::size_t order = 0;
    std::vector<double> c = {};
    std::vector<std::vector<double>> a = {}; // with the diagonal
    std::vector<double> b = {};
    std::vector<double> error = {}; // b less the weights of the embedded method; may be empty
    std::size_t errorOrder = 0;     // of the less accurate of the two
    bool stepByNewton = false;

    [[nodiscard]] bool explicitFirst() const { return a[0][0] == 0; }
    [[nodiscard]] double diagonal() const { return a.back().back(); }
    [[nodiscard]] bool endsAtLastStage() const { return a.back() == b; }
};

// Null for a name that is not in the tables: backward-euler, midpoint, trapezoidal, tr-bdf2,
// sdirk4, original.
[[nodiscard]] const DiagonalTableau* diagonalTableauNamed(const std::string& name);

class DiagonallyImplicit final : public Method {
public:
    DiagonallyImplicit(const DiagonalTableau& tableau, System& system, ErrorControl& control,
                       bool fixed);

    [[nodiscard]] const char* name() const override { return tableau_.name; }
    [[nodiscard]] std::size_t order() const override { return tableau_.order; }
    [[nodiscard]] bool implicit() const override { return true; }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;

private:
    enum class Newton { converged, failed, notFinite };

    [[nodiscard]] Newton stages();
    [[nodiscard]] Newton solveStage(std::size_t i);
    [[nodiscard]] Newton iterate(std::size_t i, bool full, bool isNew);
    [[nodiscard]] bool missing(std::size_t i, double& displacement);
    [[nodiscard]] double correct();
    [[nodiscard]] bool linearizeAt(std::size_t i);
    [[nodiscard]] Attempt judge();
    [[nodiscard]] Attempt judgeByNewton() const;

    const DiagonalTableau& tableau_;
    std::unique_ptr<LinearSolver> solver_;
    std::vector<double> jacobian_;
    struct Factors { // of the matrix of Newton's iteration
        bool areMade = false;
        double step = 0, displaced = 0; // where the Jacobian stands
    };
    Factors factors_;
    double rate_ = 1; // contraction of Newton's last iteration
    std::size_t iterations_ = 0, mostIterations_ = 0;

    std::vector<std::vector<double>> k_;
    std::vector<double> base_, z_, at_, correction_;
    std::vector<double> lastSlope_; // of the step before at its end; the start's at first
    bool afterRejection_ = false;
};

} // namespace solution
