// Expressions as a hash-consed directed acyclic graph: equal expressions are one node.
//
// Every node is made by Graph, which folds constants and applies local algebra as it builds
// (x*0 -> 0, x+0 -> x, x^1 -> x, --x -> x, ...; simplify.h), so that equations print as an author
// would write them. Nodes are indices into their graph; a node's arguments always come before it.
// A parameter is a number that takes no part in this: equations that differ in parameters alone
// have the same form.
// Constants are finite; what is not (1/0) stays the quotient that it is.
//
// A graph belongs to one thread while it is built; afterwards it may be read by any.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace expression {

enum class Op : std::uint8_t {
    constant,
    symbol,
    parameter,
    // one argument
    negate,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    sinh,
    cosh,
    tanh,
    exp,
    log,
    log10,
    sqrt,
    abs,
    sign,
    floor,
    ceil,
    logicalNot,
    // two
    add,
    subtract,
    multiply,
    divide,
    power,
    atan2,
    hypot,
    min,
    max,
    less,
    lessEqual,
    equal,
    notEqual,
    logicalAnd,
    logicalOr, // a > b is less(b, a)
    // three: condition, value if it is not 0, value if it is
    select,
};

struct Node {
    std::uint32_t index = 0;
    // clang-tidy 14 takes the 0 of a defaulted <=> for a null pointer.
    auto operator<=>(const Node&) const = default; // NOLINT(modernize-use-nullptr)
};

class Graph {
public:
    Graph();

    [[nodiscard]] Node constant(double value);
    [[nodiscard]] Node symbol(std::string_view name); // the same name is the same node
    // The same value, owner and place are the same node.
    [[nodiscard]] Node parameter(double value, Node owner, std::uint32_t place = 0);
    [[nodiscard]] Node apply(Op op, Node a);
    [[nodiscard]] Node apply(Op op, Node a, Node b);
    [[nodiscard]] Node apply(Op op, Node a, Node b, Node c);

    [[nodiscard]] Node add(Node a, Node b) { return apply(Op::add, a, b); }
    [[nodiscard]] Node subtract(Node a, Node b) { return apply(Op::subtract, a, b); }
    [[nodiscard]] Node multiply(Node a, Node b) { return apply(Op::multiply, a, b); }
    [[nodiscard]] Node divide(Node a, Node b) { return apply(Op::divide, a, b); }
    [[nodiscard]] Node negate(Node a) { return apply(Op::negate, a); }

    [[nodiscard]] Op op(Node n) const { return entries_[n.index].op; }
    [[nodiscard]] std::span<const Node> arguments(Node n) const { // valid as long as the graph
        const Entry& entry = entries_[n.index];
        return {entry.arguments.data(), entry.count};
    }
    // Of a constant or a parameter.
    [[nodiscard]] double value(Node number) const { return entries_[number.index].value; }
    [[nodiscard]] const std::string& name(Node symbol) const;
    [[nodiscard]] bool isConstant(Node n, double value) const {
        const Entry& entry = entries_[n.index];
        return entry.op == Op::constant && entry.value == value;
    }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        Op op = Op::constant;
        std::uint8_t count = 0;
        // Of a symbol, the index of its name; of a parameter its owner and place.
        std::array<Node, 3> arguments{};
        double value = 0; // of a constant or a parameter
    };
    // Entries by index, in blocks that stay where they are while more are added.
    class Entries {
    public:
        Entries() = default;
        Entries(const Entries& other) { *this = other; }
        Entries(Entries&&) noexcept = default;
        Entries& operator=(const Entries& other);
        Entries& operator=(Entries&&) noexcept = default;
        ~Entries() = default;
        [[nodiscard]] std::size_t size() const { return size_; }
        [[nodiscard]] const Entry& operator[](std::size_t i) const {
            return (*blocks_[i / block])[i % block];
        }
        void add(const Entry& entry);

    private:
        static constexpr std::size_t block = 256;
        std::vector<std::unique_ptr<std::array<Entry, block>>> blocks_;
        std::size_t size_ = 0;
    };
    // Which node has this hash: open addressing with linear probing, at most half full.
    struct Place {
        std::uint32_t hash = 0, next = 0; // next: its index + 1; 0: nobody
    };
    static Entry makeEntry(Op op, Node a, Node b, Node c);
    static std::uint32_t hashOf(const Entry& entry);
    static bool isSame(const Entry& a, const Entry& b);
    Node intern(const Entry& entry);
    Node make(Op op, Node a, Node b, Node c);
    void growTable();

    Entries entries_;
    std::vector<std::string> names_;
    std::unordered_map<std::string, Node> symbols_;
    std::vector<Place> table_;
};

// Infix text that parse() reads back to the same node.
[[nodiscard]] std::string print(const Graph& graph, Node node);

// The graph as it is, a line for each operation that the roots are made of, arguments before what
// reads them: n7 = sin n4. An operation that is read more often than once says how often.
[[nodiscard]] std::string printNodes(const Graph& graph, std::span<const Node> roots);

// d node / d symbol. Switching functions differentiate piecewise: d abs(x) = sign(x) dx,
// d floor = d sign = 0, d min(a,b) = select(a < b, da, db).
[[nodiscard]] Node differentiate(Graph& graph, Node node, Node symbol);

// Rows of a Jacobian: of each root, its derivatives that are not 0 by the symbols given, in their
// order. Every node is differentiated once by each symbol that it depends on, however many roots
// share it.
struct Partial {
    std::uint32_t symbol; // its place among the symbols
    Node derivative;
};
[[nodiscard]] std::vector<std::vector<Partial>> gradients(Graph& graph, std::span<const Node> roots,
                                                          std::span<const Node> symbols);

// Every node (a symbol, mostly) replaced by the one given for it; what is put in stays as it is.
[[nodiscard]] Node substitute(Graph& graph, Node node,
                              const std::unordered_map<std::uint32_t, Node>& replacements);
// Of several nodes: what they share is looked at once.
[[nodiscard]] std::vector<Node>
substitute(Graph& graph, std::span<const Node> nodes,
           const std::unordered_map<std::uint32_t, Node>& replacements);

// All nodes that the given ones are made of, themselves included, in order of index: arguments
// before what reads them. Nothing below the nodes of `end`.
[[nodiscard]] std::vector<Node> reachable(const Graph& graph, std::span<const Node> roots,
                                          const std::unordered_map<std::uint32_t, Node>& end = {});

// The symbols that a node reads, in order of index.
[[nodiscard]] std::vector<Node> symbolsOf(const Graph& graph, std::span<const Node> nodes);

} // namespace expression
