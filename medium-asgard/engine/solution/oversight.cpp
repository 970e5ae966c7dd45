#include "solution/oversight.h"

#include "expression/operation.h"
#include "solution/polynomial.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

namespace {

constexpr double leastLength = 1; // of time, that a step may have in any case
// Of time since the start: before, steps grow from next to nothing, and see what there is.
constexpr double unwatched = 1.0 / 64;
constexpr double firstPart = 1.0 / 16;

} // namespace

// One in the middle half of each cell, by multiples of the golden ratio: what recurs in time cannot
// hide between them. Cells grow by the same ratio.
std::vector<double> WatchedTimes::between(double from, double to) const {
    constexpr double golden = 0.618033988749895;
    const double growth = std::log1p(1 / perTime);
    const double high = to - start_;
    const double low = std::max({from - start_, firstPart * high, unwatched});
    std::vector<double> found;
    if (!(high > low) || !std::isfinite(high))
        return found;
    for (double cell = std::floor(std::log(low) / growth);; ++cell) {
        const double turns = golden * cell;
        const double elapsed = std::exp(growth * (cell + 0.25 + 0.5 * (turns - std::floor(turns))));
        const double t = start_ + elapsed;
        if (!(elapsed < high) || !(t < to))
            return found;
        if (elapsed > low && t > from)
            found.push_back(t);
    }
}

double WatchedTimes::longest(double t) const { return std::max(t - start_, leastLength); }

double WatchedTimes::longestThatSees(double t) const {
    return std::max(t - start_, leastLength) / perTime;
}

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

bool canPeak(const Graph& graph, std::span<const Node> outputs, std::span<const Node> constants,
             std::span<const Node> attitudes, std::span<const double> values) {
    const std::vector<Node> reached = expression::reachable(graph, outputs);
    std::vector<Interval> ranges;
    if (!values.empty())
        ranges = rangesOf(graph, reached, constants, values);
    const auto readsOnly = [&graph](Node node, std::span<const Node> known,
                                    std::span<const Node> alsoKnown) {
        return std::ranges::all_of(
            expression::symbolsOf(graph, std::span(&node, 1)), [&](Node symbol) {
                return std::ranges::find(known, symbol) != known.end() ||
                       std::ranges::find(alsoKnown, symbol) != alsoKnown.end();
            });
    };
    return std::ranges::any_of(reached, [&](Node node) {
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
            return !readsOnly(node, constants, {});
        case Op::divide: {
            const Node denominator = graph.arguments(node)[1];
            return !readsOnly(denominator, constants, attitudes) &&
                   (ranges.empty() || !isMild(ranges[denominator.index]));
        }
        case Op::power: {
            const Node exponent = graph.arguments(node)[1];
            const bool isLow = graph.op(exponent) == Op::constant && graph.value(exponent) >= 0 &&
                               graph.value(exponent) <= 4;
            return !isLow && !readsOnly(node, constants, {});
        }
        default:
            return false;
        }
    });
}

} // namespace solution
