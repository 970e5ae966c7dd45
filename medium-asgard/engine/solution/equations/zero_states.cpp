#include "equations/zero_states.h"

#include "equations/directions.h"
#include "expression/visited.h"

#include <algorithm>

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
        return is(0);
    case Op::divide: // by what is 0 too it is no number, but where friction rests
        return is(0) && (!is(1) || isDirectionAtRest(graph, n, zero));
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

// Lists of numbers, one for each of the numbers below `keys`, in one table.
class Lists {
public:
    // each(visit) calls visit(key, number) for all that the lists have, twice in the same order.
    template <class Each> Lists(std::size_t keys, const Each& each) : starts_(keys + 1, 0) {
        each([&](std::uint32_t key, std::uint32_t) { ++starts_[key + 1]; });
        for (std::size_t i = 1; i < starts_.size(); ++i)
            starts_[i] += starts_[i - 1];
        list_.resize(starts_.back());
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        each([&](std::uint32_t key, std::uint32_t number) { list_[next[key]++] = number; });
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t key) const {
        if (key + 1 >= starts_.size())
            return {};
        return std::span(list_).subspan(starts_[key], starts_[key + 1] - starts_[key]);
    }

private:
    std::vector<std::uint32_t> starts_, list_;
};

template <class Visit>
void eachNodeOf(std::span<const expression::Phase> phases, const Visit& visit) {
    for (const expression::Phase& phase : phases) {
        visit(phase.derivative.index);
        if (phase.given)
            visit(phase.given->index);
        if (phase.jump)
            visit(phase.jump->index);
        if (phase.condition)
            for (const auto& node : {phase.condition->rate, phase.condition->brought})
                if (node)
                    visit(node->index);
    }
}

// Nodes of a condition that move states where they are not 0, as a rate does.
template <class Test> bool hasMover(const expression::Phase& phase, const Test& test) {
    const auto passes = [&](const std::optional<Node>& node) { return node && test(node->index); };
    return phase.condition && (passes(phase.condition->rate) || passes(phase.condition->brought));
}

bool isMovedBy(const expression::Phase& phase, std::uint32_t node) {
    return phase.derivative.index == node ||
           hasMover(phase, [&](std::uint32_t mover) { return mover == node; });
}

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

bool hasRate(const expression::Unknown& unknown, double from, std::uint32_t node) {
    const auto phases = phasesFrom(unknown, from);
    return std::any_of(phases.begin(), phases.end(),
                       [&](const expression::Phase& phase) { return isMovedBy(phase, node); });
}

bool hasRateBesides(const expression::Unknown& unknown, double from,
                    const std::vector<bool>& zero) {
    const auto phases = phasesFrom(unknown, from);
    const auto gapOf = [](const expression::Phase& phase) {
        return phase.condition ? phase.condition->gap : std::nullopt;
    };
    return std::any_of(phases.begin(), phases.end(), [&](const expression::Phase& phase) {
        return gapOf(phase) != gapOf(phases.front()) || // another place is wanted from then on
               !zero[phase.derivative.index] ||
               hasMover(phase, [&](std::uint32_t mover) { return !zero[mover]; });
    });
}

} // namespace

struct ZeroStates::Readers {
    Lists nodes, unknowns;
    explicit Readers(const expression::EquationSet& set)
        : nodes(set.graph.size(),
                [&](auto&& visit) {
                    for (std::uint32_t n = 0; n < set.graph.size(); ++n)
                        for (const Node argument : set.graph.arguments(Node{n}))
                            visit(argument.index, n);
                }),
          unknowns(set.graph.size(), [&](auto&& visit) {
              for (std::uint32_t u = 0; u < set.unknowns.size(); ++u)
                  eachNodeOf(set.unknowns[u].phases, [&](std::uint32_t node) { visit(node, u); });
          }) {}
};

template <class Visit> void ZeroStates::eachReader(std::uint32_t node, const Visit& visit) const {
    for (const std::uint32_t reader : readers_->nodes.of(node))
        visit(reader);
    lateReaders_.each(node, visit);
}

template <class Visit> void ZeroStates::eachUnknown(std::uint32_t node, const Visit& visit) const {
    for (const std::uint32_t u : readers_->unknowns.of(node))
        visit(u);
    lateUnknowns_.each(node, visit);
}

// Every node is 0 until something shows that it is not.
ZeroStates::ZeroStates(const expression::EquationSet& set, double from,
                       std::span<const double> values)
    : zero_(set.unknowns.size(), false), readers_(std::make_shared<const Readers>(set)) {
    const Graph& graph = set.graph;
    nodeZero_.assign(graph.size(), false);
    for (std::size_t u = 0; u < zero_.size(); ++u) {
        zero_[u] = values[u] == 0 && isFree(set.unknowns[u], from);
        count_ += zero_[u] ? 1 : 0;
        if (zero_[u])
            nodeZero_[set.unknowns[u].symbol.index] = true;
    }
    for (std::uint32_t n = 0; n < graph.size(); ++n) // arguments come first
        if (graph.op(Node{n}) != Op::symbol)
            nodeZero_[n] = vanishes(graph, Node{n}, nodeZero_);
    std::vector<std::size_t> awake;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (zero_[u] && hasRateBesides(set.unknowns[u], from, nodeZero_))
            awake.push_back(u);
    (void)spread(set, from, std::move(awake));
    looks_ = 0;
}

// What shows that something is not 0 is handed on to the readers. Answers with all that wake.
std::vector<std::size_t> ZeroStates::spread(const expression::EquationSet& set, double from,
                                            std::vector<std::size_t> awake) {
    std::vector<std::size_t> woken;
    while (!awake.empty()) {
        const std::size_t u = awake.back();
        awake.pop_back();
        if (!zero_[u])
            continue;
        zero_[u] = false;
        --count_;
        woken.push_back(u);
        std::vector<std::uint32_t> open{set.unknowns[u].symbol.index};
        nodeZero_[open[0]] = false;
        while (!open.empty()) {
            const std::uint32_t n = open.back();
            open.pop_back();
            ++looks_;
            eachUnknown(n, [&](std::uint32_t of) {
                if (zero_[of] && hasRate(set.unknowns[of], from, n))
                    awake.push_back(of);
            });
            eachReader(n, [&](std::uint32_t reader) {
                ++looks_;
                if (nodeZero_[reader] && !vanishes(set.graph, Node{reader}, nodeZero_)) {
                    nodeZero_[reader] = false;
                    open.push_back(reader);
                }
            });
        }
    }
    std::sort(woken.begin(), woken.end());
    return woken;
}

// Nodes that the graph has got since.
void ZeroStates::grow(const Graph& graph, std::uint32_t until) {
    for (auto n = static_cast<std::uint32_t>(nodeZero_.size()); n < until; ++n) {
        ++looks_;
        nodeZero_.push_back(false);
        if (graph.op(Node{n}) != Op::symbol)
            nodeZero_[n] = vanishes(graph, Node{n}, nodeZero_);
        for (const Node argument : graph.arguments(Node{n}))
            lateReaders_.add(argument.index, n);
    }
}

// Of earlier phases it has learnt already.
void ZeroStates::learn(const expression::Unknown& unknown, double from, std::size_t u) {
    const auto number = static_cast<std::uint32_t>(u);
    eachNodeOf(phasesFrom(unknown, from), [&](std::uint32_t node) {
        ++looks_;
        bool isKnown = false;
        eachUnknown(node, [&](std::uint32_t known) { isKnown = isKnown || known == number; });
        if (!isKnown)
            lateUnknowns_.add(node, number);
    });
}

std::vector<std::size_t> ZeroStates::unknowns() const {
    std::vector<std::size_t> list;
    for (std::size_t u = 0; u < zero_.size(); ++u)
        if (zero_[u])
            list.push_back(u);
    return list;
}

void ZeroStates::add(const expression::EquationSet& set) {
    zero_.resize(set.unknowns.size(), false);
    if (empty())
        return;
    const std::uint32_t symbol = set.unknowns.back().symbol.index;
    grow(set.graph, symbol + 1); // nodes that read it come after it
    nodeZero_[symbol] = true;
    zero_.back() = true;
    ++count_;
}

std::vector<std::size_t> ZeroStates::wake(const expression::EquationSet& set, double from,
                                          std::span<const std::size_t> roused,
                                          std::span<const std::size_t> changed) {
    if (empty())
        return {};
    grow(set.graph, static_cast<std::uint32_t>(set.graph.size()));
    std::vector<std::size_t> awake(roused.begin(), roused.end());
    for (const std::size_t u : changed) {
        learn(set.unknowns[u], from, u);
        if (zero_[u] &&
            (!isFree(set.unknowns[u], from) || hasRateBesides(set.unknowns[u], from, nodeZero_)))
            awake.push_back(u);
    }
    return spread(set, from, std::move(awake));
}

std::vector<std::size_t> ZeroStates::readersOf(const expression::EquationSet& set,
                                               std::span<const std::size_t> unknowns) {
    std::vector<std::size_t> found;
    std::vector<std::uint32_t> open;
    expression::Visited seen;
    for (const std::size_t u : unknowns)
        if (seen.insert(set.unknowns[u].symbol))
            open.push_back(set.unknowns[u].symbol.index);
    while (!open.empty()) {
        const std::uint32_t n = open.back();
        open.pop_back();
        ++looks_;
        eachUnknown(n, [&](std::uint32_t u) { found.push_back(u); });
        eachReader(n, [&](std::uint32_t reader) {
            if (seen.insert(Node{reader}))
                open.push_back(reader);
        });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<Node> ZeroStates::symbolsLeft(const Graph& graph, std::span<const Node> nodes) const {
    if (empty())
        return expression::symbolsOf(graph, nodes);
    std::vector<Node> open(nodes.begin(), nodes.end()), symbols;
    expression::Visited seen;
    while (!open.empty()) {
        const Node n = open.back();
        open.pop_back();
        if (isZero(n) || !seen.insert(n))
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
