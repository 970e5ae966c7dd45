#include "expression/graph.h"

#include "expression/operation.h"

#include <algorithm>
#include <unordered_set>

namespace expression {

// An own stack: expressions may be very deep.
std::vector<Node> reachable(const Graph& graph, std::span<const Node> roots,
                            const std::unordered_map<std::uint32_t, Node>& end) {
    std::unordered_set<std::uint32_t> seen;
    std::vector<Node> pending(roots.begin(), roots.end()), found;
    while (!pending.empty()) {
        const Node n = pending.back();
        pending.pop_back();
        if (!seen.insert(n.index).second)
            continue;
        found.push_back(n);
        if (end.contains(n.index))
            continue;
        const auto arguments = graph.arguments(n);
        pending.insert(pending.end(), arguments.begin(), arguments.end());
    }
    std::ranges::sort(found);
    return found;
}

namespace {

// The chain rule at one node, given the derivatives of its arguments.
class ChainRule {
public:
    explicit ChainRule(Graph& graph) : g_(graph) {}

    // d n, when its arguments a (and b, c) have derivatives da (and db, dc), not all 0.
    Node operator()(Node n, std::span<const Node> d) {
        const auto a = g_.arguments(n); // stays valid while the graph grows
        const Op op = g_.op(n);
        if (a.size() == 1)
            return g_.multiply(slope(op, n, a[0]), d[0]);
        return op == Op::select ? g_.apply(op, a[0], d[1], d[2]) : binary(op, n, a, d);
    }

private:
    Node number(double value) { return g_.constant(value); }
    Node one() { return number(1); }
    Node square(Node a) { return g_.apply(Op::power, a, number(2)); }
    Node inverse(Node a) { return g_.divide(one(), a); }

    // d op(a) / da, where n is op(a).
    Node slope(Op op, Node n, Node a) {
        switch (op) {
        case Op::negate:
            return number(-1);
        case Op::sin:
            return g_.apply(Op::cos, a);
        case Op::cos:
            return g_.negate(g_.apply(Op::sin, a));
        case Op::tan:
            return g_.add(one(), square(n));
        case Op::asin:
            return inverse(g_.apply(Op::sqrt, g_.subtract(one(), square(a))));
        case Op::acos:
            return g_.negate(slope(Op::asin, n, a));
        case Op::atan:
            return inverse(g_.add(one(), square(a)));
        case Op::sinh:
            return g_.apply(Op::cosh, a);
        case Op::cosh:
            return g_.apply(Op::sinh, a);
        case Op::tanh:
            return g_.subtract(one(), square(n));
        case Op::exp:
            return n;
        case Op::log:
            return inverse(a);
        case Op::log10:
            return inverse(g_.multiply(g_.apply(Op::log, number(10)), a));
        case Op::sqrt:
            return inverse(g_.multiply(number(2), n));
        case Op::abs:
            return g_.apply(Op::sign, a);
        default:
            return number(0); // sign, floor, ceil, !: constant between their switches
        }
    }

    Node binary(Op op, Node n, std::span<const Node> a, std::span<const Node> d) {
        switch (op) {
        case Op::add:
            return g_.add(d[0], d[1]);
        case Op::subtract:
            return g_.subtract(d[0], d[1]);
        case Op::multiply:
            return g_.add(g_.multiply(d[0], a[1]), g_.multiply(a[0], d[1]));
        case Op::divide: // da/b - n db/b
            return g_.subtract(g_.divide(d[0], a[1]), g_.divide(g_.multiply(n, d[1]), a[1]));
        case Op::power:
            return ofPower(n, a, d);
        case Op::atan2: // of (y, x): (x dy - y dx) / (x² + y²)
            return g_.divide(g_.subtract(g_.multiply(a[1], d[0]), g_.multiply(a[0], d[1])),
                             g_.add(square(a[1]), square(a[0])));
        case Op::hypot:
            return g_.divide(g_.add(g_.multiply(a[0], d[0]), g_.multiply(a[1], d[1])), n);
        case Op::min:
            return g_.apply(Op::select, g_.apply(Op::less, a[0], a[1]), d[0], d[1]);
        case Op::max:
            return g_.apply(Op::select, g_.apply(Op::less, a[1], a[0]), d[0], d[1]);
        default:
            return number(0); // comparisons and logic
        }
    }

    // b a^(b-1) da + log(a) a^b db; only the terms that are there, since log(a) may not exist.
    Node ofPower(Node n, std::span<const Node> a, std::span<const Node> d) {
        Node sum = number(0);
        if (!g_.isConstant(d[0], 0)) {
            const Node lower = g_.apply(Op::power, a[0], g_.subtract(a[1], one()));
            sum = g_.multiply(g_.multiply(a[1], lower), d[0]);
        }
        if (!g_.isConstant(d[1], 0))
            sum = g_.add(sum, g_.multiply(g_.multiply(g_.apply(Op::log, a[0]), n), d[1]));
        return sum;
    }

    Graph& g_;
};

} // namespace

Node differentiate(Graph& graph, Node node, Node symbol) {
    const Node zero = graph.constant(0), one = graph.constant(1);
    std::unordered_map<std::uint32_t, Node> derivatives; // absent: 0
    ChainRule chainRule(graph);
    for (const Node n : reachable(graph, std::span(&node, 1))) {
        if (n == symbol) {
            derivatives.emplace(n.index, one);
            continue;
        }
        std::vector<Node> d;
        for (const Node a : graph.arguments(n)) {
            const auto found = derivatives.find(a.index);
            d.push_back(found == derivatives.end() ? zero : found->second);
        }
        if (std::ranges::any_of(d, [zero](Node x) { return x != zero; }))
            derivatives.emplace(n.index, chainRule(n, d));
    }
    const auto found = derivatives.find(node.index);
    return found == derivatives.end() ? zero : found->second;
}

Node substitute(Graph& graph, Node node,
                const std::unordered_map<std::uint32_t, Node>& replacements) {
    std::unordered_map<std::uint32_t, Node> made;
    for (const Node n : reachable(graph, std::span(&node, 1), replacements)) {
        const auto replacement = replacements.find(n.index);
        if (replacement != replacements.end()) {
            made.emplace(n.index, replacement->second);
            continue;
        }
        std::vector<Node> a;
        for (const Node argument : graph.arguments(n))
            a.push_back(made.at(argument.index));
        Node result = n;
        if (a.size() == 1)
            result = graph.apply(graph.op(n), a[0]);
        else if (a.size() == 2)
            result = graph.apply(graph.op(n), a[0], a[1]);
        else if (a.size() == 3)
            result = graph.apply(graph.op(n), a[0], a[1], a[2]);
        made.emplace(n.index, result);
    }
    return made.at(node.index);
}

std::vector<Node> symbolsOf(const Graph& graph, std::span<const Node> nodes) {
    std::vector<Node> found = reachable(graph, nodes);
    std::erase_if(found, [&graph](Node n) { return graph.op(n) != Op::symbol; });
    return found;
}

} // namespace expression
