// The multipliers that keep conditions, as expressions: the elimination of A m = -b, written out.
//
// Machine code of these expressions has no indices to follow, and shares what conditions and rates
// have in common. They are in a graph of their own, in the order in which they are best evaluated:
// entries when their row is eliminated, rates as soon as their multipliers are known. In products
// constants come first, then what the states say, then multipliers, so that products are shared;
// division by a constant is multiplication by its inverse.
//
// Each evaluation checks itself. Its multipliers are good for nothing where rows make others next
// to redundant, or where conditions keep second rates with them: so it is where the matrix, of
// which one half is read, is not symmetric, as where a drive follows another joint.
#pragma once

#include "equations/elimination_order.h"
#include "expression/graph.h"

#include <optional>
#include <span>
#include <vector>

namespace solution {

struct LinearConditions {                                              // A m + b = 0
    const expression::Graph& graph;                                    // has the nodes
    std::span<const expression::Node> symbols, constants, multipliers; // symbols: all of them
    std::vector<expression::Node> held;                                // multipliers, by row
    std::vector<EliminationOrder::Place> places;
    std::vector<expression::Node> entries; // of A at these places; elsewhere 0
    std::vector<expression::Node> rests;   // b
    std::vector<expression::Node> lefts;   // A m + b, in any form
};

struct SolvedConditions {
    expression::Graph graph;
    std::vector<expression::Node> symbols;     // as those that were given
    std::vector<expression::Node> outputs;     // with the multipliers put in
    std::vector<expression::Node> multipliers; // by row
    // All of them are positive where the multipliers are right: no pivot is next to 0, and nothing
    // but rounding is left of the conditions.
    std::vector<expression::Node> checks;
};

// None: the matrix is so full that a dense factorization costs less, or that its code, which is in
// proportion to the multiplications, would be long for so many rows.
[[nodiscard]] std::optional<EliminationOrder>
orderToWrite(std::size_t size, std::span<const EliminationOrder::Place> places);

// None: the matrix has no diagonal, or 0 where what mirrors it is another number.
[[nodiscard]] std::optional<SolvedConditions>
solvedConditions(const LinearConditions& conditions, const EliminationOrder& order,
                 std::span<const expression::Node> outputs);

} // namespace solution
