#include "equations/elimination_order.h"

#include <algorithm>
#include <iterator>

namespace solution {

std::optional<EliminationOrder> eliminationOrder(std::size_t size,
                                                 std::span<const EliminationOrder::Place> places,
                                                 double most, AmongEquals among) {
    using Index = EliminationOrder::Index;
    EliminationOrder order;
    std::vector<std::vector<Index>>& next = order.later;
    next.resize(size);
    for (const auto& [row, column] : places)
        if (row != column) {
            next[row].push_back(column);
            next[column].push_back(row);
        }
    for (std::vector<Index>& of : next) {
        std::ranges::sort(of);
        of.erase(std::unique(of.begin(), of.end()), of.end());
    }
    std::vector<char> isDone(size, 0);
    std::vector<Index> joined, waits(size, 0); // for so many others in turn
    const auto isBetter = [&](std::size_t row, std::size_t than) {
        if (next[row].size() != next[than].size())
            return next[row].size() < next[than].size();
        return among == AmongEquals::waitsLeast && waits[row] < waits[than];
    };
    while (order.rows.size() < size) {
        std::size_t least = size;
        for (std::size_t row = 0; row < size; ++row)
            if (isDone[row] == 0 && (least == size || isBetter(row, least)))
                least = row;
        order.multiplications += next[least].size() * (next[least].size() + 1) / 2;
        if (static_cast<double>(order.multiplications) > most)
            return std::nullopt;
        order.rows.push_back(static_cast<Index>(least));
        isDone[least] = 1;
        for (const Index row : next[least]) {
            waits[row] = std::max(waits[row], waits[least] + 1);
            joined.clear();
            std::ranges::set_union(next[row], next[least], std::back_inserter(joined));
            std::erase_if(joined, [&](Index i) { return i == row || i == least; });
            next[row] = joined;
        }
    }
    return order;
}

// A dense multiplication costs less than a sparse one, and a dense factorization something besides.
double worthEliminating(std::size_t size) {
    constexpr double cost = 4, besides = 500;
    const auto n = static_cast<double>(size);
    return n * n * n / 3 / cost + besides;
}

} // namespace solution
