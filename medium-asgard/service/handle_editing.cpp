#include "service/handle_editing.h"

#include "editing/element.h"
#include "gestures/handle_meaning.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <utility>

namespace service {

namespace {

const render::HandleSet nothing;

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
        const auto held = std::ranges::find_if(set->handles, [&](const render::Handle& one) {
            return one.name() == drag->handle().name();
        });
        if (held != set->handles.end() && drag->answer().possible()) {
            held->base = held->isArrow() ? held->base : drag->place();
            held->place = drag->place();
            held->aside.setZero(); // under the pointer
        }
    }
    return set;
}

bool HandleEditing::press(gestures::Ground ground, const Picture& picture,
                          render::CameraControl::Button button, const Pointer& pointer) {
    using What = gestures::Grasp::What;
    if (active())
        return false;
    const render::Drawing& drawing = picture.drawing;
    const auto set = handles(ground.scene, drawing, picture.size);
    const render::HandleSet& shown = set ? *set : nothing;
    const gestures::Sight sight{drawing.camera, picture.size};
    const double reach = gestures::handleReach * picture.scale;
    // Bodies are there without handles too.
    const auto grasp = gestures::graspAt(drawing, shown, sight, button, pointer.pixels, reach);
    if (!grasp)
        return false;
    const bool isBody = grasp->what == What::drag &&
                        grasp->handle.kind == render::HandleKind::position &&
                        !gestures::handleAt(shown, sight, pointer.pixels, reach);
    if (isBody && picture.rate && take(ground, picture, sight, grasp->handle.element, pointer))
        return true;
    scale_ = picture.scale;
    if (grasp->what == What::removePoint) {
        remove(ground, grasp->handle);
        return true;
    }
    hand_.take(std::move(ground), sight, *grasp, button, pointer.pixels, scale_);
    say(hand_.words());
    return true;
}

bool HandleEditing::pressBody(gestures::Ground ground, const Picture& picture, std::size_t body,
                              const Pointer& pointer) {
    if (active())
        return false;
    const gestures::Sight sight{picture.drawing.camera, picture.size};
    if (picture.rate && take(ground, picture, sight, body, pointer))
        return true;
    const geometry::Vector& start = ground.scene->bodies[body].initialPosition;
    scale_ = picture.scale;
    hand_.take(std::move(ground), sight,
               {gestures::Grasp::What::drag, {render::HandleKind::position, body, 0, start, start}},
               render::CameraControl::Button::left, pointer.pixels, scale_);
    say(hand_.words());
    return true;
}

bool HandleEditing::take(const gestures::Ground& ground, const Picture& picture,
                         const gestures::Sight& sight, std::size_t body, const Pointer& pointer) {
    auto why = gestures::whyNotTaken(ground, picture.drawing.time, body);
    if (!why)
        return false;
    const double moment = gestures::roundMoment(*ground.motion, picture.drawing.time);
    if (why->empty())
        if (const auto joined = gestures::joinedAt(ground, moment, body, sight, pointer.pixels))
            why = joined->whyNotThrown();
    if (why->empty())
        thrown_.emplace(
            Thrown{{ground, moment, body, sight, pointer.pixels}, sight, *picture.rate});
    say(thrown_
            ? "Let go to throw " + thrown_->body.name() + "  \u00b7  Escape: it goes on as it was"
            : *why);
    return true;
}

void HandleEditing::letFly(double seconds) {
    Thrown thrown = *std::exchange(thrown_, std::nullopt); // what it ends with may come back here
    const gestures::Ground& ground = thrown.body.ground();
    if (!thrown.body.moved()) {
        ground.finish(ground.text, {});
        return say({});
    }
    const editing::Answer answer = thrown.body.answer(thrown.sight, thrown.rate, seconds);
    std::ostringstream label;
    label << "Throw " << thrown.body.name() << " at " << thrown.body.moment() << " s";
    ground.finish(text::applied(ground.text, answer.edits), label.str());
    say(answer.possible() ? gestures::countsAnew(ground, thrown.body.moment()) : answer.reason);
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

void HandleEditing::move(const Pointer& pointer) {
    if (thrown_) {
        thrown_->body.move(thrown_->sight, pointer.pixels, pointer.seconds);
        const auto answer = thrown_->body.answer(thrown_->sight, std::nullopt, pointer.seconds);
        const gestures::Ground& ground = thrown_->body.ground();
        if (answer.possible())
            ground.preview(text::applied(ground.text, answer.edits));
        return;
    }
    hand_.move(pointer.pixels, pointer.holdsOff);
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
    if (thrown_) {
        if (key->second == Key::escape && pressed)
            cancel();
        return true;
    }
    hand_.key(key->second, pressed, scale_);
    say(hand_.words());
    return true;
}

void HandleEditing::release(render::CameraControl::Button button, const Pointer& pointer) {
    if (!thrown_)
        sayLetGo(hand_.release(button));
    else if (button == render::CameraControl::Button::left)
        letFly(pointer.seconds);
}

// Nobody saw a throw to its end.
void HandleEditing::finish() {
    if (thrown_)
        return cancel();
    sayLetGo(hand_.finish());
}

void HandleEditing::sayLetGo(const std::optional<gestures::Hand::LetGo>& gone) {
    if (!gone)
        return;
    std::string words = gone->fault;
    if (gone->drag && !words.empty())
        if (const auto& ways = gone->drag->answer().offers; !ways.empty()) {
            refused_ = {gestures::labelOf(*gone->drag->ground().scene, gone->drag->handle()), ways};
            words += "  \u00b7  Right button: what can be done instead";
        }
    say(std::move(words));
}

void HandleEditing::cancel() {
    if (const auto thrown = std::exchange(thrown_, std::nullopt))
        thrown->body.ground().finish(thrown->body.ground().text, {});
    hand_.cancel();
    say({});
}

void HandleEditing::drop() {
    const bool wasThrown = std::exchange(thrown_, std::nullopt).has_value();
    say(hand_.drop() || wasThrown ? gestures::Hand::overtaken : "");
}

void HandleEditing::say(std::string words) {
    words_ = std::move(words);
    ++generation_;
}

} // namespace service
