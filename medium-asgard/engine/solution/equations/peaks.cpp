#include "equations/peaks.h"

#include "dense/polynomial.h"
#include "equations/directions.h"
#include "equations/surfaces.h"
#include "expression/operation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

constexpr Interval anything = {-infinity, infinity};

Interval product(const Interval& a, const Interval& b) {
    const auto ends = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    if (std::ranges::any_of(ends, [](double x) { return std::isnan(x); })) // 0 times anything
        return anything;
    const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
    return {*least, *most};
}

Interval magnitude(const Interval& a) {
    const double least = a.low > 0 ? a.low : a.high < 0 ? -a.high : 0;
    return {least, std::max(-a.low, a.high)};
}

// What values an operation has, by those of its arguments; of those that bounds are found for.
Interval rangeOf(const Graph& graph, Node node, std::span<const Interval> ranges) {
    const auto arguments = graph.arguments(node);
    const auto at = [&](std::size_t k) { return ranges[arguments[k].index]; };
    switch (graph.op(node)) {
    case Op::constant:
        return {graph.value(node), graph.value(node)};
    case Op::sin:
    case Op::cos:
        return {-1, 1};
    case Op::negate:
        return {-at(0).high, -at(0).low};
    case Op::abs:
        return magnitude(at(0));
    case Op::add:
        return {at(0).low + at(1).low, at(0).high + at(1).high};
    case Op::subtract:
        return {at(0).low - at(1).high, at(0).high - at(1).low};
    case Op::multiply:
        return arguments[0] == arguments[1] ? product(magnitude(at(0)), magnitude(at(0)))
                                            : product(at(0), at(1));
    case Op::power:
        return graph.isConstant(arguments[1], 2) ? product(magnitude(at(0)), magnitude(at(0)))
                                                 : anything;
    default:
        return anything;
    }
}

// Of all nodes that are reached, by index; `values` of constants.
std::vector<Interval> rangesOf(const Graph& graph, std::span<const Node> reached,
                               std::span<const Node> constants, std::span<const double> values) {
    std::vector<Interval> ranges(graph.size(), anything);
    for (std::size_t c = 0; c < constants.size(); ++c)
        ranges[constants[c].index] = {values[c], values[c]};
    for (const Node node : reached)
        if (graph.op(node) != Op::symbol)
            ranges[node.index] = rangeOf(graph, node, ranges);
    return ranges;
}

bool isMild(const Interval& denominator) {
    constexpr double most = 8;
    const Interval size = magnitude(denominator);
    return size.low > 0 && size.high < infinity && size.high <= most * size.low;
}

} // namespace

namespace {

// By node: what it reads is among these symbols.
std::vector<bool> readsOnly(const Graph& graph, std::span<const Node> reached,
                            std::initializer_list<std::span<const Node>> symbols) {
    std::vector<bool> only(graph.size(), false);
    for (const Node node : reached)
        only[node.index] =
            graph.op(node) == Op::symbol
                ? std::ranges::any_of(symbols,
                                      [&](std::span<const Node> known) {
                                          return std::ranges::find(known, node) != known.end();
                                      })
                : std::ranges::all_of(graph.arguments(node),
                                      [&](Node argument) { return only[argument.index]; });
    return only;
}

// Of what is reached, what can peak; `isNumber`: by node, reads constants only, `isMeasured`:
// or attitudes.
std::vector<Node> peakingNodes(const Graph& graph, std::span<const Node> reached,
                               const std::vector<bool>& isNumber,
                               const std::vector<bool>& isMeasured) {
    std::vector<Node> found;
    std::ranges::copy_if(reached, std::back_inserter(found), [&](Node node) {
        switch (graph.op(node)) {
        case Op::tan:
        case Op::asin:
        case Op::acos:
        case Op::atan:
        case Op::atan2:
        case Op::sinh:
        case Op::cosh:
        case Op::tanh:
        case Op::exp:
        case Op::log:
        case Op::log10:
            return !isNumber[node.index];
        case Op::divide:
            return !isMeasured[graph.arguments(node)[1].index];
        case Op::power: {
            const Node exponent = graph.arguments(node)[1];
            const bool isLow = graph.op(exponent) == Op::constant && graph.value(exponent) >= 0 &&
                               graph.value(exponent) <= 4;
            return !isLow && !isNumber[node.index];
        }
        default:
            return false;
        }
    });
    return found;
}

void makeUnique(std::vector<Node>& nodes) {
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

// What makes it peak: arguments, of a quotient the factors of its denominator without the lengths
// that a vector is divided by once. a/|a| turns, but does not peak.
std::vector<Node> causesOf(const Graph& graph, Node peaking) {
    const auto arguments = graph.arguments(peaking);
    if (graph.op(peaking) != Op::divide)
        return {arguments.begin(), arguments.end()};
    const std::vector<Node> factors = factorsOf(graph, arguments[1]);
    std::vector<Node> left;
    std::ranges::copy_if(factors, std::back_inserter(left), [&](Node factor) {
        return !isLength(graph, factor) || std::ranges::count(factors, factor) > 1;
    });
    return left;
}

Node sumOfSquares(Graph& graph, Node length) {
    if (graph.op(length) != Op::hypot)
        return graph.multiply(length, length);
    const Node first = graph.arguments(length)[0], second = graph.arguments(length)[1];
    const Node a = sumOfSquares(graph, first), b = sumOfSquares(graph, second);
    return graph.add(a, b);
}

struct Power {
    Node base;
    double exponent;
};

// Something simpler that is least or most, or 0, where this is: roots, powers and factors that are
// numbers are taken off.
Power withoutPowers(Graph& graph, Node node, const std::vector<bool>& isNumber) {
    constexpr double anyExponent = 100; // of one that is known by its name only
    const auto isOne = [&](Node n) { return n.index < isNumber.size() && isNumber[n.index]; };
    Power power{node, 1};
    for (;;) {
        const auto arguments = graph.arguments(power.base);
        switch (graph.op(power.base)) {
        case Op::hypot:
            return {sumOfSquares(graph, power.base), 0.5 * power.exponent};
        case Op::sqrt:
            power = {arguments[0], 0.5 * power.exponent};
            break;
        case Op::negate:
        case Op::abs:
            power.base = arguments[0];
            break;
        case Op::power:
            if (!isOne(arguments[1]))
                return power;
            power.exponent *= graph.op(arguments[1]) == Op::constant
                                  ? std::abs(graph.value(arguments[1]))
                                  : anyExponent;
            power.base = arguments[0];
            break;
        case Op::divide:
            if (!isOne(arguments[1]))
                return power;
            power.base = arguments[0];
            break;
        case Op::multiply:
            if (arguments[0] == arguments[1])
                power.exponent *= 2;
            else if (!isOne(arguments[0]) && !isOne(arguments[1]))
                return power;
            power.base = arguments[isOne(arguments[0]) ? 1 : 0];
            break;
        default:
            return power;
        }
    }
}

bool arePolynomials(const Graph& graph, std::span<const Node> nodes,
                    const std::vector<bool>& isNumber) {
    const auto isOne = [&](Node n) { return n.index < isNumber.size() && isNumber[n.index]; };
    return std::ranges::all_of(expression::reachable(graph, nodes), [&](Node n) {
        switch (graph.op(n)) {
        case Op::symbol:
        case Op::negate:
        case Op::add:
        case Op::subtract:
        case Op::multiply:
            return true;
        case Op::divide:
            return isOne(graph.arguments(n)[1]);
        case Op::power:
            return graph.op(graph.arguments(n)[1]) == Op::constant;
        default:
            return isOne(n);
        }
    });
}

// d/dt along the motion, of each.
std::vector<Node> ratesOf(Graph& graph, std::span<const Node> nodes,
                          std::span<const Moving> moving) {
    std::vector<Node> symbols, rates;
    std::ranges::transform(moving, std::back_inserter(symbols), &Moving::symbol);
    for (const auto& partials : expression::gradients(graph, nodes, symbols)) {
        Node sum = graph.constant(0);
        for (const expression::Partial& partial : partials)
            sum = graph.add(sum, graph.multiply(partial.derivative, moving[partial.symbol].rate));
        rates.push_back(sum);
    }
    return rates;
}

} // namespace

bool canPeak(const Graph& graph, std::span<const Node> outputs, std::span<const Node> constants,
             std::span<const Node> attitudes, std::span<const double> values) {
    const std::vector<Node> reached = expression::reachable(graph, outputs);
    std::vector<Interval> ranges;
    if (!values.empty())
        ranges = rangesOf(graph, reached, constants, values);
    const auto peaking = peakingNodes(graph, reached, readsOnly(graph, reached, {constants}),
                                      readsOnly(graph, reached, {constants, attitudes}));
    return std::ranges::any_of(peaking, [&](Node node) {
        return graph.op(node) != Op::divide || ranges.empty() ||
               !isMild(ranges[graph.arguments(node)[1].index]);
    });
}

Peaks peaksOf(Graph& graph, std::span<const Node> outputs, std::span<const Node> constants,
              std::span<const Node> attitudes, std::span<const Moving> moving) {
    const std::vector<Node> reached = expression::reachable(graph, outputs);
    const std::vector<bool> isNumber = readsOnly(graph, reached, {constants});
    Peaks peaks;
    std::map<Node, double> ratios; // of causes
    const auto add = [&](Node value, double ratio) {
        const auto [known, isNew] = ratios.emplace(value, ratio);
        if (!isNew)
            known->second = std::min(known->second, ratio);
    };
    for (const Node node :
         peakingNodes(graph, reached, isNumber, readsOnly(graph, reached, {constants, attitudes})))
        for (const Node cause : causesOf(graph, node)) {
            if (isNumber[cause.index])
                continue;
            peaks.heights.push_back(node);
            const bool isBase = graph.op(node) == Op::power && cause == graph.arguments(node)[0];
            const Power power = withoutPowers(graph, isBase ? node : cause, isNumber);
            if (graph.op(node) == Op::divide || (isBase && power.base != node)) {
                add(power.base, std::pow(seenPeak, 1 / power.exponent));
            } else {
                add(cause, 0);
                if (power.exponent > 2) // whose rate is 0 more than once there
                    add(power.base, infinity);
            }
        }
    makeUnique(peaks.heights);
    std::vector<Node> values;
    values.reserve(ratios.size());
    for (const auto& [value, ratio] : ratios)
        values.push_back(value);
    peaks.arePolynomials = arePolynomials(graph, values, isNumber);
    const std::vector<Node> rates = ratesOf(graph, values, moving);
    for (std::size_t k = 0; k < values.size(); ++k)
        peaks.causes.push_back({values[k], rates[k], ratios.at(values[k])});
    return peaks;
}

} // namespace solution
