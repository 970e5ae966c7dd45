#include "view/text_drag.h"

#include "clipboard/copying.h"
#include "clipboard/pictures_in.h"
#include "view/document_view.h"
#include "view/writing.h"

#include <QApplication>
#include <QDrag>
#include <QMimeData>

namespace view {

namespace {

bool isText(const QMimeData& data) {
    return data.hasFormat(fragmentFormat) ||
           ((data.hasHtml() || data.hasText()) && !data.hasUrls()) || holdsPictures(data);
}

} // namespace

TextDrag::TextDrag(DocumentView& view, TextHand& hand, Writing& writing)
    : view_(view), hand_(hand), writing_(writing) {}

bool TextDrag::press(const QMouseEvent& event) {
    if (event.modifiers() != Qt::NoModifier || !hand_.isSelected(event.position()))
        return false;
    pressed_ = event.position();
    return true;
}

bool TextDrag::move(const QMouseEvent& event) {
    if (!pressed_)
        return false;
    if ((event.position() - *pressed_).manhattanLength() >= QApplication::startDragDistance()) {
        pressed_.reset();
        start();
    }
    return true;
}

bool TextDrag::release(const QMouseEvent& event) {
    if (!pressed_)
        return false;
    pressed_.reset();
    hand_.press(event);
    hand_.release();
    return true;
}

// A text that is written is moved, as long as nobody asks for a copy.
void TextDrag::start() {
    std::unique_ptr<QMimeData> data = hand_.copied();
    if (!data)
        return;
    dragged_ = hand_.cursor().interval();
    QPointer<DocumentView> alive = &view_; // a drop may close the window
    auto* drag = new QDrag(&view_);
    drag->setMimeData(data.release());
    const bool writes = writing_.isOn();
    const Qt::DropAction done =
        drag->exec(writes ? Qt::CopyAction | Qt::MoveAction : Qt::CopyAction,
                   writes ? Qt::MoveAction : Qt::CopyAction);
    if (!alive)
        return;
    // Another window has it now. Text dropped in this one is moved already.
    if (done == Qt::MoveAction && dragged_)
        writing_.cutAway();
    dragged_.reset();
}

bool TextDrag::hover(QDropEvent& event) {
    if (!writing_.isOn() || !isText(*event.mimeData()))
        return false;
    hovered_ = hand_.caretAt(event.position());
    if (!hovered_)
        return false;
    event.acceptProposedAction();
    view_.viewport()->update();
    return true;
}

void TextDrag::leave() {
    hovered_.reset();
    view_.viewport()->update();
}

bool TextDrag::drop(QDropEvent& event) {
    if (!hover(event))
        return false;
    leave();
    const bool isOwn = event.source() == &view_ && dragged_;
    const bool moves = isOwn && event.dropAction() == Qt::MoveAction;
    writing_.drop(*event.mimeData(), event.position(), moves ? dragged_ : std::nullopt);
    if (isOwn)
        dragged_.reset();
    event.acceptProposedAction();
    view_.setFocus();
    return true;
}

void TextDrag::paint(QPainter& painter, std::size_t page) const {
    if (!hovered_ || hovered_->page != page)
        return;
    const QRectF rect =
        places::Carets(view_.pages(), view_.document().document().tree()).rectOf(*hovered_);
    const double width = 2 / painter.transform().m11();
    painter.fillRect(QRectF(rect.left() - width / 2, rect.top(), width, rect.height()),
                     view_.palette().color(QPalette::Highlight));
}

} // namespace view
