#include "equations/solved_conditions.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

// Multiplications that are worth code of their own, besides and for each row: a hinge in space in a
// chain takes 29 for each.
constexpr double few = 200, each = 64;

// The part of second rates that rounding may leave of conditions; and the part of 0.
constexpr double rounding = 1e-11, nothing = 1e-200;

// Puts nodes of one graph into another one, with products in order.
class InOrder {
public:
    enum Kind : std::uint8_t { number, state, force }; // by what they read

    InOrder(const Graph& from, Graph& to) : from_(from), to_(to), one_(to.constant(1)) {}

    // `to`: what it is there.
    void put(Node symbol, Node to, Kind kind) {
        made_.insert_or_assign(symbol.index, of(to, kind));
    }

    Node operator()(Node root) {
        std::vector<Node> stack = {root};
        while (!stack.empty()) {
            const Node n = stack.back();
            if (made_.contains(n.index)) {
                stack.pop_back();
                continue;
            }
            const std::size_t size = stack.size();
            const auto arguments = from_.arguments(n);
            for (std::size_t k = arguments.size(); k-- > 0;)
                if (!made_.contains(arguments[k].index))
                    stack.push_back(arguments[k]);
            if (stack.size() > size)
                continue;
            stack.pop_back();
            made_.emplace(n.index, make(n));
        }
        return written(made_.at(root.index));
    }

private:
    struct Product { // of one factor of each kind; none: 1
        std::array<std::optional<Node>, 3> factors;
        bool isNegative = false;
    };

    static Product of(Node n, Kind kind) {
        Product product;
        product.factors[kind] = n;
        return product;
    }
    static Kind kindOf(const Product& product) {
        return product.factors[force] ? force : product.factors[state] ? state : number;
    }
    Node written(const Product& product) {
        Node all = one_;
        for (const std::optional<Node>& factor : product.factors)
            if (factor)
                all = all == one_ ? *factor : to_.multiply(all, *factor);
        return product.isNegative ? to_.negate(all) : all;
    }
    std::optional<Node> times(const std::optional<Node>& a, const std::optional<Node>& b) {
        if (!a || !b)
            return a ? a : b;
        return to_.multiply(*a, *b);
    }
    Product times(const Product& a, const Product& b) {
        Product product;
        for (std::size_t k = 0; k < product.factors.size(); ++k)
            product.factors[k] = times(a.factors[k], b.factors[k]);
        product.isNegative = a.isNegative != b.isNegative;
        return product;
    }

    Product over(const Product& a, const Product& b) {
        const Kind kind = kindOf(b);
        if (kind == number)
            return times(a, of(to_.divide(one_, written(b)), number));
        Product quotient = a;
        const Node above = quotient.factors[kind].value_or(one_);
        quotient.factors[kind] = to_.divide(above, written(b));
        return quotient;
    }

    Product make(Node n) {
        const auto arguments = from_.arguments(n);
        const auto argument = [&](std::size_t k) -> const Product& {
            return made_.at(arguments[k].index);
        };
        switch (from_.op(n)) {
        case Op::constant:
        case Op::parameter:
            return from_.value(n) == -1  ? Product{{}, true}
                   : from_.value(n) == 1 ? Product{}
                                         : of(to_.constant(from_.value(n)), number);
        case Op::negate: {
            Product product = argument(0);
            product.isNegative = !product.isNegative;
            return product;
        }
        case Op::multiply:
            return times(argument(0), argument(1));
        case Op::divide:
            return over(argument(0), argument(1));
        case Op::power:
            if (from_.isConstant(arguments[1], 2))
                return times(argument(0), argument(0));
            break;
        default:
            break;
        }
        std::array<Node, 3> a{};
        Kind kind = number;
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            a[k] = written(argument(k));
            kind = std::max(kind, kindOf(argument(k)));
        }
        const Op op = from_.op(n);
        return of(arguments.size() == 1   ? to_.apply(op, a[0])
                  : arguments.size() == 2 ? to_.apply(op, a[0], a[1])
                                          : to_.apply(op, a[0], a[1], a[2]),
                  kind);
    }

    const Graph& from_;
    Graph& to_;
    Node one_;
    std::unordered_map<std::uint32_t, Product> made_;
};

// L D L' of a sparse symmetric matrix, and what it makes of a right-hand side.
class WrittenElimination {
    using Index = EliminationOrder::Index;

public:
    WrittenElimination(const LinearConditions& conditions, Graph& graph, InOrder& inOrder)
        : conditions_(conditions), graph_(graph), inOrder_(inOrder), zero_(graph.constant(0)),
          one_(graph.constant(1)) {
        for (std::size_t k = 0; k < conditions.places.size(); ++k)
            given_.emplace(std::pair(conditions.places[k].row, conditions.places[k].column),
                           conditions.entries[k]);
        values_.resize(conditions.rests.size());
        inverses_.resize(values_.size());
        works_.resize(values_.size());
    }

    [[nodiscard]] bool hasDiagonalAndMirrors() const {
        for (Index row = 0; row < values_.size(); ++row)
            if (!given_.contains({row, row}))
                return false;
        return std::ranges::all_of(conditions_.places, [this](const EliminationOrder::Place& at) {
            return given_.contains({at.column, at.row});
        });
    }

    // Adds to checks.
    void eliminate(const EliminationOrder& order, std::vector<Node>& checks) {
        const Node least = graph_.constant(leastPivot);
        for (const Index row : order.rows) {
            const Node pivot = at(row, row), inverse = graph_.divide(one_, pivot);
            const Node own = inOrder_(given_.at({row, row}));
            checks.push_back(pivot == own ? pivot
                                          : graph_.subtract(pivot, graph_.multiply(least, own)));
            const Node value = valueOf(row);
            const std::vector<Index>& later = order.later[row];
            for (const Index a : later) {
                const Node l = graph_.multiply(at(a, row), inverse);
                for (const Index b : later)
                    if (b <= a)
                        set(a, b, graph_.subtract(at(a, b), graph_.multiply(l, at(b, row))));
                values_[a] = graph_.subtract(valueOf(a), graph_.multiply(l, value));
                factors_.emplace(std::pair(a, row), l);
            }
            values_[row] = graph_.multiply(value, inverse);
            inverses_[row] = inverse;
            works_[row] = graph_.multiply(value, *values_[row]);
        }
    }

    // Once those that come later are solved.
    Node solve(const EliminationOrder& order, Index row) {
        for (const Index a : order.later[row])
            values_[row] =
                graph_.subtract(*values_[row], graph_.multiply(factors_.at({a, row}), *values_[a]));
        return *values_[row];
    }

    // Once all rows are solved; adds to checks. What the multipliers make of their own conditions,
    // m' A m, is the size of things: with it go what rounding leaves and what is left.
    void checkWhatIsLeft(std::vector<Node>& checks) {
        Node all = graph_.constant(nothing), left = zero_;
        for (Index row = 0; row < values_.size(); ++row) {
            const Node own = inOrder_(conditions_.lefts[row]);
            all = graph_.add(all, works_[row]);
            left = graph_.add(left, graph_.multiply(graph_.multiply(own, own), inverses_[row]));
        }
        checks.push_back(
            graph_.subtract(graph_.multiply(graph_.constant(rounding * rounding), all), left));
    }

private:
    Node at(Index row, Index column) {
        const std::pair place = std::minmax(row, column);
        const auto changed = changed_.find(place);
        if (changed != changed_.end())
            return changed->second;
        const auto given = given_.find(place);
        return given == given_.end() ? zero_ : inOrder_(given->second);
    }
    void set(Index row, Index column, Node value) {
        changed_.insert_or_assign(std::minmax(row, column), value);
    }
    Node valueOf(Index row) {
        if (!values_[row])
            values_[row] = graph_.negate(inOrder_(conditions_.rests[row]));
        return *values_[row];
    }

    const LinearConditions& conditions_;
    Graph& graph_;
    InOrder& inOrder_;
    Node zero_, one_;
    using Entries = std::map<std::pair<Index, Index>, Node>;
    Entries given_, changed_, factors_;
    std::vector<std::optional<Node>> values_;
    std::vector<Node> inverses_, works_; // of pivots; m' A m is the sum of the works
};

// Of each output the row that is solved last of those whose multipliers it reads.
class Awaited {
public:
    Awaited(const LinearConditions& conditions, const EliminationOrder& order,
            std::span<const Node> outputs)
        : readers_(order.rows.size() + 1) {
        const auto none = static_cast<std::uint32_t>(order.rows.size());
        std::unordered_map<std::uint32_t, std::uint32_t> least; // rank, of nodes that read some
        for (std::uint32_t rank = 0; rank < none; ++rank)
            least.emplace(conditions.held[order.rows[rank]].index, rank);
        const auto rankOf = [&](Node n) {
            const auto found = least.find(n.index);
            return found == least.end() ? none : found->second;
        };
        for (const Node n : expression::reachable(conditions.graph, outputs)) {
            std::uint32_t rank = rankOf(n);
            for (const Node argument : conditions.graph.arguments(n))
                rank = std::min(rank, rankOf(argument));
            if (rank < none)
                least.insert_or_assign(n.index, rank);
        }
        for (std::size_t k = 0; k < outputs.size(); ++k)
            readers_[rankOf(outputs[k])].push_back(k);
    }
    // Of those that read none the number of rows.
    [[nodiscard]] const std::vector<std::size_t>& by(std::size_t rank) const {
        return readers_[rank];
    }

private:
    std::vector<std::vector<std::size_t>> readers_;
};

} // namespace

std::optional<EliminationOrder> orderToWrite(std::size_t size,
                                             std::span<const EliminationOrder::Place> places) {
    const double most = few + each * static_cast<double>(size);
    return eliminationOrder(size, places, std::min(worthEliminating(size), most),
                            AmongEquals::waitsLeast);
}

std::optional<SolvedConditions> solvedConditions(const LinearConditions& conditions,
                                                 const EliminationOrder& order,
                                                 std::span<const Node> outputs) {
    const std::size_t size = conditions.rests.size();
    SolvedConditions solved;
    Graph& graph = solved.graph;
    InOrder inOrder(conditions.graph, graph);
    for (const Node symbol : conditions.symbols) {
        solved.symbols.push_back(graph.symbol(conditions.graph.name(symbol)));
        inOrder.put(symbol, solved.symbols.back(), InOrder::state);
    }
    for (const Node constant : conditions.constants)
        inOrder.put(constant, graph.symbol(conditions.graph.name(constant)), InOrder::number);
    for (const Node multiplier : conditions.multipliers) // ties
        inOrder.put(multiplier, graph.constant(0), InOrder::number);
    WrittenElimination elimination(conditions, graph, inOrder);
    if (!elimination.hasDiagonalAndMirrors())
        return std::nullopt;
    elimination.eliminate(order, solved.checks);
    const Awaited awaited(conditions, order, outputs);
    solved.outputs.resize(outputs.size());
    solved.multipliers.resize(size);
    for (std::size_t rank = size; rank-- > 0;) {
        const EliminationOrder::Index row = order.rows[rank];
        solved.multipliers[row] = elimination.solve(order, row);
        inOrder.put(conditions.held[row], solved.multipliers[row], InOrder::force);
        for (const std::size_t output : awaited.by(rank))
            solved.outputs[output] = inOrder(outputs[output]);
    }
    for (const std::size_t output : awaited.by(size))
        solved.outputs[output] = inOrder(outputs[output]);
    elimination.checkWhatIsLeft(solved.checks);
    return solved;
}

} // namespace solution
