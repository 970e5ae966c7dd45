#include "view/document_view.h"

#include "controls/play_bar.h"
#include "layout/measure.h"
#include "view/accessible_view.h"
#include "view/folds.h"
#include "view/key_names.h"
#include "view/text_drag.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <QPaintEvent>
#include <QScrollBar>
#include <QWindow>
#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Renditions further away than this many heights of the view give their pictures back.
constexpr double farHeights = 8;
constexpr int geometryDelayMs = 90;

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
      playBar_(new controls::PlayBar(true, viewport())), text_(std::make_unique<TextHand>(*this)),
      writing_(std::make_unique<Writing>(*this, *text_)),
      drag_(std::make_unique<TextDrag>(*this, *text_, *writing_)) {
    viewport()->setAcceptDrops(true);
    AccessibleView::install();
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Document"));
    setFocusPolicy(Qt::StrongFocus);
    viewport()->setMouseTracking(true);
    verticalScrollBar()->setSingleStep(40);
    playBar_->hide();
    geometryTimer_.setSingleShot(true);
    connect(&geometryTimer_, &QTimer::timeout, this, &DocumentView::updateGeometries);
    connect(&document_.images(), &session::Images::ready, viewport(),
            qOverload<>(&QWidget::update));
    connect(&document_, &session::OpenDocument::structureChanged, this, [this] {
        std::erase_if(shown_, [this](const auto& one) {
            return !document_.document().subdocument(one.first);
        });
    });
    connect(playBar_, &controls::PlayBar::playWanted, this, [this] {
        if (media::LiveSubdocument* live = document_.live(hovered_))
            live->play();
    });
    connect(playBar_, &controls::PlayBar::pauseWanted, this, [this] {
        if (media::LiveSubdocument* live = document_.live(hovered_))
            live->pause();
    });
    connect(playBar_, &controls::PlayBar::seekWanted, this, [this](double time) {
        if (media::LiveSubdocument* live = document_.live(hovered_))
            live->seek(time);
    });
    connect(&document_.document(), &document::Document::edited, this, [this] { isBehind_ = true; });
    connect(&document_, &session::OpenDocument::presentedAnew, this, [this] { isBehind_ = true; });
    connect(&text_->cursor(), &TextCursor::changed, this, &DocumentView::selectionChanged);
    connect(this, &DocumentView::chosenChanged, this, &DocumentView::selectionChanged);
    connect(&text_->cursor(), &TextCursor::changed, folds_.get(), &Folds::followCaret);
    connect(&folds_->pages(), &session::FoldedPages::grown, this, &DocumentView::showPages);
    connect(&folds_->pages(), &session::FoldedPages::complete, this, &DocumentView::showPages);
    connect(this, &DocumentView::selectionChanged, this, [this] { AccessibleView::tell(*this); });
    connect(this, &DocumentView::laidOut, this, [this] { AccessibleView::tell(*this); });
    present();
}

DocumentView::~DocumentView() {
    for (const document::SubdocumentId id : document_.document().subdocuments())
        if (media::LiveSubdocument* live = document_.live(id))
            document_.media().setDistance(*live, this, media::LiveMedia::notNeeded);
}

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
    const std::optional<layout::Spot> spot =
        bar->value() > 0 ? layout::spotAt(pages_, {top, y}) : std::nullopt;
    const auto heightOf = [this](const layout::PlaceOnPage& place) {
        return pageTopLeft(place.page).y() + place.y * scale();
    };
    const auto was = spot ? layout::placeOf(pages_, *spot, top) : std::nullopt;
    const double stood = was ? heightOf(*was) : 0;
    const layout::Pages before = std::exchange(pages_, folds_->pages().pages());
    isBehind_ = isBehind_ && !isLaidOut();
    placeSubdocuments();
    setScrollBars();
    if (const auto place = was ? layout::placeOf(pages_, *spot, top) : std::nullopt)
        bar->setValue(bar->value() + static_cast<int>(std::lround(heightOf(*place) - stood)));
    updateNearness();
    found_.follow(pages_);
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

void DocumentView::placeSubdocuments() {
    std::map<document::SubdocumentId, Shown> before;
    before.swap(shown_);
    for (const layout::PlacedSubdocument& placed : pages().subdocuments()) {
        const auto old = before.find(placed.subdocument);
        Shown shown;
        if (old != before.end())
            shown = std::move(old->second);
        shown.id = placed.subdocument;
        shown.page = placed.page;
        shown.onPage = placed.rect;
        shown_[placed.subdocument] = std::move(shown);
    }
    for (const auto& [id, gone] : before)
        if (media::LiveSubdocument* live = document_.live(id))
            document_.media().setDistance(*live, this, media::LiveMedia::notNeeded);
    if (chosen_ && !shown_.contains(chosen_))
        choose(document::noSubdocument);
    if (!shown_.contains(hovered_))
        hovered_ = document::noSubdocument;
    updateGeometries();
    updatePlayBar();
}

void DocumentView::setPresentation(const QString& name) {
    presentation_ = name;
    present();
    setZoom(usualZoom()); // pages of another one may be wider
}

double DocumentView::scale() const { return zoom_ / layout::twipsPerPixel; }

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

// On whole device pixels, so that a picture of that many pixels is copied and not resampled.
QRectF DocumentView::placeOf(const Shown& shown) const {
    const double ratio = devicePixelRatioF();
    const QPointF corner = pageTopLeft(shown.page) + shown.onPage.topLeft() * scale();
    const auto snapped = [ratio](double x) { return std::round(x * ratio) / ratio; };
    return {snapped(corner.x()), snapped(corner.y()), snapped(shown.onPage.width() * scale()),
            snapped(shown.onPage.height() * scale())};
}

QRectF DocumentView::placeOf(document::SubdocumentId id) const {
    const auto found = shown_.find(id);
    return found == shown_.end() ? QRectF() : placeOf(found->second);
}

media::Rendition* DocumentView::rendition(document::SubdocumentId id) const {
    const auto found = shown_.find(id);
    return found == shown_.end() ? nullptr : found->second.rendition.get();
}

void DocumentView::setScrollBars() {
    const QSizeF all = places().size();
    const auto most = [](double length) {
        return std::max(0, static_cast<int>(std::ceil(length)));
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
    constexpr double margin = PagePlaces::margin;
    const double at = (verticalScrollBar()->value() + middle - margin) / zoom_;
    const double x = (horizontalScrollBar()->value() + viewport()->width() / 2.0 - margin) / zoom_;
    zoom_ = zoom;
    setScrollBars();
    verticalScrollBar()->setValue(static_cast<int>(at * zoom_ + margin - middle));
    horizontalScrollBar()->setValue(
        static_cast<int>(x * zoom_ + margin - viewport()->width() / 2.0));
    geometryTimer_.start(geometryDelayMs);
    updateNearness();
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

// --- renditions --------------------------------------------------------------------------------

void DocumentView::connectShown(Shown& shown) {
    media::LiveSubdocument* live = document_.live(shown.id);
    shown.context = std::make_unique<QObject>();
    QObject* context = shown.context.get();
    const document::SubdocumentId id = shown.id;
    const auto update = [this, id] { updateOne(id); };
    connect(shown.rendition.get(), &media::Rendition::pictureChanged, context, update);
    connect(shown.rendition.get(), &media::Rendition::cursorChanged, context, [this, id] {
        if (hovered_ == id)
            updateCursor(viewport()->mapFromGlobal(QCursor::pos()));
    });
    connect(shown.rendition.get(), &media::Rendition::unhandledInput, context,
            [this](const ipc::Input& input) {
                if (input.type != ipc::InputType::keyPress)
                    return;
                Qt::KeyboardModifiers modifiers;
                for (const ipc::Modifier modifier : input.modifiers)
                    modifiers |=
                        modifier == ipc::Modifier::shift ? Qt::ShiftModifier : Qt::NoModifier;
                int key = keyNamed(input.key);
                if (key == 0 && input.key.size() == 1)
                    key = QChar::toUpper(static_cast<uint>(input.key[0]));
                useKey(key, modifiers);
            });
    connect(live, &media::LiveSubdocument::conditionChanged, context, [this, id] {
        updateOne(id);
        if (hovered_ == id)
            updatePlayBar();
    });
    connect(live, &media::LiveSubdocument::diagnosticsChanged, context, update);
    connect(live, &media::LiveSubdocument::timeChanged, context, [this, id] {
        if (hovered_ == id)
            updatePlayBar();
    });
}

// Which renditions are needed: those that are seen and those close by. Media are told what is seen.
void DocumentView::updateNearness() {
    std::vector<document::SubdocumentId> seen;
    const double height = std::max(1, viewport()->height());
    const bool canBeSeen = isVisible() && !(window()->windowState() & Qt::WindowMinimized);
    for (auto& [id, shown] : shown_) {
        media::LiveSubdocument* live = document_.live(id);
        if (!live)
            continue;
        const QRectF place = placeOf(shown);
        const double distance = std::max({0.0, place.top() - height, -place.bottom()});
        const bool near = distance < height;
        if (near && !shown.rendition) {
            shown.rendition = live->createRendition();
            connectShown(shown);
            updateGeometry(shown);
        } else if (shown.rendition && distance > farHeights * height) {
            shown.context.reset();
            shown.rendition.reset();
        }
        const bool isSeen = canBeSeen && distance == 0 && place.bottom() > 0;
        if (shown.rendition)
            shown.rendition->setShown(isSeen);
        const double wanted = id == chosen_ ? -0.5 : distance; // what is in use lives
        document_.media().setDistance(*live, this,
                                      near && canBeSeen ? wanted : media::LiveMedia::notNeeded);
        if (isSeen)
            seen.push_back(id);
    }
    std::sort(seen.begin(), seen.end(), [this](auto a, auto b) {
        return std::pair(shown_.at(a).page, shown_.at(a).onPage.top()) <
               std::pair(shown_.at(b).page, shown_.at(b).onPage.top());
    });
    if (seen == visible_)
        return;
    visible_ = seen;
    Q_EMIT visibleChanged();
}

std::vector<document::SubdocumentId> DocumentView::visibleSubdocuments() const { return visible_; }

void DocumentView::updateGeometry(Shown& shown) {
    if (!shown.rendition)
        return;
    const double ratio = devicePixelRatioF();
    shown.rendition->setGeometry((placeOf(shown).size() * ratio).toSize(), zoom_ * ratio);
    const schemas::PageStyle& page = folds_->pages().whole().page();
    const double margins = layout::fromPoints(page.marginLeft + page.marginRight);
    if (media::LiveSubdocument* live = document_.live(shown.id))
        live->setAvailable(layout::toPixels({pages().size.width() - margins, 0}));
}

void DocumentView::updateGeometries() {
    for (auto& [id, shown] : shown_)
        updateGeometry(shown);
}

void DocumentView::updateOne(document::SubdocumentId id) {
    viewport()->update(placeOf(id).toAlignedRect().adjusted(-4, -4, 4, 4));
}

void DocumentView::choose(document::SubdocumentId id) {
    if (id == chosen_)
        return;
    const auto tell = [this](document::SubdocumentId to, ipc::InputType type) {
        if (media::Rendition* of = rendition(to)) {
            ipc::Input input;
            input.type = type;
            of->input(input);
        }
        updateOne(to);
    };
    tell(chosen_, ipc::InputType::focusOut);
    chosen_ = id;
    tell(chosen_, ipc::InputType::focusIn);
    updateNearness();
    Q_EMIT chosenChanged();
}

Shown* DocumentView::shownAt(QPointF point) {
    for (auto& [id, shown] : shown_)
        if (placeOf(shown).contains(point))
            return &shown;
    return nullptr;
}

QPointF DocumentView::pixelsIn(const Shown& shown, QPointF point) const {
    return (point - placeOf(shown).topLeft()) * devicePixelRatioF();
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
    for (auto& [id, shown] : shown_) {
        const QRectF place = placeOf(shown);
        if (!place.adjusted(-4, -4, 4, 4).intersects(QRectF(event->rect())))
            continue;
        paintShown(painter, place, shown, noticeOf(document_, shown), id == chosen_);
        text_->paintSelection(painter, id, place);
        if (shown.rendition)
            shown.rendition->painted();
    }
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
