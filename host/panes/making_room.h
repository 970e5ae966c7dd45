// A dock that comes beside the pages: they become as narrow as is left to them, and as wide again
// when it goes, unless somebody has chosen another size meanwhile.
#pragma once

#include "view/document_view.h"

#include <QDockWidget>

namespace panes {

class MakingRoom : public QObject {
    Q_OBJECT

public:
    // Lives as long as the dock; the view lives longer.
    MakingRoom(QDockWidget& dock, view::DocumentView& view);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void make();
    void giveBack();

    view::DocumentView& view_;
    std::optional<double> zoomBefore_; // it was shown, where the pages gave way
    double zoomThen_ = 1;
};

} // namespace panes
