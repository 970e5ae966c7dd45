// The pointer and the keys on the time strip.
#include "trajectories/time_strip.h"

#include "editing/number_text.h"
#include "script/numbers.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>

#include <cmath>

namespace views {

namespace {

constexpr double dragFrom = 3; // pixels after which a press is a drag

} // namespace

void TimeStrip::mousePressEvent(QMouseEvent* event) {
    press_.at = event->position();
    press_.left = false;
    const auto mark = markAt(event->position());
    if (gesture_ || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton))
        return;
    delete field_;
    if (mark && event->button() == Qt::LeftButton) {
        press_.grip = Grip::mark;
        press_.offset = position(points()[*mark].time) - event->position().x();
        choose(*mark);
    } else {
        press_.grip = Grip::scale;
        press_.time = timeAt(press_.at.x());
        setCursor(Qt::ClosedHandCursor);
    }
}

void TimeStrip::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    if (press_.grip == Grip::none) {
        setCursor(markAt(event->position()) ? Qt::SizeHorCursor : Qt::ArrowCursor);
        return;
    }
    press_.left = press_.left || std::abs(x - press_.at.x()) >= dragFrom;
    if (!press_.left)
        return;
    if (press_.grip == Grip::mark)
        return retime(
            editing::roundedTo(timeAt(x + press_.offset), editing::decimalStep(timeStep())));
    scaled(scale_.pan(press_.time - timeAt(x)));
}

void TimeStrip::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(press_.grip, Grip::none) == Grip::mark)
        finish();
    unsetCursor();
}

void TimeStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto mark = markAt(event->position())) {
        press_.grip = Grip::none;
        choose(*mark);
        askForTime();
    } else {
        showAll();
    }
}

void TimeStrip::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    if (turned.x() != 0 || (event->modifiers() & Qt::ShiftModifier)) {
        const int along = turned.x() != 0 ? turned.x() : turned.y();
        scaled(scale_.pan(-along * scale_.length() / 1200));
    } else {
        zoom(std::pow(0.998, turned.y()), timeAt(event->position().x()));
    }
    event->accept();
}

void TimeStrip::contextMenuEvent(QContextMenuEvent* event) {
    if (const auto mark =
            event->reason() == QContextMenuEvent::Mouse ? markAt(QPointF(event->pos())) : chosen_)
        choose(*mark);
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QAction* time = menu->addAction(tr("Exact &Time…"), this, [this] { askForTime(); });
    QAction* removal = menu->addAction(tr("&Remove Point"), this, [this] { removeChosen(); });
    time->setEnabled(chosen_.has_value());
    removal->setEnabled(chosen_.has_value());
    menu->addSeparator();
    menu->addAction(tr("&Show All Points"), this, [this] { showAll(); });
    menu->popup(event->globalPos());
}

// The keys that mean something here are no shortcuts of the window.
bool TimeStrip::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_0:
            event->accept();
            return true;
        case Qt::Key_Escape:
            if (gesture_) {
                event->accept();
                return true;
            }
            break;
        default:
            break;
        }
    }
    return QWidget::event(event);
}

void TimeStrip::keyPressEvent(QKeyEvent* event) {
    const double many = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_PageUp:
        return chooseNext(-1);
    case Qt::Key_PageDown:
        return chooseNext(1);
    case Qt::Key_Home:
        chosen_.reset();
        return chooseNext(1);
    case Qt::Key_End:
        chosen_.reset();
        return chooseNext(-1);
    case Qt::Key_Left:
        return nudge(-many);
    case Qt::Key_Right:
        return nudge(many);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return askForTime();
    case Qt::Key_Delete:
        return removeChosen();
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(0.5, scale_.middle());
    case Qt::Key_Minus:
        return zoom(2, scale_.middle());
    case Qt::Key_0:
        return showAll();
    case Qt::Key_Escape:
        return cancel();
    default:
        QWidget::keyPressEvent(event);
    }
}

void TimeStrip::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat() && press_.grip != Grip::mark)
        finish();
    QWidget::keyReleaseEvent(event);
}

void TimeStrip::focusOutEvent(QFocusEvent* event) {
    if (press_.grip != Grip::mark)
        finish();
    QWidget::focusOutEvent(event);
    update();
}

} // namespace views
