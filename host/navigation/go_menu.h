// The menu Go: to where one came from, and to a page.
#pragma once

#include "navigation/history.h"

#include <QMenu>

namespace navigation {

class GoMenu : public QMenu {
    Q_OBJECT

public:
    // The view outlives it.
    explicit GoMenu(view::DocumentView& view, QWidget* parent = nullptr);

    [[nodiscard]] History& history() { return history_; }
    [[nodiscard]] QAction* back() const { return back_; }
    [[nodiscard]] QAction* forward() const { return forward_; }

private:
    void askForPage();

    view::DocumentView& view_;
    History history_;
    QAction* back_;
    QAction* forward_;
};

} // namespace navigation
