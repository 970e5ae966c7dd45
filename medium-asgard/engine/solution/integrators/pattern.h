#pragma once

#include <cstddef>
#include <vector>

namespace solution {

// Places of a sparse square matrix, by columns (compressed), rows in order within each.
struct Pattern {
    std::vector<int> columnStarts, rows;
    [[nodiscard]] std::size_t size() const { return columnStarts.size() - 1; }
    [[nodiscard]] std::size_t entries() const { return rows.size(); }
};

} // namespace solution
