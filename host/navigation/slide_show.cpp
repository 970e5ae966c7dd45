#include "navigation/slide_show.h"

#include "places/carets.h"
#include "plain/plain.h"
#include "view/text_hand.h"

#include <QCloseEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QWheelEvent>

namespace navigation {

namespace {

// "": the class's default one.
QString presentationForAudience(const view::DocumentView& of) {
    const std::string& className = of.document().document().className();
    const schemas::Schemas& schemas = of.document().schemas();
    const auto isWide = [&](const QString& name) {
        const schemas::PageStyle& page = schemas.presentation(className, name).page();
        return page.width > page.height;
    };
    if (isWide(of.presentation()))
        return of.presentation();
    const QStringList all = schemas.presentations(className);
    const auto wide = std::ranges::find_if(all, isWide);
    return wide == all.end() ? of.presentation() : *wide;
}

// Below the top of the view, where the end of what was read before may still be seen. Nothing: one
// is at the beginning.
std::optional<std::size_t> placeRead(const view::DocumentView& of) {
    if (of.pages().pages.empty() || of.verticalScrollBar()->value() == 0)
        return std::nullopt;
    const places::Carets carets(of.pages(), of.document().document().tree());
    const QSizeF size = of.viewport()->size();
    const auto [page, point] = of.pagePointAt({size.width() / 2, size.height() / 3});
    const std::optional<places::Caret> caret = carets.at(page, point);
    return caret ? std::optional(carets.placeOf(*caret)) : std::nullopt;
}

} // namespace

SlideShow::SlideShow(const view::DocumentView& of, QWidget* parent)
    : view::DocumentView(of.document(), parent) {
    setObjectName("slideShow");
    setWindowFlag(Qt::Window);
    setAttribute(Qt::WA_DeleteOnClose);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setPresentation(presentationForAudience(of));
    beginsAt_ = placeRead(of);
    setSpread(view::Spread::single);
    setWindowTitle(plain::title(of.title()));
    constexpr int hidePointerMs = 2500;
    pointer_.setSingleShot(true);
    pointer_.setInterval(hidePointerMs);
    connect(&pointer_, &QTimer::timeout, this, [this] { viewport()->setCursor(Qt::BlankCursor); });
    connect(this, &view::DocumentView::laidOut, this, &SlideShow::fit);
    // Keys that a figure does not use.
    connect(this, &view::DocumentView::unhandledKey, this, &SlideShow::useKey);
    // A reference leads to another page.
    connect(this, &view::DocumentView::jumped, this, [this] {
        page_ = currentPage();
        fit();
    });
    pointer_.start();
}

// Of a long document the pages come one after the other.
void SlideShow::begin() {
    const places::Carets carets(pages(), document().document().tree());
    const std::optional<places::Caret> caret = carets.of(*beginsAt_, 0);
    if (caret)
        page_ = firstPage_ = caret->page;
    if (isLaidOut() || (caret && caret->page + 1 < pages().pages.size()))
        beginsAt_.reset();
}

void SlideShow::fit() {
    if (pages().pages.empty())
        return;
    if (beginsAt_)
        begin();
    page_ = std::min(page_, pages().pages.size() - 1);
    setZoom(pageZoom());
    verticalScrollBar()->setValue(static_cast<int>(page_) * viewport()->height());
    setAccessibleName(tr("Page %1 of %2").arg(page_ + 1).arg(pages().pages.size()));
}

void SlideShow::goBy(int pages) {
    beginsAt_.reset();
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

// A click that selects text or follows a link it turns no page.
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
    const std::optional<view::ReadingPlace> place = readingPlace();
    if (place && page_ != firstPage_)
        Q_EMIT left(place->place);
    DocumentView::closeEvent(event);
}

} // namespace navigation
