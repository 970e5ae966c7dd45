#include "solution/zero_states.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace solution {

namespace {

using expression::Graph;
using expression::Node;
using expression::Op;

// Is a node 0 when these arguments are? Like the graph's own algebra, 0 times anything is 0.
bool vanishes(const Graph& graph, Node n, const std::vector<bool>& zero) {
    const auto arguments = graph.arguments(n);
    const auto is = [&](std::size_t k) { return static_cast<bool>(zero[arguments[k].index]); };
    switch (graph.op(n)) {
    case Op::constant:
        return graph.value(n) == 0;
    case Op::negate:
    case Op::sin:
    case Op::tan:
    case Op::asin:
    case Op::atan:
    case Op::sinh:
    case Op::tanh:
    case Op::sqrt:
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::divide:
        return is(0);
    case Op::add:
    case Op::subtract:
    case Op::hypot:
    case Op::min:
    case Op::max:
    case Op::logicalOr:
        return is(0) && is(1);
    case Op::multiply:
    case Op::logicalAnd:
        return is(0) || is(1);
    case Op::power:
        return is(0) && graph.op(arguments[1]) == Op::constant && graph.value(arguments[1]) > 0;
    case Op::select:
        return is(1) && is(2);
    default:
        return false;
    }
}

// Who reads a node, for all nodes of a graph, in one table.
struct Parents {
    std::vector<std::uint32_t> starts, list;
    explicit Parents(const Graph& graph) : starts(graph.size() + 1, 0) {
        const auto each = [&](auto&& visit) {
            for (std::uint32_t n = 0; n < graph.size(); ++n)
                for (const Node argument : graph.arguments(Node{n}))
                    visit(argument.index, n);
        };
        each([&](std::uint32_t argument, std::uint32_t) { ++starts[argument + 1]; });
        for (std::size_t i = 1; i < starts.size(); ++i)
            starts[i] += starts[i - 1];
        list.resize(starts.back());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        each([&](std::uint32_t argument, std::uint32_t n) { list[next[argument]++] = n; });
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t n) const {
        return std::span(list).subspan(starts[n], starts[n + 1] - starts[n]);
    }
};

// The phases in force at `from` and after it.
std::span<const expression::Phase> phasesFrom(const expression::Unknown& unknown, double from) {
    std::size_t first = 0;
    while (first + 1 < unknown.phases.size() && unknown.phases[first + 1].from <= from)
        ++first;
    return std::span(unknown.phases).subspan(first);
}

bool isFree(const expression::Unknown& unknown, double from) {
    const auto phases = phasesFrom(unknown, from);
    return std::all_of(phases.begin(), phases.end(), [&](const expression::Phase& phase) {
        return !phase.given && (!phase.jump || phase.from < from);
    });
}

} // namespace

ZeroStates::ZeroStates(const expression::EquationSet& set, double from,
                       std::span<const double> values)
    : zero_(set.unknowns.size(), false) {
    for (std::size_t u = 0; u < zero_.size(); ++u)
        zero_[u] = values[u] == 0 && isFree(set.unknowns[u], from);
    settle(set, from);
}

// Every node is 0 until something shows that it is not; what shows it is handed on to the readers.
void ZeroStates::settle(const expression::EquationSet& set, double from) {
    const Graph& graph = set.graph;
    nodeZero_.assign(graph.size(), false);
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (zero_[u])
            nodeZero_[set.unknowns[u].symbol.index] = true;
    for (std::uint32_t n = 0; n < graph.size(); ++n) // arguments come first
        if (graph.op(Node{n}) != Op::symbol)
            nodeZero_[n] = vanishes(graph, Node{n}, nodeZero_);
    std::unordered_multimap<std::uint32_t, std::size_t> rateOf;
    std::vector<std::size_t> awake;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (zero_[u])
            for (const expression::Phase& phase : phasesFrom(set.unknowns[u], from)) {
                rateOf.emplace(phase.derivative.index, u);
                if (!nodeZero_[phase.derivative.index])
                    awake.push_back(u);
            }
    const Parents parents(graph);
    while (!awake.empty()) {
        const std::size_t u = awake.back();
        awake.pop_back();
        if (!zero_[u])
            continue;
        zero_[u] = false;
        std::vector<std::uint32_t> open{set.unknowns[u].symbol.index};
        nodeZero_[open[0]] = false;
        while (!open.empty()) {
            const std::uint32_t n = open.back();
            open.pop_back();
            for (auto [at, end] = rateOf.equal_range(n); at != end; ++at)
                awake.push_back(at->second);
            for (const std::uint32_t reader : parents.of(n))
                if (nodeZero_[reader] && !vanishes(graph, Node{reader}, nodeZero_)) {
                    nodeZero_[reader] = false;
                    open.push_back(reader);
                }
        }
    }
    count_ = static_cast<std::size_t>(std::count(zero_.begin(), zero_.end(), true));
}

std::vector<std::size_t> ZeroStates::unknowns() const {
    std::vector<std::size_t> list;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (zero_[u])
            list.push_back(u);
    return list;
}

std::vector<std::size_t> ZeroStates::wake(const expression::EquationSet& set, double from,
                                          std::span<const std::size_t> roused) {
    if (empty())
        return {};
    const std::vector<bool> before = zero_;
    for (const std::size_t u : roused)
        zero_[u] = false;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        zero_[u] = zero_[u] && isFree(set.unknowns[u], from);
    settle(set, from);
    std::vector<std::size_t> woken;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (before[u] && !zero_[u])
            woken.push_back(u);
    return woken;
}

std::vector<Node> ZeroStates::symbolsLeft(const Graph& graph, std::span<const Node> nodes) const {
    if (empty())
        return expression::symbolsOf(graph, nodes);
    std::vector<Node> open(nodes.begin(), nodes.end()), symbols;
    std::unordered_set<std::uint32_t> seen;
    while (!open.empty()) {
        const Node n = open.back();
        open.pop_back();
        if (isZero(n) || !seen.insert(n.index).second)
            continue;
        if (graph.op(n) == Op::symbol)
            symbols.push_back(n);
        const auto arguments = graph.arguments(n);
        open.insert(open.end(), arguments.begin(), arguments.end());
    }
    std::sort(symbols.begin(), symbols.end());
    return symbols;
}

} // namespace solution
