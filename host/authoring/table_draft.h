// The table around a draft's caret, whose rows, columns and cells a command changes.
#pragma once

#include "authoring/commands.h"
#include "authoring/table_nodes.h"

#include <set>

namespace authoring {

class TableDraft {
public:
    explicit TableDraft(Draft& draft);
    [[nodiscard]] bool isThere() const { return nodes_.has_value(); }

    // Each gives "" when it is done, else the reason why not. The selection is meant: the rows
    // or columns of its cells.
    QString insertRow(Direction side);
    QString insertColumn(Direction side);
    QString removeRows();
    QString removeColumns();
    QString removeTable();
    QString moveRows(Direction direction);
    QString moveColumns(Direction direction);
    QString join();
    QString split();
    QString toggleHeader();
    // Behind the last cell a new row begins.
    QString goToCell(Direction direction);
    QString select(TablePart part);
    // In points; 0: automatic.
    QString setWidth(double width);
    QString setWidths(const std::vector<double>& widths);

    // The cells of the table that are not selected, where several are.
    [[nodiscard]] std::set<sgml::NodeId> unselected() const;
    // Empties all cells that are selected, if there are several.
    bool clear();

private:
    using Cell = document::GridCell;
    [[nodiscard]] Piece& piece(const Cell& cell);
    [[nodiscard]] Piece& row(std::size_t row) { return draft_.opened(nodes_->rows[row]); }
    [[nodiscard]] const Cell* at(std::size_t row, std::size_t column) const {
        return nodes_->grid.at(row, column);
    }
    [[nodiscard]] CellRect rect() const { return nodes_->selected; }
    [[nodiscard]] bool isHeader(std::size_t row) const;
    [[nodiscard]] std::unique_ptr<Piece> emptyCell() const;
    // The index in its row that a cell of that column has, or would have.
    std::size_t indexIn(std::size_t row, std::size_t column);
    void setSpan(const Cell& cell, document::Span span);
    [[nodiscard]] std::vector<std::string> widths() const;
    void writeWidths(std::vector<std::string> widths);
    Pieces contentOf(Piece& cell);
    void goTo(Piece& cell, Piece& mark, bool atEnd);
    void goTo(Piece& cell);

    Draft& draft_;
    std::optional<TableNodes> nodes_;
};

} // namespace authoring
