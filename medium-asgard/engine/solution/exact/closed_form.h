// Unknowns that need no integrator: those whose rate, or held value, is a polynomial in time on a
// whole interval, given that time and all that they read are polynomials there.
//
// A body that slides on a plane without friction is one too: the forces of its contacts are
// constant, since their second rates read nothing that changes. LIMIT: friction that slips, and
// forces that change with time, are integrated.
//
// A ballistic coordinate is one piece until something happens to it; a position whose velocity is
// integrated by a method is the exact integral of the velocity's pieces.
#pragma once

#include "modes/component_equations.h"

namespace solution {

struct ClosedForm {
    double scale = 1, until = infinity;
    std::vector<Coefficients> columns; // states, then held unknowns
};

// From t on, with the states' values there; until the end of the inputs' pieces at t. None: some
// right-hand side is no polynomial, reads a state that depends on it, or has too high a degree; or
// the forces of multipliers change.
[[nodiscard]] std::optional<ClosedForm> closedForm(ComponentEquations& equations, double t,
                                                   std::span<const double> y);

// y' = A y + b with constant A and b, until the end of the inputs' pieces at t (linear_motion.h).
struct LinearForm {
    double until = infinity;
    std::vector<double> matrix; // A by rows, each followed by its entry of b
};
// None: a rate is something else; or that there are held values, multipliers or switches.
[[nodiscard]] std::optional<LinearForm> linearForm(ComponentEquations& equations, double t);

} // namespace solution
