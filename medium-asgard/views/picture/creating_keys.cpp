// Keys of an element that is being made: which it has a use for, a place that is typed, the cross.
#include "picture/creating.h"

#include "picture/scene_display.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>

#include <algorithm>

namespace views {

namespace {

// A letter, a digit or a blank, shifted or not.
bool isSign(const QKeyEvent& event) {
    constexpr auto others = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    const QString text = event.text();
    return !(event.modifiers() & others) && !text.isEmpty() && text.front().isPrint();
}

} // namespace

bool Creating::mayType() const {
    if (waiting_)
        return true;
    const Wanted wanted = begun_->step().wanted;
    return wanted == Wanted::point || (wanted == Wanted::hold && !begun_->shown().empty());
}

// A sign of a place's numbers. The sign between them is one only after a number.
bool Creating::types(const QKeyEvent& event) const {
    static const QString letters = QStringLiteral("0123456789.-+eE,; ");
    const auto isOfPlace = [](const QKeyEvent& one) {
        return one.text().size() == 1 && letters.contains(one.text());
    };
    const bool begun =
        !typed_.isEmpty() || (waiting_ && std::ranges::any_of(waiting_->keys, [&](const auto& one) {
                                  return isOfPlace(*one);
                              }));
    return mayType() && isSign(event) && isOfPlace(event) &&
           (begun || event.key() != Qt::Key_Space);
}

bool Creating::type(const QKeyEvent& event) {
    if (types(event))
        typed_ += event.text();
    else if (event.key() == Qt::Key_Backspace && mayType())
        typed_.chop(1);
    else
        return false;
    fault_.clear();
    next_ = indicating_.typed(*begun_, typed_);
    Q_EMIT changed();
    return true;
}

bool Creating::uses(const QKeyEvent& event) const {
    if (!active())
        return false;
    if (types(event))
        return true;
    if (isSign(event)) // the picture's commands wait: a slip of the hand moves nothing
        return true;
    constexpr auto others = Qt::AltModifier | Qt::MetaModifier;
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        return !(event.modifiers() & others);
    case Qt::Key_Escape:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Delete: // what is selected is not meant now
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
        return true;
    default:
        return false;
    }
}

bool Creating::key(const QKeyEvent& event) {
    if (!uses(event))
        return false;
    if (waiting_ && event.key() != Qt::Key_Escape) {
        waiting_->keys.emplace_back(event.clone());
        return true;
    }
    if (!inputs_.empty() && event.key() != Qt::Key_Escape) {
        inputs_.emplace_back(std::unique_ptr<QKeyEvent>(event.clone()));
        return true;
    }
    const double stride = event.modifiers() & Qt::ControlModifier ? 2 : 12;
    const auto cross = [&](double x, double y) {
        const QPointF now = cross_.value_or(QRectF(display_.rect()).center());
        cross_ = QPointF(std::clamp(now.x() + x, 0.0, display_.width() - 1.0),
                         std::clamp(now.y() + y, 0.0, display_.height() - 1.0));
        Q_EMIT changed();
    };
    if (begun_ && type(event))
        return true;
    switch (event.key()) {
    case Qt::Key_Escape:
        cancel();
        return true;
    case Qt::Key_Left:
        cross(-stride, 0);
        return true;
    case Qt::Key_Right:
        cross(stride, 0);
        return true;
    case Qt::Key_Up:
        cross(0, -stride);
        return true;
    case Qt::Key_Down:
        cross(0, stride);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (cross_)
            click(*std::exchange(cross_, std::nullopt));
        else
            otherwise();
        return true;
    default:
        return true;
    }
}

// A key that waited in vain does what it does in the window without a command.
void Creating::handBack(const QKeyEvent& event) {
    const QKeySequence keys(event.keyCombination());
    for (QAction* action : display_.window()->findChildren<QAction*>())
        if (action->isEnabled() && action->shortcuts().contains(keys))
            return action->trigger();
    const std::unique_ptr<QKeyEvent> again(event.clone());
    QCoreApplication::sendEvent(&display_, again.get());
}

} // namespace views
