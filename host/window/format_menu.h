// The menu Format: what the selected text is. Its commands are there while a view is written in;
// the open menu offers those that are allowed at the caret, and says of the others why they are
// not.
#pragma once

#include "view/writing.h"

#include <QMenu>

namespace view {
class DocumentView;
}

namespace window {

class FormatMenu : public QMenu {
    Q_OBJECT

public:
    explicit FormatMenu(view::DocumentView& view, QWidget* parent = nullptr);

private:
    struct Entry {
        QAction* action = nullptr;
        view::Writing::Command command;
        schemas::ContainerRole role = schemas::ContainerRole::none; // it is checked in one
    };
    void add(const QString& name, const QString& text, const QKeySequence& keys,
             view::Writing::Command command,
             schemas::ContainerRole role = schemas::ContainerRole::none);
    void addList(const QString& name, const QString& text, const QKeySequence& keys,
                 bool isNumbered);
    void offer();
    void offerAll();
    void askForLink();

    view::DocumentView& view_;
    std::vector<Entry> entries_;
    QAction* link_ = nullptr;
};

} // namespace window
