// What pointer and keys do in a scene's picture: the first that has a use for an event takes it.
#include "painting/pointer.h"
#include "picture/scene_display.h"
#include "plain/plain.h"
#include "surroundings/triad.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace views {

using Button = render::CameraControl::Button;

bool SceneDisplay::clickTriad(const QMouseEvent& event) {
    if (!display_.triad || event.button() != Qt::LeftButton ||
        event.modifiers() != Qt::NoModifier || control_.active() || creating_.active())
        return false;
    const auto end =
        render::triadDirectionAt(control_.camera(), pixelSize(), inPixels(event.position()));
    if (end)
        lookAlong(*end);
    return end.has_value();
}

void SceneDisplay::mousePressEvent(QMouseEvent* event) {
    if (!control_.active()) {
        press_.at = event->position();
        press_.isDrag = false;
    }
    const auto button = viewButton(event->button());
    bringUpToDate();
    if (!button)
        event->ignore();
    else if (clickTriad(*event)) {
    } else if (*button == Button::left && event->modifiers() == Qt::NoModifier &&
               !control_.active() && !creating_.active() && !editing_.dragging() &&
               !gizmo_.at(event->position()) && meters_.press(event->position())) {
    } else if (creating_.active() && *button == Button::left) {
        pressView(*button, event->position());
    } else if (editing_.dragging() || !selecting_.press(*event)) {
        if (!editing_.press(*event))
            pressView(*button, event->position());
    }
}

void SceneDisplay::pressView(Button button, const QPointF& position) {
    control_.press(button, inPixels(position), pixelSize(), render::upOf(*document_.shown().scene));
}

void SceneDisplay::mouseMoveEvent(QMouseEvent* event) {
    if (meters_.move(event->position()) || throwing_.move(*event) || selecting_.move(*event))
        return;
    if (!control_.active() && !editing_.dragging()) {
        pointing_.moveTo(event->position(), event->modifiers());
        creating_.hover(event->position(), event->modifiers() & Qt::ControlModifier);
    }
    if (!editing_.move(*event) && control_.active())
        moveView(*event);
}

bool SceneDisplay::beginDrag(QMouseEvent& event) {
    const bool isPlain = selecting_.awaitsClick();
    selecting_.forgetClick();
    if (!isPlain)
        return false;
    const auto arrow = gizmo_.at(press_.at);
    const auto body = arrow ? std::optional(arrow->body) : selecting_.draggedBodyAt(press_.at);
    if (!body)
        return false;
    if (arrow && arrow->isRing) {
        if (!editing_.turnBody(*body, press_.at, arrow->axis))
            return false;
        control_.release();
        editing_.move(event);
        return true;
    }
    using Along = gestures::HandleDrag::Along;
    if (!throwing_.press(*body, press_.at) &&
        !editing_.pressBody(*body, press_.at,
                            arrow ? std::optional(Along{arrow->axis, arrow->isPlane})
                                  : std::nullopt))
        return false;
    control_.release();
    if (!throwing_.move(event))
        editing_.move(event);
    return true;
}

// A drag begins when the pointer has left its place; then a body that is selected goes with it.
void SceneDisplay::moveView(QMouseEvent& event) {
    const bool isFar = !isNear(event.position(), press_.at);
    if (isFar && !std::exchange(press_.isDrag, true)) {
        if (beginDrag(event))
            return;
        if (!pointing_.advice().isEmpty())
            editing_.say(pointing_.advice(), false);
    }
    if ((event.buttons() & Qt::LeftButton) && !press_.isDrag)
        return;
    if (control_.move(inPixels(event.position()), pixelSize(),
                      event.modifiers() & Qt::AltModifier)) {
        press_.turns = true;
        movedByUser();
    }
}

void SceneDisplay::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && meters_.release()) {
        // It stays where it is.
    } else if (throwing_.release(*event)) {
        // The body is let go.
    } else if (creating_.active() && event->button() == Qt::LeftButton) {
        if (isNear(event->position(), press_.at))
            creating_.click(event->position(), event->modifiers() & Qt::ControlModifier);
    } else if (!editing_.dragging() && selecting_.release(*event)) {
        // It is selected.
    } else if (!editing_.release(*event) && control_.active() &&
               event->button() == Qt::RightButton && isNear(event->position(), press_.at)) {
        control_.release();
        Q_EMIT menuWanted(menuPlaceAt(document_, *this, event->position()));
        return;
    }
    control_.release();
    if (std::exchange(press_.turns, false))
        redraw(true);
    pointing_.moveTo(event->position(), event->modifiers());
}

void SceneDisplay::leaveEvent(QEvent* event) {
    pointing_.leave();
    QWidget::leaveEvent(event);
}

void SceneDisplay::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!creating_.active() && event->button() == Qt::LeftButton && !gizmo_.at(event->position()) &&
        meters_.doubleClick(event->position()))
        return;
    if (creating_.active() || !editing_.doubleClick(*event))
        mousePressEvent(event);
}

// While a handle is dragged its keys are no shortcuts.
bool SceneDisplay::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto& help = static_cast<const QHelpEvent&>(*event);
        const auto sign = faultSigns_.at(help.pos());
        QToolTip::showText(help.globalPos(), sign ? plain::tip(sign->words) : QString(), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride &&
        (editing_.dragging() || selecting_.hasBand() || meters_.holds() || throwing_.active() ||
         creating_.uses(static_cast<const QKeyEvent&>(*event)))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void SceneDisplay::wheelEvent(QWheelEvent* event) {
    bringUpToDate();
    control_.wheel(inPixels(event->position()), event->angleDelta().y() / 120.0, pixelSize());
    movedByUser();
    event->accept();
}

void SceneDisplay::keyPressEvent(QKeyEvent* event) {
    bringUpToDate();
    pointing_.setKeys(event->modifiers() |
                      (event->key() == Qt::Key_Shift ? Qt::ShiftModifier : Qt::NoModifier));
    if (event->key() == Qt::Key_Escape && (meters_.cancel() || throwing_.cancel() ||
                                           selecting_.cancel() || creating_.forgetMeasured()))
        return;
    if (creating_.key(*event) || editing_.keyPress(*event))
        return;
    if (turnKey(*event))
        return;
    const auto marked = editing_.marked();
    const QPointF pointer = mapFromGlobal(QPointF(QCursor::pos()));
    if (event->key() == Qt::Key_C && event->modifiers() == Qt::NoModifier)
        centerAt(rect().contains(pointer.toPoint()) || !marked
                     ? pointer
                     : fromPixels(sight().pixels(marked->place)));
    else
        QWidget::keyPressEvent(event);
}

// The right button has its menu when it is let go where it was pressed; this is the keyboard's.
void SceneDisplay::contextMenuEvent(QContextMenuEvent* event) {
    if (event->reason() == QContextMenuEvent::Keyboard && !creating_.active())
        Q_EMIT menuWanted(menuPlaceOfSelection(document_, *this));
    event->accept();
}

// What the buttons do with the view: Alt and the arrows turn it, with Page Up and Page Down roll
// it, Ctrl and the arrows move it, plus and minus scale it.
bool SceneDisplay::turnKey(const QKeyEvent& event) {
    const bool alt = event.modifiers() == Qt::AltModifier;
    const bool control = event.modifiers() == Qt::ControlModifier;
    constexpr double angle = 5 * M_PI / 180, way = 0.06;
    render::Camera camera = control_.camera();
    const auto turn = [&](const geometry::Vector& axis, double by) {
        camera.rotation =
            (geometry::Quaternion(Eigen::AngleAxisd(by, axis)) * camera.rotation).normalized();
    };
    const auto across = [&](double x, double y) {
        if (alt)
            camera.rotation =
                render::turnedUpright(camera.rotation, render::upOf(*document_.shown().scene),
                                      angle * render::virtualSphere * Eigen::Vector2d(x, y));
        else
            camera.position += way * geometry::Vector(x, y, 0);
        return alt || control;
    };
    bool is = false;
    switch (event.key()) {
    case Qt::Key_Left:
        is = across(-1, 0);
        break;
    case Qt::Key_Right:
        is = across(1, 0);
        break;
    case Qt::Key_Up:
        is = across(0, 1);
        break;
    case Qt::Key_Down:
        is = across(0, -1);
        break;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        turn(geometry::Vector::UnitZ(), event.key() == Qt::Key_PageUp ? angle : -angle);
        is = alt;
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
        camera.scale *= event.key() == Qt::Key_Minus ? 1 / 1.1 : 1.1;
        is = !alt && !control;
        break;
    default:
        break;
    }
    if (is)
        setCamera(camera);
    return is;
}

void SceneDisplay::keyReleaseEvent(QKeyEvent* event) {
    editing_.keyRelease(*event);
    if (event->key() == Qt::Key_Shift)
        pointing_.setKeys(event->modifiers() & ~Qt::ShiftModifier);
    QWidget::keyReleaseEvent(event);
}

void SceneDisplay::focusOutEvent(QFocusEvent* event) {
    editing_.finish();
    meters_.release();
    selecting_.cancel();
    update();
    QWidget::focusOutEvent(event);
}

} // namespace views
