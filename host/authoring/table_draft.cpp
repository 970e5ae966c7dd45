#include "authoring/table_draft.h"

#include <algorithm>
#include <set>

namespace authoring {

using document::GridCell;
using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

NodeId nodeAround(const Piece& mark) {
    const Piece* at = mark.parent;
    while (at != nullptr && at->start == noNode)
        at = at->parent;
    return at == nullptr ? noNode : at->start;
}

} // namespace

TableDraft::TableDraft(Draft& draft) : draft_(draft) {
    const NodeId first = nodeAround(draft.first()), second = nodeAround(draft.second());
    if (first != noNode && second != noNode)
        nodes_ = TableNodes::around(draft.tree(), draft.grammar(), first, second);
}

Piece& TableDraft::piece(const Cell& cell) {
    Piece& opened = draft_.opened(nodes_->node(cell));
    draft_.openChildren(opened);
    return opened;
}

std::unique_ptr<Piece> TableDraft::emptyCell() const {
    const std::string name(draft_.tree().name(nodes_->cells[rect().top].empty()
                                                  ? nodes_->node(*at(rect().top, rect().left))
                                                  : nodes_->cells[rect().top].front()));
    std::unique_ptr<Piece> cell = Draft::made(name);
    if (draft_.holdsText(*cell))
        Draft::put(*cell, 0, Draft::madeText({}));
    return cell;
}

std::size_t TableDraft::indexIn(std::size_t row, std::size_t column) {
    Piece& line = this->row(row);
    draft_.openChildren(line);
    const std::vector<GridCell>& all = nodes_->grid.row(row);
    for (const GridCell& cell : all)
        if (cell.column >= column)
            return draft_.opened(nodes_->node(cell)).index();
    return line.children.size();
}

void TableDraft::setSpan(const Cell& cell, document::Span span) {
    const auto spelled = [](std::size_t count) {
        return count == 1 ? std::string() : std::to_string(count);
    };
    Piece& of = draft_.opened(nodes_->node(cell));
    if (span.columns != cell.span.columns)
        draft_.setAttribute(of, "COLUMNS", spelled(span.columns));
    if (span.rows != cell.span.rows)
        draft_.setAttribute(of, "ROWS", spelled(span.rows));
}

// The place where a writer goes on in a cell.
void TableDraft::goTo(Piece& cell, Piece& mark, bool atEnd) {
    Piece* into = &cell;
    for (;;) {
        draft_.openChildren(*into);
        Piece* next = nullptr;
        for (const auto& child : into->children)
            if (!child->isMark() && (next == nullptr || atEnd))
                next = child.get();
        if (next == nullptr || !next->isElement() || draft_.isUnit(*next))
            break;
        into = next;
    }
    Draft::moveTo(mark, *into, atEnd ? into->children.size() : 0);
}

void TableDraft::goTo(Piece& cell) {
    goTo(cell, draft_.first(), false);
    draft_.collapse();
}

// --- rows and columns --------------------------------------------------------------------------

QString TableDraft::insertRow(Direction side) {
    const std::size_t beside = side == Direction::forward ? rect().bottom : rect().top;
    const std::size_t above = side == Direction::forward ? beside : beside - 1; // may wrap
    const std::size_t caret = rect().left;
    Piece& line = row(beside);
    Piece& made = Draft::put(*line.parent, line.index() + (side == Direction::forward ? 1 : 0),
                             Draft::made(line.name));
    draft_.putOnLine(made, line);
    Piece* to = nullptr;
    for (std::size_t c = 0; c < nodes_->grid.columns(); ++c) {
        const GridCell* cell = at(beside, c);
        const GridCell* over = above < nodes_->rows.size() ? at(above, c) : nullptr;
        const GridCell* under = above + 1 < nodes_->rows.size() ? at(above + 1, c) : nullptr;
        if (over != nullptr && over == under) { // it reaches over the new row, too
            if (over->column == c)
                setSpan(*over, {over->span.columns, over->span.rows + 1});
        } else if (cell != nullptr) {
            Piece& fresh = Draft::put(made, made.children.size(), emptyCell());
            if (const std::string align(draft_.attribute(piece(*cell), "ALIGN")); !align.empty())
                draft_.setAttribute(fresh, "ALIGN", align);
            to = to == nullptr || c <= caret ? &fresh : to;
        }
    }
    if (to == nullptr)
        return QStringLiteral("The cells here reach over all rows.");
    goTo(*to);
    return {};
}

QString TableDraft::insertColumn(Direction side) {
    const std::size_t at = side == Direction::forward ? rect().right + 1 : rect().left;
    const std::size_t caret = rect().top;
    Piece* to = nullptr;
    std::set<NodeId> widened;
    for (std::size_t r = 0; r < nodes_->rows.size(); ++r) {
        const GridCell* over = at > 0 ? this->at(r, at - 1) : nullptr;
        if (over != nullptr && over == this->at(r, at)) { // it reaches over the new column, too
            if (widened.insert(nodes_->node(*over)).second)
                setSpan(*over, {over->span.columns + 1, over->span.rows});
            continue;
        }
        Piece& made = Draft::put(row(r), indexIn(r, at), emptyCell());
        to = to == nullptr || r <= caret ? &made : to;
    }
    if (to == nullptr)
        return QStringLiteral("The cells here reach over all columns.");
    if (std::vector<std::string> all = widths(); at <= all.size() && !all.empty()) {
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), "auto");
        writeWidths(std::move(all));
    }
    goTo(*to);
    return {};
}

QString TableDraft::removeRows() {
    const CellRect gone = rect();
    if (gone.rows() == nodes_->rows.size())
        return QStringLiteral("These are all rows. Remove the table instead.");
    const std::size_t next = gone.bottom + 1 < nodes_->rows.size() ? gone.bottom + 1 : gone.top - 1;
    const GridCell* stays = at(next, gone.left);
    if (stays == nullptr && !nodes_->grid.row(next).empty())
        stays = &nodes_->grid.row(next).back();
    if (stays == nullptr)
        return QStringLiteral("The row beside it has no cells.");
    goTo(piece(*stays));
    std::vector<GridCell> below; // that begin in the row below now
    for (const GridCell& cell :
         nodes_->cellsIn({gone.top, 0, gone.bottom, nodes_->grid.columns() - 1})) {
        const std::size_t inside =
            std::min(cell.lastRow(), gone.bottom) - std::max(cell.row, gone.top) + 1;
        if (inside == cell.span.rows)
            continue;
        setSpan(cell, {cell.span.columns, cell.span.rows - inside});
        if (cell.row >= gone.top)
            below.push_back(cell);
    }
    std::sort(below.begin(), below.end(),
              [](const GridCell& a, const GridCell& b) { return a.column < b.column; });
    for (const GridCell& cell : below)
        Draft::moveTo(piece(cell), row(gone.bottom + 1), indexIn(gone.bottom + 1, cell.column));
    for (std::size_t r = gone.top; r <= gone.bottom; ++r)
        Draft::take(row(r));
    return {};
}

QString TableDraft::removeColumns() {
    const CellRect gone = rect();
    if (gone.columns() == nodes_->grid.columns())
        return QStringLiteral("These are all columns. Remove the table instead.");
    const std::size_t next =
        gone.right + 1 < nodes_->grid.columns() ? gone.right + 1 : gone.left - 1;
    const GridCell* stays = at(gone.top, next);
    for (std::size_t r = 0; stays == nullptr && r < nodes_->rows.size(); ++r)
        stays = at(r, next);
    if (stays == nullptr)
        return QStringLiteral("The column beside it has no cells.");
    goTo(piece(*stays));
    for (const GridCell& cell :
         nodes_->cellsIn({0, gone.left, nodes_->rows.size() - 1, gone.right})) {
        const std::size_t inside =
            std::min(cell.lastColumn(), gone.right) - std::max(cell.column, gone.left) + 1;
        if (inside < cell.span.columns)
            setSpan(cell, {cell.span.columns - inside, cell.span.rows});
        else
            Draft::take(draft_.opened(nodes_->node(cell)));
    }
    if (std::vector<std::string> all = widths(); gone.left < all.size()) {
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(gone.left),
                  all.begin() + static_cast<std::ptrdiff_t>(std::min(gone.right + 1, all.size())));
        writeWidths(std::move(all));
    }
    return {};
}

// A figure that held nothing but the table and its caption goes with it.
QString TableDraft::removeTable() {
    Piece* gone = &draft_.opened(nodes_->table);
    Piece* around = gone->parent;
    draft_.openChildren(*around);
    if (draft_.of(*around).role == ContainerRole::figure && around->parent != nullptr) {
        const auto counts = [&](const auto& child) {
            return !child->isMark() && child.get() != gone &&
                   !(child->isElement() && draft_.of(*child).role == ContainerRole::caption);
        };
        if (std::none_of(around->children.begin(), around->children.end(), counts))
            gone = around;
    }
    Piece& parent = *gone->parent;
    for (Piece* mark : {&draft_.second(), &draft_.first()})
        Draft::moveTo(*mark, parent, gone->index());
    Draft::take(*gone);
    draft_.openChildren(parent);
    const bool isAlone = std::all_of(parent.children.begin(), parent.children.end(),
                                     [](const auto& child) { return child->isMark(); });
    if (isAlone && makeLine(draft_, draft_.first()))
        draft_.collapse();
    return {};
}

namespace {

const QString heldTogether =
    QStringLiteral("Cells that reach over several rows or columns hold these together.");

} // namespace

// The row beside them goes to their other side.
QString TableDraft::moveRows(Direction direction) {
    const CellRect all = nodes_->grown({rect().top, 0, rect().bottom, nodes_->grid.columns() - 1});
    const bool isDown = direction == Direction::forward;
    if (isDown ? all.bottom + 1 == nodes_->rows.size() : all.top == 0)
        return isDown ? QStringLiteral("This is the last row.")
                      : QStringLiteral("This is the first row.");
    const std::size_t beside = isDown ? all.bottom + 1 : all.top - 1;
    const CellRect passed = nodes_->grown({beside, 0, beside, nodes_->grid.columns() - 1});
    if (isDown ? passed.top <= all.bottom : passed.bottom >= all.top)
        return heldTogether;
    Piece& table = *row(all.top).parent;
    for (std::size_t i = 0; i < passed.rows(); ++i) {
        if (isDown) {
            Piece& moved = row(passed.top + i);
            Draft::moveTo(moved, table, row(all.top).index());
        } else {
            Piece& moved = row(passed.bottom - i);
            Draft::moveTo(moved, table, row(all.bottom).index() + 1);
        }
    }
    return {};
}

QString TableDraft::moveColumns(Direction direction) {
    const std::size_t rows = nodes_->rows.size() - 1, columns = nodes_->grid.columns();
    const CellRect all = nodes_->grown({0, rect().left, rows, rect().right});
    const bool isRight = direction == Direction::forward;
    if (isRight ? all.right + 1 == columns : all.left == 0)
        return isRight ? QStringLiteral("This is the last column.")
                       : QStringLiteral("This is the first column.");
    const std::size_t beside = isRight ? all.right + 1 : all.left - 1;
    const CellRect passed = nodes_->grown({0, beside, rows, beside});
    if (isRight ? passed.left <= all.right : passed.right >= all.left)
        return heldTogether;
    for (std::size_t r = 0; r <= rows; ++r) {
        std::vector<Piece*> moved;
        for (const GridCell& cell : nodes_->grid.row(r))
            if (cell.column >= passed.left && cell.column <= passed.right)
                moved.push_back(&piece(cell));
        for (std::size_t i = 0; i < moved.size(); ++i) {
            Piece& one = *moved[isRight ? i : moved.size() - 1 - i];
            Draft::moveTo(one, row(r), isRight ? indexIn(r, all.left) : indexIn(r, all.right + 1));
        }
    }
    if (std::vector<std::string> of = widths(); !of.empty()) {
        of.resize(std::max(of.size(), columns), "auto");
        const auto first =
            of.begin() + static_cast<std::ptrdiff_t>(std::min(all.left, passed.left));
        const auto middle =
            of.begin() + static_cast<std::ptrdiff_t>(std::max(all.left, passed.left));
        const auto last =
            of.begin() + static_cast<std::ptrdiff_t>(std::max(all.right, passed.right)) + 1;
        std::rotate(first, middle, last);
        writeWidths(std::move(of));
    }
    return {};
}

// --- cells -------------------------------------------------------------------------------------

// A cell's content, as blocks of its own; an empty cell has none.
Pieces TableDraft::contentOf(Piece& cell) {
    Pieces content;
    draft_.openChildren(cell);
    if (draft_.isBlank(cell))
        return content;
    const std::string paragraph(draft_.grammar().named(ContainerRole::paragraph));
    Piece* line = nullptr;
    while (!cell.children.empty()) {
        std::unique_ptr<Piece> child = Draft::take(*cell.children.front());
        const bool inLine =
            !child->isElement() || draft_.isInlined(*child) || draft_.of(*child).kind == Kind::unit;
        if (!inLine || paragraph.empty()) {
            line = nullptr;
            content.push_back(std::move(child));
            continue;
        }
        if (line == nullptr) {
            content.push_back(Draft::made(paragraph));
            line = content.back().get();
        }
        child->gap = {};
        Draft::put(*line, line->children.size(), std::move(child));
    }
    return content;
}

// The first cell reaches over all of them and has their content.
QString TableDraft::join() {
    const CellRect all = rect();
    const std::vector<GridCell> cells = nodes_->cellsIn(all);
    if (cells.size() < 2)
        return QStringLiteral("Select several cells of the table first.");
    if (all.rows() > document::mostSpanned || all.columns() > document::mostSpanned)
        return QStringLiteral("A cell reaches over 100 rows and columns at most.");
    const GridCell& first = cells.front();
    if (first.row != all.top || first.column != all.left)
        return heldTogether;
    Piece& target = piece(first);
    for (Piece* mark : {&draft_.second(), &draft_.first()})
        Draft::moveTo(*mark, *target.parent, target.index() + 1);
    std::vector<Piece*> filled;
    for (const GridCell& cell : cells)
        if (!draft_.isBlank(piece(cell)))
            filled.push_back(&piece(cell));
    if (filled.size() == 1 && filled.front() != &target) {
        target.children.clear();
        while (!filled.front()->children.empty())
            Draft::moveTo(*filled.front()->children.front(), target, target.children.size());
        target.tail = {};
    } else if (filled.size() > 1) {
        Pieces content;
        for (Piece* cell : filled)
            for (std::unique_ptr<Piece>& one : contentOf(*cell))
                content.push_back(std::move(one));
        target.children.clear();
        for (std::unique_ptr<Piece>& one : content)
            Draft::put(target, target.children.size(), std::move(one));
    }
    setSpan(first, {all.columns(), all.rows()});
    goTo(target);
    for (std::size_t i = 1; i < cells.size(); ++i)
        Draft::take(draft_.opened(nodes_->node(cells[i])));
    return {};
}

QString TableDraft::split() {
    const std::vector<GridCell> cells = nodes_->cellsIn(rect());
    bool any = false;
    for (const GridCell& cell : cells) {
        if (cell.span == document::Span{})
            continue;
        any = true;
        for (std::size_t r = cell.row; r <= cell.lastRow(); ++r) {
            const std::size_t from = cell.column + (r == cell.row ? 1 : 0);
            for (std::size_t c = from; c <= cell.lastColumn(); ++c)
                Draft::put(row(r), indexIn(r, cell.lastColumn() + 1), emptyCell());
        }
        setSpan(cell, {});
    }
    return any ? QString() : QStringLiteral("This cell was not joined of several.");
}

std::set<NodeId> TableDraft::unselected() const {
    std::set<NodeId> cells;
    if (!nodes_ || !nodes_->isSeveral)
        return cells;
    for (const std::vector<NodeId>& row : nodes_->cells)
        cells.insert(row.begin(), row.end());
    for (const GridCell& cell : nodes_->cellsIn(rect()))
        cells.erase(nodes_->node(cell));
    return cells;
}

bool TableDraft::clear() {
    if (!nodes_ || !nodes_->isSeveral)
        return false;
    const std::vector<GridCell> cells = nodes_->cellsIn(rect());
    Piece& target = piece(cells.front());
    for (Piece* mark : {&draft_.second(), &draft_.first()})
        Draft::moveTo(*mark, *target.parent, target.index() + 1);
    for (const GridCell& cell : cells) {
        Piece& cleared = piece(cell);
        cleared.children.clear();
        cleared.tail = {};
        if (draft_.holdsText(cleared))
            Draft::put(cleared, 0, Draft::madeText({}));
    }
    goTo(target);
    return true;
}

// --- the look ----------------------------------------------------------------------------------

bool TableDraft::isHeader(std::size_t row) const {
    return nodes_->isHeader(draft_.tree(), draft_.grammar(), row);
}

// The first rows of a table are its header, as far as somebody wants.
QString TableDraft::toggleHeader() {
    const bool on = !isHeader(rect().bottom);
    const std::string name = row(0).name;
    if (!draft_.grammar().hasAttribute(name, "KIND"))
        return QStringLiteral("This class of documents has no headers of tables.");
    const std::size_t from = on ? 0 : rect().top;
    const std::size_t end = on ? rect().bottom + 1 : nodes_->rows.size();
    for (std::size_t r = from; r < end && (on || isHeader(r)); ++r) {
        const bool isSo = r == 0 && draft_.grammar().of(name).isHeaderFirst;
        draft_.setAttribute(row(r), "KIND", on == isSo ? "" : on ? "header" : "body");
    }
    return {};
}

std::vector<std::string> TableDraft::widths() const { return nodes_->widths(draft_.tree()); }

void TableDraft::writeWidths(std::vector<std::string> widths) {
    draft_.setAttribute(draft_.opened(nodes_->table), "WIDTHS",
                        spelledWidths(std::move(widths), {}));
}

QString TableDraft::setWidths(const std::vector<double>& widths) {
    if (!draft_.grammar().hasAttribute(draft_.tree().name(nodes_->table), "WIDTHS"))
        return QStringLiteral("Columns of this class of documents have no widths of their own.");
    draft_.setAttribute(draft_.opened(nodes_->table), "WIDTHS",
                        spelledWidths(this->widths(), widths));
    return {};
}

QString TableDraft::setWidth(double width) {
    std::vector<double> widths(rect().right + 1, -1);
    for (std::size_t c = rect().left; c <= rect().right; ++c)
        widths[c] = width;
    return setWidths(widths);
}

// --- the way through the table -----------------------------------------------------------------

QString TableDraft::goToCell(Direction direction) {
    const CellRect from = rect();
    std::vector<GridCell> all;
    for (std::size_t r = 0; r < nodes_->rows.size(); ++r)
        all.insert(all.end(), nodes_->grid.row(r).begin(), nodes_->grid.row(r).end());
    const bool isForward = direction == Direction::forward;
    const auto own = std::find_if(all.begin(), all.end(), [&](const GridCell& cell) {
        return cell.row == from.top && cell.column == from.left;
    });
    if (isForward && own + 1 == all.end()) {
        nodes_->selected.left = nodes_->selected.right = 0;
        return insertRow(Direction::forward);
    }
    if (!isForward && own == all.begin())
        return QStringLiteral("This is the first cell.");
    goTo(piece(isForward ? *(own + 1) : *(own - 1)));
    return {};
}

QString TableDraft::select(TablePart part) {
    CellRect chosen = rect();
    if (part == TablePart::row || part == TablePart::table) {
        chosen.left = 0;
        chosen.right = nodes_->grid.columns() - 1;
    }
    if (part == TablePart::column || part == TablePart::table) {
        chosen.top = 0;
        chosen.bottom = nodes_->rows.size() - 1;
    }
    const std::vector<GridCell> cells = nodes_->cellsIn(nodes_->grown(chosen));
    const GridCell* last = &cells.front();
    for (const GridCell& cell : cells)
        if (cell.lastRow() + cell.lastColumn() >= last->lastRow() + last->lastColumn())
            last = &cell;
    goTo(piece(*last), draft_.caret(), true);
    goTo(piece(cells.front()), draft_.anchor(), false);
    return {};
}

} // namespace authoring
