// Solves (shift I - J) x = b for a real and a complex shift, J sparse and given by its entries.
//
// Small systems are solved dense (Eigen, partial pivoting), others by KLU: analysed once for each
// pattern, then refactored with the same pivots as long as they stay good (reciprocal condition).
// From n = 13 on KLU is faster (docs/numerics.md).
#pragma once

#include "integrators/system.h"

#include <complex>
#include <memory>
#include <span>

namespace solution {

class LinearSolver {
public:
    explicit LinearSolver(const Pattern& pattern);
    ~LinearSolver();
    LinearSolver(const LinearSolver&) = delete;
    LinearSolver& operator=(const LinearSolver&) = delete;

    // False: singular to rounding, or not finite.
    [[nodiscard]] bool factor(std::span<const double> jacobian, double shift,
                              std::complex<double> complexShift);
    // The real one alone.
    [[nodiscard]] bool factor(std::span<const double> jacobian, double shift);
    void solve(std::span<double> x) const;
    void solve(std::span<std::complex<double>> x) const;

private:
    class Dense;
    class Sparse;
    std::unique_ptr<Dense> dense_;
    std::unique_ptr<Sparse> sparse_;
};

} // namespace solution
