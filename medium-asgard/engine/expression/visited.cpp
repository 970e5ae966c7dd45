#include "expression/visited.h"

#include <algorithm>
#include <bit>

namespace expression {

std::vector<std::unique_ptr<Visited::Table>>& Visited::freeTables() {
    thread_local std::vector<std::unique_ptr<Table>> tables;
    return tables;
}

Visited::Visited() {
    auto& tables = freeTables();
    if (tables.empty()) {
        table_ = std::make_unique<Table>();
    } else {
        table_ = std::move(tables.back());
        tables.pop_back();
    }
    if (++table_->walk == 0) { // all numbers of walks were used
        std::ranges::fill(table_->last, 0U);
        table_->walk = 1;
    }
}

Visited::~Visited() { freeTables().push_back(std::move(table_)); }

void putInOrder(std::vector<Node>& nodes) {
    constexpr std::uint32_t wide = 64;
    if (nodes.empty())
        return;
    const auto [first, last] = std::ranges::minmax(nodes);
    const std::size_t words = last.index / wide - first.index / wide + 1;
    if (words > 4 * nodes.size()) {
        std::ranges::sort(nodes);
        return;
    }
    std::vector<std::uint64_t> bits(words);
    const std::uint32_t start = first.index / wide * wide;
    for (const Node n : nodes)
        bits[(n.index - start) / wide] |= std::uint64_t{1} << (n.index % wide);
    auto next = nodes.begin();
    for (std::uint32_t word = 0; word < words; ++word)
        for (std::uint64_t left = bits[word]; left != 0; left &= left - 1)
            *next++ =
                Node{start + word * wide + static_cast<std::uint32_t>(std::countr_zero(left))};
}

} // namespace expression
