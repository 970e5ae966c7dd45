#include "gestures/hand.h"

#include "element_edits/deletion.h"
#include "gestures/handle_meaning.h"

#include <algorithm>
#include <utility>

namespace gestures {

namespace {

constexpr double keyStep = 6; // pixels of the reader, for a press of a key

} // namespace

void Hand::take(Ground ground, const Sight& sight, const Grasp& grasp, Button button,
                const Eigen::Vector2d& pixels, double scale) {
    button_ = button;
    if (grasp.what == Grasp::What::newPoint) {
        newPoint_ = std::make_unique<NewPoint>(std::move(ground), sight, grasp.handle);
        return;
    }
    drag_ = std::make_unique<HandleDrag>(std::move(ground), sight, grasp.handle, pixels);
    drag_->setCompany(grasp.company);
    if (grasp.what == Grasp::What::roll)
        drag_->setRolls();
    else
        drag_->setSnaps(scale);
}

void Hand::setUpright(const std::optional<HandleDrag::Along>& along) {
    if (!drag_)
        return;
    drag_->setUpright();
    drag_->setAlong(along);
}

void Hand::setTurns(int axis) {
    if (drag_)
        drag_->setTurns(axis);
}

bool Hand::keepAlong(const HandleDrag::Along& along) {
    if (drag_ && drag_->turnsAbout()) {
        drag_->setTurns(along.axis);
        return true;
    }
    if (!drag_ || !drag_->isUpright())
        return false;
    drag_->setAlong(drag_->along() == along ? std::nullopt : std::optional(along));
    return true;
}

void Hand::takeByKeys(Ground ground, const Sight& sight, const render::Handle& handle,
                      const std::vector<std::size_t>& company) {
    button_.reset();
    drag_ = std::make_unique<HandleDrag>(std::move(ground), sight, handle, std::nullopt);
    drag_->setCompany(company);
}

std::optional<editing::Answer> Hand::answer() const {
    if (drag_)
        return drag_->answer();
    return newPoint_ ? std::optional(newPoint_->answer()) : std::nullopt;
}

std::string Hand::words() const {
    return drag_ ? drag_->words() : newPoint_ ? newPoint_->words() : std::string();
}

void Hand::move(const Eigen::Vector2d& pixels, bool holdsOff) {
    if (newPoint_)
        return newPoint_->move(pixels);
    if (!drag_ || !button_)
        return;
    drag_->holdSnapsOff(holdsOff);
    drag_->move(pixels);
}

bool Hand::key(Key key, bool pressed, double scale) {
    if (!active())
        return false;
    if (key == Key::escape) {
        if (pressed)
            cancel();
        return true;
    }
    if (!drag_)
        return true;
    const double step = pressed ? keyStep * scale : 0;
    if (key == Key::free)
        drag_->setFree(pressed);
    else if (!pressed)
        return true;
    else if (key == Key::away || key == Key::nearer)
        drag_->push(key == Key::away ? step : -step);
    else if (key == Key::left || key == Key::right)
        drag_->nudge({key == Key::right ? step : -step, 0});
    else
        drag_->nudge({0, key == Key::down ? step : -step});
    return true;
}

std::optional<Hand::LetGo> Hand::release(Button button) {
    return button_ == button ? finish() : std::nullopt;
}

std::optional<Hand::LetGo> Hand::finish() {
    // First: what it ends with may come back here.
    LetGo gone{std::move(drag_), {}};
    const auto newPoint = std::move(newPoint_);
    if (!gone.drag && !newPoint)
        return std::nullopt;
    if (gone.drag) {
        const bool possible = gone.drag->answer().possible();
        gone.drag->finish();
        gone.fault = possible ? std::string() : gone.drag->words();
    } else {
        const bool possible = newPoint->answer().possible();
        newPoint->finish();
        gone.fault = possible ? std::string() : newPoint->words();
    }
    return gone;
}

void Hand::cancel() {
    const auto drag = std::move(drag_);
    const auto newPoint = std::move(newPoint_);
    if (drag)
        drag->cancel();
    else if (newPoint)
        newPoint->cancel();
}

bool Hand::drop() {
    const bool held = active();
    drag_.reset();
    newPoint_.reset();
    return held;
}

Removal removalOf(const Ground& ground, const render::Handle& point) {
    const editing::TrajectoryEdits edits(ground.text, ground.scene, point.element);
    const std::size_t index = pointOf(edits, point);
    editing::Answer answer = edits.remove(index);
    if (answer.possible())
        return {std::move(answer.edits), "Remove a point", false, {}, {}};
    const auto onCurve =
        std::ranges::count_if(edits.points(), [](const auto& one) { return one.onCurve; });
    if (!edits.points()[index].onCurve || onCurve > 2)
        return {{}, {}, false, {}, answer.reason};
    const editing::Element path = elementOf(point);
    editing::Deletion deletion = editing::deletionOf(ground.text, *ground.scene, {path});
    return {std::move(deletion.edits), "Delete " + editing::describe(*ground.scene, path), true,
            std::move(deletion.along), deletion.reason};
}

} // namespace gestures
