#include "view/figures.h"

#include "controls/play_bar.h"
#include "paragraphs/measure.h"
#include "view/document_view.h"
#include "view/folds.h"
#include "view/key_names.h"
#include "view/text_hand.h"

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Renditions further away than this many heights of the view give their pictures back.
constexpr double farHeights = 8;
constexpr int fittingDelayMs = 90;

} // namespace

Figures::Figures(DocumentView& view)
    : view_(view), document_(view.document()),
      playBar_(new controls::PlayBar(true, view.viewport())) {
    playBar_->hide();
    connectPlayBar();
    fitting_.setSingleShot(true);
    connect(&fitting_, &QTimer::timeout, this, &Figures::fit);
    connect(&document_, &session::OpenDocument::structureChanged, this, [this] {
        std::erase_if(shown_, [this](const auto& one) {
            return !document_.document().subdocument(one.first);
        });
    });
}

Figures::~Figures() {
    for (const document::SubdocumentId id : document_.document().subdocuments())
        if (media::LiveSubdocument* live = document_.live(id))
            document_.media().setDistance(*live, this, media::LiveMedia::notNeeded);
}

// --- places ------------------------------------------------------------------------------------

void Figures::takePlaces() {
    std::map<document::SubdocumentId, Shown> before;
    before.swap(shown_);
    for (const layout::PlacedSubdocument& placed : view_.pages().subdocuments()) {
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
    fit();
    updatePlayBar();
}

// On whole device pixels, so that a picture of that many pixels is copied and not resampled.
QRectF Figures::placeOf(const Shown& shown) const {
    const double ratio = view_.devicePixelRatioF();
    const QRectF place = view_.inViewport(shown.page, shown.onPage);
    const auto snapped = [ratio](double x) { return std::round(x * ratio) / ratio; };
    return {snapped(place.x()), snapped(place.y()), snapped(place.width()),
            snapped(place.height())};
}

QRectF Figures::placeOf(document::SubdocumentId id) const {
    const auto found = shown_.find(id);
    return found == shown_.end() ? QRectF() : placeOf(found->second);
}

const Shown* Figures::at(QPointF point) const {
    for (const auto& [id, shown] : shown_)
        if (placeOf(shown).contains(point))
            return &shown;
    return nullptr;
}

QPointF Figures::pixelsIn(const Shown& shown, QPointF point) const {
    return (point - placeOf(shown).topLeft()) * view_.devicePixelRatioF();
}

// --- renditions --------------------------------------------------------------------------------

media::Rendition* Figures::rendition(document::SubdocumentId id) const {
    const auto found = shown_.find(id);
    return found == shown_.end() ? nullptr : found->second.rendition.get();
}

void Figures::connectShown(Shown& shown) {
    media::LiveSubdocument* live = document_.live(shown.id);
    shown.context = std::make_unique<QObject>();
    QObject* context = shown.context.get();
    const document::SubdocumentId id = shown.id;
    const auto update = [this, id] { paintAgain(id); };
    connect(shown.rendition.get(), &media::Rendition::pictureChanged, context, update);
    connect(shown.rendition.get(), &media::Rendition::cursorChanged, context, [this, id] {
        if (hovered_ == id)
            Q_EMIT cursorChanged();
    });
    connect(shown.rendition.get(), &media::Rendition::unhandledInput, context,
            [this](const ipc::Input& input) {
                if (input.type != ipc::InputType::keyPress)
                    return;
                const QKeyCombination unused = keyOf(input);
                Q_EMIT unusedKey(unused.key(), unused.keyboardModifiers());
            });
    connect(live, &media::LiveSubdocument::conditionChanged, context, [this, id] {
        paintAgain(id);
        if (hovered_ == id)
            updatePlayBar();
    });
    connect(live, &media::LiveSubdocument::diagnosticsChanged, context, update);
    connect(live, &media::LiveSubdocument::timeChanged, context, [this, id] {
        if (hovered_ == id)
            updatePlayBar();
    });
}

void Figures::follow() {
    updateNearness();
    updatePlayBar();
}

// Which renditions are needed: those that are seen and those close by. Media are told what is seen.
void Figures::updateNearness() {
    std::vector<document::SubdocumentId> seen;
    const double height = std::max(1, view_.viewport()->height());
    const bool canBeSeen =
        view_.isVisible() && !(view_.window()->windowState() & Qt::WindowMinimized);
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
            fitOne(shown);
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

void Figures::fitOne(Shown& shown) {
    if (!shown.rendition)
        return;
    const double ratio = view_.devicePixelRatioF();
    shown.rendition->setGeometry((placeOf(shown).size() * ratio).toSize(), view_.zoom() * ratio);
    const schemas::PageStyle& page = view_.folds().pages().whole().page();
    const double margins = paragraphs::fromPoints(page.marginLeft + page.marginRight);
    if (media::LiveSubdocument* live = document_.live(shown.id))
        live->setAvailable(paragraphs::toPixels({view_.pages().size.width() - margins, 0}));
}

void Figures::fit() {
    for (auto& [id, shown] : shown_)
        fitOne(shown);
}

void Figures::fitSoon() { fitting_.start(fittingDelayMs); }

void Figures::paintAgain(document::SubdocumentId id) {
    view_.viewport()->update(placeOf(id).toAlignedRect().adjusted(-4, -4, 4, 4));
}

void Figures::paint(QPainter& painter, const QRect& area) {
    for (auto& [id, shown] : shown_) {
        const QRectF place = placeOf(shown);
        if (!place.adjusted(-4, -4, 4, 4).intersects(QRectF(area)))
            continue;
        paintShown(painter, place, shown, noticeOf(document_, shown), id == chosen_);
        view_.text().paintSelection(painter, id, place);
        if (shown.rendition)
            shown.rendition->painted();
    }
}

void Figures::choose(document::SubdocumentId id) {
    if (id == chosen_)
        return;
    const auto tell = [this](document::SubdocumentId to, ipc::InputType type) {
        if (media::Rendition* of = rendition(to)) {
            ipc::Input input;
            input.type = type;
            of->input(input);
        }
        paintAgain(to);
    };
    tell(chosen_, ipc::InputType::focusOut);
    chosen_ = id;
    tell(chosen_, ipc::InputType::focusIn);
    updateNearness();
    Q_EMIT chosenChanged();
}

// --- pointer and keys --------------------------------------------------------------------------

bool Figures::press(const QMouseEvent& event) {
    const Shown* shown = at(event.position());
    choose(shown ? shown->id : document::noSubdocument);
    if (!shown)
        return false;
    media::LiveSubdocument* live = document_.live(shown->id);
    if (!live || !shown->rendition)
        return true;
    if (live->condition() == media::Condition::failed) {
        live->startAgain();
        return true;
    }
    live->dismissNotice();
    grabbed_ = shown->id;
    shown->rendition->input(inputOf(event, pixelsIn(*shown, event.position())));
    return true;
}

void Figures::move(const QMouseEvent& event) {
    const Shown* shown = at(event.position());
    const document::SubdocumentId hovered =
        shown && document_.live(shown->id) ? shown->id : document::noSubdocument;
    if (hovered != hovered_ && !grabbed_) {
        hovered_ = hovered;
        updatePlayBar();
    }
    const document::SubdocumentId to = grabbed_             ? grabbed_
                                       : hovered == chosen_ ? chosen_
                                                            : document::noSubdocument;
    if (media::Rendition* of = rendition(to))
        of->input(inputOf(event, pixelsIn(shown_.at(to), event.position())));
}

document::SubdocumentId Figures::release(const QMouseEvent& event) {
    const auto held = shown_.find(grabbed_);
    if (held == shown_.end() || !held->second.rendition)
        return document::noSubdocument;
    held->second.rendition->input(inputOf(event, pixelsIn(held->second, event.position())));
    return grabbed_;
}

bool Figures::turnWheel(const QWheelEvent& event) {
    const Shown* shown = at(event.position());
    if (!shown || shown->id != chosen_ || !shown->rendition)
        return false;
    shown->rendition->input(inputOf(event, pixelsIn(*shown, event.position())));
    return true;
}

void Figures::leave() {
    hovered_ = document::noSubdocument;
    updatePlayBar();
}

std::optional<QCursor> Figures::cursorAt(QPointF point) const {
    const Shown* shown = at(point);
    if (!shown || !shown->rendition || (shown->id != chosen_ && shown->id != grabbed_))
        return std::nullopt;
    return cursorOf(shown->rendition->cursor());
}

// --- the play bar ------------------------------------------------------------------------------

void Figures::connectPlayBar() {
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
}

void Figures::updatePlayBar() {
    const auto found = shown_.find(hovered_);
    const media::LiveSubdocument* live = document_.live(hovered_);
    const bool hasTime = live && live->time() && live->time()->finish > live->time()->start &&
                         live->condition() == media::Condition::live;
    constexpr double leastWidth = 160;
    if (found == shown_.end() || !hasTime || placeOf(found->second).width() < leastWidth) {
        playBar_->hide();
        return;
    }
    constexpr int inset = 8;
    const QRectF place = placeOf(found->second);
    playBar_->setTime(*live->time());
    playBar_->setGeometry(QRectF(place.left() + inset,
                                 place.bottom() - controls::PlayBar::barHeight - inset,
                                 place.width() - 2 * inset, controls::PlayBar::barHeight)
                              .toRect());
    playBar_->show();
}

} // namespace view
