// The user's input in a DocumentView: pointer, wheel, keys, links, the play bar.
#include "view/document_view.h"

#include "view/figures.h"
#include "view/folds.h"
#include "view/gap_caret.h"
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

// --- events ------------------------------------------------------------------------------------

void DocumentView::resizeEvent(QResizeEvent*) {
    setScrollBars();
    figures_->follow();
}

void DocumentView::scrollContentsBy(int, int) {
    figures_->follow();
    text_->refresh();
    viewport()->update();
}

void DocumentView::showEvent(QShowEvent* event) {
    QAbstractScrollArea::showEvent(event);
    if (!std::exchange(wasShown_, true))
        setZoom(usualZoom());
    figures_->fit();
    figures_->follow();
}

void DocumentView::hideEvent(QHideEvent* event) {
    QAbstractScrollArea::hideEvent(event);
    figures_->follow();
}

bool DocumentView::event(QEvent* event) {
    // Plain keys belong to the chosen rendition before they are shortcuts of a menu.
    if (event->type() == QEvent::ShortcutOverride && chosen()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
        if (!(key->modifiers() & commands) && key->key() != Qt::Key_Tab &&
            key->key() != Qt::Key_Backtab && !Writing::isForClipboard(*key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ShortcutOverride && !chosen() && isWriting() &&
        (Writing::isForText(*static_cast<QKeyEvent*>(event)) ||
         writing_->movesInTable(*static_cast<QKeyEvent*>(event)))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::WindowStateChange)
        figures_->follow();
    return QAbstractScrollArea::event(event);
}

bool DocumentView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::Leave) {
        figures_->leave();
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
    press_ = {event->position()};
    if (event->button() == Qt::LeftButton &&
        (folds_->press(event->position()) || writing_->gestures().press(event->position())))
        return;
    if (figures_->press(*event))
        return;
    if (event->button() == Qt::LeftButton && !drag_->press(*event)) {
        text_->press(*event);
        if (!event->modifiers() && !pressGap(*this, event->position()))
            writing_->pressBelow(event->position());
    } else if (event->button() == Qt::MiddleButton) {
        pasteSelection(*event);
    }
}

void DocumentView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton &&
        (folds_->press(event->position()) || writing_->gestures().pressTwice(event->position())))
        return;
    if (event->button() != Qt::LeftButton || figures_->isAt(event->position()))
        return mousePressEvent(event);
    press_.wasDragged = true; // no click on a link
    const model::Run* run = isWriting() ? runAt(event->position()) : nullptr;
    if (run && run->kind == model::RunKind::formula)
        Q_EMIT elementActivated(run->element, schemas::Display::formula);
    else if (run && run->kind == model::RunKind::value)
        Q_EMIT elementActivated(run->element, schemas::Display::value);
    else if (run && run->refers)
        Q_EMIT elementActivated(run->element, schemas::Display::reference);
    else
        text_->pressTwice(*event);
    if (!isWriting() && text_->isOverText(event->position()))
        Q_EMIT triedToWrite();
}

void DocumentView::mouseMoveEvent(QMouseEvent* event) {
    constexpr double dragLength = 4;
    press_.wasDragged |= (event->position() - press_.at).manhattanLength() > dragLength;
    if (writing_->gestures().drag(event->position()) || drag_->move(*event))
        return;
    if (text_->isDragging()) {
        if (press_.wasDragged)
            text_->drag(event->position());
        return;
    }
    figures_->move(*event);
    folds_->hover(event->position());
    updateCursor(event->position());
}

void DocumentView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton &&
        (writing_->gestures().release() || drag_->release(*event)))
        return;
    if (const document::SubdocumentId held = figures_->release(*event)) {
        // With Shift it is the medium's, as where it edits its picture.
        if (event->button() == Qt::RightButton && !press_.wasDragged &&
            !(event->modifiers() & Qt::ShiftModifier))
            Q_EMIT contextMenuWanted(held, event->globalPosition().toPoint());
    } else if (event->button() == Qt::RightButton && !press_.wasDragged) {
        if (isWriting())
            writing_->goTo(event->position());
        Q_EMIT textMenuWanted(event->globalPosition().toPoint());
    } else if (event->button() == Qt::LeftButton && !press_.wasDragged &&
               !text_->cursor().selects() &&
               (!isWriting() || (event->modifiers() & Qt::ControlModifier))) {
        if (const model::Run* link = linkAt(event->position()))
            follow(QString::fromStdString(link->target));
    }
    if (event->button() == Qt::LeftButton)
        text_->release();
    if (!event->buttons())
        figures_->letGo();
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

// Data that is not for the text is for the window: the file of a document.
void DocumentView::dropEvent(QDropEvent* event) {
    if (!drag_->drop(*event))
        event->ignore();
}

// By key only: by mouse it comes with the release, since the right button drags in some media.
void DocumentView::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() != QContextMenuEvent::Keyboard)
        return;
    const QRectF caret = text_->caretRect().value_or(QRectF(viewport()->rect().center(), QSizeF()));
    if (chosen())
        Q_EMIT contextMenuWanted(chosen(),
                                 viewport()->mapToGlobal(placeOf(chosen()).center().toPoint()));
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
    if (figures_->turnWheel(*event)) {
        event->accept();
        return;
    }
    QAbstractScrollArea::wheelEvent(event);
}

void DocumentView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && writing_->gestures().cancel())
        return;
    const media::LiveSubdocument* live = document_.live(chosen());
    const bool isHeard = live && live->condition() == media::Condition::live;
    if (chosen() && event->key() == Qt::Key_Escape &&
        !figures_->isHeld()) // else what is dragged is given up
        chosenFigure().leave();
    else if (media::Rendition* of = rendition(chosen()); of && isHeard)
        of->input(inputOf(*event));
    else if (chosen() || !isWriting() || !writing_->useKey(*event))
        useKey(event->key(), event->modifiers());
}

void DocumentView::keyReleaseEvent(QKeyEvent* event) {
    if (media::Rendition* of = rendition(chosen()))
        of->input(inputOf(*event));
}

namespace {

// Whether the key changes a text that is written.
bool isWritten(int key, Qt::KeyboardModifiers modifiers) {
    constexpr int firstOfOthers = Qt::Key_Escape; // behind all letters
    const bool isLetter = key > 0 && key < firstOfOthers;
    return !(modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) &&
           (isLetter || key == Qt::Key_Backspace || key == Qt::Key_Delete);
}

} // namespace

// A key that is the host's: because nothing is chosen, or because the medium did not use it.
void DocumentView::useKey(int key, Qt::KeyboardModifiers modifiers) {
    if (chosen() && chosenFigure().useKey(key, modifiers))
        return;
    if (!chosen() && text_->useKey(key, modifiers, false))
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
        if (!chosen() && !figures_->visible().empty())
            choose(figures_->visible().front());
        break;
    default:
        Q_EMIT unhandledKey(key, modifiers);
        if (!isWriting() && !chosen() && isWritten(key, modifiers))
            Q_EMIT triedToWrite();
    }
}

// --- the text that is selected -----------------------------------------------------------------

bool DocumentView::canCopy() const { return chosen() || text_->cursor().selects(); }

void DocumentView::copy() {
    if (chosen())
        chosenFigure().copy();
    else if (canCopy())
        text_->copy();
}

void DocumentView::selectAll() {
    choose(document::noSubdocument);
    text_->selectAll();
}

bool DocumentView::isWriting() const { return writing_->isOn(); }

ChosenFigure& DocumentView::chosenFigure() const { return writing_->chosenFigure(); }

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

// The selection of the desktop's other windows comes in where the pointer is.
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
    if (isWriting() && !chosen())
        writing_->compose(*event);
    event->accept();
}

QVariant DocumentView::inputMethodQuery(Qt::InputMethodQuery query) const {
    const QVariant answer = isWriting() ? writing_->answer(query) : QVariant();
    return answer.isValid() ? answer : QAbstractScrollArea::inputMethodQuery(query);
}

// The selection looks otherwise while the keys go elsewhere.
void DocumentView::focusInEvent(QFocusEvent* event) {
    QAbstractScrollArea::focusInEvent(event);
    text_->refresh();
    Q_EMIT focusChanged();
}

void DocumentView::focusOutEvent(QFocusEvent* event) {
    QAbstractScrollArea::focusOutEvent(event);
    Q_EMIT focusChanged();
    text_->refresh();
}

// Tab goes from rendition to rendition, then on to the other widgets. In text that one writes it is
// a command of writing.
bool DocumentView::focusNextPrevChild(bool next) {
    if (isWriting() && !chosen()) {
        writing_->goBy(next);
        return true;
    }
    std::vector<document::SubdocumentId> order;
    for (const layout::PlacedSubdocument& placed : pages().subdocuments())
        order.push_back(placed.subdocument);
    const auto at = std::find(order.begin(), order.end(), chosen());
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

// --- links, cursor -----------------------------------------------------------------------------

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

void DocumentView::updateCursor(QPointF point) {
    const bool isOnFigure = figures_->isAt(point);
    if (const auto cursor = writing_->gestures().cursorAt(point))
        viewport()->setCursor(*cursor);
    else if (folds_->isOver(point))
        viewport()->setCursor(Qt::PointingHandCursor);
    else if (const auto ofMedium = figures_->cursorAt(point))
        viewport()->setCursor(*ofMedium);
    else if (!isOnFigure && linkAt(point))
        viewport()->setCursor(Qt::PointingHandCursor);
    else if (!isOnFigure && text_->isOverText(point))
        viewport()->setCursor(Qt::IBeamCursor);
    else
        viewport()->setCursor(Qt::ArrowCursor);
}

} // namespace view
