// Rosenbrock methods, from tables: linearly implicit, one Jacobian and one factorisation a step, no
// Newton iteration. In the variables that need no product with J (Hairer and Wanner, Solving ODEs
// II, IV.7, equation 7.25), f_t the derivative by time, E = I/(h g) - J:
//
//   E u_i = f(t + alpha_i h, y + sum_{j<i} a_ij u_j) + sum_{j<i} c_ij/h u_j + gamma_i h f_t
//   y1 = y + sum_i m_i u_i                                  error = sum_i e_i u_i
#pragma once

#include "integrators/linear_solver.h"
#include "integrators/method.h"

namespace solution {

struct RosenbrockTableau {
    const char* name;
    std::size_t order = 0, errorOrder = 0;
    double diagonal = 0; // g
    std::vector<double> alpha = {}, gamma = {};
    std::vector<std::vector<double>> a = {}, c = {};
    std::vector<double> m = {}, error = {};
    // y + s (y1 - y) + s (1 - s) (p + s q),  p and q sums of u_i
    std::vector<double> p = {}, q = {};
};

// Null for a name that is not in the tables: rodas4.
[[nodiscard]] const RosenbrockTableau* rosenbrockTableauNamed(const std::string& name);

class Rosenbrock final : public Method {
public:
    Rosenbrock(const RosenbrockTableau& tableau, System& system, ErrorControl& control, bool fixed);

    [[nodiscard]] const char* name() const override { return tableau_.name; }
    [[nodiscard]] std::size_t order() const override { return tableau_.order; }
    [[nodiscard]] bool implicit() const override { return true; }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;

private:
    [[nodiscard]] bool linearize();
    [[nodiscard]] bool stage(std::size_t i);
    [[nodiscard]] double combination(std::span<const double> weights, std::size_t n) const;

    const RosenbrockTableau& tableau_;
    std::unique_ptr<LinearSolver> solver_;
    std::vector<double> jacobian_;
    bool linearized_ = false; // at this start
    std::vector<std::vector<double>> u_;
    std::vector<double> timeSlope_, at_, error_;
    bool afterRejection_ = false;
};

} // namespace solution
