#include "language/draft_row.h"

#include "editing/changes.h"
#include "language/draft.h"
#include "language/scene_editor.h"
#include "plain/plain.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace views {

DraftRow::DraftRow(SceneDocument& document, Draft& draft, SceneEditor& editor, Offers offers)
    : document_(document), draft_(draft), editor_(editor), state_(plain::label()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    column->addLayout(row);
    const auto add = [this, row](const char* name, const QString& label, const QString& tip) {
        QPushButton* button = made(name, label, tip);
        row->addWidget(button);
        return button;
    };
    update_ = add("update", tr("&Update"), {}); // its tip changes
    save_ = add("save", tr("&Save"), tr("Update, and write the file (Ctrl+S)"));
    save_->setVisible(offers.save);
    revert_ = add("revert", tr("&Revert"),
                  document_.hasHost()
                      ? tr("Drop the draft: back to the document's text (Ctrl+Shift+R)")
                      : tr("Back to the text that was saved last, in every view (Ctrl+Shift+R)"));
    state_->setObjectName("state");
    state_->setAccessibleName(tr("State of the text"));
    state_->setForegroundRole(QPalette::PlaceholderText);
    if (offers.dismiss) {
        row->addSpacing(8);
        row->addWidget(state_, 1);
    } else { // in a pane, which may be narrow
        row->addStretch();
        state_->setWordWrap(true);
        column->addWidget(state_);
    }
    auto* dismiss = add("dismiss", tr("&Dismiss"), tr("Close this viewer (Ctrl+W)"));
    dismiss->setVisible(offers.dismiss);
    connect(update_, &QPushButton::clicked, this, &DraftRow::updateWanted);
    connect(save_, &QPushButton::clicked, this, &DraftRow::saveWanted);
    connect(revert_, &QPushButton::clicked, this, &DraftRow::revertWanted);
    connect(dismiss, &QPushButton::clicked, this, &DraftRow::dismissWanted);
    connect(&document_, &SceneDocument::sceneChanged, this, &DraftRow::tellChanges);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &DraftRow::showState);
    connect(&document_, &SceneDocument::workChanged, this, &DraftRow::showState);
}

QPushButton* DraftRow::made(const char* name, const QString& label, const QString& tip) {
    auto* button = new QPushButton(plain::ours(label));
    button->setObjectName(name);
    button->setToolTip(plain::ours(tip));
    return button;
}

void DraftRow::expectChanges() {
    updating_.emplace(document_.shownText(), document_.shown().scene);
}

void DraftRow::refresh() {
    const bool isEdited = draft_.edited(), isDisputed = !draft_.conflicts().empty();
    // A button that has done its work gives the keyboard back to the text, and to no other field.
    const auto enable = [this](QPushButton* button, bool isUseful) {
        if (!isUseful && window()->focusWidget() == button)
            editor_.setFocus();
        button->setEnabled(isUseful);
    };
    enable(update_, isEdited && !isDisputed);
    update_->setDefault(isEdited && !isDisputed);
    update_->setToolTip(
        plain::ours(isDisputed ? tr("Another view changed the same places. First choose, above "
                                    "the text, which change stays")
                               : tr("Make this the scene's text, in every view (Ctrl+Return)")));
    enable(save_, isEdited ? !isDisputed : document_.isModified());
    enable(revert_, isEdited || (!document_.hasHost() && document_.isModified()));
    showState();
}

void DraftRow::showState() {
    const auto errors = std::ranges::count_if(document_.diagnostics(), [](const auto& fault) {
        return fault.severity == scene::Severity::error;
    });
    state_->setText(draft_.edited()                     ? tr("Draft: the scene has it after Update")
                    : document_.work() == Work::reading ? tr("Reading…")
                    : errors > 0 && !document_.sceneIsCurrent()
                        ? (errors == 1 ? tr("1 error: the last good scene is shown")
                                       : tr("%1 errors: the last good scene is shown").arg(errors))
                    : errors > 0         ? tr("The motion has faults")
                    : updated_.isEmpty() ? tr("The scene's text")
                                         : updated_);
}

// Elements that an Update added, modified and removed.
void DraftRow::tellChanges() {
    updated_.clear();
    const auto before = std::exchange(updating_, std::nullopt);
    if (!before || !document_.sceneIsCurrent())
        return showState();
    // LIMIT: of long texts, where it would hold up the window, it is not counted.
    constexpr std::size_t quick = 500'000; // bytes
    if (document_.text().size() > quick) {
        updated_ = tr("Updated");
        return showState();
    }
    const editing::Changes changes = editing::changesBetween(
        {before->first, *before->second}, {document_.text(), *document_.shown().scene});
    QStringList parts;
    const auto add = [&](std::size_t count, const QString& what) {
        if (count > 0)
            parts += tr("%1 %2").arg(count).arg(what);
    };
    add(changes.added.size(), tr("added"));
    add(static_cast<std::size_t>(std::ranges::count_if(
            changes.kept, [](const editing::Kept& one) { return one.modified; })),
        tr("modified"));
    add(changes.removed.size(), tr("removed"));
    updated_ = parts.isEmpty() ? tr("Updated: no element changed")
                               : tr("Updated: %1").arg(parts.join(QStringLiteral(", ")));
    showState();
}

} // namespace views
