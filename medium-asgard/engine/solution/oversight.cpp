#include "solution/oversight.h"

#include "expression/operation.h"

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

bool canPeak(const Graph& graph, std::span<const Node> outputs, std::span<const Node> constants,
             std::span<const Node> attitudes) {
    const auto readsOnly = [&graph](Node node, std::span<const Node> known,
                                    std::span<const Node> alsoKnown) {
        return std::ranges::all_of(
            expression::symbolsOf(graph, std::span(&node, 1)), [&](Node symbol) {
                return std::ranges::find(known, symbol) != known.end() ||
                       std::ranges::find(alsoKnown, symbol) != alsoKnown.end();
            });
    };
    return std::ranges::any_of(expression::reachable(graph, outputs), [&](Node node) {
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
        case Op::divide:
            return !readsOnly(graph.arguments(node)[1], constants, attitudes);
        case Op::power: {
            const Node exponent = graph.arguments(node)[1];
            const bool isMild = graph.op(exponent) == Op::constant && graph.value(exponent) >= 0 &&
                                graph.value(exponent) <= 4;
            return !isMild && !readsOnly(node, constants, {});
        }
        default:
            return false;
        }
    });
}

} // namespace solution
