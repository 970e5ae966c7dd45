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
    pressed_ = event->position();
    left_ = false;
    const auto mark = markAt(event->position());
    if (gesture_ || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton))
        return;
    delete field_;
    if (mark && event->button() == Qt::LeftButton) {
        grip_ = Grip::mark;
        offset_ = position(points()[*mark].time) - event->position().x();
        choose(*mark);
    } else {
        grip_ = Grip::scale;
        pressedFrom_ = from_;
        pressedTo_ = to_;
        setCursor(Qt::ClosedHandCursor);
    }
}

void TimeStrip::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    if (grip_ == Grip::none) {
        setCursor(markAt(event->position()) ? Qt::SizeHorCursor : Qt::ArrowCursor);
        return;
    }
    left_ = left_ || std::abs(x - pressed_.x()) >= dragFrom;
    if (!left_)
        return;
    if (grip_ == Grip::mark)
        return retime(editing::roundedTo(timeAt(x + offset_), editing::decimalStep(timeStep())));
    const double shift = (pressed_.x() - x) / area().width() * (pressedTo_ - pressedFrom_);
    zoomed_ = true;
    setSeen(pressedFrom_ + shift, pressedTo_ + shift);
}

void TimeStrip::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(grip_, Grip::none) == Grip::mark)
        finish();
    unsetCursor();
}

void TimeStrip::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto mark = markAt(event->position())) {
        grip_ = Grip::none;
        choose(*mark);
        askForTime();
    } else {
        showAll();
    }
}

void TimeStrip::wheelEvent(QWheelEvent* event) {
    const QPoint turned = event->angleDelta();
    const double length = to_ - from_;
    if (turned.x() != 0 || (event->modifiers() & Qt::ShiftModifier)) {
        const int along = turned.x() != 0 ? turned.x() : turned.y();
        zoomed_ = true;
        setSeen(from_ - along * length / 1200, to_ - along * length / 1200);
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
        return zoom(0.5, (from_ + to_) / 2);
    case Qt::Key_Minus:
        return zoom(2, (from_ + to_) / 2);
    case Qt::Key_0:
        return showAll();
    case Qt::Key_Escape:
        return cancel();
    default:
        QWidget::keyPressEvent(event);
    }
}

void TimeStrip::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat() && grip_ != Grip::mark)
        finish();
    QWidget::keyReleaseEvent(event);
}

void TimeStrip::focusOutEvent(QFocusEvent* event) {
    if (grip_ != Grip::mark)
        finish();
    QWidget::focusOutEvent(event);
    update();
}

} // namespace views
