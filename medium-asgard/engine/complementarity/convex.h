// Intervals on a symmetric, positive semidefinite A: always the same answer, and always found.
//
// The forces are where the convex function f.A f/2 + b.f has its minimum within the intervals. The
// active set method of Lawson and Hanson (Solving Least Squares Problems, 1974, chapter 23) finds
// it, with two ends to each interval as in Stark and Parker (Bounded-variable least squares, 1995).
// Redundant laws (four feet of a table) make A singular and f not unique, but A f is; then the
// shortest f is taken, which shares a load evenly.
#pragma once

#include "complementarity/laws.h"

#include <optional>

namespace complementarity {

// Nothing when no forces within the intervals keep the laws: joints or motors that contradict each
// other. `laws` has intervals only.
[[nodiscard]] std::optional<Answer> solveConvex(const Matrix& a, const Vector& b, const Laws& laws);

} // namespace complementarity
