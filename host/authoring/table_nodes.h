// A table of a document as its rows and cells, and which of these are selected.
//
// Places in two cells of a table select all cells of the rectangle between them.
#pragma once

#include "document/selection.h"
#include "document/table_grid.h"
#include "manuscript/manuscript.h"
#include "sgml/tree.h"

#include <optional>
#include <string>
#include <vector>

namespace authoring {

using manuscript::Grammar, manuscript::Manuscript, manuscript::Selection;

struct CellRect { // rows and columns, inclusive
    std::size_t top = 0, left = 0, bottom = 0, right = 0;
    [[nodiscard]] std::size_t rows() const { return bottom - top + 1; }
    [[nodiscard]] std::size_t columns() const { return right - left + 1; }
    bool operator==(const CellRect&) const = default;
};

struct TableNodes {
    sgml::NodeId table = sgml::noNode; // the element around the rows
    std::vector<sgml::NodeId> rows;
    std::vector<std::vector<sgml::NodeId>> cells; // of each row
    document::TableGrid grid;
    CellRect selected;      // as many whole cells as it takes
    bool isSeveral = false; // several of them

    // The innermost table with a cell around each of two nodes; nothing: there is none.
    [[nodiscard]] static std::optional<TableNodes>
    around(const sgml::Tree& tree, const Grammar& grammar, sgml::NodeId one, sgml::NodeId other);

    [[nodiscard]] sgml::NodeId node(const document::GridCell& cell) const {
        return cells[cell.row][cell.number];
    }
    // Those that cover places of a rectangle, each once, row by row.
    [[nodiscard]] std::vector<document::GridCell> cellsIn(const CellRect& rect) const;
    // Does it stand again on each page of the table?
    [[nodiscard]] bool isHeader(const sgml::Tree& tree, const Grammar& grammar,
                                std::size_t row) const;
    // As spelled: "30mm" or "auto"; those behind the last are automatic.
    [[nodiscard]] std::vector<std::string> widths(const sgml::Tree& tree) const;
    // The least rectangle around it that cuts no cell.
    [[nodiscard]] CellRect grown(CellRect rect) const;
};

// The attribute WIDTHS with other widths, in points; 0: automatic; less: it stays.
[[nodiscard]] std::string spelledWidths(std::vector<std::string> spelled,
                                        const std::vector<double>& widths);

// Of the document's own class. LIMIT: tables in nested documents of text have no selected cells.
[[nodiscard]] std::optional<TableNodes> tableAround(const Manuscript& manuscript,
                                                    document::Selection selection);
// The elements of several cells that are selected; none when the selection is text.
[[nodiscard]] std::vector<sgml::NodeId> selectedCells(const Manuscript& manuscript,
                                                      document::Selection selection);

} // namespace authoring
