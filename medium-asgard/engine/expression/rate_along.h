// How do values change while what they read changes?
#pragma once

#include "expression/graph.h"

#include <span>
#include <vector>

namespace expression {

// Of each root, its rate while these symbols change at these rates, and no others do: one
// derivative for each node, where gradients() makes one for each node and symbol. Other nodes than
// symbols may be given, whose rates are known: those that follow from their arguments are not made.
// Each is given once.
[[nodiscard]] std::vector<Node> ratesAlong(Graph& graph, std::span<const Node> roots,
                                           std::span<const Node> moving,
                                           std::span<const Node> rates);

} // namespace expression
