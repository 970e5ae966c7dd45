#include "document/table_grid.h"

#include "document/subdocument.h"

#include <algorithm>

namespace document {

std::size_t spannedBy(std::optional<std::string_view> attribute) {
    const std::optional<double> number = numberIn(attribute, 1, static_cast<double>(mostSpanned));
    return number ? static_cast<std::size_t>(*number) : 1;
}

TableGrid::TableGrid(const std::vector<std::vector<Span>>& rows) {
    std::vector<std::size_t> covered; // by column: so many of the next rows
    rows_.resize(rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::size_t column = 0;
        const auto isCovered = [&](std::size_t at) {
            return at < covered.size() && covered[at] > 0;
        };
        std::vector<std::size_t> next = covered;
        for (std::size_t i = 0; i < rows[r].size(); ++i) {
            while (isCovered(column))
                ++column;
            GridCell cell{.row = r, .number = i, .column = column};
            cell.span.rows = std::clamp<std::size_t>(rows[r][i].rows, 1, rows.size() - r);
            std::size_t wanted = std::clamp<std::size_t>(rows[r][i].columns, 1, mostSpanned);
            while (cell.span.columns < wanted && !isCovered(column + cell.span.columns))
                ++cell.span.columns;
            column += cell.span.columns;
            next.resize(std::max(next.size(), column));
            for (std::size_t c = cell.column; c < column; ++c)
                next[c] = cell.span.rows;
            rows_[r].push_back(cell);
        }
        for (std::size_t& rest : next)
            rest -= rest > 0 ? 1 : 0;
        covered = std::move(next);
    }
    columns_ = covered.size();
}

const GridCell* TableGrid::at(std::size_t row, std::size_t column) const {
    for (std::size_t r = row + 1; r-- > 0 && row - r < mostSpanned;) {
        const auto behind =
            std::upper_bound(rows_[r].begin(), rows_[r].end(), column,
                             [](std::size_t at, const GridCell& cell) { return at < cell.column; });
        if (behind != rows_[r].begin() && (behind - 1)->lastColumn() >= column &&
            (behind - 1)->lastRow() >= row)
            return &*(behind - 1);
    }
    return nullptr;
}

std::size_t TableGrid::endOfBand(std::size_t row) const {
    std::size_t end = row + 1;
    for (std::size_t r = row; r < end; ++r)
        for (const GridCell& cell : rows_[r])
            end = std::max(end, cell.lastRow() + 1);
    return end;
}

} // namespace document
