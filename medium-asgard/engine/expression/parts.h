// Of which formulas is a node a part?
//
//     for (const auto& [node, formulas] : partsOf(graph, {{x' of a}, {x' of b}}, isLeftOut)) ...
//
// Formulas share most of their nodes, as the rates of bodies in contact do. So one walk looks at
// sixty-four of them together, at each node once, and says of it by bits in which of them it is.
#pragma once

#include "expression/graph.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace expression {

inline constexpr std::size_t formulasAtOnce = 64;

struct PartOf {
    Node node;
    std::uint64_t formulas = 0; // a bit for each
};

// Of at most `formulasAtOnce` formulas, each of some nodes; what reads a node comes before it.
// isLeftOut(node): nothing is asked of it nor, through it, of what it is made of; none: none is.
[[nodiscard]] std::vector<PartOf> partsOf(const Graph& graph,
                                          std::span<const std::vector<Node>> formulas,
                                          const std::function<bool(Node)>& isLeftOut = {});

// each(f): of the formulas that these bits name, in order.
template <class Each> void eachFormula(std::uint64_t bits, const Each& each) {
    for (; bits != 0; bits &= bits - 1)
        each(static_cast<std::size_t>(std::countr_zero(bits)));
}

} // namespace expression
