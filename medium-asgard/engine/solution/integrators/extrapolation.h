// The extrapolation method of Gragg, Bulirsch and Stoer with four columns, written out as a table:
// an explicit Runge-Kutta method of order 8 with an embedded one of order 6.
//
// Column j takes the step in n_j = 2, 6, 10, 14 parts by the explicit midpoint rule, whose error
// has an expansion in (h/n_j)^2; Aitken and Neville's scheme removes its terms. These n_j put an
// odd point into the middle of the step, so that values and differences there have such expansions
// too and make the dense output, of order 7 (Hairer and Ostermann 1990; Hairer, Norsett and Wanner,
// Solving ODEs I, II.9).
#pragma once

#include "integrators/tableau.h"

namespace solution {

[[nodiscard]] Tableau makeExtrapolation();

} // namespace solution
