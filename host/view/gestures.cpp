#include "view/gestures.h"

#include "view/column_drag.h"
#include "view/document_view.h"
#include "view/resizing.h"

namespace view {

Gestures::Gestures(DocumentView& view) : view_(view) {
    add(std::make_unique<Resizing>(view));
    add(std::make_unique<ColumnDrag>(view));
}

Gestures::~Gestures() = default;

Gesture* Gestures::at(QPointF point) const {
    if (!view_.isWriting())
        return nullptr;
    for (const std::unique_ptr<Gesture>& gesture : all_)
        if (gesture->cursorAt(point))
            return gesture.get();
    return nullptr;
}

bool Gestures::press(QPointF point) {
    taken_ = at(point);
    if (taken_ != nullptr)
        taken_->take(point);
    view_.viewport()->update();
    return taken_ != nullptr;
}

bool Gestures::pressTwice(QPointF point) {
    Gesture* const gesture = at(point);
    if (gesture != nullptr)
        gesture->takeTwice(point);
    return gesture != nullptr;
}

bool Gestures::drag(QPointF point) {
    if (taken_ == nullptr)
        return false;
    taken_->drag(point);
    view_.viewport()->update();
    return true;
}

bool Gestures::release() {
    Gesture* const done = std::exchange(taken_, nullptr);
    if (done == nullptr)
        return false;
    done->finish();
    view_.viewport()->update();
    return true;
}

bool Gestures::cancel() {
    Gesture* const given = std::exchange(taken_, nullptr);
    if (given == nullptr)
        return false;
    given->cancel();
    view_.viewport()->update();
    return true;
}

std::optional<Qt::CursorShape> Gestures::cursorAt(QPointF point) const {
    Gesture* const gesture = taken_ != nullptr ? taken_ : at(point);
    return gesture == nullptr ? std::nullopt : gesture->cursorAt(point);
}

void Gestures::paint(QPainter& painter) const {
    if (!view_.isWriting())
        return;
    for (const std::unique_ptr<Gesture>& gesture : all_)
        gesture->paint(painter);
}

void Gestures::selectionChanged() {
    for (const std::unique_ptr<Gesture>& gesture : all_)
        gesture->selectionChanged();
}

} // namespace view
