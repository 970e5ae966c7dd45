// The laws by pivots, where they are linear: Lemke's method.
//
// In a plane a disc has one row. Its force is p - n, its slip s, and all laws read
//
//     w = M x + q,   x >= 0,   w >= 0,   x w = 0
//
// A number z that is added to all w makes x = 0 an answer. Pivots take z back to 0 and keep the
// rest (Lemke, Management Science 11, 1965; for friction: Stewart and Trinkle, International
// Journal for Numerical Methods in Engineering 39, 1996; ties by the lexicographic rule: Cottle,
// Pang and Stone, The Linear Complementarity Problem, 2009, 4.9). A problem whose contacts are
// redundant, and of which many just touch without a force, is as good as any other: there, the path
// of interior.h ends at forces and rates that are both next to 0.
//
// The answer is a corner of the set of answers: of redundant contacts no more press than must.
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

// Without slips and levers. Nothing: a disc has several rows that others move, the laws are too
// many, or the pivots end without an answer.
[[nodiscard]] std::optional<Answer> byPivots(const Matrix& a, const Vector& b, const Laws& laws);

} // namespace complementarity
