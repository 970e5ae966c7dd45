#include "navigation/page_commands.h"

#include "menus/actions.h"
#include "navigation/slide_show.h"

namespace navigation {

PageCommands::PageCommands(view::DocumentView& view, QWidget* window)
    : QObject(window), view_(view), window_(window) {}

void PageCommands::addTo(QMenu& menu) {
    menus::addTo(menu, "fitPage", tr("Fit Pa&ge"), QKeySequence("Ctrl+8"), [this] {
        view_.setZoom(view_.pageZoom());
        view_.goToPage(view_.currentPage());
    });
    QAction* pairs = menus::addTo(
        menu, "twoPages", tr("Two Pages Si&de by Side"), QKeySequence("Ctrl+2"), [this] {
            view_.setSpread(view_.spread() == view::Spread::pairs ? view::Spread::column
                                                                  : view::Spread::pairs);
        });
    pairs->setCheckable(true);
    menus::addTo(menu, "present", tr("P&resent"), QKeySequence(Qt::Key_F5), [this] { present(); });
}

void PageCommands::present() {
    auto* show = new SlideShow(view_, window_);
    connect(show, &SlideShow::left, this, [this](std::size_t place) { view_.goTo(place); });
    show->setScreen(window_->screen());
    show->showFullScreen();
    show->activateWindow();
    show->setFocus();
}

} // namespace navigation
