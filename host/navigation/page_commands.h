// The commands of the menu View that say how pages stand in the window, or alone on the screen.
#pragma once

#include "view/document_view.h"

class QMenu;

namespace navigation {

class PageCommands : public QObject {
    Q_OBJECT

public:
    // The view outlives them, as its window does.
    PageCommands(view::DocumentView& view, QWidget* window);

    void addTo(QMenu& menu);
    void present(); // fills the screen

private:
    view::DocumentView& view_;
    QWidget* window_;
};

} // namespace navigation
