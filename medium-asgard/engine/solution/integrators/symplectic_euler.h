// Symplectic Euler: velocities by the rates at the start, then positions by the new velocities.
//
//     v1 = v0 + h f_v(t, x0, v0)          x1 = x0 + h f_x(t + h, x0, v1)
//
// Order 1; on an oscillator stable, with bounded energy, up to h = 2/w; damping is explicit
// (Hairer, Lubich and Wanner, Geometric Numerical Integration, I.1.2).
#pragma once

#include "integrators/method.h"

namespace solution {

class SymplecticEuler final : public Method {
public:
    SymplecticEuler(System& system, ErrorControl& control);

    [[nodiscard]] const char* name() const override { return "symplectic-euler"; }
    [[nodiscard]] std::size_t order() const override { return 1; }
    [[nodiscard]] bool implicit() const override { return false; }
    [[nodiscard]] bool begin(double t, std::span<const double> y) override;
    [[nodiscard]] Attempt attempt(double h) override;
    void dense(std::span<Coefficients> columns) override;
    [[nodiscard]] bool proceed(std::span<const double> y) override;

private:
    std::vector<double> at_, rates_;
};

} // namespace solution
