#include "frame/session_actions.h"

#include "plain/plain.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
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

QAction* withKey(const QMenu& menu, const QKeySequence& key) {
    for (QAction* action : menu.actions())
        if (action->shortcuts().contains(key))
            return action;
    return nullptr;
}

// Entries of a menu before the ones that it has.
class Inserted {
public:
    Inserted(QMainWindow& window, QMenu& menu, QAction* before)
        : window_(window), menu_(menu), before_(before) {}

    QAction* add(const QString& label, const QKeySequence& key, const std::function<void()>& does) {
        auto* action = new QAction(plain::ours(label), &window_);
        action->setShortcut(key);
        QObject::connect(action, &QAction::triggered, &window_, does);
        menu_.insertAction(before_, action);
        return action;
    }
    void add(QAction* action) { menu_.insertAction(before_, action); }
    void add(QMenu* menu) { menu_.insertMenu(before_, menu); }
    void separate() { menu_.insertSeparator(before_); }

private:
    QMainWindow& window_;
    QMenu& menu_;
    QAction* before_;
};

void addFileActions(QMainWindow& window, QMenu& file, const Session& session) {
    QAction* ownSave = withKey(file, QKeySequence::Save); // which saves what the window holds, too
    if (ownSave)
        file.removeAction(ownSave);
    Inserted first(window, file, file.actions().value(0));
    first.add(QObject::tr("&New Scene"), QKeySequence::New, session.newScene)
        ->setObjectName("newScene");
    first.add(QObject::tr("&Open…"), QKeySequence::Open, session.open)->setObjectName("open");
    auto* recent = new QMenu(QObject::tr("Open &Recent"), &file);
    session.fillRecent(recent);
    first.add(recent);
    if (session.firstPage)
        first.add(QObject::tr("S&amples…"), {}, session.firstPage);
    first.separate();
    if (ownSave)
        first.add(ownSave);
    else
        first.add(QObject::tr("&Save"), QKeySequence::Save, session.save)->setObjectName("save");
    first.add(QObject::tr("Save &As…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
              session.saveAs);
    first.add(QObject::tr("&Export…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E),
              session.exports);
    first.separate();
}

// Escape in a menu leaves the bar, too; Qt's bar would keep the keyboard, and take the letters that
// are typed next for its menus.
class EscapeLeaves : public QObject {
public:
    explicit EscapeLeaves(QMenuBar& bar) : QObject(&bar), bar_(bar) {
        for (QAction* one : bar.actions())
            if (one->menu())
                one->menu()->installEventFilter(this);
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::KeyPress ||
            static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
            return false;
        static_cast<QMenu*>(watched)->close();
        if (bar_.hasFocus()) { // the menu was opened by keys
            QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
            QCoreApplication::sendEvent(&bar_, &escape);
        }
        return true;
    }

private:
    QMenuBar& bar_;
};

} // namespace

void addSessionActions(QMainWindow& window, const Session& session) {
    QMenu* file = fileMenuOf(window);
    if (session.quit)
        addFileActions(window, *file, session);
    if (!withKey(*file, QKeySequence(Qt::CTRL | Qt::Key_W)))
        file->addAction(QObject::tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), &window,
                        &QWidget::close);
    new EscapeLeaves(*window.menuBar());
    if (session.quit)
        file->addAction(QObject::tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), &window,
                        session.quit);
}

void closeByEscape(QMainWindow& window) {
    auto* close = new QAction(&window);
    close->setShortcut(QKeySequence(Qt::Key_Escape));
    QObject::connect(close, &QAction::triggered, &window, &QWidget::close);
    window.addAction(close);
}

} // namespace views
