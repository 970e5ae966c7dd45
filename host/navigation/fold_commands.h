// The commands of the menu View that fold sections of a view, and unfold them.
#pragma once

#include "view/document_view.h"

class QAction;
class QMenu;

namespace navigation {

class FoldCommands : public QObject {
    Q_OBJECT

public:
    // The view outlives them.
    explicit FoldCommands(view::DocumentView& view, QObject* parent);

    void addTo(QMenu& menu);

private:
    void offer();

    view::DocumentView& view_;
    QAction* fold_ = nullptr;
    QAction* unfoldAll_ = nullptr;
};

} // namespace navigation
