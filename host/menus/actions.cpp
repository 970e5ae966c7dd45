#include "menus/actions.h"

#include "controls/icons.h"
#include "plain/plain.h"

namespace menus {

QAction* addTo(QMenu& menu, const QString& name, const QString& text, const QKeySequence& keys,
               const std::function<void()>& done, const QString& icon) {
    QAction* action = menu.addAction(plain::ours(text), &menu, done);
    action->setObjectName(name);
    action->setShortcut(keys);
    if (!icon.isEmpty())
        action->setIcon(controls::iconNamed(icon));
    action->setIconVisibleInMenu(false);
    return action;
}

} // namespace menus
