#include "expression/graph.h"

#include "expression/node_map.h"
#include "expression/operation.h"
#include "expression/rate_along.h"
#include "expression/visited.h"

#include <algorithm>
#include <array>

namespace expression {
// An own stack: expressions may be very deep.
std::vector<Node> reachable(const Graph& graph, std::span<const Node> roots,
                            const std::unordered_map<std::uint32_t, Node>& end) {
    Visited seen;
    std::vector<Node> found, pending;
    const auto see = [&](Node n) {
        if (!seen.insert(n))
            return;
        found.push_back(n);
        if (end.empty() || !end.contains(n.index))
            pending.push_back(n);
    };
    std::ranges::for_each(roots, see);
    while (!pending.empty()) {
        const auto arguments = graph.arguments(pending.back());
        pending.pop_back();
        std::ranges::for_each(arguments, see);
    }
    putInOrder(found);
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
    const auto rows = gradients(graph, std::span(&node, 1), std::span(&symbol, 1));
    return rows[0].empty() ? graph.constant(0) : rows[0][0].derivative;
}

namespace {

// Derivatives of nodes in order of index, so that those of arguments are there before.
class Gradients {
public:
    Gradients(Graph& graph, std::span<const Node> symbols)
        : graph_(graph), chainRule_(graph), zero_(graph.constant(0)), one_(graph.constant(1)) {
        for (std::size_t i = 0; i < symbols.size(); ++i)
            places_.insert(symbols[i], static_cast<std::uint32_t>(i));
    }

    void add(Node n) {
        const auto first = static_cast<std::uint32_t>(partials_.size());
        if (const auto* const place = places_.find(n))
            partials_.push_back({*place, one_});
        else
            derive(n);
        if (partials_.size() > first)
            ranges_.insert(n, {first, static_cast<std::uint32_t>(partials_.size())});
    }

    [[nodiscard]] std::span<const Partial> of(Node n) const {
        const auto* const range = ranges_.find(n);
        if (!range)
            return {};
        return std::span(partials_).subspan(range->first, range->second - range->first);
    }

private:
    // By each symbol that some argument depends on; the arguments' lists are in order of symbols.
    void derive(Node n) {
        const auto arguments = graph_.arguments(n);
        std::array<std::pair<std::uint32_t, std::uint32_t>, 3> left{}; // of each list
        for (std::size_t k = 0; k < arguments.size(); ++k)
            if (const auto* const range = ranges_.find(arguments[k]))
                left[k] = *range;
        for (;;) {
            std::uint32_t symbol = none;
            for (const auto& [at, end] : left)
                if (at < end)
                    symbol = std::min(symbol, partials_[at].symbol);
            if (symbol == none)
                return;
            std::array<Node, 3> d{zero_, zero_, zero_};
            for (std::size_t k = 0; k < arguments.size(); ++k)
                if (left[k].first < left[k].second && partials_[left[k].first].symbol == symbol)
                    d[k] = partials_[left[k].first++].derivative;
            const Node derivative = chainRule_(n, std::span(d).first(arguments.size()));
            if (derivative != zero_)
                partials_.push_back({symbol, derivative});
        }
    }

    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    Graph& graph_;
    ChainRule chainRule_;
    Node zero_, one_;
    NodeMap<std::uint32_t> places_; // of symbols
    std::vector<Partial> partials_;
    NodeMap<std::pair<std::uint32_t, std::uint32_t>> ranges_; // of partials, by node
};

} // namespace

std::vector<std::vector<Partial>> gradients(Graph& graph, std::span<const Node> roots,
                                            std::span<const Node> symbols) {
    Gradients all(graph, symbols);
    for (const Node n : reachable(graph, roots))
        all.add(n);
    std::vector<std::vector<Partial>> rows;
    rows.reserve(roots.size());
    for (const Node root : roots) {
        const auto row = all.of(root);
        rows.emplace_back(row.begin(), row.end());
    }
    return rows;
}

std::vector<Node> ratesAlong(Graph& graph, std::span<const Node> roots,
                             std::span<const Node> moving, std::span<const Node> rates) {
    const Node zero = graph.constant(0);
    ChainRule chainRule(graph);
    NodeMap<Node> made; // absent: 0
    for (std::size_t i = 0; i < moving.size(); ++i)
        made.insert(moving[i], rates[i]);
    for (const Node n : reachable(graph, roots)) {
        if (made.find(n))
            continue;
        std::array<Node, 3> d{zero, zero, zero};
        bool changes = false;
        const auto arguments = graph.arguments(n);
        for (std::size_t k = 0; k < arguments.size(); ++k)
            if (const Node* const of = made.find(arguments[k])) {
                d[k] = *of;
                changes = true;
            }
        if (!changes)
            continue;
        const Node rate = chainRule(n, std::span(d).first(arguments.size()));
        if (rate != zero)
            made.insert(n, rate);
    }
    std::vector<Node> found;
    for (const Node root : roots) {
        const Node* const rate = made.find(root);
        found.push_back(rate ? *rate : zero);
    }
    return found;
}

// What holds nothing that is replaced stays the node that it is.
Node substitute(Graph& graph, Node node,
                const std::unordered_map<std::uint32_t, Node>& replacements) {
    return substitute(graph, std::span(&node, 1), replacements)[0];
}

std::vector<Node> substitute(Graph& graph, std::span<const Node> nodes,
                             const std::unordered_map<std::uint32_t, Node>& replacements) {
    std::vector<Node> results(nodes.begin(), nodes.end());
    if (replacements.empty())
        return results;
    NodeMap<Node> made; // absent: as it was
    for (const Node n : reachable(graph, nodes, replacements)) {
        const auto replacement = replacements.find(n.index);
        if (replacement != replacements.end()) {
            made.insert(n, replacement->second);
            continue;
        }
        std::array<Node, 3> a{};
        bool isChanged = false;
        const auto arguments = graph.arguments(n);
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            const Node* const other = made.find(arguments[k]);
            a[k] = other ? *other : arguments[k];
            isChanged |= other != nullptr;
        }
        if (!isChanged)
            continue;
        const Op op = graph.op(n);
        made.insert(n, arguments.size() == 1   ? graph.apply(op, a[0])
                       : arguments.size() == 2 ? graph.apply(op, a[0], a[1])
                                               : graph.apply(op, a[0], a[1], a[2]));
    }
    for (Node& result : results)
        if (const Node* const other = made.find(result))
            result = *other;
    return results;
}

std::vector<Node> symbolsOf(const Graph& graph, std::span<const Node> nodes) {
    std::vector<Node> found = reachable(graph, nodes);
    std::erase_if(found, [&graph](Node n) { return graph.op(n) != Op::symbol; });
    return found;
}

} // namespace expression
