// The forces of given states, to the last bits.
//
// Once it is known of each law whether its force is inside, at a bound or at the edge, the laws are
// equations: rates inside are 0, and at the edge of a disc  w + s f = 0, |f| = r  with an unknown
// s >= 0 (Alart and Curnier, 1991, for the edge). Those of discs hold at the centre of their normal
// forces, which moves with these, and so does the direction of a slip. Newton's method solves them.
// Of many solutions one takes the shortest, or the nearest.
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

enum class Aim { shortest, nearest }; // of many solutions

// From the forces `near`. Nothing where the equations have no solution.
[[nodiscard]] std::optional<Answer> solveStates(const Matrix& a, const Vector& b, const Laws& laws,
                                                const States& states, const Vector& near, Aim aim);

// The states that the answer's wrong forces and rates ask for: a law that is right keeps its own.
[[nodiscard]] States improved(const Laws& laws, const Answer& answer);

// The law with the largest rate of those inside leaves, in the direction of its rate: for rates
// that cannot all be 0, as those of a table with four feet that are not quite in one plane.
[[nodiscard]] States opened(const Laws& laws, const Answer& answer);

} // namespace complementarity
