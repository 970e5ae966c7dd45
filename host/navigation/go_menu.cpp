#include "navigation/go_menu.h"

#include "menus/actions.h"

#include <QInputDialog>

namespace navigation {

GoMenu::GoMenu(view::DocumentView& view, QWidget* parent)
    : QMenu(tr("&Go"), parent), view_(view), history_(view),
      back_(menus::addTo(*this, "goBack", tr("&Back"), QKeySequence(Qt::ALT | Qt::Key_Left),
                         [this] { history_.goBack(); })),
      forward_(menus::addTo(*this, "goForward", tr("&Forward"),
                            QKeySequence(Qt::ALT | Qt::Key_Right),
                            [this] { history_.goForward(); })) {
    setObjectName("go");
    menus::addTo(*this, "goToPage", tr("&Page..."), QKeySequence("Ctrl+G"),
                 [this] { askForPage(); });
    const auto offer = [this] {
        back_->setEnabled(history_.canGoBack());
        forward_->setEnabled(history_.canGoForward());
    };
    connect(&history_, &History::changed, this, offer);
    offer();
}

void GoMenu::askForPage() {
    const auto count = static_cast<int>(view_.pages().pages.size());
    const auto current = static_cast<int>(view_.currentPage()) + 1;
    bool isGiven = false;
    const QString question = tr("Page, from 1 to %1:").arg(count);
    const int page = QInputDialog::getInt(parentWidget(), tr("Go to Page"), question, current, 1,
                                          std::max(1, count), 1, &isGiven);
    if (isGiven)
        view_.goToPage(static_cast<std::size_t>(page - 1));
}

} // namespace navigation
