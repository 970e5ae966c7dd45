// Commands for tables. Their work on rows and cells: table_draft.h.
#include "authoring/new_table.h"
#include "authoring/table_draft.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using schemas::ContainerRole;
using schemas::Display;

namespace {

Result changeTable(const Manuscript& manuscript, Selection selection, const QString& label,
                   const std::function<QString(TableDraft&)>& change) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    TableDraft table(draft);
    if (!table.isThere())
        return refused(QStringLiteral("The caret is in no table."));
    if (const QString why = change(table); !why.isEmpty())
        return refused(why);
    return draft.result(label);
}

} // namespace

Result insertRow(const Manuscript& manuscript, Selection selection, Direction side) {
    return changeTable(manuscript, selection, QStringLiteral("Insert Row"),
                       [side](TableDraft& table) { return table.insertRow(side); });
}

Result insertColumn(const Manuscript& manuscript, Selection selection, Direction side) {
    return changeTable(manuscript, selection, QStringLiteral("Insert Column"),
                       [side](TableDraft& table) { return table.insertColumn(side); });
}

Result removeRow(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Remove Row"),
                       [](TableDraft& table) { return table.removeRows(); });
}

Result removeColumn(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Remove Column"),
                       [](TableDraft& table) { return table.removeColumns(); });
}

Result removeTable(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Remove Table"),
                       [](TableDraft& table) { return table.removeTable(); });
}

Result moveRow(const Manuscript& manuscript, Selection selection, Direction direction) {
    return changeTable(manuscript, selection, QStringLiteral("Move Row"),
                       [direction](TableDraft& table) { return table.moveRows(direction); });
}

Result moveColumn(const Manuscript& manuscript, Selection selection, Direction direction) {
    return changeTable(manuscript, selection, QStringLiteral("Move Column"),
                       [direction](TableDraft& table) { return table.moveColumns(direction); });
}

Result joinCells(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Join Cells"),
                       [](TableDraft& table) { return table.join(); });
}

Result splitCell(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Split Cell"),
                       [](TableDraft& table) { return table.split(); });
}

Result toggleHeader(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Header Row"),
                       [](TableDraft& table) { return table.toggleHeader(); });
}

Result setColumnWidth(const Manuscript& manuscript, Selection selection, double width) {
    return changeTable(manuscript, selection, QStringLiteral("Column Width"),
                       [width](TableDraft& table) { return table.setWidth(width); });
}

Result selectInTable(const Manuscript& manuscript, Selection selection, TablePart part) {
    return changeTable(manuscript, selection, QStringLiteral("Select"),
                       [part](TableDraft& table) { return table.select(part); });
}

Result goToCell(const Manuscript& manuscript, Selection selection, Direction direction) {
    return changeTable(manuscript, {selection.caret, selection.caret}, QStringLiteral("Insert Row"),
                       [direction](TableDraft& table) { return table.goToCell(direction); });
}

namespace {

constexpr std::string_view alignAttribute = "ALIGN";

std::vector<sgml::NodeId> cellsOf(const Manuscript& manuscript, Selection selection) {
    std::vector<sgml::NodeId> cells;
    if (const auto table = tableAround(manuscript, selection))
        for (const document::GridCell& cell : table->cellsIn(table->selected))
            cells.push_back(table->node(cell));
    return cells;
}

} // namespace

Result alignCells(const Manuscript& manuscript, Selection selection, std::string_view align) {
    const sgml::Tree& tree = manuscript.document.tree();
    const std::vector<sgml::NodeId> cells = cellsOf(manuscript, selection);
    const Grammar* grammar = manuscript.grammars.of(manuscript.document.className());
    if (cells.empty() || grammar == nullptr)
        return refused(QStringLiteral("The caret is in no table."));
    if (!grammar->hasAttribute(tree.name(cells.front()), alignAttribute))
        return refused(QStringLiteral("Cells of this class of documents cannot be aligned."));
    Step step;
    for (const sgml::NodeId cell : cells)
        for (text::Edit& edit :
             align.empty() ? sgml::attributeRemoval(tree, cell, alignAttribute)
                           : sgml::attributeEdit(tree, cell, alignAttribute, std::string(align)))
            step.edits.push_back(std::move(edit));
    std::ranges::sort(step.edits, {}, [](const text::Edit& edit) { return edit.range.from; });
    step.after = {text::moved(selection.anchor, step.edits, text::Gravity::before),
                  text::moved(selection.caret, step.edits, text::Gravity::before)};
    step.label = QStringLiteral("Align Cells");
    return step;
}

std::optional<std::string> alignmentOfCells(const Manuscript& manuscript, Selection selection) {
    const sgml::Tree& tree = manuscript.document.tree();
    std::optional<std::string> all;
    for (const sgml::NodeId cell : cellsOf(manuscript, selection)) {
        const std::string own(tree.attribute(cell, alignAttribute).value_or(""));
        if (all && *all != own)
            return std::nullopt;
        all = own;
    }
    return all;
}

Result setColumnWidths(const Manuscript& manuscript, Selection selection, sgml::NodeId table,
                       const std::vector<double>& widths) {
    const sgml::Tree& tree = manuscript.document.tree();
    TableNodes nodes;
    nodes.table = table;
    return setAttributes(manuscript, selection, table,
                         {{"WIDTHS", spelledWidths(nodes.widths(tree), widths)}},
                         QStringLiteral("Column Width"));
}

Result insertTable(const Manuscript& manuscript, Selection selection, const NewTable& wanted) {
    return insertTable(manuscript, selection, wanted, 0);
}

Result insertTable(const Manuscript& manuscript, Selection selection, const NewTable& wanted,
                   double columnWidth) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const Grammar& grammar = draft.grammar();
    const std::string table(grammar.named(Display::table)), row(grammar.named(Display::row)),
        cell(grammar.named(Display::cell)), caption(grammar.named(ContainerRole::caption));
    if (table.empty() || row.empty() || cell.empty())
        return refused(QStringLiteral("This class of documents has no tables."));
    Piece* made = putBlock(draft, draft.first(), Draft::made(table));
    if (made == nullptr)
        return refused(QStringLiteral("A table may not stand here."));
    if (columnWidth > 0 && grammar.hasAttribute(table, "WIDTHS")) {
        const auto columns = static_cast<std::size_t>(std::max(wanted.columns, 1));
        made->attributes =
            " " + sgml::attributeText("WIDTHS",
                                      spelledWidths({}, std::vector<double>(columns, columnWidth)));
    }
    if (wanted.hasCaption && grammar.mayHold(table, caption)) {
        Piece& line = Draft::put(*made, 0, Draft::made(caption));
        line.gap.fresh = "\n";
        Draft::put(line, 0, Draft::madeText(wanted.caption));
    }
    Piece* first = nullptr;
    const bool isHeaderFirst = grammar.of(row).isHeaderFirst;
    for (int i = 0; i < std::max(wanted.rows, 1); ++i) {
        Piece& line = Draft::put(*made, made->children.size(), Draft::made(row));
        line.gap.fresh = "\n";
        if (i == 0 && wanted.hasHeader != isHeaderFirst && grammar.hasAttribute(row, "KIND"))
            line.attributes =
                " " + sgml::attributeText("KIND", wanted.hasHeader ? "header" : "body");
        for (int j = 0; j < std::max(wanted.columns, 1); ++j)
            Draft::put(Draft::put(line, line.children.size(), Draft::made(cell)), 0,
                       Draft::madeText({}));
        first = first == nullptr ? line.children.front().get() : first;
    }
    made->tail.fresh = "\n";
    Draft::moveTo(draft.first(), *first, 0);
    draft.collapse();
    return draft.result(QStringLiteral("Table"));
}

} // namespace authoring
