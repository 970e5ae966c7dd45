#include "view/document_view.h"

#include "paragraphs/measure.h"
#include "view/figures.h"
#include "view/folds.h"
#include "view/text_drag.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <QPaintEvent>
#include <QScreen>
#include <QScrollBar>
#include <QWindow>
#include <algorithm>
#include <cmath>

namespace view {

namespace {

QColor backdrop(const QPalette& palette) {
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    return dark ? QColor(40, 41, 44) : QColor(229, 231, 235);
}

void paintShadow(QPainter& painter, const QRectF& page) {
    for (int i = 0; i < 5; ++i) {
        painter.setPen(QColor(0, 0, 0, 16 - 3 * i));
        painter.drawRect(page.adjusted(-0.5 - i, 0.5 - i, 0.5 + i, 1.5 + i));
    }
}

} // namespace

DocumentView::DocumentView(session::OpenDocument& document, QWidget* parent)
    : QAbstractScrollArea(parent), document_(document), folds_(std::make_unique<Folds>(*this)),
      figures_(std::make_unique<Figures>(*this)), text_(std::make_unique<TextHand>(*this)),
      writing_(std::make_unique<Writing>(*this, *text_)),
      drag_(std::make_unique<TextDrag>(*this, *text_, *writing_)) {
    viewport()->setAcceptDrops(true);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Document"));
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    verticalScrollBar()->setSingleStep(40);
    connect(&document_.images(), &session::Images::ready, viewport(),
            qOverload<>(&QWidget::update));
    connect(figures_.get(), &Figures::chosenChanged, this, &DocumentView::chosenChanged);
    connect(figures_.get(), &Figures::visibleChanged, this, &DocumentView::visibleChanged);
    connect(figures_.get(), &Figures::unusedKey, this, &DocumentView::useKey);
    connect(figures_.get(), &Figures::cursorChanged, this,
            [this] { updateCursor(viewport()->mapFromGlobal(QCursor::pos())); });
    connect(&document_.document(), &document::Document::edited, this, [this] { isBehind_ = true; });
    connect(&document_, &session::OpenDocument::presentedAnew, this, [this] { isBehind_ = true; });
    connect(&text_->cursor(), &TextCursor::changed, this, &DocumentView::selectionChanged);
    connect(this, &DocumentView::chosenChanged, this, &DocumentView::selectionChanged);
    connect(&text_->cursor(), &TextCursor::changed, folds_.get(), &Folds::followCaret);
    connect(&folds_->pages(), &session::FoldedPages::grown, this, &DocumentView::showPages);
    connect(&folds_->pages(), &session::FoldedPages::complete, this, &DocumentView::showPages);
    connect(&folds_->pages(), &session::FoldedPages::wholeChanged, this,
            &DocumentView::followFound);
    present();
}

DocumentView::~DocumentView() = default;

// --- layout ------------------------------------------------------------------------------------

void DocumentView::present() {
    folds_->pages().present(presentation_);
    showPages();
}

// The words at the top of the view stay where they are, unless that is the top of the document.
void DocumentView::showPages() {
    QScrollBar* bar = verticalScrollBar();
    // Pages that follow an edit and do not reach what one reads yet would lose its place.
    if (isBehind_ && !isLaidOut() && bar->value() > 0)
        return;
    const std::size_t top = places().firstAt(bar->value());
    const double y = -pageTopLeft(top).y() / scale();
    const std::optional<places::Spot> spot =
        bar->value() > 0 ? places::spotAt(pages_, {top, y}) : std::nullopt;
    const auto heightOf = [this](const places::PlaceOnPage& place) {
        return pageTopLeft(place.page).y() + place.y * scale();
    };
    const auto was = spot ? places::placeOf(pages_, *spot, top) : std::nullopt;
    const double stood = was ? heightOf(*was) : 0;
    const layout::Pages before = std::exchange(pages_, folds_->pages().pages());
    isBehind_ = isBehind_ && !isLaidOut();
    figures_->takePlaces();
    setScrollBars();
    if (const auto place = was ? places::placeOf(pages_, *spot, top) : std::nullopt)
        bar->setValue(bar->value() + static_cast<int>(std::lround(heightOf(*place) - stood)));
    figures_->follow();
    followFound();
    showChanged(before);
    text_->refresh();
    Q_EMIT laidOut();
}

// Paints what is no longer as it was.
void DocumentView::showChanged(const layout::Pages& before) {
    const auto& now = pages_.pages;
    if (before.size != pages_.size || before.paper != pages_.paper ||
        before.headers != pages_.headers || before.pages.size() != now.size())
        return viewport()->update(); // the headers may say how many pages there are
    for (std::size_t i = 0; i < now.size(); ++i)
        if (before.pages[i] != now[i] || now[i]->hasPageNumbers)
            viewport()->update(QRectF(pageTopLeft(i), pageSize()).toAlignedRect());
}

void DocumentView::setPresentation(const QString& name) {
    presentation_ = name;
    present();
    setZoom(usualZoom()); // pages of another one may be wider
}

double DocumentView::scale() const { return zoom_ / paragraphs::twipsPerPixel; }

QSizeF DocumentView::pageSize() const { return pages().size * scale(); }

QPointF DocumentView::pageTopLeft(std::size_t page) const {
    return places().topLeft(page) -
           QPointF(horizontalScrollBar()->value(), verticalScrollBar()->value());
}

std::pair<std::size_t, QPointF> DocumentView::pagePointAt(QPointF point) const {
    const QPointF scrolled(horizontalScrollBar()->value(), verticalScrollBar()->value());
    const std::size_t page = places().at(point + scrolled);
    return {page, (point - pageTopLeft(page)) / scale()};
}

QRectF DocumentView::inViewport(std::size_t page, const QRectF& twips) const {
    return {pageTopLeft(page) + twips.topLeft() * scale(), twips.size() * scale()};
}

std::shared_ptr<const model::Model> DocumentView::model() const {
    return folds_->pages().whole().model();
}

bool DocumentView::isLaidOut() const { return folds_->pages().isComplete(); }

const QString& DocumentView::title() const { return folds_->pages().whole().title(); }

void DocumentView::settle() {
    if (isBehind_)
        folds_->pages().settle();
}

void DocumentView::settleSoon() {
    constexpr int mostMs = 12;
    if (isBehind_)
        folds_->pages().settle(mostMs);
}

void DocumentView::setScrollBars() {
    const QSizeF all = places().size();
    const auto most = [](double length) { // sums of widths that fill the view are rounded
        constexpr double rounding = 0.01;
        return std::max(0, static_cast<int>(std::ceil(length - rounding)));
    };
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setRange(0, most(all.height() - viewport()->height()));
    horizontalScrollBar()->setPageStep(viewport()->width());
    horizontalScrollBar()->setRange(0, most(all.width() - viewport()->width()));
}

void DocumentView::setZoom(double zoom) {
    zoom = std::clamp(zoom, leastZoom, mostZoom);
    if (zoom == zoom_)
        return;
    const double middle = viewport()->height() / 2.0;
    const bool isAtTop = verticalScrollBar()->value() == 0 && verticalScrollBar()->maximum() > 0;
    constexpr double margin = PagePlaces::margin;
    const double at = (verticalScrollBar()->value() + middle - margin) / zoom_;
    const double x = (horizontalScrollBar()->value() + viewport()->width() / 2.0 - margin) / zoom_;
    zoom_ = zoom;
    setScrollBars();
    verticalScrollBar()->setValue(isAtTop ? 0 : static_cast<int>(at * zoom_ + margin - middle));
    horizontalScrollBar()->setValue(
        static_cast<int>(x * zoom_ + margin - viewport()->width() / 2.0));
    figures_->fitSoon();
    figures_->follow();
    viewport()->update();
    Q_EMIT zoomChanged();
}

double DocumentView::usualZoom() const {
    return std::min(folds_->pages().whole().page().zoom, widthZoom());
}

double DocumentView::widthZoom() const {
    return std::max(leastZoom, zoom_ * places().widthFactor());
}

double DocumentView::pageZoom() const {
    const PagePlaces places = this->places();
    return std::max(leastZoom, zoom_ * std::min(places.widthFactor(), places.heightFactor()));
}

void DocumentView::zoomBy(int steps) {
    constexpr double step = 1.1;
    const double next = zoom_ * std::pow(step, steps);
    // Passing 100 % stops there.
    setZoom((zoom_ < 0.999 && next > 1) || (zoom_ > 1.001 && next < 1) ? 1 : next);
}

// --- figures ------------------------------------------------------------------------------------

document::SubdocumentId DocumentView::chosen() const { return figures_->chosen(); }
void DocumentView::choose(document::SubdocumentId id) { figures_->choose(id); }

std::vector<document::SubdocumentId> DocumentView::visibleSubdocuments() const {
    return figures_->visible();
}

media::Rendition* DocumentView::rendition(document::SubdocumentId id) const {
    return figures_->rendition(id);
}

QRectF DocumentView::placeOf(document::SubdocumentId id) const { return figures_->placeOf(id); }

std::optional<ipc::ScreenArea> DocumentView::screenAreaOf(document::SubdocumentId id) const {
    const QRect seen = placeOf(id).toRect() & viewport()->rect();
    if (seen.isEmpty() || QGuiApplication::platformName().startsWith("wayland"))
        return std::nullopt;
    const QPoint corner = screen()->geometry().topLeft();
    const double ratio = screen()->devicePixelRatio();
    const QPointF at = QPointF(viewport()->mapToGlobal(seen.topLeft()) - corner) * ratio + corner;
    return ipc::ScreenArea{qRound(at.x()), qRound(at.y()), qRound(seen.width() * ratio),
                           qRound(seen.height() * ratio)};
}

void DocumentView::scrollTo(document::SubdocumentId id) {
    if (const document::Subdocument* of = document_.document().subdocument(id))
        folds_->reveal(document_.document().tree().node(of->element).range.from);
    const QRectF place = placeOf(id);
    if (place.isNull() || (place.top() >= 0 && place.bottom() <= viewport()->height()))
        return;
    verticalScrollBar()->setValue(
        verticalScrollBar()->value() + static_cast<int>(place.top()) -
        std::max(20, (viewport()->height() - static_cast<int>(place.height())) / 2));
}

// --- painting ----------------------------------------------------------------------------------

void DocumentView::paintEvent(QPaintEvent* event) {
    QPainter painter(viewport());
    painter.fillRect(event->rect(), spread_ == Spread::single ? Qt::black : backdrop(palette()));
    paintPages(painter, event->rect());
    figures_->paint(painter, event->rect());
    writing_->gestures().paint(painter);
    folds_->paint(painter);
}

// The picture of a file as far as it is decoded; it is painted again when there is more of it.
QImage DocumentView::imageOf(const layout::ImagePiece& piece) {
    const QSizeF pixels = piece.rect.size() * (scale() * devicePixelRatioF());
    return document_.images().image(piece.source, pixels.toSize());
}

void DocumentView::paintPages(QPainter& painter, const QRect& area) {
    const QSizeF size = pageSize();
    const PagePlaces places = this->places();
    const int top = verticalScrollBar()->value();
    constexpr int shadow = 10;
    const std::size_t end =
        std::min(places.endAbove(top + area.bottom() + shadow), pages().pages.size());
    for (std::size_t i = places.firstAt(top + area.top()); i < end; ++i) {
        const QRectF page(pageTopLeft(i), size);
        if (!page.adjusted(-8, -8, 8, 8).intersects(QRectF(area)))
            continue;
        ++pagesPainted_;
        if (spread_ != Spread::single)
            paintShadow(painter, page);
        painter.fillRect(page, pages().paper);
        painter.save();
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
        painter.setClipRect(page & QRectF(area));
        painter.translate(page.topLeft());
        painter.scale(scale(), scale());
        const QRectF clip((QPointF(area.topLeft()) - page.topLeft()) / scale(),
                          QSizeF(area.size()) / scale());
        layout::paintPage(painter, pages(), i, clip,
                          {{}, [this](const layout::ImagePiece& piece) { return imageOf(piece); }});
        Q_EMIT paintingPage(painter, i);
        paintFound(painter, i);
        text_->paintSelection(painter, i);
        writing_->paint(painter, i);
        drag_->paint(painter, i);
        painter.restore();
    }
}

} // namespace view
