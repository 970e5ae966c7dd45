#include "panes/making_room.h"

namespace panes {

MakingRoom::MakingRoom(QDockWidget& dock, view::DocumentView& view) : QObject(&dock), view_(view) {
    dock.installEventFilter(this);
}

bool MakingRoom::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Show && !event->spontaneous())
        QTimer::singleShot(0, this, &MakingRoom::make); // the pages are as wide as before yet
    if (event->type() == QEvent::Hide && !event->spontaneous())
        giveBack();
    return QObject::eventFilter(watched, event);
}

void MakingRoom::make() {
    if (view_.zoom() <= view_.widthZoom())
        return;
    zoomBefore_ = view_.zoom();
    view_.setZoom(view_.widthZoom());
    zoomThen_ = view_.zoom();
}

void MakingRoom::giveBack() {
    const std::optional<double> before = std::exchange(zoomBefore_, std::nullopt);
    if (before && view_.zoom() == zoomThen_)
        view_.setZoom(*before);
}

} // namespace panes
