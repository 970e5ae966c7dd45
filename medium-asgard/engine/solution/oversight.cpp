#include "solution/oversight.h"

#include "expression/operation.h"
#include "solution/directions.h"
#include "solution/polynomial.h"
#include "solution/switching.h"

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

constexpr double leastLength = 1; // of time: limits on steps grow from that of so much
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
// As many times as at a step's ends something may be within it, and be seen by its stages.
constexpr double seen = 16;

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
                add(power.base, std::pow(seen, 1 / power.exponent));
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

namespace {

// What a few values at even distances say of what lies between them, by parabolas.
struct Course {
    explicit Course(std::span<const double> values) {
        const auto [least, most] = std::ranges::minmax(values);
        double bend = 0;
        for (std::size_t i = 2; i < values.size(); ++i)
            bend = std::max(bend, std::abs(values[i] - 2 * values[i - 1] + values[i - 2]));
        const double low = least > 0 ? least : most < 0 ? -most : 0;
        change = most - least + 0.25 * bend;
        high = std::max(most, -least);
        // Twice what a parabola passes below the lowest of them.
        lowest = std::max(low - 0.25 * bend, 0.0);
        staysAway = lowest > 1e-3 * high;
    }
    double change, lowest, high; // of the size
    bool staysAway;              // from 0
};

// Of causes and rates, those that may be 0 somewhere.
std::vector<std::size_t> suspects(const std::vector<double>& ratios, bool arePolynomials,
                                  const std::function<void(double, std::span<double>)>& evaluate,
                                  double from, double to) {
    const std::size_t causes = ratios.size(), count = arePolynomials ? 3 : 9;
    std::array<std::vector<double>, 9> samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(count - 1);
        samples[i].resize(2 * causes);
        evaluate(i + 1 == count ? to : from + s * (to - from), samples[i]);
    }
    const auto course = [&](std::size_t k) {
        std::array<double, 9> values{};
        for (std::size_t i = 0; i < count; ++i)
            values[i] = samples[i][k];
        return Course(std::span(values).first(count));
    };
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < causes; ++k) {
        const Course value = course(k), rate = course(causes + k);
        if (!value.staysAway)
            found.push_back(k);
        const bool isSeen =
            ratios[k] > 0 ? value.high <= ratios[k] * value.lowest : value.change <= std::log(seen);
        if (!rate.staysAway && !isSeen)
            found.push_back(causes + k);
    }
    return found;
}

} // namespace

namespace {

using Evaluate = std::function<void(double, std::span<double>)>;

// Times in (from, to) at which one of `watched` changes its sign, by which one.
std::vector<std::pair<double, std::size_t>> signChanges(const std::vector<std::size_t>& watched,
                                                        std::size_t count, const Evaluate& evaluate,
                                                        double from, double to) {
    constexpr std::size_t most = 64;
    std::vector<std::pair<double, std::size_t>> found;
    if (watched.empty())
        return found;
    std::vector<double> all(count), sides(watched.size());
    evaluate(from, all);
    for (std::size_t k = 0; k < watched.size(); ++k)
        sides[k] = all[watched[k]] < 0 ? -1 : 1;
    const auto besideSides = [&](double t, std::span<double> values) {
        evaluate(t, all);
        for (std::size_t k = 0; k < watched.size(); ++k)
            values[k] = sides[k] * all[watched[k]];
    };
    for (std::size_t i = 0; i < most + watched.size(); ++i) {
        const auto next = firstViolation(watched.size(), besideSides, from, to, Care::some);
        if (!next || next->time >= to)
            return found;
        for (const std::size_t k : next->watches) {
            sides[k] = -sides[k];
            if (next->time > from)
                found.emplace_back(next->time, watched[k]);
        }
        from = next->time;
    }
    return found;
}

// Of what is monotone from `low` to `high`, to the last bit; none where its sign is the same there.
std::optional<double> root(std::size_t k, std::size_t count, const Evaluate& evaluate, double low,
                           double high) {
    std::vector<double> all(count);
    const auto isNegative = [&](double t) {
        evaluate(t, all);
        return all[k] < 0;
    };
    const bool side = isNegative(low);
    if (isNegative(high) == side)
        return std::nullopt;
    for (;;) {
        const double middle = std::midpoint(low, high);
        if (middle <= low || middle >= high)
            return high;
        (isNegative(middle) == side ? low : high) = middle;
    }
}

} // namespace

// Between the roots of its rate a cause has one root at most. Where it touches 0 there, as squares
// do, it would be looked for in vain.
std::vector<double> centresPassed(const std::vector<double>& ratios, bool arePolynomials,
                                  const Evaluate& evaluate, double from, double to) {
    std::vector<std::size_t> values, rates;
    for (const std::size_t k : suspects(ratios, arePolynomials, evaluate, from, to))
        (k < ratios.size() ? values : rates).push_back(k);
    const auto turns = signChanges(rates, 2 * ratios.size(), evaluate, from, to);
    std::vector<double> found;
    found.reserve(turns.size());
    for (const auto& [time, rate] : turns)
        found.push_back(time);
    for (const std::size_t k : values) {
        double low = from;
        const auto take = [&](double high) {
            const auto time = root(k, 2 * ratios.size(), evaluate, low, high);
            if (time && *time > from && *time < to)
                found.push_back(*time);
            low = high;
        };
        for (const auto& [time, rate] : turns)
            if (rate == k + ratios.size())
                take(time);
        take(to);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace solution
