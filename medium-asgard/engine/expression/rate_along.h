// How do values change while what they read changes?
#pragma once

#include "expression/graph.h"

#include <span>
#include <vector>

namespace expression {

// Of each root, its rate while these symbols change at these rates, and no others do: one
// derivative for each node, where gradients() makes one for each node and symbol.
[[nodiscard]] std::vector<Node> ratesAlong(Graph& graph, std::span<const Node> roots,
                                           std::span<const Node> symbols,
                                           std::span<const Node> rates);

} // namespace expression
