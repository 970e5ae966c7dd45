#include "service/handle_editing.h"

#include "editing/element.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace service {

namespace {

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
    if (const gestures::HandleDrag* drag = hand_.drag()) {
        const auto held = std::ranges::find_if(
            set->handles, [&](const render::Handle& one) { return same(one, drag->handle()); });
        if (held != set->handles.end() && drag->answer().possible()) {
            held->base = held->isArrow() ? held->base : drag->place();
            held->place = drag->place();
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
    scale_ = scale;
    if (grasp->what == What::removePoint) {
        remove(ground, grasp->handle);
        return true;
    }
    hand_.take(std::move(ground), sight, *grasp, button, pixels, scale);
    say(hand_.words());
    return true;
}

// Nobody can be asked here about what depends on a trajectory.
void HandleEditing::remove(const gestures::Ground& ground, const render::Handle& handle) {
    const gestures::Removal removal = gestures::removalOf(ground, handle);
    if (!removal.possible())
        return say(removal.reason);
    if (removal.along.empty()) {
        ground.finish(text::applied(ground.text, removal.edits), removal.label);
        return say({});
    }
    std::string words = "With this point its trajectory goes, and with that";
    for (const editing::Element& one : removal.along)
        words +=
            (&one == removal.along.data() ? " " : ", ") + editing::describe(*ground.scene, one);
    say(words + ": a graphical viewer deletes them together.");
}

void HandleEditing::move(const Eigen::Vector2d& pixels, bool holdsOff) {
    hand_.move(pixels, holdsOff);
    say(active() ? hand_.words() : words_);
}

bool HandleEditing::key(const std::string& name, bool pressed) {
    using Key = gestures::Hand::Key;
    static const std::map<std::string, Key> keys{
        {"z", Key::away},        {"x", Key::nearer},       {"a", Key::free},
        {"Escape", Key::escape}, {"ArrowLeft", Key::left}, {"ArrowRight", Key::right},
        {"ArrowUp", Key::up},    {"ArrowDown", Key::down}};
    std::string letter = name;
    if (letter.size() == 1)
        std::ranges::transform(letter, letter.begin(),
                               [](unsigned char c) { return std::tolower(c); });
    const auto key = keys.find(letter);
    if (!active() || key == keys.end())
        return false;
    hand_.key(key->second, pressed, scale_);
    say(hand_.words());
    return true;
}

void HandleEditing::release(render::CameraControl::Button button) {
    sayLetGo(hand_.release(button));
}

void HandleEditing::finish() { sayLetGo(hand_.finish()); }

void HandleEditing::sayLetGo(const std::optional<gestures::Hand::LetGo>& gone) {
    if (gone)
        say(gone->fault);
}

void HandleEditing::cancel() {
    hand_.cancel();
    say({});
}

void HandleEditing::drop() { say(hand_.drop() ? gestures::Hand::overtaken : ""); }

void HandleEditing::say(std::string words) {
    words_ = std::move(words);
    ++generation_;
}

} // namespace service
