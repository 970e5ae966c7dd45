// One entry of a menu, as all menus of a window make them.
#pragma once

#include <QAction>
#include <QMenu>

#include <functional>

namespace menus {

// `name`: of the object; `icon`: a picture of controls/icons.h for tool bars, since menus have
// none.
QAction* addTo(QMenu& menu, const QString& name, const QString& text, const QKeySequence& keys,
               const std::function<void()>& done, const QString& icon = {});

} // namespace menus
