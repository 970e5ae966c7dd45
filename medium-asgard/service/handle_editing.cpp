#include "service/handle_editing.h"

#include "editing/trajectory_edit.h"

#include <algorithm>
#include <utility>

namespace service {

namespace {

constexpr double keyStep = 6; // pixels of the reader, for a press of a key

bool same(const render::Handle& a, const render::Handle& b) {
    return a.kind == b.kind && a.element == b.element && a.part == b.part;
}

} // namespace

std::shared_ptr<const render::HandleSet>
HandleEditing::handles(const std::shared_ptr<const scene::Scene>& scene,
                       const render::Drawing& drawing, render::Size size) {
    if (!render::showsHandles(drawing.display))
        return nullptr;
    if (!prepared_ || prepared_->scene != scene || prepared_->motion != drawing.motion)
        prepared_.reset(
            new Prepared{scene, drawing.motion, render::Handles(*scene, drawing.motion)});
    auto set = std::make_shared<render::HandleSet>(
        prepared_->handles.at(drawing.time, drawing.display, drawing.camera, size));
    if (drag_) {
        const auto held = std::ranges::find_if(
            set->handles, [&](const render::Handle& one) { return same(one, drag_->handle()); });
        if (held != set->handles.end() && drag_->answer().possible()) {
            held->base = held->isArrow() ? held->base : drag_->place();
            held->place = drag_->place();
            held->aside.setZero(); // under the pointer
        }
    }
    return set;
}

bool HandleEditing::press(gestures::Ground ground, const render::Drawing& drawing,
                          render::Size size, double scale, render::CameraControl::Button button,
                          const Eigen::Vector2d& pixels) {
    using What = gestures::Grasp::What;
    if (active())
        return false;
    const auto set = handles(ground.scene, drawing, size);
    const gestures::Sight sight{drawing.camera, size};
    // Bodies are there without handles too.
    const auto grasp = gestures::graspAt(drawing, set ? *set : render::HandleSet(), sight, button,
                                         pixels, gestures::handleReach * scale);
    if (!grasp)
        return false;
    button_ = button;
    scale_ = scale;
    if (grasp->what == What::removePoint) {
        remove(ground, grasp->handle);
    } else if (grasp->what == What::newPoint) {
        newPoint_ = std::make_unique<gestures::NewPoint>(std::move(ground), sight, grasp->handle);
        say(newPoint_->words());
    } else {
        drag_ =
            std::make_unique<gestures::HandleDrag>(std::move(ground), sight, grasp->handle, pixels);
        if (grasp->what == What::roll)
            drag_->setRolls();
        say(drag_->words());
    }
    return true;
}

void HandleEditing::remove(const gestures::Ground& ground, const render::Handle& handle) {
    const editing::TrajectoryEdits edits(ground.text, ground.scene, handle.element);
    const editing::Answer answer = edits.remove(gestures::pointOf(edits, handle));
    if (answer.possible())
        ground.finish(text::applied(ground.text, answer.edits), "Remove a point");
    say(answer.reason);
}

void HandleEditing::move(const Eigen::Vector2d& pixels) {
    if (drag_)
        drag_->move(pixels);
    if (newPoint_)
        newPoint_->move(pixels);
    say(drag_ ? drag_->words() : newPoint_ ? newPoint_->words() : words_);
}

bool HandleEditing::key(const std::string& name, bool pressed) {
    if (!active())
        return false;
    if (name == "Escape" && pressed) {
        cancel();
        return true;
    }
    std::string letter = name;
    std::ranges::transform(letter, letter.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool pushes = letter == "z" || letter == "x";
    if (!pushes && letter != "a")
        return false;
    if (drag_ && letter == "a")
        drag_->setFree(pressed);
    else if (drag_ && pressed)
        drag_->push((letter == "z" ? keyStep : -keyStep) * scale_);
    if (drag_)
        say(drag_->words());
    return true;
}

void HandleEditing::release(render::CameraControl::Button button) {
    if (button == button_)
        finish();
}

void HandleEditing::finish() {
    // First: what it ends with may come back here.
    const auto drag = std::move(drag_);
    const auto newPoint = std::move(newPoint_);
    if (drag) {
        const bool possible = drag->answer().possible();
        drag->finish();
        say(possible ? "" : drag->words());
    } else if (newPoint) {
        const bool possible = newPoint->answer().possible();
        newPoint->finish();
        say(possible ? "" : newPoint->words());
    }
}

void HandleEditing::cancel() {
    const auto drag = std::move(drag_);
    const auto newPoint = std::move(newPoint_);
    if (drag)
        drag->cancel();
    else if (newPoint)
        newPoint->cancel();
    say({});
}

void HandleEditing::drop() {
    const bool lost = active();
    drag_.reset();
    newPoint_.reset();
    say(lost ? "The text was changed meanwhile, so the drag has ended." : "");
}

void HandleEditing::say(std::string words) {
    words_ = std::move(words);
    ++generation_;
}

} // namespace service
