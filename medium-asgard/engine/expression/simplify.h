// Local algebra: the node that says the same as an operation on given arguments, if there is a
// shorter one.
//
// Every rule looks at the operation and at most two levels below it, so that building stays linear.
// Rules may drop an operand that a 0 makes irrelevant (x*0 -> 0, x-x -> 0, 0/x -> 0) although IEEE
// arithmetic would let its NaN through: dependencies must be exact, since partitioning follows
// them. Sums are never regrouped: (x - 1e6) + 0.1 keeps its own rounding, which is exact where x -
// 999999.9 is not. Products with constants are, since they lose nothing.
//
// The guards of sign, abs, min, max and comparisons are written in one way, whatever numbers stand
// in front of them: sign(3*v) is sign(v), 3*a < 3*b is a < b, and so is sign(v*abs(v)). Two that
// switch at the same place can then be seen to (equations/surfaces.h).
#pragma once

#include "expression/graph.h"

#include <optional>
#include <span>

namespace expression {

[[nodiscard]] std::optional<Node> simplified(Graph& graph, Op op, std::span<const Node> arguments);

} // namespace expression
