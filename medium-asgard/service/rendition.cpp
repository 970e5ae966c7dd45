#include "service/rendition.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace service {
namespace {

constexpr const char* stateFormat = "asgard-4";
// States of before have as many switches as there were.
constexpr std::pair<const char*, std::ptrdiff_t> olderFormats[] = {{"asgard-2", 13},
                                                                   {"asgard-3", 15}};
constexpr bool render::Display::*displaySwitches[] = {&render::Display::wireframe,
                                                      &render::Display::axes,
                                                      &render::Display::grid,
                                                      &render::Display::trails,
                                                      &render::Display::positionHandles,
                                                      &render::Display::orientationHandles,
                                                      &render::Display::velocityHandles,
                                                      &render::Display::spinHandles,
                                                      &render::Display::forceHandles,
                                                      &render::Display::torqueHandles,
                                                      &render::Display::linkHandles,
                                                      &render::Display::lightHandles,
                                                      &render::Display::trajectories,
                                                      &render::Display::joints,
                                                      &render::Display::jointHandles,
                                                      &render::Display::shadows,
                                                      &render::Display::contactForces,
                                                      &render::Display::frictionCones};

bool same(const render::Display& a, const render::Display& b) {
    return a.background == b.background && a.opened == b.opened &&
           std::ranges::all_of(displaySwitches, [&](auto which) { return a.*which == b.*which; });
}

bool sound(const render::Camera& camera) {
    return camera.center.allFinite() && camera.position.allFinite() && camera.scale > 0 &&
           std::isfinite(camera.scale) && std::abs(camera.rotation.norm() - 1) < 1e-6;
}

} // namespace

std::optional<render::CameraControl::Button> buttonOf(ipc::Button button) {
    switch (button) {
    case ipc::Button::left:
        return render::CameraControl::Button::left;
    case ipc::Button::middle:
        return render::CameraControl::Button::middle;
    case ipc::Button::right:
        return render::CameraControl::Button::right;
    default:
        return std::nullopt;
    }
}

bool covers(const Look& shown, const Look& wanted) {
    return shown.generation == wanted.generation && shown.time == wanted.time &&
           shown.camera == wanted.camera && same(shown.display, wanted.display) &&
           shown.handles == wanted.handles && shown.selection == wanted.selection &&
           shown.values == wanted.values && shown.row == wanted.row &&
           shown.display.samples >= wanted.display.samples;
}

void Rendition::shape(const ipc::RenditionGeometry& geometry,
                      std::array<std::shared_ptr<const MappedSlot>, 2> slots) {
    geometry_ = geometry;
    presentation_ = presentationNamed(geometry.presentation).value_or(Presentation::picture);
    slots_ = std::move(slots);
    unacknowledged_.clear();
    shown_.reset();
    begun_.reset();
}

render::Size Rendition::size() const {
    return {static_cast<int>(geometry_.width), static_cast<int>(geometry_.height)};
}

void Rendition::see(const scene::Scene& scene, const simulation::MotionPointer& motion,
                    unsigned generation) {
    if (turned_ || followed_.of == std::pair(generation, size()))
        return; // how all of the motion is seen takes a look at all of it
    followed_.of = {generation, size()};
    followed_.view.emplace(scene, motion, followed_.name, size());
}

void Rendition::follow(const std::string& view) {
    followed_.name = view;
    turned_ = false;
    followed_.of.reset();
    control_.release();
}

render::Camera Rendition::camera(double time) const {
    if (turned_ || !followed_.view)
        return control_.camera();
    return followed_.view->at(time);
}

Around Rendition::around() const {
    using Keeps = render::Renderer::Keeps;
    const bool isFramedAnew = !turned_ && followed_.name.empty();
    return {around_, !knowsWhole_   ? Keeps::nothing
                     : isFramedAnew ? Keeps::whereItFits
                                    : Keeps::all};
}

void Rendition::holdView(double time) {
    if (turned_ || !followed_.name.empty())
        return;
    control_.set(camera(time));
    turned_ = true;
}

std::string Rendition::state() const {
    std::ostringstream words;
    words.precision(17);
    words << stateFormat;
    for (const auto which : displaySwitches)
        words << ' ' << (display.*which ? 1 : 0);
    words << ' ' << (turned_ ? 1 : 0);
    if (turned_) {
        const render::Camera camera = control_.camera();
        for (const auto& vector : {camera.center, camera.position})
            words << ' ' << vector.x() << ' ' << vector.y() << ' ' << vector.z();
        const auto& q = camera.rotation;
        words << ' ' << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' '
              << camera.scale;
    }
    words << ' ' << followed_.name;
    return words.str();
}

void Rendition::restore(const std::string& state) {
    std::istringstream words(state);
    std::string format, view;
    render::Display shown = display;
    render::Camera camera;
    bool turned = false;
    words >> format;
    const auto older =
        std::ranges::find(olderFormats, format, &std::pair<const char*, std::ptrdiff_t>::first);
    const bool isOlder = older != std::end(olderFormats);
    const auto count = isOlder ? older->second : std::ssize(displaySwitches);
    for (std::ptrdiff_t i = 0; i < count; ++i)
        words >> shown.*displaySwitches[i];
    words >> turned;
    if (turned) {
        for (auto* vector : {&camera.center, &camera.position})
            words >> vector->x() >> vector->y() >> vector->z();
        auto& q = camera.rotation;
        words >> q.w() >> q.x() >> q.y() >> q.z() >> camera.scale;
    }
    if (!words || (format != stateFormat && !isOlder) || !sound(camera))
        return;
    words.ignore(1);
    std::getline(words, view);
    follow(view);
    display = shown;
    turned_ = turned;
    control_.set(camera);
}

bool Rendition::input(const ipc::Input& input, double time, const render::Vector& up) {
    if (!turned_)
        control_.set(camera(time));
    const Eigen::Vector2d pixels(input.x, input.y);
    const auto held = [&](ipc::Modifier key) {
        return std::ranges::find(input.modifiers, key) != input.modifiers.end();
    };
    const auto button = buttonOf(input.button);
    bool changed = false;
    if (input.type == ipc::InputType::press && button && !held(ipc::Modifier::shift)) {
        control_.press(*button, pixels, size(), up);
    } else if (input.type == ipc::InputType::move && control_.active()) {
        changed = control_.move(pixels, size(), held(ipc::Modifier::alt));
    } else if (input.type == ipc::InputType::release || input.type == ipc::InputType::focusOut) {
        control_.release();
    } else if (input.type == ipc::InputType::wheel && input.dy != 0) {
        control_.wheel(pixels, input.dy, size());
        changed = true;
    }
    turned_ = turned_ || changed;
    return changed;
}

std::optional<ipc::Integer> Rendition::freeSlot() const {
    for (const ipc::Integer slot : {0, 1})
        if (std::ranges::none_of(unacknowledged_,
                                 [&](auto& entry) { return entry.second == slot; }))
            return slot;
    return std::nullopt;
}

Rendition::Frame Rendition::begin(const Look& look) {
    const ipc::Integer slot = freeSlot().value();
    Frame frame;
    frame.message.rendition = geometry_.rendition;
    frame.message.slot = slot;
    frame.message.width = geometry_.width;
    frame.message.height = geometry_.height;
    frame.message.time = look.time;
    frame.into.size = size();
    frame.into.stride = static_cast<std::size_t>(4 * geometry_.width);
    if (sharesMemory()) {
        const auto index = static_cast<std::size_t>(slot);
        frame.slot = slots_[index];
        frame.into.pixels = frame.slot->pixels();
        frame.into.stride = static_cast<std::size_t>(geometry_.slots[index].stride);
    }
    frame.look = begun_ = std::make_shared<const Look>(look);
    return frame;
}

void Rendition::finish(Frame& frame) {
    knowsWhole_ = knowsWhole_ || frame.isWhole;
    frame.message.serial = ++serial_;
    unacknowledged_[serial_] = frame.message.slot;
    shown_ = *begun_;
    begun_.reset();
}

} // namespace service
