#include "authoring/table_nodes.h"

#include "manuscript/leaves.h"

#include <algorithm>

namespace authoring {

using manuscript::documentAround;

using document::GridCell;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

// The cells around a node, the innermost first.
std::vector<NodeId> cellsAround(const sgml::Tree& tree, const Grammar& grammar, NodeId node) {
    std::vector<NodeId> found;
    for (NodeId at = node; at != noNode; at = tree.node(at).parent) {
        const NodeId row = tree.node(at).parent;
        if (tree.isElement(at) && grammar.of(tree.name(at)).display == Display::cell &&
            row != noNode && grammar.of(tree.name(row)).display == Display::row)
            found.push_back(at);
    }
    return found;
}

std::vector<NodeId> childrenShownAs(const sgml::Tree& tree, const Grammar& grammar, NodeId parent,
                                    Display display) {
    std::vector<NodeId> found;
    for (NodeId child = tree.node(parent).firstChild; child != noNode;
         child = tree.node(child).next)
        if (tree.isElement(child) && grammar.of(tree.name(child)).display == display)
            found.push_back(child);
    return found;
}

const GridCell& placeOf(const TableNodes& table, NodeId cell) {
    for (std::size_t r = 0; r < table.cells.size(); ++r)
        for (std::size_t i = 0; i < table.cells[r].size(); ++i)
            if (table.cells[r][i] == cell)
                return table.grid.row(r)[i];
    return table.grid.row(0).front(); // not reached: it is one of them
}

} // namespace

std::optional<TableNodes> TableNodes::around(const sgml::Tree& tree, const Grammar& grammar,
                                             NodeId one, NodeId other) {
    const auto tableOf = [&](NodeId cell) { return tree.node(tree.node(cell).parent).parent; };
    const std::vector<NodeId> ofOther = cellsAround(tree, grammar, other);
    for (const NodeId cell : cellsAround(tree, grammar, one)) {
        const auto same = std::find_if(ofOther.begin(), ofOther.end(),
                                       [&](NodeId at) { return tableOf(at) == tableOf(cell); });
        if (same == ofOther.end())
            continue;
        TableNodes found;
        found.table = tableOf(cell);
        found.rows = childrenShownAs(tree, grammar, found.table, Display::row);
        std::vector<std::vector<document::Span>> spans;
        for (const NodeId row : found.rows) {
            found.cells.push_back(childrenShownAs(tree, grammar, row, Display::cell));
            spans.emplace_back();
            for (const NodeId at : found.cells.back())
                spans.back().push_back({document::spannedBy(tree.attribute(at, "COLUMNS")),
                                        document::spannedBy(tree.attribute(at, "ROWS"))});
        }
        found.grid = document::TableGrid(spans);
        const GridCell a = placeOf(found, cell), b = placeOf(found, *same);
        found.selected = found.grown({std::min(a.row, b.row), std::min(a.column, b.column),
                                      std::max(a.lastRow(), b.lastRow()),
                                      std::max(a.lastColumn(), b.lastColumn())});
        found.isSeveral = cell != *same;
        return found;
    }
    return std::nullopt;
}

std::vector<GridCell> TableNodes::cellsIn(const CellRect& rect) const {
    std::vector<GridCell> found;
    const std::size_t first = rect.top + 1 - std::min(rect.top + 1, document::mostSpanned);
    for (std::size_t r = first; r <= rect.bottom; ++r)
        for (const GridCell& cell : grid.row(r))
            if (cell.lastRow() >= rect.top && cell.column <= rect.right &&
                cell.lastColumn() >= rect.left)
                found.push_back(cell);
    return found;
}

CellRect TableNodes::grown(CellRect rect) const {
    for (;;) {
        const CellRect before = rect;
        for (const GridCell& cell : cellsIn(before)) {
            rect.top = std::min(rect.top, cell.row);
            rect.left = std::min(rect.left, cell.column);
            rect.bottom = std::max(rect.bottom, cell.lastRow());
            rect.right = std::max(rect.right, cell.lastColumn());
        }
        if (rect == before)
            return rect;
    }
}

bool TableNodes::isHeader(const sgml::Tree& tree, const Grammar& grammar, std::size_t row) const {
    const std::string_view kind = tree.attribute(rows[row], "KIND").value_or("");
    const bool isFirst = row == 0 && grammar.of(tree.name(rows[row])).isHeaderFirst;
    return kind == "header" || (isFirst && kind != "body");
}

std::vector<std::string> TableNodes::widths(const sgml::Tree& tree) const {
    std::vector<std::string> all;
    std::string_view rest = tree.attribute(table, "WIDTHS").value_or("");
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (end > 0)
            all.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return all;
}

std::string spelledWidths(std::vector<std::string> spelled, const std::vector<double>& widths) {
    constexpr double millimetre = 72 / 25.4;
    spelled.resize(std::max(spelled.size(), widths.size()), "auto");
    for (std::size_t i = 0; i < widths.size(); ++i)
        if (widths[i] >= 0)
            spelled[i] = widths[i] == 0
                             ? "auto"
                             : QString::number(widths[i] / millimetre, 'f', 1).toStdString() + "mm";
    while (!spelled.empty() && spelled.back() == "auto")
        spelled.pop_back();
    std::string all;
    for (const std::string& one : spelled)
        all += (all.empty() ? "" : " ") + one;
    return all;
}

std::optional<TableNodes> tableAround(const Manuscript& manuscript, Selection selection) {
    const sgml::Tree& tree = manuscript.document.tree();
    const std::size_t from = std::min(selection.anchor, selection.caret);
    const std::size_t to = std::max(selection.anchor, selection.caret);
    if (to >= tree.bytes().size() || tree.isBroken())
        return std::nullopt;
    const NodeId document = documentAround(manuscript, from, to);
    const Grammar* grammar = manuscript.grammars.of(tree.name(document));
    if (grammar == nullptr)
        return std::nullopt;
    return TableNodes::around(tree, *grammar, tree.innermostAt(selection.anchor),
                              tree.innermostAt(selection.caret));
}

std::vector<NodeId> selectedCells(const Manuscript& manuscript, Selection selection) {
    std::vector<NodeId> found;
    const std::optional<TableNodes> table = tableAround(manuscript, selection);
    if (table && table->isSeveral)
        for (const GridCell& cell : table->cellsIn(table->selected))
            found.push_back(table->node(cell));
    return found;
}

} // namespace authoring
