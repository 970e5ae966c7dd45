#include "expression/simplify.h"

#include "expression/operation.h"

#include <algorithm>
#include <cmath>

namespace expression {
namespace {

using Result = std::optional<Node>;

// One operation's view of its arguments, with the questions that rules ask.
struct Rules {
    Graph& g;

    [[nodiscard]] bool is(Node n, Op op) const { return g.op(n) == op; }
    [[nodiscard]] bool isNumber(Node n) const { return g.op(n) == Op::constant; }
    [[nodiscard]] Node first(Node n) const { return g.arguments(n)[0]; }
    [[nodiscard]] Node second(Node n) const { return g.arguments(n)[1]; }
    [[nodiscard]] bool isNegative(Node n) const { return isNumber(n) && g.value(n) < 0; }
    // A product with a number in front: 2*x.
    [[nodiscard]] bool isScaled(Node n) const { return is(n, Op::multiply) && isNumber(first(n)); }
    // Its text would begin with a minus that belongs to a number: -2, -2*x, -2/x, -2*x/y.
    [[nodiscard]] bool leadsNegative(Node n) const {
        if (is(n, Op::divide))
            n = first(n);
        return isNegative(isScaled(n) ? first(n) : n);
    }
    // Base and exponent of a power with a whole number above; of any other x, x and 1.
    [[nodiscard]] std::pair<Node, double> wholePower(Node n) const {
        if (is(n, Op::power) && isNumber(second(n)) &&
            g.value(second(n)) == std::floor(g.value(second(n))))
            return {first(n), g.value(second(n))};
        return {n, 1.0};
    }

    [[nodiscard]] Result folded(Op op, std::span<const Node> arguments) const;
    [[nodiscard]] Result negate(Node a) const;
    [[nodiscard]] Result add(Node a, Node b) const;
    [[nodiscard]] Result subtract(Node a, Node b) const;
    [[nodiscard]] Result multiply(Node a, Node b) const;
    [[nodiscard]] Result multiplyByNumber(Node number, Node b) const;
    [[nodiscard]] Result divide(Node a, Node b) const;
    [[nodiscard]] Result quotientByLength(Node a, Node b) const;
    [[nodiscard]] Result productWithLength(Node a, Node b) const;
    [[nodiscard]] Result without(Node product, Node factor, int depth = 0) const;
    [[nodiscard]] Result power(Node a, Node b) const;
    [[nodiscard]] Result function(Op op, Node a) const;
    struct Scaled {
        Node of;
        double by = 1; // not 0
    };
    [[nodiscard]] Scaled scaled(Node n) const;
    [[nodiscard]] std::optional<Scaled> lengthOfOne(Node n) const;
    [[nodiscard]] Node times(Node n, double by) const;
    [[nodiscard]] bool isLengthOf(Node n, Node of) const;
    [[nodiscard]] bool isNeverNegative(Node n) const;
    [[nodiscard]] bool isWhole(Node n, int depth = 0) const;
    [[nodiscard]] Node ofSameSign(Node n) const;
    [[nodiscard]] Result sign(Node a) const;
    [[nodiscard]] Result abs(Node a) const;
    [[nodiscard]] Result compared(Op op, Node a, Node b) const;
    [[nodiscard]] Result lesser(Op op, Node a, Node b) const;
    [[nodiscard]] Result hypot(Node a, Node b) const;
    [[nodiscard]] Result logical(Op op, Node a, Node b) const;
    [[nodiscard]] Node truthOf(Node n) const;
};

Result Rules::folded(Op op, std::span<const Node> arguments) const {
    if (!std::ranges::all_of(arguments, [this](Node n) { return isNumber(n); }))
        return std::nullopt;
    double values[3] = {0, 0, 0};
    std::ranges::transform(arguments, values, [this](Node n) { return g.value(n); });
    const double value = compute(op, values[0], values[1], values[2]);
    if (!std::isfinite(value))
        return std::nullopt;
    return g.constant(value);
}

Result Rules::negate(Node a) const {
    if (is(a, Op::negate))
        return first(a);
    if (is(a, Op::subtract))
        return g.subtract(second(a), first(a));
    const bool isRatio = is(a, Op::divide) && (isNumber(first(a)) || isScaled(first(a)));
    if (isScaled(a) || isRatio)
        return g.apply(g.op(a), g.negate(first(a)), second(a));
    return std::nullopt;
}

Result Rules::add(Node a, Node b) const {
    if (g.isConstant(a, 0))
        return b;
    if (g.isConstant(b, 0))
        return a;
    if (a == b)
        return g.multiply(g.constant(2), a);
    if (is(b, Op::negate))
        return g.subtract(a, first(b));
    if (leadsNegative(b))
        return g.subtract(a, g.negate(b));
    if (is(a, Op::negate))
        return g.subtract(b, first(a));
    return std::nullopt;
}

Result Rules::subtract(Node a, Node b) const {
    if (g.isConstant(b, 0))
        return a;
    if (g.isConstant(a, 0))
        return g.negate(b);
    if (a == b)
        return g.constant(0);
    if (is(b, Op::negate))
        return g.add(a, first(b));
    if (leadsNegative(b))
        return g.add(a, g.negate(b));
    return std::nullopt;
}

Result Rules::multiplyByNumber(Node number, Node b) const {
    if (g.isConstant(number, 0))
        return g.constant(0);
    if (g.isConstant(number, 1))
        return b;
    if (g.isConstant(number, -1))
        return g.negate(b);
    if (is(b, Op::negate))
        return g.multiply(g.negate(number), first(b));
    if (isScaled(b)) {
        const double product = g.value(number) * g.value(first(b));
        if (std::isnormal(product))
            return g.multiply(g.constant(product), second(b));
    }
    if (is(b, Op::divide) && !g.isConstant(second(b), 0))
        return g.divide(g.multiply(number, first(b)), second(b));
    return std::nullopt;
}

Result Rules::multiply(Node a, Node b) const {
    if (isNumber(a))
        return multiplyByNumber(a, b);
    if (isNumber(b))
        return g.multiply(b, a);
    if (is(a, Op::negate))
        return g.negate(g.multiply(first(a), b));
    if (is(b, Op::negate))
        return g.negate(g.multiply(a, first(b)));
    if (isScaled(a))
        return g.multiply(first(a), g.multiply(second(a), b));
    if (isScaled(b))
        return g.multiply(first(b), g.multiply(a, second(b)));
    for (const auto& [factor, quotient] : {std::pair(a, b), {b, a}})
        if (const Result signs = productWithLength(factor, quotient))
            return signs;
    const auto x = wholePower(a), y = wholePower(b);
    if (x.first == y.first && x.second > 0 && y.second > 0)
        return g.apply(Op::power, x.first, g.constant(x.second + y.second));
    return std::nullopt;
}

// A product in which that factor is 1; none where it is no factor.
Result Rules::without(Node product, Node factor, int depth) const {
    constexpr int deepest = 8;
    if (product == factor)
        return g.constant(1);
    if (const auto [base, times] = wholePower(product); base == factor && times > 1)
        return g.apply(Op::power, factor, g.constant(times - 1));
    if (depth > deepest || !is(product, Op::multiply))
        return std::nullopt;
    if (const Result rest = without(first(product), factor, depth + 1))
        return g.multiply(*rest, second(product));
    if (const Result rest = without(second(product), factor, depth + 1))
        return g.multiply(first(product), *rest);
    return std::nullopt;
}

// v and 3 of 3*abs(v), 3*hypot(v, 0), sqrt(9*v^2). A length may have a number added that changes
// none but 0: it keeps 0/0 out of unit vectors.
std::optional<Rules::Scaled> Rules::lengthOfOne(Node n) const {
    if (is(n, Op::add))
        for (const auto& [number, other] :
             {std::pair(first(n), second(n)), std::pair(second(n), first(n))})
            if (isNumber(number) && std::abs(g.value(number)) < 1e-290)
                return lengthOfOne(other);
    const Node length = isScaled(n) ? second(n) : n;
    const double by = isScaled(n) ? g.value(first(n)) : 1;
    if (is(length, Op::abs))
        return Scaled{first(length), by};
    if (is(length, Op::hypot) && g.isConstant(second(length), 0))
        return Scaled{first(length), by};
    if (is(length, Op::hypot) && g.isConstant(first(length), 0))
        return Scaled{second(length), by};
    if (!is(length, Op::sqrt))
        return std::nullopt;
    const Node under = first(length), square = isScaled(under) ? second(under) : under;
    const double weight = isScaled(under) ? g.value(first(under)) : 1;
    if (!is(square, Op::power) || !g.isConstant(second(square), 2) || !(weight > 0))
        return std::nullopt;
    const Node of = first(square);
    return Scaled{is(of, Op::negate) ? first(of) : of, by * std::sqrt(weight)};
}

// v/abs(v), v/hypot(v, 0) and v/sqrt(v^2) mean the sign, at 0 too.
Result Rules::quotientByLength(Node a, Node b) const {
    const auto length = lengthOfOne(b);
    if (!length)
        return std::nullopt;
    const Result rest = without(a, length->of);
    if (!rest)
        return std::nullopt;
    const Node signs = g.multiply(*rest, g.apply(Op::sign, length->of));
    return length->by == 1 ? signs : g.divide(signs, g.constant(length->by));
}

// v*(1/abs(v)), as where it was written as v*(v^2)^-0.5.
Result Rules::productWithLength(Node a, Node b) const {
    if (!is(b, Op::divide) || !lengthOfOne(second(b)))
        return std::nullopt;
    return quotientByLength(g.multiply(a, first(b)), second(b));
}

Result Rules::divide(Node a, Node b) const {
    if (g.isConstant(b, 1))
        return a;
    if (g.isConstant(b, -1))
        return g.negate(a);
    if (is(a, Op::negate))
        return g.negate(g.divide(first(a), b));
    if (g.isConstant(b, 0))
        return std::nullopt; // stays what it says
    if (g.isConstant(a, 0))
        return g.constant(0);
    if (a == b)
        return g.constant(1);
    if (is(b, Op::negate))
        return g.negate(g.divide(a, first(b)));
    if (isNegative(b))
        return g.negate(g.divide(a, g.negate(b)));
    if (const Result signs = quotientByLength(a, b))
        return signs;
    if (is(a, Op::divide) && !g.isConstant(second(a), 0))
        return g.divide(first(a), g.multiply(second(a), b));
    if (isNumber(b) && isScaled(a)) {
        const double quotient = g.value(first(a)) / g.value(b);
        if (std::isnormal(quotient))
            return g.multiply(g.constant(quotient), second(a));
    }
    return std::nullopt;
}

Result Rules::power(Node a, Node b) const {
    if (g.isConstant(b, 0) || g.isConstant(a, 1))
        return g.constant(1);
    if (g.isConstant(b, 1))
        return a;
    if (g.isConstant(b, 0.5))
        return g.apply(Op::sqrt, a);
    if (g.isConstant(b, -1))
        return g.divide(g.constant(1), a);
    if (g.isConstant(b, -0.5))
        return g.divide(g.constant(1), g.apply(Op::sqrt, a));
    const auto base = wholePower(a);
    if (isNumber(b) && g.value(b) == std::floor(g.value(b)) && base.first != a)
        return g.apply(Op::power, base.first, g.constant(base.second * g.value(b)));
    return std::nullopt;
}

// What switches at the same place reads the same: friction on one body may be written with
// sign(v), and that on the other with sign(3*v). Numbers in front go outside.
Rules::Scaled Rules::scaled(Node n) const {
    const auto isFactor = [this](Node number) {
        return isNumber(number) && std::isnormal(g.value(number));
    };
    if (is(n, Op::negate)) {
        const Scaled inner = scaled(first(n));
        return {inner.of, -inner.by};
    }
    if (isScaled(n) && isFactor(first(n)))
        return {second(n), g.value(first(n))};
    if (is(n, Op::divide) && isFactor(second(n)) && std::isnormal(1 / g.value(second(n))))
        return {first(n), 1 / g.value(second(n))};
    if (is(n, Op::add) || is(n, Op::subtract)) {
        const double turn = is(n, Op::add) ? -1 : 1;
        const Node a = first(n), b = second(n);
        if (isScaled(a) && isScaled(b) && isFactor(first(a)) &&
            g.value(first(b)) == turn * g.value(first(a)))
            return {g.subtract(second(a), second(b)), g.value(first(a))};
    }
    return {n, 1};
}

Node Rules::times(Node n, double by) const { return by == 1 ? n : g.multiply(g.constant(by), n); }

// 0 where that is 0, and above it elsewhere.
bool Rules::isLengthOf(Node n, Node of) const {
    constexpr int deepest = 3;
    for (int depth = 0; depth < deepest; ++depth) {
        if (is(n, Op::abs))
            return first(n) == of;
        if (!is(n, Op::sqrt) &&
            !(is(n, Op::power) && isNumber(second(n)) && g.value(second(n)) > 0))
            return false;
        n = first(n);
    }
    return false;
}

bool Rules::isNeverNegative(Node n) const {
    return is(n, Op::abs) || is(n, Op::sqrt) ||
           (is(n, Op::max) && (g.isConstant(first(n), 0) || g.isConstant(second(n), 0)));
}

// It takes whole values only: floor and ceil of it are no switches of their own.
bool Rules::isWhole(Node n, int depth) const {
    constexpr int deepest = 8;
    if (depth > deepest)
        return false;
    switch (g.op(n)) {
    case Op::constant:
        return g.value(n) == std::floor(g.value(n)) && std::abs(g.value(n)) < 1e6;
    case Op::sign:
    case Op::floor:
    case Op::ceil:
        return true;
    case Op::negate:
    case Op::abs:
        return isWhole(first(n), depth + 1);
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::min:
    case Op::max:
        return isWhole(first(n), depth + 1) && isWhole(second(n), depth + 1);
    default:
        return isTruth(g.op(n));
    }
}

// The least that has its sign: v of v*abs(v), of v^3, of sign(v)*sqrt(abs(v)).
Node Rules::ofSameSign(Node n) const {
    if (is(n, Op::sign))
        return first(n);
    if (is(n, Op::sqrt) && isNeverNegative(first(n)))
        return first(n);
    if (is(n, Op::power) && isNumber(second(n)) && g.value(second(n)) > 0 &&
        (isNeverNegative(first(n)) || std::fmod(g.value(second(n)), 2) == 1))
        return first(n);
    if (is(n, Op::multiply)) {
        const Node a = first(n), b = second(n);
        const Node signOfA = is(a, Op::sign) ? first(a) : a,
                   signOfB = is(b, Op::sign) ? first(b) : b;
        if (isLengthOf(b, signOfA))
            return signOfA;
        if (isLengthOf(a, signOfB))
            return signOfB;
    }
    return n;
}

Result Rules::sign(Node a) const {
    const Scaled inner = scaled(a);
    const Node least = ofSameSign(inner.of);
    if (least == a)
        return std::nullopt;
    const Node sign = g.apply(Op::sign, least);
    return inner.by < 0 ? g.negate(sign) : sign;
}

Result Rules::abs(Node a) const {
    const Scaled inner = scaled(a);
    if (inner.of == a)
        return std::nullopt;
    return times(g.apply(Op::abs, inner.of), std::abs(inner.by));
}

Result Rules::compared(Op op, Node a, Node b) const {
    const Scaled one = scaled(a), other = scaled(b);
    const auto made = [&](Node x, Node y, double by) {
        return by < 0 ? g.apply(op, y, x) : g.apply(op, x, y);
    };
    if (g.isConstant(b, 0)) {
        const Node least = ofSameSign(one.of);
        return least == a ? Result() : Result(made(least, b, one.by));
    }
    if (g.isConstant(a, 0)) {
        const Node least = ofSameSign(other.of);
        return least == b ? Result() : Result(made(a, least, other.by));
    }
    if (one.by == other.by && std::abs(one.by) != 1)
        return made(one.of, other.of, one.by);
    return std::nullopt;
}

// The lesser or greater of two.
Result Rules::lesser(Op op, Node a, Node b) const {
    if (a == b)
        return a;
    const Scaled one = scaled(a), other = scaled(b);
    const bool isZero = g.isConstant(a, 0) || g.isConstant(b, 0);
    const double by = g.isConstant(a, 0) ? other.by : one.by;
    if (std::abs(by) == 1 || (!isZero && one.by != other.by))
        return std::nullopt;
    const Op turned = by > 0 ? op : op == Op::min ? Op::max : Op::min;
    return times(
        g.apply(turned, g.isConstant(a, 0) ? a : one.of, g.isConstant(b, 0) ? b : other.of), by);
}

Result Rules::function(Op op, Node a) const {
    if (op == Op::sign)
        return sign(a);
    if (op == Op::abs)
        return abs(a);
    if ((op == Op::floor || op == Op::ceil) && isWhole(a))
        return a;
    if (op == Op::logicalNot && is(a, Op::logicalNot))
        return truthOf(first(a));
    if (!is(a, Op::negate))
        return std::nullopt;
    switch (op) {
    case Op::sin:
    case Op::tan:
    case Op::asin:
    case Op::atan:
    case Op::sinh:
    case Op::tanh:
        return g.negate(g.apply(op, first(a)));
    case Op::cos:
    case Op::cosh:
        return g.apply(op, first(a));
    default:
        return std::nullopt;
    }
}

// A length that has no third part. Of what may be negative it would be abs(), which switches.
Result Rules::hypot(Node a, Node b) const {
    const auto isLength = [this](Node n) {
        return is(n, Op::hypot) || is(n, Op::abs) || is(n, Op::sqrt);
    };
    if (g.isConstant(b, 0) && isLength(a))
        return a;
    if (g.isConstant(a, 0) && isLength(b))
        return b;
    return std::nullopt;
}

// n as 0 or 1.
Node Rules::truthOf(Node n) const {
    return isTruth(g.op(n)) ? n : g.apply(Op::notEqual, n, g.constant(0));
}

Result Rules::logical(Op op, Node a, Node b) const {
    const bool isAnd = op == Op::logicalAnd;
    if (isNumber(b) && !isNumber(a))
        return logical(op, b, a);
    if (isNumber(a))
        return (g.value(a) != 0) == isAnd ? truthOf(b) : g.constant(isAnd ? 0 : 1);
    if (a == b)
        return truthOf(a);
    return std::nullopt;
}

} // namespace

std::optional<Node> simplified(Graph& graph, Op op, std::span<const Node> arguments) {
    const Rules rules{graph};
    if (const auto number = rules.folded(op, arguments))
        return number;
    switch (op) {
    case Op::negate:
        return rules.negate(arguments[0]);
    case Op::add:
        return rules.add(arguments[0], arguments[1]);
    case Op::subtract:
        return rules.subtract(arguments[0], arguments[1]);
    case Op::multiply:
        return rules.multiply(arguments[0], arguments[1]);
    case Op::divide:
        return rules.divide(arguments[0], arguments[1]);
    case Op::power:
        return rules.power(arguments[0], arguments[1]);
    case Op::hypot:
        return rules.hypot(arguments[0], arguments[1]);
    case Op::min:
    case Op::max:
        return rules.lesser(op, arguments[0], arguments[1]);
    case Op::less:
    case Op::lessEqual:
    case Op::equal:
    case Op::notEqual:
        return rules.compared(op, arguments[0], arguments[1]);
    case Op::logicalAnd:
    case Op::logicalOr:
        return rules.logical(op, arguments[0], arguments[1]);
    case Op::select:
        if (graph.op(arguments[0]) == Op::constant)
            return graph.value(arguments[0]) != 0 ? arguments[1] : arguments[2];
        if (isTruth(graph.op(arguments[0])) && graph.isConstant(arguments[1], 1) &&
            graph.isConstant(arguments[2], 0))
            return arguments[0];
        if (arguments[1] == arguments[2])
            return arguments[1];
        return std::nullopt;
    default:
        return arguments.size() == 1 ? rules.function(op, arguments[0]) : std::nullopt;
    }
}

} // namespace expression
