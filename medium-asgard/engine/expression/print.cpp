#include "expression/graph.h"
#include "expression/operation.h"

#include <array>
#include <charconv>
#include <cmath>
#include <unordered_map>
#include <variant>

namespace expression {
namespace {

// How tightly an operator binds; an operand that binds less is put in parentheses.
enum Binding {
    ternary = 1,
    disjunction,
    conjunction,
    equality,
    order,
    sum,
    product,
    sign,
    power,
    atom
};

Binding bindingOf(const Graph& graph, Node n) {
    switch (graph.op(n)) {
    case Op::constant:
    case Op::parameter:
        return graph.value(n) < 0 || std::signbit(graph.value(n)) ? sign : atom;
    case Op::negate:
    case Op::logicalNot:
        return sign;
    case Op::add:
    case Op::subtract:
        return sum;
    case Op::multiply:
    case Op::divide:
        return product;
    case Op::power:
        return power;
    case Op::less:
    case Op::lessEqual:
        return order;
    case Op::equal:
    case Op::notEqual:
        return equality;
    case Op::logicalAnd:
        return conjunction;
    case Op::logicalOr:
        return disjunction;
    case Op::select:
        return ternary;
    default:
        return atom;
    }
}

// The shortest digits that read back to the same number, without an exponent where that is legible.
std::string numberText(double value) {
    std::array<char, 32> buffer;
    const double size = std::abs(value);
    const bool isLegible = value == 0 || (size >= 1e-4 && size < 1e15);
    const auto format = isLegible ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr;
    return {buffer.data(), end};
}

// Prints with a stack of its own: an expression may be deeper than the machine's stack.
class Printer {
public:
    explicit Printer(const Graph& graph) : graph_(graph) {}

    std::string print(Node root) {
        push(root, ternary);
        while (!pending_.empty()) {
            const Item item = pending_.back();
            pending_.pop_back();
            if (const auto* text = std::get_if<std::string_view>(&item))
                text_ += *text;
            else
                expand(std::get<Operand>(item));
        }
        return std::move(text_);
    }

private:
    struct Operand {
        Node node;
        Binding least;
    };
    using Item = std::variant<std::string_view, Operand>;

    void push(Node node, Binding least) { pending_.emplace_back(Operand{node, least}); }
    void push(std::string_view text) { pending_.emplace_back(text); }

    // Pushes in reverse, since the stack gives back the last first.
    void expand(Operand operand) {
        const bool isWeaker = bindingOf(graph_, operand.node) < operand.least;
        if (isWeaker) {
            push(")");
            pending_.emplace_back(Operand{operand.node, ternary});
            push("(");
            return;
        }
        const Op op = graph_.op(operand.node);
        if (op == Op::constant || op == Op::parameter)
            text_ += numberText(graph_.value(operand.node));
        else if (op == Op::symbol)
            text_ += graph_.name(operand.node);
        else
            expandOperation(op, operand.node, operand.least);
    }

    void expandOperation(Op op, Node node, Binding least) {
        const auto a = graph_.arguments(node);
        const Binding own = bindingOf(graph_, node);
        if (op == Op::select) {
            push(a[2], ternary);
            push(" : ");
            push(a[1], ternary);
            push(" ? ");
            push(a[0], disjunction);
        } else if (own == sign) {
            const bool mayRunOn = op == Op::negate && least <= product;
            push(a[0], mayRunOn && negatesFirstFactor(a[0]) ? product : sign);
            push(nameOf(op));
        } else if (own == atom) {
            expandCall(op, a);
        } else {
            expandInfix(op, a, own);
        }
    }

    void expandCall(Op op, std::span<const Node> a) {
        push(")");
        for (std::size_t i = a.size(); i-- > 0;) {
            push(a[i], ternary);
            push(i > 0 ? ", " : "(");
        }
        push(nameOf(op));
    }

    void expandInfix(Op op, std::span<const Node> a, Binding own) {
        if (op == Op::power) {
            push(a[1], sign);
            push("^");
            push(a[0], atom);
            return;
        }
        const bool joins = op == Op::multiply && graph_.op(a[0]) == Op::constant && isProduct(a[1]);
        push(a[1], joins ? own : static_cast<Binding>(own + 1));
        if (own == product)
            push(nameOf(op));
        else
            pushSpaced(op);
        push(a[0], own);
    }

    void pushSpaced(Op op) {
        push(" ");
        push(nameOf(op));
        push(" ");
    }

    // x*y*z, which after a number reads back as the same product: 2*x*y is 2*(x*y). One that begins
    // with a number does not: 3*5e-324*x would be the product of two numbers times x.
    [[nodiscard]] bool isProduct(Node n) const {
        if (graph_.op(n) != Op::multiply)
            return false;
        while (graph_.op(n) == Op::multiply)
            n = graph_.arguments(n)[0];
        return graph_.op(n) != Op::divide && graph_.op(n) != Op::constant &&
               graph_.op(n) != Op::parameter;
    }

    // -x*y reads back as -(x*y) if -x is a plain negation.
    [[nodiscard]] bool negatesFirstFactor(Node n) const {
        if (bindingOf(graph_, n) != product)
            return false;
        while (bindingOf(graph_, n) == product)
            n = graph_.arguments(n)[0];
        return graph_.op(n) == Op::symbol || graph_.op(n) == Op::power;
    }

    const Graph& graph_;
    std::vector<Item> pending_;
    std::string text_;
};

} // namespace

std::string print(const Graph& graph, Node node) { return Printer(graph).print(node); }

std::string printNodes(const Graph& graph, std::span<const Node> roots) {
    const std::vector<Node> nodes = reachable(graph, roots);
    std::unordered_map<std::uint32_t, std::size_t> reads, number;
    for (const Node n : nodes)
        for (const Node argument : graph.arguments(n))
            ++reads[argument.index];
    for (const Node root : roots)
        ++reads[root.index];
    const auto named = [&](Node n) {
        const auto place = number.find(n.index);
        return place == number.end() ? print(graph, n) : "n" + std::to_string(place->second);
    };
    std::string text;
    for (const Node n : nodes) {
        if (graph.arguments(n).empty())
            continue;
        const std::size_t place = number.size();
        text += "n" + std::to_string(place) + " = " + std::string(nameOf(graph.op(n)));
        for (const Node argument : graph.arguments(n))
            text += ' ' + named(argument);
        text +=
            reads[n.index] > 1 ? "  (read " + std::to_string(reads[n.index]) + " times)\n" : "\n";
        number.emplace(n.index, place);
    }
    return text;
}

} // namespace expression
