// The menu Edit of a window, and the menu at the pointer over text.
#pragma once

#include <QMenu>

#include <functional>
#include <vector>

namespace panes {
class FindBar;
}

namespace view {
class DocumentView;
}

namespace window {

class EditMenu : public QMenu {
    Q_OBJECT

public:
    // Both outlive it.
    EditMenu(view::DocumentView& view, panes::FindBar& find, QWidget* parent);

    // The switch between reading and writing, for the tool bar, too.
    [[nodiscard]] QAction& write() const { return *write_; }
    void showAt(const QPoint& at);
    // One more menu at the pointer, where it is of use.
    void offerAtPointer(QMenu& menu, std::function<bool()> isOfUse);

Q_SIGNALS:
    // Others put entries before these.
    void aboutToShowAt(QMenu& menu, const QPoint& at);

private:
    void addFinding(panes::FindBar& find);
    void addSigns();
    void undo();
    void redo();
    void updateUndo();
    void updateSelection();

    view::DocumentView& view_;
    std::vector<std::pair<QMenu*, std::function<bool()>>> atPointer_;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* cut_ = nullptr;
    QAction* copy_ = nullptr;
    QAction* paste_ = nullptr;
    QAction* selectAll_ = nullptr;
    QAction* write_ = nullptr;
    QAction* replace_ = nullptr;
};

} // namespace window
