#include "menus/command_menu.h"

#include "menus/actions.h"
#include "plain/plain.h"
#include "view/document_view.h"

#include <QTimer>

namespace menus {

CommandMenu::CommandMenu(const QString& title, view::DocumentView& view, QWidget* parent)
    : QMenu(title, parent), view_(view) {
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &CommandMenu::offer);
    // Not before the entry that is being chosen has done its work.
    connect(this, &QMenu::aboutToHide, this, [this] {
        if (view_.chosen())
            QTimer::singleShot(0, this, &CommandMenu::offerAll);
        else
            offerAll();
    });
    connect(&view_, &view::DocumentView::writingChanged, this, &CommandMenu::offerAll);
    connect(&view_, &view::DocumentView::chosenChanged, this, &CommandMenu::offerAll);
    offerAll();
}

QAction* CommandMenu::append(const QString& name, const QString& text, const QKeySequence& keys,
                             Entry entry, const std::function<void()>& done) {
    entry.action = addTo(*this, name, text, keys, done);
    entry.action->setCheckable(entry.role != Role::none);
    entries_.push_back(std::move(entry));
    offerAll();
    return entries_.back().action;
}

QAction* CommandMenu::add(const QString& name, const QString& text, const QKeySequence& keys,
                          Command command, Role role) {
    const auto whyNot = [this, command] { return this->whyNot(command); };
    const auto done = [this, command = std::move(command)] { perform(command); };
    return append(name, text, keys, {nullptr, whyNot, role}, done);
}

// A command that is not allowed says why, and asks nothing.
QAction* CommandMenu::addAsking(const QString& name, const QString& text, const QKeySequence& keys,
                                Command probe, std::function<void()> ask) {
    const auto whyNot = [this, probe] { return this->whyNot(probe); };
    const auto done = [this, probe = std::move(probe), ask = std::move(ask)] {
        if (this->whyNot(probe).isEmpty())
            ask();
        else
            perform(probe);
    };
    return append(name, text, keys, {nullptr, whyNot}, done);
}

QAction* CommandMenu::addToggle(const QString& name, const QString& text, const QKeySequence& keys,
                                Role role) {
    const auto whyNot = [this, role] {
        return view_.chosen() ? tr("A figure is chosen, and no letters.")
                              : view_.writing().whyNotToggled(role);
    };
    return append(name, text, keys, {nullptr, whyNot, role},
                  [this, role] { view_.writing().toggle(role); });
}

bool CommandMenu::perform(const Command& command) {
    view_.chosenFigure().standBehind();
    return view_.writing().perform(command);
}

QString CommandMenu::whyNot(const Command& command) const {
    const auto at = view_.chosenFigure().behind();
    if (!at)
        return view_.writing().whyNot(command);
    const authoring::Result result = command(view_.writing().manuscript(), *at);
    const auto* refusal = std::get_if<authoring::Refusal>(&result);
    return refusal ? refusal->why : QString();
}

void CommandMenu::offerAll() {
    const bool writes = view_.isWriting() && !view_.chosen();
    menuAction()->setVisible(view_.isWriting());
    for (const Entry& entry : entries_) {
        entry.action->setEnabled(writes);
        entry.action->setToolTip(plain::tip({}));
    }
}

void CommandMenu::offer() {
    for (const Entry& entry : entries_) {
        const QString why = entry.whyNot();
        entry.action->setEnabled(view_.isWriting() && why.isEmpty());
        entry.action->setToolTip(plain::tip(why));
        if (entry.role != Role::none)
            entry.action->setChecked(view_.writing().isMarked(entry.role));
    }
}

} // namespace menus
