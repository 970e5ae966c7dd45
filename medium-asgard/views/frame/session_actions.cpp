#include "frame/session_actions.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace views {

namespace {

QMenu* fileMenuOf(QMainWindow& window) {
    const auto menus = window.menuBar()->actions();
    for (QAction* action : menus)
        if (action->menu() && action->text().remove('&') == QObject::tr("File"))
            return action->menu();
    auto* file = new QMenu(QObject::tr("&File"), &window);
    window.menuBar()->insertMenu(menus.value(0), file);
    return file;
}

bool hasKey(const QMenu& menu, const QKeySequence& key) {
    for (const QAction* action : menu.actions())
        if (action->shortcuts().contains(key))
            return true;
    return false;
}

} // namespace

void addSessionActions(QMainWindow& window, const Session& session) {
    QMenu* file = fileMenuOf(window);
    const QKeySequence close(QKeySequence::Close), quit(Qt::CTRL | Qt::Key_Q);
    if (!hasKey(*file, close) && !hasKey(*file, quit)) // the control panel's end is all's
        file->addAction(QObject::tr("&Close"), close, &window, &QWidget::close);
    if (!session.quit || hasKey(*file, quit))
        return;
    auto* scene = new QAction(QObject::tr("Ne&w Scene"), &window);
    scene->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N));
    QObject::connect(scene, &QAction::triggered, &window, session.newScene);
    file->insertAction(file->actions().value(0), scene);
    file->addAction(QObject::tr("&Quit"), quit, &window, session.quit);
}

void closeByEscape(QMainWindow& window) {
    auto* close = new QAction(&window);
    close->setShortcut(QKeySequence(Qt::Key_Escape));
    QObject::connect(close, &QAction::triggered, &window, &QWidget::close);
    window.addAction(close);
}

} // namespace views
