#include "equations/directions.h"

#include "expression/operation.h"

#include <algorithm>
#include <iterator>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

// With a number before it at most: what is left of a sum where the others are 0 throughout.
bool isOneSquare(const Graph& graph, Node n) {
    const auto isSquare = [&](Node x) {
        return graph.op(x) == Op::power && graph.isConstant(graph.arguments(x)[1], 2);
    };
    return isSquare(n) || (graph.op(n) == Op::multiply &&
                           (isSquare(graph.arguments(n)[0]) || isSquare(graph.arguments(n)[1])));
}

} // namespace

bool isLength(const Graph& graph, Node n) {
    if (graph.op(n) != Op::sqrt)
        return graph.op(n) == Op::hypot;
    const Node under = graph.arguments(n)[0];
    return graph.op(under) == Op::add || isOneSquare(graph, under);
}

std::vector<Node> factorsOf(const Graph& graph, Node product) {
    std::vector<Node> open{product}, factors;
    while (!open.empty()) {
        const Node n = open.back();
        open.pop_back();
        const auto arguments = graph.arguments(n);
        if (graph.op(n) == Op::multiply)
            open.insert(open.end(), arguments.begin(), arguments.end());
        else if (graph.op(n) == Op::negate || graph.op(n) == Op::divide)
            open.push_back(arguments[0]);
        else
            factors.push_back(n);
    }
    return factors;
}

namespace {

// The lengths that are factors of a denominator.
void lengthsIn(const Graph& graph, Node denominator, std::vector<Node>& found) {
    std::ranges::copy_if(factorsOf(graph, denominator), std::back_inserter(found),
                         [&](Node n) { return isLength(graph, n); });
}

// Of a term of a sum, what is squared in it; none: nothing is, or something else in it is 0 too.
std::optional<Node> squaredIn(const Graph& graph, Node term, const std::vector<bool>& isZero) {
    std::optional<Node> squared;
    for (const Node factor : factorsOf(graph, term))
        if (graph.op(factor) == Op::power && graph.isConstant(graph.arguments(factor)[1], 2))
            squared = graph.arguments(factor)[0];
        else if (isZero[factor.index])
            return std::nullopt;
    return squared;
}

// The arguments of hypot(), or the terms of the sum under a root: the last first.
std::vector<Node> termsOf(const Graph& graph, Node length) {
    const Op inner = graph.op(length) == Op::sqrt ? Op::add : Op::hypot;
    std::vector<Node> open(graph.arguments(length).begin(), graph.arguments(length).end()), terms;
    while (!open.empty()) {
        const Node n = open.back();
        open.pop_back();
        if (graph.op(n) == inner)
            open.insert(open.end(), graph.arguments(n).begin(), graph.arguments(n).end());
        else
            terms.push_back(n);
    }
    return terms;
}

// What a length is the length of; none where it is no root of squares. Numbers before them stay
// out.
std::vector<Node> partsOfLength(const Graph& graph, Node length, const std::vector<bool>& isZero) {
    std::vector<Node> parts;
    for (const Node term : termsOf(graph, length))
        if (graph.op(length) == Op::hypot)
            std::ranges::copy(factorsOf(graph, term), std::back_inserter(parts));
        else if (const auto squared = squaredIn(graph, term, isZero))
            parts.push_back(*squared);
        else
            return {};
    return parts;
}

bool isSameButSign(const Graph& graph, Node a, Node b) {
    return a == b || (graph.op(a) == Op::subtract && graph.op(b) == Op::subtract &&
                      graph.arguments(a)[0] == graph.arguments(b)[1] &&
                      graph.arguments(a)[1] == graph.arguments(b)[0]);
}

// A square, of what it is the square, and what it is multiplied with.
std::optional<Direction::Part> squareIn(Graph& graph, Node n,
                                        const std::function<bool(Node)>& isNumber) {
    Direction::Part part{n, {}};
    const auto arguments = graph.arguments(n);
    const Node first = arguments.empty() ? n : arguments[0];
    switch (graph.op(n)) {
    case Op::power:
        if (!graph.isConstant(arguments[1], 2))
            return std::nullopt;
        part.node = first;
        return part;
    case Op::multiply: {
        const Node second = arguments[1];
        if (first == second) {
            part.node = first;
            return part;
        }
        const bool isFirst = isNumber(first);
        if (!isFirst && !isNumber(second))
            return std::nullopt;
        auto inner = squareIn(graph, isFirst ? second : first, isNumber);
        if (inner) {
            const Node factor = isFirst ? first : second;
            inner->weight = inner->weight ? graph.multiply(factor, *inner->weight) : factor;
        }
        return inner;
    }
    default:
        return std::nullopt;
    }
}

// Of an argument of hypot(): numbers before it and signs are taken off.
Direction::Part partIn(Graph& graph, Node n, const std::function<bool(Node)>& isNumber) {
    Direction::Part part{n, {}};
    for (;;) {
        const auto arguments = graph.arguments(part.node);
        const Op op = graph.op(part.node);
        if (op == Op::negate || op == Op::abs) {
            part.node = arguments[0];
            continue;
        }
        if (op != Op::multiply || (!isNumber(arguments[0]) && !isNumber(arguments[1])))
            return part;
        const Node factor = arguments[isNumber(arguments[0]) ? 0 : 1];
        part.node = arguments[isNumber(arguments[0]) ? 1 : 0];
        const Node square = graph.multiply(factor, factor);
        part.weight = part.weight ? graph.multiply(square, *part.weight) : square;
    }
}

// By node: it is divided by one of these lengths, or multiplied with what is.
std::vector<bool> quotientsAmong(const Graph& graph, std::span<const Node> nodes,
                                 std::span<const Node> lengths) {
    std::vector<bool> isQuotient(graph.size(), false);
    for (const Node n : nodes) { // arguments come first
        const auto arguments = graph.arguments(n);
        const auto is = [&](std::size_t k) {
            return static_cast<bool>(isQuotient[arguments[k].index]);
        };
        if (graph.op(n) == Op::divide) {
            std::vector<Node> found;
            lengthsIn(graph, arguments[1], found);
            isQuotient[n.index] = is(0) || std::ranges::any_of(found, [&](Node length) {
                                      return std::ranges::find(lengths, length) != lengths.end();
                                  });
        } else if (graph.op(n) == Op::multiply) {
            isQuotient[n.index] = is(0) || is(1);
        } else if (graph.op(n) == Op::negate) {
            isQuotient[n.index] = is(0);
        }
    }
    return isQuotient;
}

} // namespace

bool isDirectionAtRest(const Graph& graph, Node quotient, const std::vector<bool>& isZero) {
    std::vector<Node> zeros = factorsOf(graph, graph.arguments(quotient)[1]);
    std::erase_if(zeros, [&](Node factor) { return !isZero[factor.index]; });
    if (zeros.size() != 1 || !isLength(graph, zeros[0]))
        return false;
    const std::vector<Node> parts = partsOfLength(graph, zeros[0], isZero);
    return std::ranges::any_of(factorsOf(graph, graph.arguments(quotient)[0]), [&](Node factor) {
        return std::ranges::any_of(parts,
                                   [&](Node part) { return isSameButSign(graph, factor, part); });
    });
}

bool dividesByLength(const Graph& graph) {
    std::vector<Node> found;
    for (std::uint32_t n = 0; n < graph.size() && found.empty(); ++n)
        if (graph.op(Node{n}) == Op::divide)
            lengthsIn(graph, graph.arguments(Node{n})[1], found);
    return !found.empty();
}

std::vector<Node> lengthsDividedBy(const Graph& graph, std::span<const Node> outputs) {
    return lengthsInQuotients(graph, expression::reachable(graph, outputs));
}

std::vector<Node> lengthsInQuotients(const Graph& graph, std::span<const Node> nodes) {
    std::vector<Node> found;
    for (const Node n : nodes)
        if (graph.op(n) == Op::divide)
            lengthsIn(graph, graph.arguments(n)[1], found);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::optional<Direction> directionOf(Graph& graph, Node length,
                                     const std::function<bool(Node)>& isNumber) {
    Direction direction{length, {}};
    const bool isRoot = graph.op(length) == Op::sqrt;
    for (const Node term : termsOf(graph, length)) {
        if (graph.isConstant(term, 0))
            continue;
        const auto part = isRoot ? squareIn(graph, term, isNumber) : partIn(graph, term, isNumber);
        if (!part || isNumber(part->node))
            return std::nullopt;
        direction.parts.push_back(*part);
    }
    std::ranges::reverse(direction.parts);
    constexpr std::size_t most = 3;
    if (direction.parts.empty() || direction.parts.size() > most)
        return std::nullopt;
    return direction;
}

std::vector<Node> withDirections(Graph& graph, std::span<const Node> outputs,
                                 std::span<const Node> lengths,
                                 const std::unordered_map<std::uint32_t, Node>& replacements) {
    const std::vector<Node> nodes = expression::reachable(graph, outputs);
    const std::vector<bool> isQuotient = quotientsAmong(graph, nodes, lengths);
    std::unordered_map<std::uint32_t, Node> inside = replacements, outside;
    for (const Node n : nodes) // what switches goes on with what it is
        if (expression::isSwitch(graph.op(n)))
            inside.emplace(n.index, n);
    const auto replace = [&](Node quotient) {
        if (isQuotient[quotient.index] && !outside.contains(quotient.index))
            outside.emplace(quotient.index, expression::substitute(graph, quotient, inside));
    };
    for (const Node n : nodes)
        if (!isQuotient[n.index]) {
            const std::vector<Node> arguments(graph.arguments(n).begin(), graph.arguments(n).end());
            std::ranges::for_each(arguments, replace);
        }
    std::ranges::for_each(outputs, replace);
    std::vector<Node> replaced;
    for (const Node output : outputs)
        replaced.push_back(expression::substitute(graph, output, outside));
    return replaced;
}

std::vector<Node> withoutForcesAtRest(Graph& graph, std::span<const Node> outputs) {
    const std::vector<Node> lengths = lengthsDividedBy(graph, outputs);
    std::unordered_map<std::uint32_t, Node> replacements;
    for (const Node length : lengths)
        replacements.emplace(length.index,
                             graph.apply(Op::select, length, length, graph.constant(1)));
    return withDirections(graph, outputs, lengths, replacements);
}

} // namespace solution
