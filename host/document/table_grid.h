// The places of a table's cells, of which some reach over several columns or rows.
//
// Each row is filled from the left; what a cell from above covers is passed, as in HTML.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace document {

// How many columns and rows a cell covers.
struct Span {
    std::size_t columns = 1, rows = 1;
    bool operator==(const Span&) const = default;
};

// LIMIT: of one cell, each way.
inline constexpr std::size_t mostSpanned = 100;
// The number that an attribute COLUMNS or ROWS holds; 1 for what is none or out of bounds.
[[nodiscard]] std::size_t spannedBy(std::optional<std::string_view> attribute);

struct GridCell {
    std::size_t row = 0, number = 0; // of the row's cells
    std::size_t column = 0;
    Span span{}; // as far as there is room for it

    [[nodiscard]] std::size_t lastColumn() const { return column + span.columns - 1; }
    [[nodiscard]] std::size_t lastRow() const { return row + span.rows - 1; }
};

class TableGrid {
public:
    TableGrid() = default;
    explicit TableGrid(const std::vector<std::vector<Span>>& rows);

    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    [[nodiscard]] const std::vector<GridCell>& row(std::size_t row) const { return rows_[row]; }
    // The cell that covers a place; null: none does.
    [[nodiscard]] const GridCell* at(std::size_t row, std::size_t column) const;
    // Behind the last of the rows from `row` on that cells hold together: a band.
    [[nodiscard]] std::size_t endOfBand(std::size_t row) const;

private:
    std::vector<std::vector<GridCell>> rows_;
    std::size_t columns_ = 0;
};

} // namespace document
