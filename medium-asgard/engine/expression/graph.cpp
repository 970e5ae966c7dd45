#include "expression/graph.h"

#include "expression/operation.h"
#include "expression/simplify.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace expression {
namespace {

std::size_t mixed(std::size_t hash, std::size_t value) {
    hash ^= value + 0x9e3779b97f4a7c15u + (hash << 6) + (hash >> 2);
    return hash * 0xbf58476d1ce4e5b9u;
}

} // namespace

Graph::Graph() = default;

std::size_t Graph::hashOf(const Entry& entry) {
    std::size_t hash = static_cast<std::size_t>(entry.op);
    for (std::uint8_t i = 0; i < entry.count; ++i)
        hash = mixed(hash, entry.arguments[i].index);
    if (entry.op == Op::constant)
        hash = mixed(hash, std::bit_cast<std::uint64_t>(entry.value));
    if (entry.op == Op::symbol)
        hash = mixed(hash, entry.name);
    return hash ^ hash >> 32;
}

bool Graph::isSame(const Entry& a, const Entry& b) {
    return a.op == b.op && a.count == b.count && a.name == b.name &&
           std::equal(a.arguments, a.arguments + a.count, b.arguments) &&
           std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

std::optional<Node> Graph::find(const Entry& entry, std::size_t hash) const {
    if (table_.empty())
        return std::nullopt;
    const std::size_t mask = table_.size() - 1;
    for (std::size_t i = hash & mask; table_[i] != free; i = (i + 1) & mask)
        if (isSame(entries_[table_[i]], entry))
            return Node{table_[i]};
    return std::nullopt;
}

void Graph::enter(std::uint32_t index, std::size_t hash) {
    const auto place = [this](std::uint32_t entry, std::size_t at) {
        const std::size_t mask = table_.size() - 1;
        for (at &= mask; table_[at] != free;)
            at = (at + 1) & mask;
        table_[at] = entry;
    };
    if (2 * entries_.size() > table_.size()) {
        table_.assign(std::max<std::size_t>(64, 2 * table_.size()), free);
        for (std::uint32_t i = 0; i < index; ++i)
            place(i, hashOf(entries_[i]));
    }
    place(index, hash);
}

Node Graph::intern(const Entry& entry) {
    const std::size_t hash = hashOf(entry);
    if (const auto found = find(entry, hash))
        return *found;
    if (isCommutative(entry.op)) { // keep the order in which it was first written
        Entry swapped = entry;
        std::swap(swapped.arguments[0], swapped.arguments[1]);
        if (const auto found = find(swapped, hashOf(swapped)))
            return *found;
    }
    const auto index = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back(entry);
    enter(index, hash);
    return Node{index};
}

// What is not finite is kept as the quotient that makes it, so that it prints and parses.
Node Graph::constant(double value) {
    if (!std::isfinite(value)) {
        const double numerator = std::isnan(value) ? 0 : value > 0 ? 1 : -1;
        return intern(makeEntry(Op::divide, constant(numerator), constant(0)));
    }
    Entry entry;
    entry.op = Op::constant;
    entry.value = value;
    return intern(entry);
}

Node Graph::symbol(std::string_view name) {
    const auto [it, isNew] = symbols_.try_emplace(std::string(name));
    if (isNew) {
        Entry entry;
        entry.op = Op::symbol;
        entry.name = static_cast<std::uint32_t>(names_.size());
        names_.emplace_back(name);
        it->second = intern(entry);
    }
    return it->second;
}

Graph::Entry Graph::makeEntry(Op op, Node a, Node b, Node c) {
    Entry entry;
    entry.op = op;
    entry.count = static_cast<std::uint8_t>(argumentCount(op));
    const Node arguments[3] = {a, b, c};
    std::copy(arguments, arguments + entry.count, entry.arguments);
    return entry;
}

Node Graph::make(Op op, Node a, Node b, Node c) {
    const Entry entry = makeEntry(op, a, b, c);
    const std::span<const Node> arguments(entry.arguments, entry.count);
    const auto shorter = simplified(*this, op, arguments);
    return shorter ? *shorter : intern(entry);
}

Node Graph::apply(Op op, Node a) {
    assert(argumentCount(op) == 1);
    return make(op, a, {}, {});
}

Node Graph::apply(Op op, Node a, Node b) {
    assert(argumentCount(op) == 2);
    return make(op, a, b, {});
}

Node Graph::apply(Op op, Node a, Node b, Node c) {
    assert(argumentCount(op) == 3);
    return make(op, a, b, c);
}

std::span<const Node> Graph::arguments(Node n) const {
    const Entry& entry = entries_[n.index];
    return {entry.arguments, entry.count};
}

const std::string& Graph::name(Node symbol) const { return names_[entries_[symbol.index].name]; }

bool Graph::isConstant(Node n, double value) const {
    const Entry& entry = entries_[n.index];
    return entry.op == Op::constant && entry.value == value;
}

} // namespace expression
