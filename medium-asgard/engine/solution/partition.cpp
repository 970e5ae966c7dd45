#include "solution/partition.h"

#include "expression/operation.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace solution {

namespace {

using expression::Node;

std::vector<Node> nodesAfter(const expression::Unknown& unknown, double from) {
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < unknown.phases.size(); ++i) {
        const expression::Phase& phase = unknown.phases[i];
        const bool over = i + 1 < unknown.phases.size() && unknown.phases[i + 1].from <= from;
        if (over)
            continue;
        if (phase.given)
            nodes.push_back(*phase.given);
        else
            nodes.push_back(phase.derivative);
        if (phase.jump)
            nodes.push_back(*phase.jump);
    }
    return nodes;
}

bool hasSwitch(const expression::Graph& graph) {
    for (std::uint32_t n = 0; n < graph.size(); ++n)
        if (expression::isSwitch(graph.op(Node{n})))
            return true;
    return false;
}

// What a switch compares, the same for all that have the same surface (switching.h), whichever way
// round they write it.
using Compared = std::pair<Node, Node>;
constexpr Node nothing{std::numeric_limits<std::uint32_t>::max()};

Compared comparedBy(const expression::Graph& graph, Node switching) {
    const auto arguments = graph.arguments(switching);
    Compared pair{arguments[0], arguments.size() == 2 ? arguments[1] : nothing};
    const auto isZero = [&graph](Node n) {
        return n != nothing && graph.op(n) == expression::Op::constant && graph.value(n) == 0;
    };
    if (isZero(pair.first))
        std::swap(pair.first, pair.second);
    if (isZero(pair.second))
        pair.second = nothing;
    while (pair.second == nothing && graph.op(pair.first) == expression::Op::negate)
        pair.first = graph.arguments(pair.first)[0];
    if (pair.second == nothing && graph.op(pair.first) == expression::Op::subtract)
        pair = {graph.arguments(pair.first)[0], graph.arguments(pair.first)[1]};
    if (pair.second != nothing && pair.second < pair.first)
        std::swap(pair.first, pair.second);
    return pair;
}

// Places of those whose rates have a switch, by what it compares.
std::map<Compared, std::vector<std::size_t>> sharersOf(const expression::EquationSet& equations,
                                                       std::span<const std::size_t> unknowns,
                                                       double from, const ZeroStates& zero) {
    std::map<Compared, std::vector<std::size_t>> sharers;
    for (std::size_t place = 0; place < unknowns.size(); ++place) {
        if (zero.contains(unknowns[place]))
            continue;
        const std::vector<Node> nodes = nodesAfter(equations.unknowns[unknowns[place]], from);
        for (const Node n : expression::reachable(equations.graph, nodes)) {
            const expression::Op op = equations.graph.op(n);
            if (!expression::isSwitch(op) || op == expression::Op::floor ||
                op == expression::Op::ceil)
                continue;
            std::vector<std::size_t>& places = sharers[comparedBy(equations.graph, n)];
            if (places.empty() || places.back() != place)
                places.push_back(place);
        }
    }
    return sharers;
}

} // namespace

UnknownIndex::UnknownIndex(const expression::EquationSet& set) {
    for (std::size_t i = 0; i < set.unknowns.size(); ++i) {
        const std::uint32_t symbol = set.unknowns[i].symbol.index;
        if (symbol >= bySymbol_.size())
            bySymbol_.resize(symbol + 1, none);
        if (bySymbol_[symbol] == none)
            bySymbol_[symbol] = static_cast<std::uint32_t>(i);
    }
    quaternions_.resize(set.unknowns.size(), none);
    for (std::size_t q = 0; q < set.quaternions.size(); ++q)
        for (const std::size_t i : set.quaternions[q])
            quaternions_[i] = static_cast<std::uint32_t>(q);
}

Reads readsOf(const expression::EquationSet& equations, double from, const ZeroStates& zero) {
    return readsOf(equations, UnknownIndex(equations), from, zero);
}

std::vector<std::size_t> readsOf(const expression::EquationSet& equations,
                                 const UnknownIndex& index, std::size_t unknown, double from,
                                 const ZeroStates& zero) {
    std::vector<std::size_t> reads;
    const std::vector<Node> nodes = nodesAfter(equations.unknowns[unknown], from);
    for (const Node symbol : zero.symbolsLeft(equations.graph, nodes))
        if (const auto read = index.of(symbol))
            reads.push_back(*read);
    if (const auto four = index.quaternionOf(unknown))
        std::ranges::copy_if(equations.quaternions[*four], std::back_inserter(reads),
                             [&](std::size_t i) { return !zero.contains(i); });
    std::ranges::sort(reads);
    reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
    return reads;
}

Reads readsOf(const expression::EquationSet& equations, const UnknownIndex& index, double from,
              const ZeroStates& zero) {
    Reads reads(equations.unknowns.size());
    for (std::size_t i = 0; i < reads.size(); ++i)
        if (!zero.contains(i))
            reads[i] = readsOf(equations, index, i, from, zero);
    if (hasSwitch(equations.graph)) {
        std::vector<std::size_t> all(reads.size());
        std::iota(all.begin(), all.end(), 0);
        addSharedSwitches(equations, index, all, from, zero, reads);
    }
    return reads;
}

void addSharedSwitches(const expression::EquationSet& equations, const UnknownIndex& index,
                       std::span<const std::size_t> unknowns, double from, const ZeroStates& zero,
                       Reads& reads) {
    for (const auto& [compared, places] : sharersOf(equations, unknowns, from, zero)) {
        if (places.size() < 2)
            continue;
        std::vector<Node> guard{compared.first};
        if (compared.second != nothing)
            guard.push_back(compared.second);
        for (const Node symbol : zero.symbolsLeft(equations.graph, guard)) {
            const auto moved = index.of(symbol);
            const auto isMoved = [&](std::size_t p) { return moved && unknowns[p] == *moved; };
            const auto place = std::ranges::find_if(places, isMoved);
            if (place == places.end())
                continue;
            std::vector<std::size_t>& list = reads[*place];
            list.insert(list.end(), places.begin(), places.end());
            std::ranges::sort(list);
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
    }
}

namespace {

void connect(Partition& partition, const Reads& reads) {
    partition.componentOf.assign(reads.size(), noComponent);
    for (std::size_t c = 0; c < partition.components.size(); ++c)
        for (const std::size_t i : partition.components[c])
            partition.componentOf[i] = c;
    partition.reads.resize(partition.components.size());
    for (std::size_t c = 0; c < partition.components.size(); ++c) {
        std::vector<std::size_t>& list = partition.reads[c];
        for (const std::size_t i : partition.components[c])
            for (const std::size_t j : reads[i])
                if (partition.componentOf[j] != c)
                    list.push_back(partition.componentOf[j]);
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
}

} // namespace

std::vector<bool> unreadBy(const std::vector<std::size_t>& asked, const Reads& reads) {
    std::vector<bool> unread(reads.size(), true);
    std::vector<std::size_t> open = asked;
    while (!open.empty()) {
        const std::size_t u = open.back();
        open.pop_back();
        if (!unread[u])
            continue;
        unread[u] = false;
        open.insert(open.end(), reads[u].begin(), reads[u].end());
    }
    return unread;
}

Partition partitionOf(const Reads& reads, const std::vector<bool>& leftOut) {
    constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
    const std::size_t n = reads.size();
    std::vector<std::size_t> number(n, unseen), low(n, 0), stack;
    std::vector<bool> onStack(n, false);
    struct Visit {
        std::size_t node, arc;
    };
    std::vector<Visit> visits;
    std::size_t count = 0;
    Partition partition;

    const auto enter = [&](std::size_t v) {
        number[v] = low[v] = count++;
        stack.push_back(v);
        onStack[v] = true;
        visits.push_back({v, 0});
    };
    const auto close = [&](std::size_t root) {
        std::vector<std::size_t> component;
        std::size_t v = unseen;
        do {
            v = stack.back();
            stack.pop_back();
            onStack[v] = false;
            component.push_back(v);
        } while (v != root);
        std::sort(component.begin(), component.end());
        partition.components.push_back(std::move(component));
    };

    // Arcs are followed from an equation to what it reads, so a component closes after its inputs.
    for (std::size_t start = 0; start < n; ++start) {
        if (number[start] != unseen || (!leftOut.empty() && leftOut[start]))
            continue;
        enter(start);
        while (!visits.empty()) {
            const std::size_t v = visits.back().node;
            if (visits.back().arc < reads[v].size()) {
                const std::size_t w = reads[v][visits.back().arc++];
                if (number[w] == unseen)
                    enter(w);
                else if (onStack[w])
                    low[v] = std::min(low[v], number[w]);
                continue;
            }
            visits.pop_back();
            if (!visits.empty())
                low[visits.back().node] = std::min(low[visits.back().node], low[v]);
            if (low[v] == number[v])
                close(v);
        }
    }
    connect(partition, reads);
    return partition;
}

Partition wholePartition(const Reads& reads) {
    Partition partition;
    if (!reads.empty()) {
        partition.components.emplace_back(reads.size());
        for (std::size_t i = 0; i < reads.size(); ++i)
            partition.components[0][i] = i;
    }
    connect(partition, reads);
    return partition;
}

} // namespace solution
