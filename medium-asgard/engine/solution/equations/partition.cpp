#include "equations/partition.h"

#include "equations/directions.h"

#include "expression/operation.h"
#include "expression/parts.h"

#include <algorithm>
#include <functional>
#include <iterator>
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
        if (phase.condition)
            for (const auto& node : {phase.condition->gap, phase.condition->rate,
                                     phase.condition->release, phase.condition->brought})
                if (node)
                    nodes.push_back(*node);
        if (phase.condition)
            nodes.insert(nodes.end(), phase.condition->valid.begin(), phase.condition->valid.end());
    }
    return nodes;
}

bool hasSwitch(const expression::Graph& graph) {
    for (std::uint32_t n = 0; n < graph.size(); ++n)
        if (expression::isSwitch(graph.op(Node{n})))
            return true;
    return false;
}

void putInOrder(std::vector<std::size_t>& places) {
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
}

// What a switch compares, the same for all that have the same surface (surfaces.h), whichever way
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

// Floors and ceilings have a surface each of their own.
bool compares(expression::Op op) {
    return expression::isSwitch(op) && op != expression::Op::floor && op != expression::Op::ceil;
}

// visit(node, eachReader): of each node that is left of these unknowns' equations;
// eachReader(visit) visits the places of the unknowns that read it.
template <class Visit>
void eachNodeOf(const expression::EquationSet& equations, std::span<const std::size_t> unknowns,
                double from, const std::function<bool(Node)>& isLeftOut, const Visit& visit) {
    for (std::size_t first = 0; first < unknowns.size(); first += expression::formulasAtOnce) {
        std::vector<std::vector<Node>> formulas;
        for (const std::size_t u :
             unknowns.subspan(first, std::min(expression::formulasAtOnce, unknowns.size() - first)))
            formulas.push_back(nodesAfter(equations.unknowns[u], from));
        for (const expression::PartOf& part :
             expression::partsOf(equations.graph, formulas, isLeftOut)) {
            const auto eachReader = [first, &part](const auto& each) {
                expression::eachFormula(part.formulas, [&](std::size_t f) { each(first + f); });
            };
            visit(part.node, eachReader);
        }
    }
}

// A multiplier of a contact is no state that a switch could hold; the rates of the bodies that it
// pushes have the same switches. Its last phase is the one that events wrote.
bool isOfContact(const expression::Unknown& unknown) {
    const auto& condition = unknown.phases.back().condition;
    return condition && condition->parts;
}

// Places of those whose rates have a switch, by what it compares.
std::map<Compared, std::vector<std::size_t>> sharersOf(const expression::EquationSet& equations,
                                                       std::span<const std::size_t> unknowns,
                                                       double from, const ZeroStates& zero) {
    std::vector<std::size_t> awake, places;
    for (std::size_t place = 0; place < unknowns.size(); ++place)
        if (!zero.contains(unknowns[place]) && !isOfContact(equations.unknowns[unknowns[place]])) {
            awake.push_back(unknowns[place]);
            places.push_back(place);
        }
    std::map<Compared, std::vector<std::size_t>> sharers;
    eachNodeOf(equations, awake, from, {}, [&](Node n, const auto& eachReader) {
        const auto add = [&](const Compared& compared) {
            std::vector<std::size_t>& sharing = sharers[compared];
            eachReader([&](std::size_t i) { sharing.push_back(places[i]); });
        };
        if (compares(equations.graph.op(n)))
            add(comparedBy(equations.graph, n));
        for (const Node length : lengthsInQuotients(equations.graph, std::span(&n, 1)))
            add({length, nothing}); // friction in a plane
    });
    for (auto& [compared, sharing] : sharers)
        putInOrder(sharing);
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
    for (std::size_t m = 0; m < set.unknowns.size(); ++m)
        for (const expression::Phase& phase : set.unknowns[m].phases)
            if (phase.condition)
                findMoved(set, *phase.condition, m);
    for (const std::size_t release : releases_)
        followRelease(set, release);
    const auto isValue = [](const expression::Phase& phase) { // of which no state need be read
        return phase.condition && !phase.condition->gap && !phase.condition->rate;
    };
    std::set<std::size_t> values;
    for (std::size_t m = 0; m < set.unknowns.size(); ++m)
        if (std::ranges::all_of(set.unknowns[m].phases, isValue))
            values.insert(m);
    for (std::size_t u = 0; u < set.unknowns.size() && !values.empty(); ++u) {
        std::vector<Node> rates;
        for (const expression::Phase& phase : set.unknowns[u].phases)
            if (!phase.given && !phase.condition)
                rates.push_back(phase.derivative);
        for (const Node symbol : expression::symbolsOf(set.graph, rates))
            if (const auto read = of(symbol); read && values.contains(*read))
                releasesBy_[*read].push_back(u);
    }
}

std::span<const std::size_t> UnknownIndex::releasesBy(std::size_t multiplier) const {
    const auto found = releasesBy_.find(multiplier);
    return found == releasesBy_.end() ? std::span<const std::size_t>() : found->second;
}

void UnknownIndex::followRelease(const expression::EquationSet& set, std::size_t release) {
    for (auto& [multiplier, releases] : releasesBy_)
        std::erase(releases, release);
    const auto isMultiplier = [&](std::size_t unknown) {
        return std::ranges::any_of(set.unknowns[unknown].phases, [](const expression::Phase& p) {
            return p.condition.has_value();
        });
    };
    std::vector<Node> nodes;
    for (const expression::Phase& phase : set.unknowns[release].phases)
        if (phase.given)
            nodes.push_back(*phase.given);
    for (const Node symbol : expression::symbolsOf(set.graph, nodes))
        if (const auto read = of(symbol); read && isMultiplier(*read))
            releasesBy_[*read].push_back(release);
}

void UnknownIndex::add(const expression::EquationSet& set, std::size_t unknown) {
    const std::uint32_t symbol = set.unknowns[unknown].symbol.index;
    if (symbol >= bySymbol_.size())
        bySymbol_.resize(symbol + 1, none);
    bySymbol_[symbol] = static_cast<std::uint32_t>(unknown);
    quaternions_.resize(set.unknowns.size(), none);
}

void UnknownIndex::follow(const expression::EquationSet& set, std::size_t multiplier, double from) {
    for (auto& [unknown, multipliers] : multipliers_)
        std::erase(multipliers, multiplier);
    const std::vector<expression::Phase>& phases = set.unknowns[multiplier].phases;
    for (std::size_t i = 0; i < phases.size(); ++i)
        if (phases[i].condition && !(i + 1 < phases.size() && phases[i + 1].from <= from))
            findMoved(set, *phases[i].condition, multiplier);
    for (auto& [unknown, multipliers] : multipliers_)
        std::ranges::sort(multipliers);
}

void UnknownIndex::findMoved(const expression::EquationSet& set,
                             const expression::Condition& condition, std::size_t multiplier) {
    std::vector<Node> nodes;
    for (const auto& node : {condition.gap, condition.rate, condition.release})
        if (node)
            nodes.push_back(*node);
    if (const auto release = condition.release ? of(*condition.release) : std::nullopt)
        releases_.insert(*release);
    for (const Node symbol : expression::symbolsOf(set.graph, nodes))
        if (const auto unknown = of(symbol)) {
            std::vector<std::size_t>& multipliers = multipliers_[*unknown];
            if (std::ranges::find(multipliers, multiplier) == multipliers.end())
                multipliers.push_back(multiplier);
        }
}

std::span<const std::size_t> UnknownIndex::multipliersOf(std::size_t unknown) const {
    const auto found = multipliers_.find(unknown);
    return found == multipliers_.end() ? std::span<const std::size_t>() : found->second;
}

Reads readsOf(const expression::EquationSet& equations, double from, const ZeroStates& zero) {
    return readsOf(equations, UnknownIndex(equations), from, zero);
}

Reads readsOf(const expression::EquationSet& equations, const UnknownIndex& index,
              std::span<const std::size_t> unknowns, double from, const ZeroStates& zero) {
    Reads reads(unknowns.size());
    const auto isLeftOut =
        zero.empty() ? std::function<bool(Node)>() : [&zero](Node n) { return zero.isZero(n); };
    eachNodeOf(equations, unknowns, from, isLeftOut, [&](Node n, const auto& eachReader) {
        if (const auto read = index.of(n))
            eachReader([&](std::size_t i) { reads[i].push_back(*read); });
    });
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const auto add = [&](std::span<const std::size_t> more) {
            std::ranges::copy_if(more, std::back_inserter(reads[i]),
                                 [&](std::size_t u) { return !zero.contains(u); });
        };
        add(index.multipliersOf(unknowns[i]));
        add(index.releasesBy(unknowns[i]));
        if (const auto four = index.quaternionOf(unknowns[i]))
            add(equations.quaternions[*four]);
        putInOrder(reads[i]);
    }
    return reads;
}

Reads readsOf(const expression::EquationSet& equations, const UnknownIndex& index, double from,
              const ZeroStates& zero) {
    std::vector<std::size_t> awake;
    for (std::size_t i = 0; i < equations.unknowns.size(); ++i)
        if (!zero.contains(i))
            awake.push_back(i);
    Reads reads(equations.unknowns.size());
    Reads ofAwake = readsOf(equations, index, awake, from, zero);
    for (std::size_t i = 0; i < awake.size(); ++i)
        reads[awake[i]] = std::move(ofAwake[i]);
    if (hasSwitch(equations.graph) || dividesByLength(equations.graph)) {
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
            putInOrder(list);
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

namespace {

// Tarjan's strongly connected components, without recursion. Arcs are followed from an equation to
// what it reads, so that a component closes after its inputs.
class StrongComponents {
public:
    explicit StrongComponents(const Reads& reads)
        : reads_(reads), number_(reads.size(), unseen), low_(reads.size(), 0),
          onStack_(reads.size(), false) {}

    // Adds those that are reached from here and were not seen before.
    void visit(std::size_t start, std::vector<std::vector<std::size_t>>& components) {
        if (number_[start] == unseen)
            enter(start);
        while (!visits_.empty()) {
            Visit& last = visits_.back();
            if (last.arc < reads_[last.node].size())
                look(last.node, reads_[last.node][last.arc++]);
            else
                leave(components);
        }
    }

private:
    static constexpr std::size_t unseen = std::numeric_limits<std::size_t>::max();
    struct Visit {
        std::size_t node, arc;
    };

    void enter(std::size_t v) {
        number_[v] = low_[v] = count_++;
        stack_.push_back(v);
        onStack_[v] = true;
        visits_.push_back({v, 0});
    }
    void look(std::size_t from, std::size_t to) {
        if (number_[to] == unseen)
            enter(to);
        else if (onStack_[to])
            low_[from] = std::min(low_[from], number_[to]);
    }
    void leave(std::vector<std::vector<std::size_t>>& components) {
        const std::size_t v = visits_.back().node;
        visits_.pop_back();
        if (!visits_.empty())
            low_[visits_.back().node] = std::min(low_[visits_.back().node], low_[v]);
        if (low_[v] == number_[v])
            components.push_back(closed(v));
    }
    std::vector<std::size_t> closed(std::size_t root) {
        std::vector<std::size_t> component;
        do {
            component.push_back(stack_.back());
            onStack_[stack_.back()] = false;
            stack_.pop_back();
        } while (component.back() != root);
        std::sort(component.begin(), component.end());
        return component;
    }

    const Reads& reads_;
    std::vector<std::size_t> number_, low_, stack_;
    std::vector<bool> onStack_;
    std::vector<Visit> visits_;
    std::size_t count_ = 0;
};

} // namespace

Partition partitionOf(const Reads& reads, const std::vector<bool>& leftOut) {
    Partition partition;
    StrongComponents search(reads);
    for (std::size_t start = 0; start < reads.size(); ++start)
        if (leftOut.empty() || !leftOut[start])
            search.visit(start, partition.components);
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
