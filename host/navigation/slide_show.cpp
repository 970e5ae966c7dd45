#include "navigation/slide_show.h"

#include "plain/plain.h"
#include "view/text_hand.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QWheelEvent>

namespace navigation {

SlideShow::SlideShow(const view::DocumentView& of, QWidget* parent)
    : view::DocumentView(of.document(), parent), page_(of.currentPage()) {
    setObjectName("slideShow");
    setWindowFlag(Qt::Window);
    setAttribute(Qt::WA_DeleteOnClose);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setPresentation(of.presentation());
    setSpread(view::Spread::single);
    setWindowTitle(plain::title(of.title()));
    constexpr int hidePointerMs = 2500;
    pointer_.setSingleShot(true);
    pointer_.setInterval(hidePointerMs);
    connect(&pointer_, &QTimer::timeout, this, [this] { viewport()->setCursor(Qt::BlankCursor); });
    connect(this, &view::DocumentView::laidOut, this, &SlideShow::fit);
    // What a figure does not use.
    connect(this, &view::DocumentView::unhandledKey, this, &SlideShow::useKey);
    // A reference leads to another page.
    connect(this, &view::DocumentView::jumped, this, [this] {
        page_ = currentPage();
        fit();
    });
    pointer_.start();
}

void SlideShow::fit() {
    if (pages().pages.empty())
        return;
    page_ = std::min(page_, pages().pages.size() - 1);
    setZoom(pageZoom());
    verticalScrollBar()->setValue(static_cast<int>(page_) * viewport()->height());
    setAccessibleName(tr("Page %1 of %2").arg(page_ + 1).arg(pages().pages.size()));
}

void SlideShow::goBy(int pages) {
    const auto last = static_cast<int>(this->pages().pages.size()) - 1;
    page_ =
        static_cast<std::size_t>(std::clamp(static_cast<int>(page_) + pages, 0, std::max(0, last)));
    fit();
}

// --- keys and pointer ----------------------------------------------------------------------------

bool SlideShow::useKey(int key, Qt::KeyboardModifiers modifiers) {
    if (modifiers & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier))
        return false;
    const auto all = static_cast<int>(pages().pages.size());
    switch (key) {
    case Qt::Key_Right:
    case Qt::Key_Down:
    case Qt::Key_Space:
    case Qt::Key_PageDown:
        goBy(1);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Up:
    case Qt::Key_Backspace:
    case Qt::Key_PageUp:
        goBy(-1);
        return true;
    case Qt::Key_Home:
        goBy(-all);
        return true;
    case Qt::Key_End:
        goBy(all);
        return true;
    case Qt::Key_Escape:
    case Qt::Key_F5:
        close();
        return true;
    default:
        return false;
    }
}

void SlideShow::keyPressEvent(QKeyEvent* event) {
    if (chosen() || !useKey(event->key(), event->modifiers()))
        DocumentView::keyPressEvent(event);
}

void SlideShow::wheelEvent(QWheelEvent* event) {
    if (chosen() && placeOf(chosen()).contains(event->position()))
        return DocumentView::wheelEvent(event);
    turned_ += event->angleDelta().y();
    const int notches = turned_ / QWheelEvent::DefaultDeltasPerStep;
    turned_ -= notches * QWheelEvent::DefaultDeltasPerStep;
    goBy(-notches);
    event->accept();
}

// A click on a figure is the figure's; one beside an active figure leaves it.
void SlideShow::mousePressEvent(QMouseEvent* event) {
    const bool hadFigure = chosen();
    const std::size_t page = page_;
    DocumentView::mousePressEvent(event);
    turns_ = event->button() == Qt::LeftButton && !hadFigure && !chosen() && page == page_;
}

void SlideShow::mouseMoveEvent(QMouseEvent* event) {
    DocumentView::mouseMoveEvent(event);
    pointer_.start();
}

// Where it selects text or follows a link it turns no page.
void SlideShow::mouseReleaseEvent(QMouseEvent* event) {
    const std::size_t page = page_;
    const bool turns = std::exchange(turns_, false) && !text().cursor().selects() &&
                       viewport()->cursor().shape() != Qt::PointingHandCursor;
    DocumentView::mouseReleaseEvent(event);
    if (turns && page == page_)
        goBy(1);
}

// --- the window ----------------------------------------------------------------------------------

void SlideShow::resizeEvent(QResizeEvent* event) {
    DocumentView::resizeEvent(event);
    fit();
}

void SlideShow::showEvent(QShowEvent* event) {
    DocumentView::showEvent(event);
    fit();
}

void SlideShow::closeEvent(QCloseEvent* event) {
    Q_EMIT left(page_);
    DocumentView::closeEvent(event);
}

} // namespace navigation
