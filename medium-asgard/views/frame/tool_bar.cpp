#include "frame/tool_bar.h"

#include "plain/plain.h"

#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

namespace views {

namespace {

// "Undo Drag (Ctrl+Z)"
QString tipOf(const QAction& command) {
    const QString label = command.text().remove('&').remove(QStringLiteral("…"));
    const QString key = command.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? label : QStringLiteral("%1 (%2)").arg(label, key);
}

// A command, or the entry that opens a menu.
QAction* namedIn(const QMainWindow& window, const char* name) {
    if (auto* menu = window.menuBar()->findChild<QMenu*>(name))
        return menu->menuAction();
    return window.findChild<QAction*>(name);
}

// The pointer left it for its menu, of which Qt tells nothing when an entry is chosen.
void leave(QToolButton& button) {
    if (button.rect().contains(button.mapFromGlobal(QCursor::pos())))
        return;
    QEvent left(QEvent::Leave);
    QApplication::sendEvent(&button, &left);
    button.setAttribute(Qt::WA_UnderMouse, false);
    button.update();
}

} // namespace

ToolBar::ToolBar(QMainWindow& window) : QToolBar(tr("Tools"), &window), window_(window) {
    setObjectName("tools");
    setIconSize(QSize(22, 22));
    setMovable(true);
    window.addToolBar(this);
}

void ToolBar::add(const char* name, Icon which) {
    QAction* command = namedIn(window_, name);
    if (!command)
        return;
    command->setIcon(icon(which, palette()));
    command->setIconVisibleInMenu(false);
    addAction(command);
    auto* button = qobject_cast<QToolButton*>(widgetForAction(command));
    button->setFocusPolicy(Qt::NoFocus); // the keys stay where one works
    button->setObjectName(QStringLiteral("tool.") + QString::fromLatin1(name));
    if (QMenu* menu = command->menu()) {
        button->setPopupMode(QToolButton::InstantPopup);
        connect(
            menu, &QMenu::aboutToHide, button, [button] { leave(*button); }, Qt::QueuedConnection);
    }
    const auto show = [command] { command->setToolTip(plain::tip(tipOf(*command))); };
    connect(command, &QAction::changed, this, [command, show] {
        if (command->toolTip() != plain::tip(tipOf(*command)))
            show();
    });
    show();
    commands_.emplace_back(command, which);
}

void ToolBar::separate() {
    if (!commands_.empty())
        addSeparator();
}

void ToolBar::changeEvent(QEvent* event) {
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        for (const auto& [command, which] : commands_)
            command->setIcon(icon(which, palette()));
}

} // namespace views
