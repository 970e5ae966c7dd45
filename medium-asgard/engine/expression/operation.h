// The name and the value of each operation: one meaning for folding and for evaluation.
//
// Arithmetic is plain IEEE 754, nothing traps; a NaN in min, max, sign, abs, floor or ceil stays a
// NaN, so that a force that is not a number is never hidden. Elementary functions are the C
// library's, one value at a time. The power with a whole or half exponent up to 4 is products and
// a square root (every factor rounded once, so within 3 units in the last place); any other is the
// library's pow, which is within one.
#pragma once

#include "expression/graph.h"

#include <string_view>

namespace expression {

[[nodiscard]] int argumentCount(Op op);
[[nodiscard]] std::string_view nameOf(Op op); // as it is called in a text: "sin", "+", "?:"
[[nodiscard]] bool isCommutative(Op op);
[[nodiscard]] bool isTruth(Op op);  // its value is 0 or 1
[[nodiscard]] bool isSwitch(Op op); // its value or slope jumps where a guard is 0 (see tape.h)

[[nodiscard]] double compute(Op op, double a, double b = 0, double c = 0);
[[nodiscard]] double powerOf(double base, double exponent);
[[nodiscard]] bool isShortPower(double exponent); // products and a root
[[nodiscard]] double signOf(double x);            // -1, 0, 1; NaN stays

} // namespace expression
