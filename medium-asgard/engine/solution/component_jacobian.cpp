// The symbolic Jacobian of a component; see component_equations.h.
#include "solution/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Decision;
using expression::Node;
using expression::Op;

const Pattern& ComponentEquations::jacobianPattern() {
    if (!jacobian_)
        makeJacobian();
    return jacobian_->pattern;
}

void ComponentEquations::makeJacobian() {
    jacobian_ = std::make_unique<Jacobian>();
    expression::Graph graph = graph_;
    std::vector<std::vector<std::pair<int, Node>>> columns(states_.size());
    for (std::size_t row = 0; row < states_.size(); ++row)
        for (const Node symbol : expression::symbolsOf(graph, {&outputs_[row], 1}))
            for (std::size_t column = 0; column < states_.size(); ++column)
                if (symbols_[1 + column] == symbol) {
                    const Node d = expression::differentiate(graph, outputs_[row], symbol);
                    if (!graph.isConstant(d, 0))
                        columns[column].emplace_back(static_cast<int>(row), d);
                }
    Pattern& pattern = jacobian_->pattern;
    std::vector<Node> entries;
    pattern.columnStarts.push_back(0);
    for (const auto& column : columns) {
        for (const auto& [row, node] : column) {
            pattern.rows.push_back(row);
            entries.push_back(node);
        }
        pattern.columnStarts.push_back(static_cast<int>(pattern.rows.size()));
    }
    jacobian_->entries = derive(graph, entries);
}

// Its own switches are ours, or stand on the same surfaces as ours.
ComponentEquations::Derived ComponentEquations::derive(expression::Graph& graph,
                                                       std::span<const Node> nodes) {
    Derived derived;
    derived.tape = expression::Tape(graph, symbols_, nodes);
    for (const Node switching : switchesOf(graph, nodes)) {
        Derived::Source source;
        const auto same = std::lower_bound(switches_.begin(), switches_.end(), switching);
        const Op op = graph.op(switching);
        if (same != switches_.end() && *same == switching) {
            source.decision = static_cast<std::size_t>(same - switches_.begin());
        } else if (op != Op::floor && op != Op::ceil) {
            const Guard guard = guardOf(graph, switching);
            source.orientation = guard.orientation;
            for (std::size_t s = 0; s < surfaces_.size(); ++s)
                if (!surfaces_[s].whole && surfaces_[s].guard == guard.node)
                    source.surface = s;
        }
        derived.sources.push_back(source);
    }
    derived.decisions.resize(derived.sources.size());
    return derived;
}

void ComponentEquations::evaluate(Derived& derived, std::span<double> out) const {
    for (std::size_t i = 0; i < derived.sources.size(); ++i) {
        const Derived::Source& source = derived.sources[i];
        derived.decisions[i] = source.decision ? decisions_[*source.decision]
                               : source.surface
                                   ? Decision{sides_[*source.surface]} * source.orientation
                                   : expression::noBranch;
    }
    derived.tape.evaluate(in_, out, derived.scratch, derived.decisions, {});
}

bool ComponentEquations::jacobian(double t, std::span<const double> y, std::span<double> entries) {
    if (!jacobian_)
        makeJacobian();
    if (!sliding_.empty())
        return differences(t, y, entries);
    fill(t, y);
    evaluate(jacobian_->entries, entries);
    return std::all_of(entries.begin(), entries.end(), [](double x) { return std::isfinite(x); });
}

// While sliding f is a mixture whose weights depend on y too; few unknowns slide, so differences
// do.
bool ComponentEquations::differences(double t, std::span<const double> y,
                                     std::span<double> entries) {
    std::vector<double> at(y.begin(), y.end()), low(states_.size()), high(states_.size());
    const Pattern& pattern = jacobian_->pattern;
    for (std::size_t column = 0; column < states_.size(); ++column) {
        const double step = 6e-6 * std::max(1e-3, std::abs(y[column]));
        at[column] = y[column] + step;
        if (!rates(t, at, high))
            return false;
        at[column] = y[column] - step;
        if (!rates(t, at, low))
            return false;
        at[column] = y[column];
        for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k) {
            const auto row = static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(k)]);
            entries[static_cast<std::size_t>(k)] = (high[row] - low[row]) / (2 * step);
        }
    }
    return true;
}

} // namespace solution
