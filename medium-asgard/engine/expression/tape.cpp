#include "expression/tape.h"

#include "expression/node_map.h"
#include "expression/operation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace expression {

double guardOf(Op op, double a, double b, Decision taken) {
    if (taken == noBranch)
        return 1; // never reaches 0
    const auto branch = static_cast<double>(taken);
    switch (op) {
    case Op::abs:
    case Op::sign:
        return a;
    case Op::floor:
        return std::min(a - branch, branch + 1 - a);
    case Op::ceil:
        return std::min(branch - a, a - (branch - 1));
    default:
        return a - b;
    }
}

namespace {

Decision signOfGuard(double guard) {
    return std::isnan(guard) ? noBranch : (guard > 0) - (guard < 0);
}

// Compares before subtracting: a - b of equal infinities is no number, and they are equal.
Decision decisionOf(Op op, double a, double b) {
    if (op == Op::abs || op == Op::sign)
        return signOfGuard(a);
    if (op != Op::floor && op != Op::ceil)
        return std::isnan(a) || std::isnan(b) ? noBranch : (a > b) - (a < b);
    const double whole = compute(op, a);
    constexpr double largest = 9e18;
    return std::abs(whole) < largest ? static_cast<Decision>(whole) : noBranch;
}

// Where there is no number there is no sign to copy: two evaluators may differ in it.
double zeroLike(double a) { return std::isnan(a) ? 0.0 : std::copysign(0.0, a); }

} // namespace

// The value on a branch that may not be the one that the values imply.
double onBranch(Op op, double a, double b, Decision taken) {
    if (taken == noBranch)
        return compute(op, a, b);
    switch (op) {
    case Op::abs:
        return taken > 0 ? a : taken < 0 ? -a : std::abs(a);
    case Op::floor:
    case Op::ceil:
        return taken == 0 ? zeroLike(a) : static_cast<double>(taken);
    case Op::sign:
        return static_cast<double>(taken);
    case Op::min:
        return taken == 0 ? compute(op, a, b) : taken < 0 ? a : b;
    case Op::max:
        return taken == 0 ? compute(op, a, b) : taken > 0 ? a : b;
    case Op::less:
        return taken < 0;
    case Op::lessEqual:
        return taken <= 0;
    case Op::equal:
        return taken == 0;
    default:
        return taken != 0;
    }
}

std::size_t Sequence::hash() const {
    std::uint64_t hash = inputs + (std::uint64_t{constants} << 32);
    const auto mix = [&hash](std::uint64_t a, std::uint64_t b) {
        hash = (hash ^ a) * 0x9e3779b97f4a7c15u + b;
        hash ^= hash >> 29;
    };
    for (const Instruction& i : instructions)
        mix((std::uint64_t{i.a} << 32) + i.b, (std::uint64_t{i.c} << 8) + std::uint64_t(i.op));
    for (const std::uint32_t slot : outputs)
        mix(slot, 1);
    return hash;
}

Tape::Tape(const Graph& graph, std::span<const Node> inputs, std::span<const Node> outputs) {
    sequence_.inputs = static_cast<std::uint32_t>(inputs.size());
    NodeMap<std::uint32_t> slotOf;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        slotOf.insert(inputs[i], static_cast<std::uint32_t>(i));
    const std::vector<Node> nodes = reachable(graph, outputs);
    constants_.push_back(1); // of short powers
    for (const Node n : nodes)
        if (graph.op(n) == Op::constant || graph.op(n) == Op::parameter) {
            slotOf.insert(n, static_cast<std::uint32_t>(sequence_.inputs + constants_.size()));
            constants_.push_back(graph.value(n));
        }
    sequence_.constants = static_cast<std::uint32_t>(constants_.size());
    for (const Node n : nodes) {
        if (slotOf.find(n))
            continue;
        assert(graph.op(n) != Op::symbol && "every symbol that is read must be an input");
        const auto a = graph.arguments(n);
        const auto slot = [&](std::size_t i) { return i < a.size() ? *slotOf.find(a[i]) : 0; };
        const bool isShort = graph.op(n) == Op::power && graph.op(a[1]) == Op::constant &&
                             isShortPower(graph.value(a[1]));
        slotOf.insert(n, isShort ? emitShortPower(slot(0), graph.value(a[1]))
                                 : emit(graph.op(n), slot(0), slot(1), slot(2)));
    }
    std::ranges::transform(outputs, std::back_inserter(sequence_.outputs),
                           [&](Node n) { return *slotOf.find(n); });
}

std::uint32_t Tape::emit(Op op, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::int32_t decision =
        isSwitch(op) ? static_cast<std::int32_t>(sequence_.decisions++) : -1;
    const std::uint32_t result = sequence_.slots();
    sequence_.instructions.push_back({op, result, a, b, c, decision});
    return result;
}

// The products and the root that powerOf() computes, in its order: the same bits.
std::uint32_t Tape::emitShortPower(std::uint32_t base, double exponent) {
    const double size = std::abs(exponent);
    const int whole = static_cast<int>(size);
    std::uint32_t result = base;
    if (whole >= 2)
        result = emit(Op::multiply, base, base);
    if (whole >= 3)
        result = emit(Op::multiply, result, whole == 3 ? base : result);
    if (whole != size) {
        const std::uint32_t root = emit(Op::sqrt, base);
        result = whole == 0 ? root : emit(Op::multiply, result, root);
    }
    return exponent < 0 ? emit(Op::divide, sequence_.inputs, result) : result;
}

template <class Switch>
void Tape::run(std::span<const double> in, Scratch& scratch, const Switch& atSwitch) const {
    assert(in.size() == inputs());
    if (scratch.size() < sequence_.slots())
        scratch.resize(sequence_.slots());
    std::ranges::copy(in, scratch.begin());
    std::ranges::copy(constants_, scratch.begin() + static_cast<std::ptrdiff_t>(inputs()));
    double* const s = scratch.data();
    for (const Instruction& i : sequence_.instructions) {
        switch (i.op) {
        case Op::negate:
            s[i.result] = -s[i.a];
            break;
        case Op::add:
            s[i.result] = s[i.a] + s[i.b];
            break;
        case Op::subtract:
            s[i.result] = s[i.a] - s[i.b];
            break;
        case Op::multiply:
            s[i.result] = s[i.a] * s[i.b];
            break;
        case Op::divide:
            s[i.result] = s[i.a] / s[i.b];
            break;
        default:
            s[i.result] = i.decision < 0 ? compute(i.op, s[i.a], s[i.b], s[i.c])
                                         : atSwitch(i, s[i.a], s[i.b]);
        }
    }
}

void Tape::copyOutputs(const Scratch& scratch, std::span<double> out) const {
    assert(out.size() == sequence_.outputs.size());
    std::ranges::transform(sequence_.outputs, out.begin(),
                           [&](std::uint32_t s) { return scratch[s]; });
}

void Tape::evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch) const {
    run(in, scratch, [](const Instruction& i, double a, double b) { return compute(i.op, a, b); });
    copyOutputs(scratch, out);
}

void Tape::evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch,
                    std::span<const Decision> decisions, std::span<double> guards) const {
    assert(decisions.size() == this->decisions() &&
           (guards.empty() || guards.size() == this->decisions()));
    run(in, scratch, [&](const Instruction& i, double a, double b) {
        const auto index = static_cast<std::size_t>(i.decision);
        if (!guards.empty())
            guards[index] = guardOf(i.op, a, b, decisions[index]);
        return onBranch(i.op, a, b, decisions[index]);
    });
    copyOutputs(scratch, out);
}

void Tape::decide(std::span<const double> in, std::span<Decision> decisions,
                  std::span<double> guards, Scratch& scratch) const {
    assert(decisions.size() == this->decisions() &&
           (guards.empty() || guards.size() == this->decisions()));
    run(in, scratch, [&](const Instruction& i, double a, double b) {
        const auto index = static_cast<std::size_t>(i.decision);
        decisions[index] = decisionOf(i.op, a, b);
        if (!guards.empty())
            guards[index] = guardOf(i.op, a, b, decisions[index]);
        return compute(i.op, a, b);
    });
}

std::string Tape::print() const {
    const auto named = [this](std::uint32_t slot) {
        if (slot < inputs())
            return "in" + std::to_string(slot);
        if (slot < inputs() + constants_.size()) {
            Graph graph;
            return expression::print(graph, graph.constant(constants_[slot - inputs()]));
        }
        return "r" + std::to_string(slot - inputs() - constants_.size());
    };
    std::string text;
    for (const Instruction& i : sequence_.instructions) {
        text += named(i.result) + " = " + std::string(nameOf(i.op)) + ' ' + named(i.a);
        if (argumentCount(i.op) > 1)
            text += ' ' + named(i.b);
        if (argumentCount(i.op) > 2)
            text += ' ' + named(i.c);
        text += i.decision < 0 ? "\n" : "  [decision " + std::to_string(i.decision) + "]\n";
    }
    for (std::size_t i = 0; i < sequence_.outputs.size(); ++i)
        text += "out" + std::to_string(i) + " = " + named(sequence_.outputs[i]) + '\n';
    return text;
}

} // namespace expression
