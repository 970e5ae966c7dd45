// The menu Format: what the selected text is.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class FormatMenu : public CommandMenu {
    Q_OBJECT

public:
    explicit FormatMenu(view::DocumentView& view, QWidget* parent = nullptr);

private:
    void addList(const QString& name, const QString& text, const QKeySequence& keys,
                 bool isNumbered);
};

} // namespace menus
