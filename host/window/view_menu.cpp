#include "window/view_menu.h"

#include "menus/actions.h"
#include "navigation/fold_commands.h"
#include "navigation/page_commands.h"
#include "plain/plain.h"
#include "source/presentation_draft.h"
#include "window/application.h"

#include <QActionGroup>

namespace window {

ViewMenu::ViewMenu(Application& application, DocumentWindow& window, const QList<QAction*>& parts)
    : QMenu(tr("&View"), &window), window_(window) {
    setToolTipsVisible(true);
    view::DocumentView& view = window_.view();
    menus::addTo(*this, "newWindow", tr("&New Window"), QKeySequence("Ctrl+Shift+N"),
                 [&application, &window] { application.addWindow(window.shared()); });
    presentations_ = addMenu(tr("&Presentation"));
    presentations_->setObjectName("presentations");
    presentations_->setToolTipsVisible(true);
    connect(presentations_, &QMenu::aboutToShow, this, &ViewMenu::fillPresentations);
    edit_ = new QAction(tr("&Edit This Presentation"), this);
    edit_->setObjectName("editPresentation");
    connect(edit_, &QAction::triggered, this, &ViewMenu::editPresentationWanted);
    supplied_ = new QAction(tr("As It &Comes with the Program"), this);
    supplied_->setObjectName("suppliedPresentation");
    connect(supplied_, &QAction::triggered, this,
            [this] { Q_EMIT suppliedPresentationWanted(presentationFile()); });
    addSeparator();
    menus::addTo(
        *this, "zoomIn", tr("Zoom &In"), QKeySequence("Ctrl++"), [&view] { view.zoomBy(1); },
        "zoom-in")
        ->setShortcuts({QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")});
    menus::addTo(
        *this, "zoomOut", tr("Zoom &Out"), QKeySequence("Ctrl+-"), [&view] { view.zoomBy(-1); },
        "zoom-out");
    menus::addTo(*this, "fitWidth", tr("Fit &Width"), QKeySequence("Ctrl+9"),
                 [&view] { view.setZoom(view.widthZoom()); });
    menus::addTo(*this, "actualSize", tr("&Actual Size"), QKeySequence("Ctrl+0"),
                 [&view] { view.setZoom(1); });
    (new navigation::PageCommands(view, &window_))->addTo(*this);
    addSeparator();
    (new navigation::FoldCommands(view, &window_))->addTo(*this);
    addSeparator();
    addActions(parts);
    menus::addTo(*this, "fullScreen", tr("&Full Screen"), QKeySequence("F11"),
                 [this] { window_.setWindowState(window_.windowState() ^ Qt::WindowFullScreen); });
}

void ViewMenu::fillPresentations() {
    presentations_->clear();
    auto* group = new QActionGroup(presentations_);
    const session::OpenDocument& of = window_.document();
    view::DocumentView& view = window_.view();
    const QStringList names = of.schemas().presentations(of.document().className());
    for (const QString& name : names) {
        QAction* action =
            presentations_->addAction(plain::caption(name.left(1).toUpper() + name.mid(1)), this,
                                      [&view, name] { view.setPresentation(name); });
        action->setCheckable(true);
        action->setChecked(name == view.presentation() ||
                           (view.presentation().isEmpty() && name == names.first()));
        group->addAction(action);
    }
    presentations_->addSeparator();
    presentations_->addAction(edit_);
    presentations_->addAction(supplied_);
    const bool isOwn = source::hasOwnPresentation(presentationFile());
    supplied_->setEnabled(isOwn);
    supplied_->setToolTip(plain::tip(
        isOwn ? tr("Your own file is kept beside it, with another name") : tr("It is so")));
}

QString ViewMenu::presentationFile() const {
    const session::OpenDocument& of = window_.document();
    return of.schemas().fileOf(of.document().className(), window_.view().presentation()).name;
}

} // namespace window
