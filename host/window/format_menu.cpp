#include "window/format_menu.h"

#include "plain/plain.h"
#include "view/document_view.h"

#include <QInputDialog>

namespace window {

using authoring::Manuscript, authoring::Selection;
using schemas::ContainerRole;

FormatMenu::FormatMenu(view::DocumentView& view, QWidget* parent)
    : QMenu(tr("F&ormat"), parent), view_(view) {
    setObjectName("format");
    setToolTipsVisible(true);
    const auto toggle = [](ContainerRole role) {
        return
            [role](const Manuscript& in, Selection at) { return authoring::toggle(in, at, role); };
    };
    add("emphasis", tr("&Emphasis"), QKeySequence::Italic, toggle(ContainerRole::emphasis),
        ContainerRole::emphasis);
    add("strong", tr("&Strong"), QKeySequence::Bold, toggle(ContainerRole::strong),
        ContainerRole::strong);
    add("code", tr("&Code"), QKeySequence("Ctrl+Shift+M"), toggle(ContainerRole::code),
        ContainerRole::code);
    addSeparator();
    add("paragraph", tr("&Paragraph"), QKeySequence("Ctrl+Alt+0"), authoring::makeParagraph);
    constexpr int levels = 3;
    for (int level = 1; level <= levels; ++level)
        add(QStringLiteral("heading%1").arg(level), tr("Heading &%1").arg(level),
            QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(level)),
            [level](const Manuscript& in, Selection at) {
                return authoring::makeHeading(in, at, level);
            });
    addSeparator();
    addList("bullets", tr("&Bulleted List"), QKeySequence("Ctrl+Shift+L"), false);
    addList("numbers", tr("&Numbered List"), QKeySequence("Ctrl+Alt+L"), true);
    add("indent", tr("&Into the Item Before"), QKeySequence("Ctrl+]"), authoring::indentItems);
    add("outdent", tr("&Out of the List"), QKeySequence("Ctrl+["), authoring::outdentItems);
    addSeparator();
    link_ = addAction(tr("&Link..."), this, &FormatMenu::askForLink);
    link_->setObjectName("link");
    link_->setShortcut(QKeySequence("Ctrl+K"));
    add("footnote", tr("&Footnote"), QKeySequence("Ctrl+Alt+F"), authoring::insertFootnote);
    connect(this, &QMenu::aboutToShow, this, &FormatMenu::offer);
    connect(this, &QMenu::aboutToHide, this, &FormatMenu::offerAll);
    connect(&view_, &view::DocumentView::writingChanged, this, &FormatMenu::offerAll);
    connect(&view_, &view::DocumentView::chosenChanged, this, &FormatMenu::offerAll);
    offerAll();
}

void FormatMenu::add(const QString& name, const QString& text, const QKeySequence& keys,
                     view::Writing::Command command, ContainerRole role) {
    QAction* action = addAction(plain::ours(text), this, [this, at = entries_.size()] {
        view_.writing().perform(entries_[at].command);
    });
    action->setObjectName(name);
    action->setShortcut(keys);
    action->setCheckable(role != ContainerRole::none);
    entries_.push_back({action, std::move(command), role});
}

// The presentation of a class tells kinds of lists apart by an attribute. LIMIT: the plain one has
// bullets, the first of the others numbers.
void FormatMenu::addList(const QString& name, const QString& text, const QKeySequence& keys,
                         bool isNumbered) {
    add(name, text, keys, [isNumbered](const Manuscript& in, Selection at) -> authoring::Result {
        if (!isNumbered)
            return authoring::makeList(in, at);
        const authoring::Grammar* grammar = in.grammars.of(in.document.className());
        if (grammar)
            for (const auto& [attribute, value] :
                 grammar->variants(grammar->named(ContainerRole::list)))
                return authoring::makeList(in, at, attribute, value);
        return authoring::Refusal{tr("Documents of this class have no numbered lists.")};
    });
}

// Keys work at any time: what is not allowed then says why in the status line.
void FormatMenu::offerAll() {
    const bool writes = view_.isWriting() && !view_.chosen();
    menuAction()->setVisible(view_.isWriting());
    for (const Entry& entry : entries_) {
        entry.action->setEnabled(writes);
        entry.action->setToolTip(plain::tip({}));
    }
    link_->setEnabled(writes);
}

void FormatMenu::offer() {
    for (const Entry& entry : entries_) {
        const QString why = view_.writing().whyNot(entry.command);
        entry.action->setEnabled(entry.action->isEnabled() && why.isEmpty());
        entry.action->setToolTip(plain::tip(why));
        if (entry.role != ContainerRole::none)
            entry.action->setChecked(view_.writing().isMarked(entry.role));
    }
}

// No address: what was a link is none any more.
void FormatMenu::askForLink() {
    bool isGiven = false;
    const QString address =
        QInputDialog::getText(this, tr("Link"), tr("Address of a page, or # and an ID:"),
                              QLineEdit::Normal, {}, &isGiven);
    if (!isGiven)
        return;
    const std::string target = address.trimmed().toStdString();
    view_.writing().perform(
        [&](const Manuscript& in, Selection at) { return authoring::link(in, at, target); });
}

} // namespace window
