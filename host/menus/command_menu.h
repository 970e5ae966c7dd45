// A menu of commands of writing. The open menu offers the commands that are allowed at their place
// (Writing::place), and says of the others why they are not; their keys work at any time, and the
// status line says then what the tool tip would. In a view for reading that is that it is for
// reading.
#pragma once

#include "view/writing.h"

#include <QMenu>

namespace view {
class DocumentView;
}

namespace menus {

class CommandMenu : public QMenu {
    Q_OBJECT

public:
    // The view outlives it.
    CommandMenu(const QString& title, view::DocumentView& view, QWidget* parent);

    using Command = view::Writing::Command;
    using Role = schemas::ContainerRole;
    // An entry that does the command. It is checked where all that is selected has the role.
    QAction* add(const QString& name, const QString& text, const QKeySequence& keys,
                 Command command, Role role = Role::none);
    // One that asks first and does then what was wanted. `probe` is a command like it: the entry
    // is offered where this one is allowed.
    QAction* addAsking(const QString& name, const QString& text, const QKeySequence& keys,
                       const Command& probe, const std::function<void()>& ask);

    // The next entry begins to write; it is there in a view for reading.
    void addBeginning();
    // The entry of another menu, of that object name, stands in this one, too.
    void addEntryOf(const CommandMenu& other, const QString& name);
    // Emphasis and the like: on and off.
    QAction* addToggle(const QString& name, const QString& text, const QKeySequence& keys,
                       Role role);

protected:
    [[nodiscard]] view::DocumentView& view() const { return view_; }

private:
    struct Entry {
        QAction* action = nullptr;
        std::function<QString()> whyNot; // "": it is offered
        Role role = Role::none;
    };
    QAction* append(const QString& name, const QString& text, const QKeySequence& keys, Entry entry,
                    const std::function<void()>& done);
    [[nodiscard]] QString whyNot(const Entry& entry) const;
    void offer();
    void offerAll();

    view::DocumentView& view_;
    std::vector<Entry> entries_;
    QList<QAction*> beginning_; // the entry that begins to write, and what parts it from the others
};

} // namespace menus
