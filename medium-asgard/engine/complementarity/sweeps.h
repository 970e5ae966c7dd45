// Sweeps over the laws, one law solved after another with the forces of all others as they are
// (projected Gauss and Seidel; Jean, The non-smooth contact dynamics method, 1999). They converge
// slowly, but from anywhere.
#pragma once

#include "complementarity/laws.h"

namespace complementarity {

// One sweep. Gives the largest change of a force.
double sweep(const Matrix& a, const Vector& b, const Laws& laws, Vector& forces);

// The states that these forces are in.
[[nodiscard]] States statesOf(const Matrix& a, const Vector& b, const Laws& laws,
                              const Vector& forces);

} // namespace complementarity
