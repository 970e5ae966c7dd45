// The multipliers that keep conditions, as expressions: the elimination of A m = -b, written out.
//
// Machine code of these expressions has no indices to follow, and shares what conditions and rates
// have in common. They are in a graph of their own, in the order in which they are best evaluated:
// entries when their row is eliminated, rates as soon as their multipliers are known. In products
// constants come first, then what the states say, then multipliers, so that products are shared;
// division by a constant is multiplication by its inverse.
//
// They are good for nothing where rows make others next to redundant, as the checks say, and where
// the matrix is not symmetric, as where forces read forces.
#pragma once

#include "equations/elimination_order.h"
#include "expression/graph.h"

#include <optional>
#include <span>
#include <vector>

namespace solution {

// A pivot that is less, of what the diagonal had, may be what rounding leaves of 0.
inline constexpr double leastPivot = 1e-10;

struct LinearConditions {                                              // A m + b = 0
    const expression::Graph& graph;                                    // has the nodes
    std::span<const expression::Node> symbols, constants, multipliers; // symbols: all of them
    std::vector<expression::Node> held;                                // multipliers, by row
    std::vector<EliminationOrder::Place> places;
    std::vector<expression::Node> entries; // of A at these places; elsewhere 0
    std::vector<expression::Node> rests;   // b
};

struct SolvedConditions {
    expression::Graph graph;
    std::vector<expression::Node> symbols;     // as those that were given
    std::vector<expression::Node> outputs;     // with the multipliers put in
    std::vector<expression::Node> multipliers; // by row
    std::vector<expression::Node> checks;      // all of them are positive: no pivot is next to 0
    std::size_t multiplications = 0;
};

// None: the matrix is so full that a dense factorization costs less, or its code would be long; or
// it has no diagonal.
[[nodiscard]] std::optional<SolvedConditions>
solvedConditions(const LinearConditions& conditions, std::span<const expression::Node> outputs);

} // namespace solution
