#include "accessibility/accessible_table.h"

#include "accessibility/accessible_view.h"
#include "reading/block_text.h"

#include <algorithm>

namespace accessibility {

using reading::Part;

// --- a table -----------------------------------------------------------------------------------

void* AccessibleTable::interface_cast(QAccessible::InterfaceType type) {
    if (type == QAccessible::TableInterface)
        return static_cast<QAccessibleTableInterface*>(this);
    return AccessiblePart::interface_cast(type);
}

// It stands beside the table.
QAccessibleInterface* AccessibleTable::caption() const {
    for (const std::unique_ptr<Part>& beside : part().parent->parts)
        if (beside->role == schemas::ContainerRole::caption)
            return of(root(), *beside);
    return nullptr;
}

QAccessibleInterface* AccessibleTable::cellAt(int row, int column) const {
    if (row < 0 || column < 0)
        return nullptr;
    Part* cell = root().tree().cellAt(part(), static_cast<std::size_t>(row),
                                      static_cast<std::size_t>(column));
    return cell ? of(root(), *cell) : nullptr;
}

QString AccessibleTable::columnDescription(int column) const {
    const QAccessibleInterface* cell = part().block->headerRows > 0 ? cellAt(0, column) : nullptr;
    return cell ? cell->text(QAccessible::Name) : QString();
}

int AccessibleTable::columnCount() const {
    std::size_t count = 0;
    for (const std::unique_ptr<Part>& cell : parts())
        count = std::max(count, cell->place.lastColumn() + 1);
    return static_cast<int>(count);
}

int AccessibleTable::rowCount() const { return static_cast<int>(part().block->rows.size()); }

// --- a cell ------------------------------------------------------------------------------------

void* AccessibleCell::interface_cast(QAccessible::InterfaceType type) {
    if (type == QAccessible::TableCellInterface)
        return static_cast<QAccessibleTableCellInterface*>(this);
    return AccessiblePart::interface_cast(type);
}

QList<QAccessibleInterface*> AccessibleCell::columnHeaderCells() const {
    QList<QAccessibleInterface*> headers;
    const std::size_t rows = std::min(part().block->headerRows, part().place.row);
    for (std::size_t row = 0; row < rows; ++row)
        if (Part* cell = root().tree().cellAt(*part().parent, row, part().place.column))
            headers.push_back(of(root(), *cell));
    return headers;
}

int AccessibleCell::columnIndex() const { return static_cast<int>(part().place.column); }
int AccessibleCell::rowIndex() const { return static_cast<int>(part().place.row); }
int AccessibleCell::columnExtent() const { return static_cast<int>(part().place.span.columns); }
int AccessibleCell::rowExtent() const { return static_cast<int>(part().place.span.rows); }

QAccessibleInterface* AccessibleCell::table() const { return parent(); }

} // namespace accessibility
