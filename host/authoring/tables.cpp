// Tables: their rows and columns, and the way from cell to cell.
#include "authoring/commands.h"

#include <algorithm>

namespace authoring {

using schemas::Display;

namespace {

// The table around the caret, taken apart into rows and cells.
class Table {
public:
    explicit Table(Draft& draft) : draft_(draft) {
        for (Piece* at = draft.first().parent; at != nullptr && row_ == nullptr; at = at->parent) {
            const Display display = draft.of(*at).display;
            if (display == Display::cell && cell_ == nullptr)
                cell_ = at;
            else if (display == Display::row && cell_ != nullptr)
                row_ = at;
        }
        if (row_ == nullptr || row_->parent == nullptr)
            return;
        draft.openChildren(*row_->parent);
        for (const auto& child : row_->parent->children)
            if (child->isElement() && draft.of(*child).display == Display::row) {
                draft.openChildren(*child);
                rows_.push_back(child.get());
            }
        const std::vector<Piece*> own = cells(*row_);
        column_ = static_cast<std::size_t>(std::find(own.begin(), own.end(), cell_) - own.begin());
    }

    [[nodiscard]] bool isThere() const { return !rows_.empty(); }

    QString insertRow(Direction side) {
        Piece& made =
            Draft::put(*row_->parent, row_->index() + (side == Direction::forward ? 1 : 0),
                       Draft::made(row_->name));
        draft_.putOnLine(made, *row_);
        for (std::size_t i = 0; i < cells(*row_).size(); ++i)
            Draft::put(made, i, emptyCell());
        goTo(*cells(made)[std::min(column_, cells(made).size() - 1)]);
        return {};
    }

    QString insertColumn(Direction side) {
        Piece* to = nullptr;
        for (Piece* row : rows_) {
            const std::vector<Piece*> all = cells(*row);
            std::size_t index = row->children.size();
            if (column_ < all.size())
                index = all[column_]->index() + (side == Direction::forward ? 1 : 0);
            Piece& made = Draft::put(*row, index, emptyCell());
            if (row == row_)
                to = &made;
        }
        goTo(*to);
        return {};
    }

    QString removeRow() {
        if (rows_.size() == 1)
            return QStringLiteral("This is the only row. Erase the table instead.");
        const auto at = std::find(rows_.begin(), rows_.end(), row_);
        Piece& next = at + 1 == rows_.end() ? **(at - 1) : **(at + 1);
        const std::vector<Piece*> all = cells(next);
        if (all.empty())
            return QStringLiteral("The row beside it has no cells.");
        goTo(*all[std::min(column_, all.size() - 1)]);
        Draft::take(*row_);
        return {};
    }

    QString removeColumn() {
        const std::vector<Piece*> own = cells(*row_);
        if (own.size() == 1)
            return QStringLiteral("This is the only column. Erase the table instead.");
        goTo(*own[column_ + 1 == own.size() ? column_ - 1 : column_ + 1]);
        for (Piece* row : rows_)
            if (const std::vector<Piece*> all = cells(*row); column_ < all.size())
                Draft::take(*all[column_]);
        return {};
    }

    // Behind the last cell a new row begins.
    QString goToCell(Direction direction) {
        std::vector<Piece*> all;
        for (Piece* row : rows_)
            for (Piece* cell : cells(*row))
                all.push_back(cell);
        const auto at = std::find(all.begin(), all.end(), cell_);
        if (direction == Direction::forward && at + 1 == all.end()) {
            column_ = 0;
            return insertRow(Direction::forward);
        }
        if (direction == Direction::backward && at == all.begin())
            return QStringLiteral("This is the first cell.");
        goTo(direction == Direction::forward ? **(at + 1) : **(at - 1));
        return {};
    }

private:
    [[nodiscard]] std::vector<Piece*> cells(Piece& row) const {
        std::vector<Piece*> found;
        for (const auto& child : row.children)
            if (child->isElement() && draft_.of(*child).display == Display::cell)
                found.push_back(child.get());
        return found;
    }
    [[nodiscard]] std::unique_ptr<Piece> emptyCell() const {
        std::unique_ptr<Piece> cell = Draft::made(cell_->name);
        if (draft_.holdsText(*cell_))
            Draft::put(*cell, 0, Draft::madeText({}));
        return cell;
    }
    void goTo(Piece& cell) {
        Piece* into = &cell;
        draft_.openChildren(*into);
        while (!into->children.empty() && into->children.front()->isElement() &&
               !draft_.isUnit(*into->children.front())) {
            into = into->children.front().get();
            draft_.openChildren(*into);
        }
        Draft::moveTo(draft_.first(), *into, 0);
        draft_.collapse();
    }

    Draft& draft_;
    Piece *cell_ = nullptr, *row_ = nullptr; // around the caret
    std::vector<Piece*> rows_;
    std::size_t column_ = 0;
};

Result changeTable(const Manuscript& manuscript, Selection selection, const QString& label,
                   const std::function<QString(Table&)>& change) {
    Draft draft(manuscript, {selection.caret, selection.caret});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    Table table(draft);
    if (!table.isThere())
        return refused(QStringLiteral("The caret is in no table."));
    if (const QString why = change(table); !why.isEmpty())
        return refused(why);
    return draft.result(label);
}

} // namespace

Result insertRow(const Manuscript& manuscript, Selection selection, Direction side) {
    return changeTable(manuscript, selection, QStringLiteral("Insert Row"),
                       [side](Table& table) { return table.insertRow(side); });
}

Result insertColumn(const Manuscript& manuscript, Selection selection, Direction side) {
    return changeTable(manuscript, selection, QStringLiteral("Insert Column"),
                       [side](Table& table) { return table.insertColumn(side); });
}

Result removeRow(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Remove Row"),
                       [](Table& table) { return table.removeRow(); });
}

Result removeColumn(const Manuscript& manuscript, Selection selection) {
    return changeTable(manuscript, selection, QStringLiteral("Remove Column"),
                       [](Table& table) { return table.removeColumn(); });
}

Result goToCell(const Manuscript& manuscript, Selection selection, Direction direction) {
    return changeTable(manuscript, selection, QStringLiteral("Insert Row"),
                       [direction](Table& table) { return table.goToCell(direction); });
}

Result insertTable(const Manuscript& manuscript, Selection selection, int rows, int columns) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string table(draft.grammar().named(Display::table)),
        row(draft.grammar().named(Display::row)), cell(draft.grammar().named(Display::cell));
    if (table.empty() || row.empty() || cell.empty())
        return refused(QStringLiteral("This class of documents has no tables."));
    Piece* made = putBlock(draft, draft.first(), Draft::made(table));
    if (made == nullptr)
        return refused(QStringLiteral("A table may not stand here."));
    for (int i = 0; i < std::max(rows, 1); ++i) {
        Piece& line = Draft::put(*made, made->children.size(), Draft::made(row));
        line.gap.fresh = "\n";
        for (int j = 0; j < std::max(columns, 1); ++j)
            Draft::put(Draft::put(line, line.children.size(), Draft::made(cell)), 0,
                       Draft::madeText({}));
    }
    made->tail.fresh = "\n";
    Draft::moveTo(draft.first(), *made->children.front()->children.front(), 0);
    draft.collapse();
    return draft.result(QStringLiteral("Table"));
}

} // namespace authoring
