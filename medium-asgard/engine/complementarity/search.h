// The search for the states of laws: of discs that act where their rows say, and of intervals
// (solve.h says by which ways, and in which order).
#pragma once

#include "complementarity/solve.h"

namespace complementarity {

inline constexpr double kept = 1e-11;  // a violation under this is rounding
inline constexpr double hardly = 1e-9; // under this no slower way looks for a better answer

// Intervals on a symmetric A without a negative direction.
[[nodiscard]] bool isConvex(const Matrix& a, const Laws& laws);
// Laws that hold at centres, or follow these: slips, and discs with levers.
[[nodiscard]] bool haveCentres(const Laws& laws);

// Of laws without centres.
[[nodiscard]] std::optional<Answer>
solveAtMiddles(const Matrix& a, const Vector& b, const Laws& laws, const Answer& guess, Work& work);
// From the states and forces of a guess, and those that their faults ask for; of laws of any kind.
[[nodiscard]] std::optional<Answer> around(const Matrix& a, const Vector& b, const Laws& laws,
                                           const Answer& guess, Work& work);
// By steps to answers that a pull keeps near the last one, while the pull fades; of laws of any
// kind.
[[nodiscard]] std::optional<Answer> pulledFrom(const Matrix& a, const Vector& b, const Laws& laws,
                                               const Answer& guess, Work& work);

} // namespace complementarity
