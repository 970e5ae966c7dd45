#include "menus/command_menu.h"

#include "menus/actions.h"
#include "plain/plain.h"
#include "view/document_view.h"

namespace menus {

CommandMenu::CommandMenu(const QString& title, view::DocumentView& view, QWidget* parent)
    : QMenu(title, parent), view_(view) {
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &CommandMenu::offer);
    connect(this, &QMenu::aboutToHide, this, &CommandMenu::offerAll);
    connect(&view_, &view::DocumentView::writingChanged, this, &CommandMenu::offerAll);
    offerAll();
}

QAction* CommandMenu::append(const QString& name, const QString& text, const QKeySequence& keys,
                             Entry entry, const std::function<void()>& done) {
    const auto guarded = [this, entry, done] {
        const QString why = whyNot(entry);
        if (why.isEmpty())
            return done();
        Q_EMIT view_.writing().refused(why);
        if (!view_.isWriting())
            Q_EMIT view_.triedToWrite();
    };
    entry.action = addTo(*this, name, text, keys, guarded);
    entry.action->setCheckable(entry.role != Role::none);
    entries_.push_back(std::move(entry));
    offerAll();
    return entries_.back().action;
}

QAction* CommandMenu::add(const QString& name, const QString& text, const QKeySequence& keys,
                          Command command, Role role) {
    const auto whyNot = [this, command] { return view_.writing().whyUseless(command); };
    const auto done = [this, command = std::move(command)] { view_.writing().perform(command); };
    return append(name, text, keys, {nullptr, whyNot, role}, done);
}

QAction* CommandMenu::addAsking(const QString& name, const QString& text, const QKeySequence& keys,
                                const Command& probe, const std::function<void()>& ask) {
    const auto whyNot = [this, probe] { return view_.writing().whyNot(probe); };
    return append(name, text, keys, {nullptr, whyNot}, ask);
}

void CommandMenu::addEntryOf(const CommandMenu& other, const QString& name) {
    for (const Entry& entry : other.entries_)
        if (entry.action->objectName() == name) {
            addAction(entry.action);
            entries_.push_back(entry);
        }
}

QAction* CommandMenu::addToggle(const QString& name, const QString& text, const QKeySequence& keys,
                                Role role) {
    const auto whyNot = [this, role] { return view_.writing().whyNotToggled(role); };
    return append(name, text, keys, {nullptr, whyNot, role},
                  [this, role] { view_.writing().toggle(role); });
}

void CommandMenu::addBeginning() {
    QAction* begin =
        addTo(*this, "beginWriting", tr("&Write in This Document") + "\tCtrl+E", {}, [this] {
            view_.setWriting(true);
            view_.setFocus();
        });
    beginning_ = {begin, addSeparator()};
    offerAll();
}

QString CommandMenu::whyNot(const Entry& entry) const {
    return view_.isWriting() ? entry.whyNot()
                             : tr("This document is open for reading. Edit > Write (Ctrl+E) lets "
                                  "you change it.");
}

void CommandMenu::offerAll() {
    for (QAction* one : beginning_)
        one->setVisible(!view_.isWriting());
    for (const Entry& entry : entries_) {
        entry.action->setEnabled(true);
        entry.action->setToolTip(plain::tip({}));
    }
}

void CommandMenu::offer() {
    for (const Entry& entry : entries_) {
        const QString why = whyNot(entry);
        entry.action->setEnabled(why.isEmpty());
        entry.action->setToolTip(plain::tip(why));
        if (entry.role != Role::none)
            entry.action->setChecked(view_.writing().isMarked(entry.role));
    }
}

} // namespace menus
