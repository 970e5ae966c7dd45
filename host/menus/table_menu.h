// The menu Table: rows, columns and cells of the table around the caret.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class TableMenu : public CommandMenu {
    Q_OBJECT

public:
    explicit TableMenu(view::DocumentView& view, QWidget* parent = nullptr);

    // Is the caret in a table?
    [[nodiscard]] bool isInTable() const;

private:
    void addRowsAndColumns();
    void addCells();
    void addAlignment();
    void checkHeader();
    void askForTable();
    void askForWidth();

    QAction* header_ = nullptr;
};

} // namespace menus
