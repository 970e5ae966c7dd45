#include "menus/actions.h"

#include "plain/plain.h"
#include "view/icons.h"

namespace menus {

QAction* addTo(QMenu& menu, const QString& name, const QString& text, const QKeySequence& keys,
               const std::function<void()>& done, const QString& icon) {
    QAction* action = menu.addAction(plain::ours(text), &menu, done);
    action->setObjectName(name);
    action->setShortcut(keys);
    if (!icon.isEmpty())
        action->setIcon(view::iconNamed(icon));
    action->setIconVisibleInMenu(false);
    return action;
}

} // namespace menus
