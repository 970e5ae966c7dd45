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

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
    return hash ^ (hash >> 32);
}

} // namespace

Graph::Graph() = default;

Graph::Entries& Graph::Entries::operator=(const Entries& other) {
    if (this == &other)
        return *this;
    blocks_.clear();
    blocks_.reserve(other.blocks_.size());
    for (const auto& entries : other.blocks_)
        blocks_.push_back(std::make_unique<std::array<Entry, block>>(*entries));
    size_ = other.size_;
    return *this;
}

void Graph::Entries::add(const Entry& entry) {
    if (size_ % block == 0)
        blocks_.push_back(std::make_unique<std::array<Entry, block>>());
    (*blocks_.back())[size_ % block] = entry;
    ++size_;
}

// The same for both orders of arguments that may be swapped.
std::uint32_t Graph::hashOf(const Entry& entry) {
    auto hash = static_cast<std::uint64_t>(entry.op);
    std::uint64_t a = entry.arguments[0].index, b = entry.arguments[1].index;
    if (isCommutative(entry.op) && b < a)
        std::swap(a, b);
    hash = mixed(hash, a + (b << 32));
    if (entry.count == 3)
        hash = mixed(hash, entry.arguments[2].index);
    if (entry.op == Op::constant || entry.op == Op::parameter)
        hash = mixed(hash, std::bit_cast<std::uint64_t>(entry.value));
    return static_cast<std::uint32_t>(hash ^ (hash >> 29));
}

bool Graph::isSame(const Entry& a, const Entry& b) {
    if (a.op != b.op ||
        std::bit_cast<std::uint64_t>(a.value) != std::bit_cast<std::uint64_t>(b.value))
        return false;
    return a.arguments == b.arguments || (isCommutative(a.op) && a.arguments[0] == b.arguments[1] &&
                                          a.arguments[1] == b.arguments[0]);
}

// The order of arguments is that in which a node was first written.
Node Graph::intern(const Entry& entry) {
    if (2 * (entries_.size() + 1) > table_.size())
        growTable();
    const std::uint32_t hash = hashOf(entry);
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash & mask;
    for (; table_[at].next != 0; at = (at + 1) & mask)
        if (table_[at].hash == hash && isSame(entries_[table_[at].next - 1], entry))
            return Node{table_[at].next - 1};
    const auto index = static_cast<std::uint32_t>(entries_.size());
    entries_.add(entry);
    table_[at] = {hash, index + 1};
    return Node{index};
}

void Graph::growTable() {
    std::vector<Place> larger(std::max<std::size_t>(64, 2 * table_.size()));
    const std::size_t mask = larger.size() - 1;
    for (const Place& place : table_) {
        if (place.next == 0)
            continue;
        std::size_t at = place.hash & mask;
        while (larger[at].next != 0)
            at = (at + 1) & mask;
        larger[at] = place;
    }
    table_ = std::move(larger);
}

// What is not finite is kept as the quotient that makes it, so that it prints and parses.
Node Graph::constant(double value) {
    if (!std::isfinite(value)) {
        const double numerator = std::isnan(value) ? 0 : value > 0 ? 1 : -1;
        return intern(makeEntry(Op::divide, constant(numerator), constant(0), {}));
    }
    Entry entry;
    entry.op = Op::constant;
    entry.value = value;
    return intern(entry);
}

Node Graph::parameter(double value, Node owner, std::uint32_t place) {
    Entry entry;
    entry.op = Op::parameter;
    entry.arguments = {owner, Node{place}, {}};
    entry.value = value;
    return intern(entry);
}

Node Graph::symbol(std::string_view name) {
    const auto [it, isNew] = symbols_.try_emplace(std::string(name));
    if (isNew) {
        Entry entry;
        entry.op = Op::symbol;
        entry.arguments[0].index = static_cast<std::uint32_t>(names_.size());
        names_.emplace_back(name);
        it->second = intern(entry);
    }
    return it->second;
}

Graph::Entry Graph::makeEntry(Op op, Node a, Node b, Node c) {
    Entry entry;
    entry.op = op;
    entry.count = static_cast<std::uint8_t>(argumentCount(op));
    entry.arguments = {a, b, c};
    return entry;
}

Node Graph::make(Op op, Node a, Node b, Node c) {
    const Entry entry = makeEntry(op, a, b, c);
    const auto shorter = simplified(*this, op, std::span(entry.arguments).first(entry.count));
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

const std::string& Graph::name(Node symbol) const {
    return names_[entries_[symbol.index].arguments[0].index];
}

} // namespace expression
