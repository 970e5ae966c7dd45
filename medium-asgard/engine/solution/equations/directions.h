// Which unit vectors do expressions have, that have none at 0?
//
// Friction in a plane is written -k*dx/hypot(dx,dz) and -k*dz/hypot(dx,dz): k times a/|a|, with
// a = (dx, dz). At a = 0 that is 0/0. Such a vector is a Direction: its length |a|, as hypot() or
// as the root of a sum of squares, by which something is divided, and its parts.
//
// LIMIT: a length that is divided by in a higher power, or of which something is added before
// (dx/(hypot(dx,dz)+1e-6)), is no direction, nor are parts that are written as other expressions in
// the numerators than in the length.
#pragma once

#include "expression/graph.h"

#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace solution {

struct Direction {
    struct Part {
        expression::Node node;
        std::optional<expression::Node> weight; // of its square; none: 1
    };
    expression::Node length; // the root of the sum of the squares
    std::vector<Part> parts;
};

// hypot(), or the root of a sum or of a square.
[[nodiscard]] bool isLength(const expression::Graph& graph, expression::Node node);

// Of a product, signs taken off; of a quotient those of its numerator.
[[nodiscard]] std::vector<expression::Node> factorsOf(const expression::Graph& graph,
                                                      expression::Node product);

// A quotient in which one factor of the denominator alone is 0, a length, and the numerator has one
// of its parts as a factor: a direction times something.
[[nodiscard]] bool isDirectionAtRest(const expression::Graph& graph, expression::Node quotient,
                                     const std::vector<bool>& isZero);

// Something in it is divided by a length: a look at every node.
[[nodiscard]] bool dividesByLength(const expression::Graph& graph);

// Lengths by which some of these are divided, in order of index.
[[nodiscard]] std::vector<expression::Node>
lengthsDividedBy(const expression::Graph& graph, std::span<const expression::Node> outputs);
// Lengths by which the nodes themselves are divided, without a look at their arguments.
[[nodiscard]] std::vector<expression::Node>
lengthsInQuotients(const expression::Graph& graph, std::span<const expression::Node> nodes);

// None: it is no length of parts that are 0 together. `isNumber` tells symbols that are numbers.
// New nodes go into the graph.
[[nodiscard]] std::optional<Direction>
directionOf(expression::Graph& graph, expression::Node length,
            const std::function<bool(expression::Node)>& isNumber);

// The outputs with other nodes in place of what is divided by these lengths, and of what it is
// multiplied with: lengths and parts are replaced there, and nowhere else.
[[nodiscard]] std::vector<expression::Node>
withDirections(expression::Graph& graph, std::span<const expression::Node> outputs,
               std::span<const expression::Node> lengths,
               const std::unordered_map<std::uint32_t, expression::Node>& replacements);

// The outputs with 0 for the directions of what is 0.
[[nodiscard]] std::vector<expression::Node>
withoutForcesAtRest(expression::Graph& graph, std::span<const expression::Node> outputs);

} // namespace solution
