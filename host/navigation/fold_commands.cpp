#include "navigation/fold_commands.h"

#include "menus/actions.h"
#include "view/folds.h"

namespace navigation {

FoldCommands::FoldCommands(view::DocumentView& view, QObject* parent)
    : QObject(parent), view_(view) {}

void FoldCommands::addTo(QMenu& menu) {
    view::Folds& folds = view_.folds();
    fold_ = menus::addTo(menu, "foldSection", tr("F&old Section"), QKeySequence("F8"), [&folds] {
        if (const sgml::NodeId heading = folds.headingHere(); heading != sgml::noNode)
            folds.toggle(heading);
    });
    menus::addTo(menu, "foldAll", tr("Fold All Se&ctions"), QKeySequence("Ctrl+F8"),
                 [&folds] { folds.foldAll(); });
    unfoldAll_ = menus::addTo(menu, "unfoldAll", tr("&Unfold All"), QKeySequence("Shift+F8"),
                              [&folds] { folds.unfoldAll(); });
    connect(&menu, &QMenu::aboutToShow, this, &FoldCommands::offer);
    // Keys are for what the menu has not looked at yet.
    connect(&menu, &QMenu::aboutToHide, this, [this] {
        fold_->setEnabled(true);
        unfoldAll_->setEnabled(true);
    });
}

void FoldCommands::offer() {
    view::Folds& folds = view_.folds();
    const sgml::NodeId heading = folds.headingHere();
    const bool isFolded = heading != sgml::noNode && folds.pages().isFolded(heading);
    fold_->setText(isFolded ? tr("Unf&old Section") : tr("F&old Section"));
    fold_->setEnabled(heading != sgml::noNode);
    fold_->setToolTip(heading != sgml::noNode
                          ? tr("Hides what is under its heading, in this view alone")
                          : tr("No section with a heading is here"));
    unfoldAll_->setEnabled(folds.pages().foldsAny());
}

} // namespace navigation
