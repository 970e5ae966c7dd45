// What is painted over a picture: labels, what is selected, what is said.
#include "gestures/handle_meaning.h"
#include "gestures/things.h"
#include "handles/handle_layout.h"
#include "labels/handle_labels.h"
#include "picture/picture_editing.h"
#include "picture/scene_display.h"

#include <QPainter>

namespace views {

QString PictureEditing::words() const { return QString::fromStdString(hand_.words()); }

// A dashed frame about each body that is selected, a ring about the handles of the others.
void PictureEditing::paintSelection(QPainter& painter) const {
    const bool dark = display_.palette().color(QPalette::Base).lightness() < 128;
    painter.setPen(
        QPen(dark ? QColor(110, 170, 255, 230) : QColor(20, 90, 200, 200), 1.3, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    const render::Drawing drawing = display_.drawn();
    const gestures::Sight sight = display_.sight();
    // LIMIT: of a crowd not all are framed: it would take longer than one wants to wait, and more
    // frames than one can tell apart.
    constexpr std::size_t most = 300;
    std::size_t framed = 0;
    for (const editing::Element& element : document_.selected()) {
        if (++framed > most)
            break;
        for (const render::Handle& handle : display_.drawnHandles().handles)
            if (element.kind != editing::Kind::body && gestures::elementOf(handle) == element)
                painter.drawEllipse(
                    display_.fromPixels(render::standOf(handle, sight.camera, sight.size)), 9, 9);
        if (element.kind != editing::Kind::body)
            continue;
        const double ratio = display_.devicePixelRatioF();
        const Eigen::AlignedBox2d frame =
            gestures::frameOf(drawing, sight, element.index, 4 * ratio);
        if (!frame.isEmpty())
            painter.drawRoundedRect(
                QRectF(display_.fromPixels(frame.min()), display_.fromPixels(frame.max())), 5, 5);
    }
}

void PictureEditing::paintWords(QPainter& painter, const QString& words, bool possible) const {
    if (words.isEmpty())
        return;
    const QRect space = display_.rect().adjusted(display_.width() / 3, 10, -12, -10);
    const QRect needed = painter.boundingRect(space, Qt::AlignRight | Qt::TextWordWrap, words);
    painter.setPen(Qt::NoPen);
    QColor paper = display_.palette().color(QPalette::Base);
    const bool dark = paper.lightness() < 128;
    paper.setAlpha(225);
    painter.setBrush(paper);
    painter.drawRoundedRect(needed.adjusted(-8, -4, 8, 4), 4, 4);
    painter.setPen(possible ? display_.palette().color(QPalette::Text)
                   : dark   ? QColor(255, 130, 120)
                            : QColor(170, 30, 20));
    painter.drawText(space, Qt::AlignRight | Qt::TextWordWrap, words);
}

// The axes that a drag keeps to, as lines through the whole picture.
void PictureEditing::paintAlong(QPainter& painter) const {
    const gestures::HandleDrag* drag = hand_.drag();
    if (!drag || !drag->along())
        return;
    const gestures::Sight sight = display_.sight();
    const Vector place = drag->place();
    const double reach = sight.pixelLength(place) * (sight.size.width + sight.size.height) / 8.0;
    for (int axis = 0; axis < 3; ++axis) {
        if ((axis == drag->along()->axis) == drag->along()->isPlane)
            continue;
        painter.setPen(QPen(QColor::fromRgb(colorOfAxis(axis)), 1.3));
        painter.drawLine(display_.fromPixels(sight.pixels(place - reach * Vector::Unit(axis))),
                         display_.fromPixels(sight.pixels(place + reach * Vector::Unit(axis))));
    }
}

void PictureEditing::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    paintSelection(painter);
    paintLabels(painter, display_, display_.meters());
    const auto answer = hand_.answer();
    const bool possible = !answer || answer->possible();
    const gestures::HandleDrag* drag = hand_.drag();
    const auto handle = marked();
    const bool isOfMany = handle && handle->kind == render::HandleKind::position &&
                          !companyOf(handle->element).empty(); // these have their frames
    if (drag || (handle && display_.hasFocus() && !isOfMany)) {
        const Vector place = drag ? drag->place() : handle->place;
        painter.setPen(QPen(possible ? QColor(20, 90, 200) : QColor(190, 40, 30), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(display_.fromPixels(display_.sight().pixels(place)), 11, 11);
    }
    paintAlong(painter);
    if (const gestures::NewPoint* point = hand_.newPoint()) {
        painter.setPen(QPen(QColor(20, 90, 200), 2));
        painter.drawEllipse(display_.fromPixels(display_.sight().pixels(point->place())), 8, 8);
    }
    if (dragging()) {
        paintWords(painter, words(), possible);
    } else if (!said().isEmpty()) {
        painter.setOpacity(said_.opacity());
        paintWords(painter, said(), !said_.isFault());
        painter.setOpacity(1);
    } else if (!display_.creating().active()) { // which has words of its own there
        paintWords(painter, display_.pointing().words(), true);
    }
}

} // namespace views
