// Laws of faces that press at several points: friction acts at the centre of the normal forces, and
// the forces of a slip follow them there. A path on which the centres follow leads there as a rule
// (together.h). Else the search holds the centres, solves, and moves them to the answer's
// (fixed_point.h), from several starts. Forces that bodies share in many ways, as in a
// wall, may lead it from one centre to another without end: then a pull to the last answer, at its
// own centres, leaves one way to share them. If no start leads to an end, friction grows from none
// to its own.
#pragma once

#include "complementarity/solve.h"

namespace complementarity {

[[nodiscard]] std::optional<Answer> solveFromCentres(const Matrix& a, const Vector& b,
                                                     const Laws& laws, const Answer& guess,
                                                     Work& work);

// The search for centres may find no end. Here each disc acts at a place held near its centre, and
// keeps Coulomb's law there. Of discs and intervals on a symmetric A; there is one wherever bodies
// can part (widened.h).
[[nodiscard]] std::optional<Answer> solveBesideCentres(const Matrix& a, const Vector& b,
                                                       const Laws& laws);

} // namespace complementarity
