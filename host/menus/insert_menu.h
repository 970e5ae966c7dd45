// The menu Insert: what comes in at the caret.
#pragma once

#include "menus/command_menu.h"
#include "menus/value_dialog.h"

namespace menus {

class InsertMenu : public CommandMenu {
    Q_OBJECT

public:
    // With the entry `insertTable` of one menu, and all of another.
    InsertMenu(view::DocumentView& view, const CommandMenu& tables, QMenu& images,
               QWidget* parent = nullptr);

    // Entries for what is at a place of the screen.
    void addTo(QMenu& menu, const QPoint& at);

private:
    void ask(sgml::NodeId element, schemas::Display as);
    void addCaption();
    [[nodiscard]] std::optional<std::size_t> chosenFigureEnd() const; // within its element
    void askForLink();
    void askForReference(sgml::NodeId element); // noNode: a new one
    void askForFormula(sgml::NodeId element);   // noNode: a new one
    void askForValue(sgml::NodeId element);     // the same
    struct ChosenValue {
        sgml::NodeId figure = sgml::noNode;
        document::ValueUse use;
    };
    [[nodiscard]] std::vector<ValuedFigure> figures();
    [[nodiscard]] std::optional<ChosenValue>
    chosenValue(std::vector<ValuedFigure> figures, const document::ValueUse& now, QWidget* parent);
};

} // namespace menus
