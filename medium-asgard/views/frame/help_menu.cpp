#include "frame/help_menu.h"

#include "frame/help_page.h"
#include "frame/manual.h"

#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <utility>

namespace views {

namespace {

// Of the thing under the pointer; with the pointer elsewhere, of the one that has the keyboard.
QString topicAt(const QMainWindow& window, const std::function<QString(const QWidget&)>& pointed) {
    const QWidget* under = QApplication::widgetAt(QCursor::pos());
    if (under && (under == &window || window.isAncestorOf(under))) {
        const QString exactly = pointed ? pointed(*under) : QString();
        return exactly.isEmpty() ? helpOf(under) : exactly;
    }
    const QWidget* focused = QApplication::focusWidget();
    return helpOf(focused && window.isAncestorOf(focused) ? focused : &window);
}

} // namespace

QMenu* addHelpMenu(QMainWindow* window, const QString& topic,
                   std::function<QString(const QWidget&)> pointed) {
    setHelp(*window, topic);
    QMenu* help = window->menuBar()->addMenu(QObject::tr("&Help"));
    QAction* what = help->addAction(
        QObject::tr("&What Is This?"), QKeySequence(Qt::Key_F1), window,
        [window, pointed = std::move(pointed)] { showHelp(topicAt(*window, pointed)); });
    what->setObjectName("help");
    help->addAction(QObject::tr("&Manual"), window, [] { showManual(); });
    help->addAction(QObject::tr("&About Asgard"), window, [window] { showAbout(window); });
    return help;
}

} // namespace views
