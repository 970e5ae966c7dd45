#include "solution/component_equations.h"

#include "expression/operation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace solution {

using expression::Decision;
using expression::Node;
using expression::Op;

namespace {

std::vector<std::size_t> inputUnknowns(const expression::EquationSet& set,
                                       const UnknownIndex& index, const ZeroStates& zero,
                                       const std::vector<std::size_t>& own,
                                       std::span<const Node> nodes) {
    std::vector<std::size_t> found;
    for (const Node symbol : zero.symbolsLeft(set.graph, nodes))
        if (const auto unknown = index.of(symbol);
            unknown && !std::binary_search(own.begin(), own.end(), *unknown))
            found.push_back(*unknown);
    std::sort(found.begin(), found.end());
    return found;
}

// The same expression in another graph; arguments first, on an own stack.
Node transplant(expression::Graph& to, const expression::Graph& from, Node root,
                std::unordered_map<std::uint32_t, Node>& done) {
    std::vector<Node> stack{root};
    while (!stack.empty()) {
        const Node n = stack.back();
        const auto arguments = from.arguments(n);
        const std::size_t size = stack.size();
        for (const Node argument : arguments)
            if (!done.contains(argument.index))
                stack.push_back(argument);
        if (stack.size() > size)
            continue;
        stack.pop_back();
        if (done.contains(n.index))
            continue;
        const auto a = [&](std::size_t k) { return done.at(arguments[k].index); };
        const Op op = from.op(n);
        done[n.index] = op == Op::constant      ? to.constant(from.value(n))
                        : op == Op::symbol      ? to.symbol(from.name(n))
                        : arguments.size() == 1 ? to.apply(op, a(0))
                        : arguments.size() == 2 ? to.apply(op, a(0), a(1))
                                                : to.apply(op, a(0), a(1), a(2));
    }
    return done.at(root.index);
}

std::vector<Node> rawNodes(const expression::EquationSet& set,
                           const std::vector<std::size_t>& unknowns,
                           std::span<const std::size_t> phases) {
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const expression::Phase& phase = set.unknowns[unknowns[i]].phases[phases[i]];
        nodes.push_back(phase.given ? *phase.given : phase.derivative);
    }
    return nodes;
}

} // namespace

ComponentEquations::ComponentEquations(const expression::EquationSet& set,
                                       const UnknownIndex& index, const Histories& histories,
                                       const ZeroStates& zero, std::vector<std::size_t> unknowns,
                                       std::span<const std::size_t> phases)
    : set_(set), unknowns_(std::move(unknowns)),
      inputs_(histories,
              inputUnknowns(set, index, zero, unknowns_, rawNodes(set, unknowns_, phases))) {
    orderHeld(zero, phases);
    if (!loop_.empty())
        return;
    makeOutputs(zero, phases);
    makeTape();
    findIntegrals();
}

// Held unknowns after those that they read.
void ComponentEquations::orderHeld(const ZeroStates& zero, std::span<const std::size_t> phases) {
    std::vector<std::size_t> waiting;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
        if (set_.unknowns[unknowns_[i]].phases[phases[i]].given)
            waiting.push_back(i);
        else
            states_.push_back(i);
    while (!waiting.empty()) {
        const auto readsWaiting = [&](std::size_t i) {
            const Node given = *set_.unknowns[unknowns_[i]].phases[phases[i]].given;
            const std::vector<Node> symbols = zero.symbolsLeft(set_.graph, {&given, 1});
            return std::any_of(waiting.begin(), waiting.end(), [&](std::size_t j) {
                return std::find(symbols.begin(), symbols.end(),
                                 set_.unknowns[unknowns_[j]].symbol) != symbols.end();
            });
        };
        const auto ready = std::find_if_not(waiting.begin(), waiting.end(), readsWaiting);
        if (ready == waiting.end()) {
            loop_ = waiting;
            return;
        }
        held_.push_back(*ready);
        waiting.erase(ready);
    }
}

void ComponentEquations::makeOutputs(const ZeroStates& zero, std::span<const std::size_t> phases) {
    const auto phaseOf = [&](std::size_t i) -> const expression::Phase& {
        return set_.unknowns[unknowns_[i]].phases[phases[i]];
    };
    std::unordered_map<std::uint32_t, Node> values, done;
    for (const std::size_t u : zero.unknowns())
        done.emplace(set_.unknowns[u].symbol.index, graph_.constant(0));
    std::vector<Node> heldNodes;
    for (const std::size_t i : held_) {
        const Node given = transplant(graph_, set_.graph, *phaseOf(i).given, done);
        heldNodes.push_back(expression::substitute(graph_, given, values));
        values.emplace(graph_.symbol(set_.graph.name(set_.unknowns[unknowns_[i]].symbol)).index,
                       heldNodes.back());
    }
    for (const std::size_t i : states_) {
        const Node derivative = transplant(graph_, set_.graph, phaseOf(i).derivative, done);
        outputs_.push_back(expression::substitute(graph_, derivative, values));
    }
    outputs_.insert(outputs_.end(), heldNodes.begin(), heldNodes.end());
}

void ComponentEquations::makeTape() {
    const auto own = [this](Node symbol) { return graph_.symbol(set_.graph.name(symbol)); };
    symbols_.push_back(own(set_.time));
    for (const std::size_t i : states_)
        symbols_.push_back(own(set_.unknowns[unknowns_[i]].symbol));
    for (const std::size_t u : inputs_.unknowns())
        symbols_.push_back(own(set_.unknowns[u].symbol));
    surfaces_ = surfacesOf(graph_, outputs_);
    switches_ = switchesOf(graph_, outputs_);
    gradients_.resize(surfaces_.size());
    for (std::size_t s = 0; s < surfaces_.size(); ++s)
        for (std::size_t i = 0; i < states_.size(); ++i)
            if (!surfaces_[s].whole && surfaces_[s].guard == symbols_[1 + i])
                ownGuards_.emplace_back(s, i);
    sides_.assign(surfaces_.size(), onSurface);
    tape_ = expression::Tape(graph_, symbols_, outputs_);
    in_.resize(symbols_.size());
    out_.resize(outputs_.size());
    base_.resize(outputs_.size());
    other_.resize(outputs_.size());
    guards_.resize(tape_.decisions());
    decisions_.resize(tape_.decisions());
}

void ComponentEquations::findIntegrals() {
    for (std::size_t x = 0; x < states_.size(); ++x)
        for (std::size_t v = 0; v < states_.size(); ++v)
            if (outputs_[x] == symbols_[1 + v])
                integrals_.emplace_back(x, v);
    findConfiguration();
    const std::vector<Node> read = expression::symbolsOf(graph_, outputs_);
    readsStates_ = std::any_of(read.begin(), read.end(), [&](Node n) {
        return std::find(symbols_.begin() + 1,
                         symbols_.begin() + 1 + static_cast<std::ptrdiff_t>(states_.size()),
                         n) != symbols_.begin() + 1 + static_cast<std::ptrdiff_t>(states_.size());
    });
}

// Known by what they are, since a velocity may be solved in another component.
void ComponentEquations::findConfiguration() {
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (set_.unknowns[unknowns_[states_[i]]].lengthPerUnit > 0)
            configuration_.push_back(i);
}

void ComponentEquations::fill(double t, std::span<const double> y) {
    in_[0] = t;
    std::copy(y.begin(), y.end(), in_.begin() + 1);
    inputs_.values(t, std::span(in_).subspan(1 + states_.size()));
}

// A state that lies on a surface of its own is moved off it, to its side, by next to nothing: what
// is written v/abs(v) is then the sign that it means.
void ComponentEquations::evaluate(std::span<double> out) {
    constexpr double nextToNothing = 1e-150; // its square is still a number
    if (decisions_.empty()) {
        tape_.evaluate(in_, out, scratch_);
        return;
    }
    for (const auto& [surface, state] : ownGuards_)
        if (in_[1 + state] == 0)
            in_[1 + state] = sides_[surface] * nextToNothing;
    tape_.evaluate(in_, out, scratch_, decisions_, {});
    for (const auto& [surface, state] : ownGuards_)
        if (std::abs(in_[1 + state]) == nextToNothing)
            in_[1 + state] = 0;
}

bool ComponentEquations::rates(double t, std::span<const double> y, std::span<double> out) {
    fill(t, y);
    slidingFailed_ = !sliding_.empty() && !weigh();
    if (slidingFailed_)
        return false;
    if (sliding_.empty())
        evaluate(out_);
    std::copy_n(out_.begin(), states_.size(), out.begin());
    return std::all_of(out_.begin(), out_.end(), [](double x) { return std::isfinite(x); });
}

bool ComponentEquations::heldValues(double t, std::span<const double> y, std::span<double> out) {
    fill(t, y);
    evaluate(out_);
    std::copy(out_.begin() + static_cast<std::ptrdiff_t>(states_.size()), out_.end(), out.begin());
    return std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); });
}

std::vector<std::size_t> ComponentEquations::notFinite(double t, std::span<const double> y) {
    fill(t, y);
    evaluate(out_);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < out_.size(); ++i)
        if (!std::isfinite(out_[i]))
            found.push_back(i < states_.size() ? states_[i] : held_[i - states_.size()]);
    std::sort(found.begin(), found.end());
    return found;
}

std::optional<Decision> ComponentEquations::decisionOf(Node switching) const {
    const auto at = std::lower_bound(switches_.begin(), switches_.end(), switching);
    if (at == switches_.end() || *at != switching)
        return std::nullopt;
    return decisions_[static_cast<std::size_t>(at - switches_.begin())];
}

std::optional<std::size_t> ComponentEquations::inputOf(Node symbol) const {
    const auto first = symbols_.begin() + 1 + static_cast<std::ptrdiff_t>(states_.size());
    const auto at = std::find(first, symbols_.end(), symbol);
    if (at == symbols_.end())
        return std::nullopt;
    return static_cast<std::size_t>(at - first);
}

} // namespace solution
