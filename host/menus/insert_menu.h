// The menu Insert: what comes in at the caret.
#pragma once

#include "menus/command_menu.h"

namespace menus {

class InsertMenu : public CommandMenu {
    Q_OBJECT

public:
    explicit InsertMenu(view::DocumentView& view, QWidget* parent = nullptr);

private:
    void askForLink();
    void askForReference();
    [[nodiscard]] sgml::NodeId selectedFormula() const; // noNode: none is selected alone
    void askForFormula(sgml::NodeId element);           // noNode: a new one
};

} // namespace menus
