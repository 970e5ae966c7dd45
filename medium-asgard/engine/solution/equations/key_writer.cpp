#include "equations/key_writer.h"

#include "expression/operation.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace solution {

using expression::Node;
using expression::Op;
using Operand = KeyWriter::Operand;

namespace {

// The rest of an operation with a 0 in the place of an unknown: numbers beside it meet and fold.
std::optional<Operand> shortened(Op op, const std::array<Operand, 3>& a) {
    if (op == Op::add && (a[0].is(0) || a[1].is(0)))
        return a[a[0].is(0) ? 1 : 0];
    if (op == Op::subtract && a[1].is(0))
        return a[0];
    if (op == Op::multiply && (a[0].is(0) || a[1].is(0)))
        return KeyWriter::number(0);
    if (op == Op::multiply && (a[0].is(1) || a[1].is(1)))
        return a[a[0].is(1) ? 1 : 0];
    return std::nullopt;
}

} // namespace

// Arguments first, on an own stack: expressions may be deep.
KeyWriter::Operand KeyWriter::operandOf(Node root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
        const Node n = stack_.back();
        if (done_.find(n.index)) {
            stack_.pop_back();
            continue;
        }
        const std::size_t size = stack_.size();
        if (!zero_.isZero(n))
            for (const Node argument : graph_.arguments(n))
                if (!done_.find(argument.index))
                    stack_.push_back(argument);
        if (stack_.size() > size)
            continue;
        stack_.pop_back();
        done_.insert(n.index, zero_.isZero(n) ? number(0) : made(n));
    }
    return *done_.find(root.index);
}

KeyWriter::Operand KeyWriter::made(Node n) {
    const Op op = graph_.op(n);
    if (op == Op::constant)
        return number(graph_.value(n));
    if (op == Op::symbol)
        return symbolOf_(n);
    if (op == Op::parameter) {
        constants_.push_back(graph_.value(n));
        return leaf(key::constant);
    }
    std::array<Operand, 3> a;
    const auto arguments = graph_.arguments(n);
    for (std::size_t k = 0; k < arguments.size(); ++k)
        a[k] = *done_.find(arguments[k].index);
    return apply(op, a, arguments.size());
}

KeyWriter::Operand KeyWriter::apply(Op op, const std::array<Operand, 3>& a, std::size_t count) {
    if (std::ranges::all_of(std::span(a).first(count), &Operand::isNumber)) {
        const double value = expression::compute(op, a[0].number, a[1].number, a[2].number);
        if (std::isfinite(value))
            return number(value);
    }
    if (const auto shorter = shortened(op, a))
        return *shorter;
    std::array<std::uint32_t, 3> entries{};
    for (std::size_t k = 0; k < count; ++k)
        entries[k] =
            op == Op::power && k == 1 && a[k].isNumber ? literal(a[k].number) : entryOf(a[k]);
    key_.push_back(static_cast<std::uint32_t>(op));
    key_.insert(key_.end(), entries.begin(), entries.begin() + static_cast<long>(count));
    return {false, 0, entries_++};
}

KeyWriter::Operand KeyWriter::leaf(std::uint32_t kind, std::optional<std::uint32_t> which) {
    key_.push_back(kind);
    if (which)
        key_.push_back(*which);
    return {false, 0, entries_++};
}

std::uint32_t KeyWriter::literal(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    key_.insert(key_.end(),
                {static_cast<std::uint32_t>(Op::constant), static_cast<std::uint32_t>(bits),
                 static_cast<std::uint32_t>(bits >> 32)});
    return entries_++;
}

std::uint32_t KeyWriter::entryOf(const Operand& operand) {
    if (!operand.isNumber)
        return operand.entry;
    const double value = operand.number;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (const auto* known = numbers_.find(bits))
        return *known;
    std::uint32_t entry = 0;
    if (value == 0 || std::abs(value) == 1) {
        entry = literal(value);
    } else {
        constants_.push_back(value);
        entry = leaf(key::constant).entry;
    }
    numbers_.insert(bits, entry);
    return entry;
}

} // namespace solution
