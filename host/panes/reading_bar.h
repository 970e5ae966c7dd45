// A bar below the pages of a view for reading, when somebody tries to write there: that the
// document is open for reading, and a button that begins to write. It is shown once as long as the
// view is for reading; who closes it is asked no more.
#pragma once

#include <QAction>
#include <QFrame>

namespace view {
class DocumentView;
}

namespace panes {

class ReadingBar : public QFrame {
    Q_OBJECT

public:
    // `write` is the menu's entry that begins to write.
    ReadingBar(view::DocumentView& view, QAction& write, QWidget* parent);

private:
    void offer();

    view::DocumentView& view_;
    bool isClosed_ = false;
};

} // namespace panes
