#include "controls/keyboard.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>

namespace controls {

// Alt and a letter give it to the menu bar while a menu is open.
QWidget* keyboardWidget() {
    static QPointer<QWidget> last;
    static const auto follow =
        QObject::connect(qApp, &QApplication::focusChanged, qApp, [](QWidget*, QWidget* now) {
            if (now && !qobject_cast<QMenuBar*>(now) && !qobject_cast<QMenu*>(now))
                last = now;
        });
    QWidget* now = QApplication::focusWidget();
    const bool isMenu = qobject_cast<QMenuBar*>(now) || qobject_cast<QMenu*>(now);
    return isMenu ? last.data() : now;
}

} // namespace controls
