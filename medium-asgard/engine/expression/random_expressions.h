// Random expressions for tests, and what they mean by the slowest and plainest of evaluators.
#pragma once

#include "expression/graph.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace expression::testing {

// Whole and half powers up to 4 are products and a root (operation.h).
inline double powered(double x, double exponent) {
    const double size = std::abs(exponent), whole = std::floor(size), rest = size - whole;
    if (!(size <= 4) || (rest != 0 && rest != 0.5))
        return std::pow(x, exponent);
    double result = whole == 4 ? (x * x) * (x * x) : 1;
    for (int i = 0; whole < 4 && i < whole; ++i)
        result = i == 0 ? x : result * x;
    if (rest != 0)
        result = whole == 0 ? std::sqrt(x) : result * std::sqrt(x);
    return exponent < 0 ? 1 / result : result;
}

// The value of an expression, node by node as one would explain it, knowing nothing of tapes,
// shared subexpressions or compute().
inline double explained(const Graph& g, Node n, std::span<const Node> symbols,
                        std::span<const double> values) {
    const auto value = [&](std::size_t i) {
        return explained(g, g.arguments(n)[i], symbols, values);
    };
    switch (g.op(n)) {
    case Op::constant:
    case Op::parameter:
        return g.value(n);
    case Op::symbol:
        for (std::size_t i = 0; i < symbols.size(); ++i)
            if (symbols[i] == n)
                return values[i];
        throw std::logic_error("a symbol without value");
    case Op::negate:
        return -value(0);
    case Op::sin:
        return std::sin(value(0));
    case Op::cos:
        return std::cos(value(0));
    case Op::tan:
        return std::tan(value(0));
    case Op::asin:
        return std::asin(value(0));
    case Op::acos:
        return std::acos(value(0));
    case Op::atan:
        return std::atan(value(0));
    case Op::sinh:
        return std::sinh(value(0));
    case Op::cosh:
        return std::cosh(value(0));
    case Op::tanh:
        return std::tanh(value(0));
    case Op::exp:
        return std::exp(value(0));
    case Op::log:
        return std::log(value(0));
    case Op::log10:
        return std::log10(value(0));
    case Op::sqrt:
        return std::sqrt(value(0));
    case Op::abs:
        return std::fabs(value(0));
    case Op::sign: {
        const double x = value(0);
        return std::isnan(x) ? x : x == 0 ? 0 : std::copysign(1, x);
    }
    case Op::floor:
        return std::floor(value(0));
    case Op::ceil:
        return -std::floor(-value(0));
    case Op::logicalNot:
        return value(0) == 0;
    case Op::add:
        return value(0) + value(1);
    case Op::subtract:
        return value(0) - value(1);
    case Op::multiply:
        return value(0) * value(1);
    case Op::divide:
        return value(0) / value(1);
    case Op::power:
        return powered(value(0), value(1));
    case Op::atan2:
        return std::atan2(value(0), value(1));
    case Op::hypot:
        return std::hypot(value(0), value(1));
    case Op::min:
    case Op::max: {
        const double a = value(0), b = value(1);
        if (std::isnan(a) || std::isnan(b))
            return std::nan("");
        return (g.op(n) == Op::min ? b < a : a < b) ? b : a;
    }
    case Op::less:
        return value(0) < value(1);
    case Op::lessEqual:
        return value(0) <= value(1);
    case Op::equal:
        return value(0) == value(1);
    case Op::notEqual:
        return value(0) != value(1);
    case Op::logicalAnd:
        return value(0) != 0 && value(1) != 0;
    case Op::logicalOr:
        return value(0) != 0 || value(1) != 0;
    case Op::select:
        return value(0) != 0 ? value(1) : value(2);
    }
    return 0;
}

// The same number, bit for bit; every NaN is one, and 0 is -0.
inline bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

class RandomExpressions {
public:
    explicit RandomExpressions(std::uint32_t seed, bool withSpecial = true)
        : random_(seed), withSpecial_(withSpecial) {}

    Node make(Graph& graph, int depth) {
        if (depth == 0 || pick(6) == 0)
            return leaf(graph);
        const auto op = static_cast<Op>(3 + pick(35));
        const Node a = make(graph, depth - 1);
        if (op < Op::add)
            return graph.apply(op, a);
        const Node b = make(graph, depth - 1);
        return op < Op::select ? graph.apply(op, a, b)
                               : graph.apply(op, a, b, make(graph, depth - 1));
    }

    double number() {
        static constexpr double special[] = {0,
                                             -0.0,
                                             1,
                                             -1,
                                             2,
                                             0.5,
                                             -1.5,
                                             3,
                                             1e300,
                                             1e-300,
                                             1e-310,
                                             5e-324, // the smallest
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::quiet_NaN()};
        return withSpecial_ && pick(3) == 0 ? special[pick(std::size(special))]
                                            : std::uniform_real_distribution(-4.0, 4.0)(random_);
    }

private:
    Node leaf(Graph& graph) {
        static constexpr std::string_view names[] = {"x", "y", "z"};
        return pick(3) == 0 ? graph.constant(number()) : graph.symbol(names[pick(3)]);
    }
    std::uint32_t pick(std::uint32_t below) {
        return std::uniform_int_distribution<std::uint32_t>(0, below - 1)(random_);
    }
    std::mt19937 random_;
    bool withSpecial_; // numbers that are huge, tiny, infinite or none
};

struct Xyz {
    Graph graph;
    std::vector<Node> symbols{graph.symbol("x"), graph.symbol("y"), graph.symbol("z")};
};

// ASGARD_LONG=100 makes it the million.
inline int repetitions(int usual) {
    const char* factor = std::getenv("ASGARD_LONG");
    return factor ? usual * std::atoi(factor) : usual;
}

} // namespace expression::testing
