// What the user does in a DocumentView: pointer, wheel, keys, links, the play bar.
#include "view/document_view.h"

#include "controls/play_bar.h"
#include "view/accessible_view.h"
#include "view/copying.h"
#include "view/folds.h"
#include "view/key_names.h"
#include "view/text_drag.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

namespace view {

namespace {

bool erases(int key) { return key == Qt::Key_Delete || key == Qt::Key_Backspace; }

} // namespace

// --- events ------------------------------------------------------------------------------------

void DocumentView::resizeEvent(QResizeEvent*) {
    setScrollBars();
    updateNearness();
    updatePlayBar();
}

void DocumentView::scrollContentsBy(int, int) {
    updateNearness();
    updatePlayBar();
    text_->refresh();
    viewport()->update();
}

void DocumentView::showEvent(QShowEvent* event) {
    QAbstractScrollArea::showEvent(event);
    if (!std::exchange(wasShown_, true))
        setZoom(usualZoom());
    updateGeometries();
    updateNearness();
}

void DocumentView::hideEvent(QHideEvent* event) {
    QAbstractScrollArea::hideEvent(event);
    updateNearness();
}

bool DocumentView::event(QEvent* event) {
    // Plain keys belong to the chosen rendition before they are shortcuts of a menu.
    if (event->type() == QEvent::ShortcutOverride && chosen_) {
        const auto* key = static_cast<QKeyEvent*>(event);
        constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
        if (!(key->modifiers() & commands) && key->key() != Qt::Key_Tab &&
            key->key() != Qt::Key_Backtab) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride && !chosen_ && isWriting() &&
        (Writing::isForText(*static_cast<QKeyEvent*>(event)) ||
         writing_->movesInTable(*static_cast<QKeyEvent*>(event)))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::WindowStateChange)
        updateNearness();
    return QAbstractScrollArea::event(event);
}

bool DocumentView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        hovered_ = document::noSubdocument;
        updatePlayBar();
        folds_->hover({-1, -1});
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), folds_->tipAt(help->pos()), viewport());
        return true;
    }
    return QAbstractScrollArea::viewportEvent(event);
}

void DocumentView::mousePressEvent(QMouseEvent* event) {
    pressedAt_ = event->position();
    wasDragged_ = false;
    if (event->button() == Qt::LeftButton &&
        (folds_->press(event->position()) || writing_->gestures().press(event->position())))
        return;
    Shown* shown = shownAt(event->position());
    choose(shown ? shown->id : document::noSubdocument);
    if (!shown) {
        if (event->button() == Qt::LeftButton && !drag_->press(*event))
            text_->press(*event);
        else if (event->button() == Qt::MiddleButton)
            pasteSelection(*event);
        return;
    }
    media::LiveSubdocument* live = document_.live(shown->id);
    if (!live || !shown->rendition)
        return;
    if (live->condition() == media::Condition::failed) {
        live->startAgain();
        return;
    }
    live->dismissNotice();
    grabbed_ = shown->id;
    shown->rendition->input(inputOf(*event, pixelsIn(*shown, event->position())));
}

void DocumentView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton &&
        (folds_->press(event->position()) || writing_->gestures().pressTwice(event->position())))
        return;
    if (event->button() != Qt::LeftButton || shownAt(event->position()))
        return mousePressEvent(event);
    wasDragged_ = true; // no click on a link
    const model::Run* run = isWriting() ? runAt(event->position()) : nullptr;
    if (run && run->kind == model::RunKind::formula)
        Q_EMIT formulaActivated(run->element);
    else
        text_->pressTwice(*event);
}

void DocumentView::mouseMoveEvent(QMouseEvent* event) {
    constexpr double dragLength = 4;
    wasDragged_ |= (event->position() - pressedAt_).manhattanLength() > dragLength;
    if (writing_->gestures().drag(event->position()) || drag_->move(*event))
        return;
    if (text_->isDragging()) {
        if (wasDragged_)
            text_->drag(event->position());
        return;
    }
    Shown* shown = shownAt(event->position());
    const document::SubdocumentId hovered =
        shown && document_.live(shown->id) ? shown->id : document::noSubdocument;
    if (hovered != hovered_ && !grabbed_) {
        hovered_ = hovered;
        updatePlayBar();
    }
    const document::SubdocumentId to = grabbed_ ? grabbed_ : hovered == chosen_ ? chosen_ : 0;
    if (media::Rendition* of = rendition(to))
        of->input(inputOf(*event, pixelsIn(shown_.at(to), event->position())));
    folds_->hover(event->position());
    updateCursor(event->position());
}

void DocumentView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton &&
        (writing_->gestures().release() || drag_->release(*event)))
        return;
    const auto held = shown_.find(grabbed_);
    if (held != shown_.end() && held->second.rendition) {
        held->second.rendition->input(inputOf(*event, pixelsIn(held->second, event->position())));
        // With Shift it is the medium's, as where it edits its picture.
        if (event->button() == Qt::RightButton && !wasDragged_ &&
            !(event->modifiers() & Qt::ShiftModifier))
            Q_EMIT contextMenuWanted(grabbed_, event->globalPosition().toPoint());
    } else if (event->button() == Qt::RightButton && !wasDragged_) {
        if (isWriting())
            writing_->goTo(event->position());
        Q_EMIT textMenuWanted(event->globalPosition().toPoint());
    } else if (event->button() == Qt::LeftButton && !wasDragged_ && !text_->cursor().selects() &&
               (!isWriting() || (event->modifiers() & Qt::ControlModifier))) {
        if (const model::Run* link = linkAt(event->position()))
            follow(QString::fromStdString(link->target));
    }
    if (event->button() == Qt::LeftButton)
        text_->release();
    if (!event->buttons())
        grabbed_ = document::noSubdocument;
}

void DocumentView::dragEnterEvent(QDragEnterEvent* event) {
    if (!drag_->hover(*event))
        event->ignore();
}

void DocumentView::dragMoveEvent(QDragMoveEvent* event) {
    if (!drag_->hover(*event))
        event->ignore();
}

void DocumentView::dragLeaveEvent(QDragLeaveEvent*) { drag_->leave(); }

// What is not for the text is for the window: the file of a document.
void DocumentView::dropEvent(QDropEvent* event) {
    if (!drag_->drop(*event))
        event->ignore();
}

// By key only: by mouse it comes with the release, since the right button drags in some media.
void DocumentView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Keyboard)
        return;
    const QRectF caret = text_->caretRect().value_or(QRectF(viewport()->rect().center(), QSizeF()));
    if (chosen_)
        Q_EMIT contextMenuWanted(chosen_,
                                 viewport()->mapToGlobal(placeOf(chosen_).center().toPoint()));
    else
        Q_EMIT textMenuWanted(viewport()->mapToGlobal(caret.bottomLeft().toPoint()));
}

void DocumentView::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ControlModifier) {
        const int delta = event->angleDelta().y();
        zoomBy(delta > 0 ? 1 : delta < 0 ? -1 : 0);
        event->accept();
        return;
    }
    const Shown* shown = shownAt(event->position());
    if (shown && shown->id == chosen_ && shown->rendition) {
        shown->rendition->input(inputOf(*event, pixelsIn(*shown, event->position())));
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void DocumentView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && writing_->gestures().cancel())
        return;
    const media::LiveSubdocument* live = document_.live(chosen_);
    const bool isHeard = live && live->condition() == media::Condition::live;
    if (chosen_ && event->key() == Qt::Key_Escape && !grabbed_) // else what is dragged is given up
        choose(document::noSubdocument);
    else if (chosen_ && !isHeard && erases(event->key()))
        useKey(event->key(), event->modifiers());
    else if (media::Rendition* of = rendition(chosen_))
        of->input(inputOf(*event));
    else if (chosen_ || !isWriting() || !writing_->useKey(*event))
        useKey(event->key(), event->modifiers());
}

void DocumentView::keyReleaseEvent(QKeyEvent* event) {
    if (media::Rendition* of = rendition(chosen_))
        of->input(inputOf(*event));
}

// A key that is the host's: because nothing is chosen, or because the medium did not use it.
void DocumentView::useKey(int key, Qt::KeyboardModifiers modifiers) {
    if (chosen_ && isWriting() && erases(key))
        return eraseChosen();
    if (!chosen_ && text_->useKey(key, modifiers, false))
        return;
    QScrollBar* bar = verticalScrollBar();
    switch (key) {
    case Qt::Key_Up:
        bar->triggerAction(QAbstractSlider::SliderSingleStepSub);
        break;
    case Qt::Key_Down:
        bar->triggerAction(QAbstractSlider::SliderSingleStepAdd);
        break;
    case Qt::Key_Left:
        horizontalScrollBar()->triggerAction(QAbstractSlider::SliderSingleStepSub);
        break;
    case Qt::Key_Right:
        horizontalScrollBar()->triggerAction(QAbstractSlider::SliderSingleStepAdd);
        break;
    case Qt::Key_PageUp:
        bar->triggerAction(QAbstractSlider::SliderPageStepSub);
        break;
    case Qt::Key_PageDown:
        bar->triggerAction(QAbstractSlider::SliderPageStepAdd);
        break;
    case Qt::Key_Home:
        bar->setValue(0);
        break;
    case Qt::Key_End:
        bar->setValue(bar->maximum());
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!chosen_ && !visible_.empty())
            choose(visible_.front());
        break;
    default:
        Q_EMIT unhandledKey(key, modifiers);
    }
}

// --- the text that is selected -----------------------------------------------------------------

bool DocumentView::canCopy() const { return chosen_ || text_->cursor().selects(); }

void DocumentView::copy() {
    if (chosen_)
        copyChosen();
    else if (canCopy())
        text_->copy();
}

// With its caption; other programs get its picture.
void DocumentView::copyChosen() {
    settle();
    const document::Document& document = document_.document();
    const document::Subdocument* figure = document.subdocument(chosen_);
    if (!figure || !model())
        return;
    const sgml::NodeId whole = authoring::wholeFigure(writing_->manuscript(), figure->element);
    std::unique_ptr<QMimeData> copy = copied(document, *model(), document.tree().node(whole).range);
    if (const media::Rendition* of = rendition(chosen_); of && !of->picture().isNull())
        copy->setImageData(of->picture());
    QApplication::clipboard()->setMimeData(copy.release());
}

void DocumentView::eraseChosen() {
    if (const document::Subdocument* figure = document_.document().subdocument(chosen_))
        writing_->perform([figure](const authoring::Manuscript& in, authoring::Selection) {
            return authoring::removeElement(in, authoring::wholeFigure(in, figure->element),
                                            tr("Delete Figure"));
        });
}

void DocumentView::selectAll() {
    choose(document::noSubdocument);
    text_->selectAll();
}

bool DocumentView::isWriting() const { return writing_->isOn(); }

void DocumentView::setWriting(bool on) {
    if (on == isWriting())
        return;
    setAttribute(Qt::WA_InputMethodEnabled, on);
    if (on)
        writing_->begin();
    else
        writing_->end();
    Q_EMIT writingChanged(on);
}

// What the desktop's other windows have selected, where the pointer is.
void DocumentView::pasteSelection(const QMouseEvent& event) {
    const QClipboard* clipboard = QApplication::clipboard();
    if (!isWriting() || !clipboard->supportsSelection())
        return;
    // Its own selection is gone once the caret is elsewhere.
    QMimeData text;
    text.setText(clipboard->text(QClipboard::Selection));
    text_->press(event);
    text_->release();
    writing_->paste(text);
}

void DocumentView::inputMethodEvent(QInputMethodEvent* event) {
    if (isWriting() && !chosen_)
        writing_->compose(*event);
    event->accept();
}

QVariant DocumentView::inputMethodQuery(Qt::InputMethodQuery query) const {
    const QVariant answer = isWriting() ? writing_->answer(query) : QVariant();
    return answer.isValid() ? answer : QAbstractScrollArea::inputMethodQuery(query);
}

// What is selected looks otherwise where the keys go elsewhere.
void DocumentView::focusInEvent(QFocusEvent* event) {
    QAbstractScrollArea::focusInEvent(event);
    text_->refresh();
    AccessibleView::tell(*this);
}

void DocumentView::focusOutEvent(QFocusEvent* event) {
    QAbstractScrollArea::focusOutEvent(event);
    AccessibleView::tell(*this);
    text_->refresh();
}

// Tab goes from rendition to rendition, then on to the other widgets. In text that one writes it is
// a command of writing.
bool DocumentView::focusNextPrevChild(bool next) {
    if (isWriting() && !chosen_) {
        writing_->goBy(next);
        return true;
    }
    std::vector<document::SubdocumentId> order;
    for (const layout::PlacedSubdocument& placed : pages().subdocuments())
        order.push_back(placed.subdocument);
    const auto at = std::find(order.begin(), order.end(), chosen_);
    std::size_t index = at == order.end() ? (next ? 0 : order.size() - 1)
                                          : static_cast<std::size_t>(at - order.begin()) +
                                                (next ? 1 : static_cast<std::size_t>(-1));
    if (index >= order.size()) {
        choose(document::noSubdocument);
        return QAbstractScrollArea::focusNextPrevChild(next);
    }
    choose(order[index]);
    scrollTo(order[index]);
    return true;
}

// --- links, bar, cursor ------------------------------------------------------------------------

const model::Run* DocumentView::runAt(QPointF point) const {
    if (pages().pages.empty())
        return nullptr;
    const auto [page, on] = pagePointAt(point);
    return layout::runAt(*pages().pages[page], on);
}

const model::Run* DocumentView::linkAt(QPointF point) const {
    const model::Run* run = runAt(point);
    return run && !run->target.empty() ? run : nullptr;
}

void DocumentView::follow(const QString& target) {
    if (!target.startsWith('#')) {
        Q_EMIT linkActivated(target);
        return;
    }
    folds_->reveal(target.mid(1).toStdString());
    const auto anchor = pages().anchor(target.mid(1).toStdString());
    if (!anchor)
        return;
    Q_EMIT jumping(false);
    const double y = pageTopLeft(anchor->first).y() + anchor->second * scale();
    scrollBy(y - PagePlaces::margin);
    Q_EMIT jumped();
}

void DocumentView::updatePlayBar() {
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

void DocumentView::updateCursor(QPointF point) {
    Shown* shown = shownAt(point);
    if (const auto cursor = writing_->gestures().cursorAt(point))
        viewport()->setCursor(*cursor);
    else if (folds_->isOver(point))
        viewport()->setCursor(Qt::PointingHandCursor);
    else if (shown && shown->rendition && (shown->id == chosen_ || shown->id == grabbed_))
        viewport()->setCursor(cursorOf(shown->rendition->cursor()));
    else if (!shown && linkAt(point))
        viewport()->setCursor(Qt::PointingHandCursor);
    else if (!shown && text_->isOverText(point))
        viewport()->setCursor(Qt::IBeamCursor);
    else
        viewport()->setCursor(Qt::ArrowCursor);
}

} // namespace view
