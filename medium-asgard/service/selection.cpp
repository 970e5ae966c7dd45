#include "service/selection.h"

#include "editing/followed.h"
#include "element_edits/deletion.h"
#include "gestures/copies.h"
#include "gestures/grasp.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace service {

namespace {

constexpr double margin = 4; // of a frame, in the reader's pixels
constexpr double still = 4;  // two clicks in one place

} // namespace

void Selection::select(std::vector<editing::Element> elements) {
    isAsked_ = false;
    expected_.clear();
    if (elements == elements_)
        return;
    elements_ = std::move(elements);
    commands_.reset();
    ++generation_;
}

void Selection::click(const render::Drawing& drawing, const render::HandleSet& handles,
                      const gestures::Sight& sight, const Eigen::Vector2d& pixels, double scale) {
    const auto things =
        gestures::thingsAt(drawing, handles, sight, pixels, gestures::handleReach * scale);
    const bool isAgain = clicked_ && (*clicked_ - pixels).lpNorm<1>() < still * scale;
    clicked_ = pixels;
    const gestures::Thing* thing = gestures::meant(things, elements_, isAgain);
    select(thing ? std::vector{thing->element} : std::vector<editing::Element>());
}

void Selection::point(const render::Drawing& drawing, const render::HandleSet& handles,
                      const gestures::Sight& sight, const Eigen::Vector2d& pixels, double scale) {
    const auto things =
        gestures::thingsAt(drawing, handles, sight, pixels, gestures::handleReach * scale);
    const bool isThere = std::ranges::any_of(things, [&](const gestures::Thing& one) {
        return std::ranges::find(elements_, one.element) != elements_.end();
    });
    if (!isThere)
        select(things.empty() ? std::vector<editing::Element>()
                              : std::vector{things.front().element});
}

void Selection::follow(const std::shared_ptr<const scene::Scene>& scene, const std::string& text) {
    if (scene == scene_)
        return;
    if (!expected_.empty() && scene) {
        std::vector<editing::Element> there = expected_;
        std::erase_if(there, [&](const editing::Element& one) {
            return editing::sourceOf(*scene, one) == nullptr;
        });
        select(std::move(there));
    } else if (!elements_.empty()) {
        if (scene && scene_)
            select(editing::followed(elements_, {text_, *scene_}, {text, *scene},
                                     editing::renamedBetween(*scene_, *scene)));
        else
            select({});
    }
    scene_ = scene;
    text_ = text;
    commands_.reset();
}

std::string Selection::name() const {
    return elements_.empty() || !scene_ ? std::string()
                                        : editing::describe(*scene_, elements_.front());
}

const std::shared_ptr<const std::vector<ThingCommand>>&
Selection::commands(const simulation::MotionPointer& motion) {
    if (!commands_ && !elements_.empty() && scene_)
        commands_ = std::make_shared<const std::vector<ThingCommand>>(
            commandsOf(scene_, motion, elements_.front(), name()));
    return commands_;
}

std::string Selection::remove(const gestures::Ground& ground) {
    const editing::Deletion deletion = editing::deletionOf(ground.text, *ground.scene, elements_);
    if (!deletion.possible())
        return deletion.reason;
    if (!deletion.along.empty() && !std::exchange(isAsked_, true)) {
        std::string along;
        for (const editing::Element& one : deletion.along)
            along += (along.empty() ? "" : ", ") + editing::describe(*ground.scene, one);
        return "With " + name() + " goes: " + along + ". Delete once more takes all of it out.";
    }
    const std::string label = "Delete " + name();
    select({});
    ground.finish(text::applied(ground.text, deletion.edits), label);
    return {};
}

std::string Selection::duplicate(const gestures::Ground& ground) {
    const editing::Copied copy = editing::copied(ground.text, *ground.scene, elements_);
    if (!copy.possible())
        return copy.reason;
    editing::Pasted paste = gestures::pastedBeside(ground.text, *ground.scene, copy.commands);
    if (!paste.possible())
        return paste.reason;
    expected_ = std::move(paste.added);
    ground.finish(text::applied(ground.text, paste.edits), "Duplicate " + name());
    return {};
}

std::vector<Eigen::AlignedBox2d> Selection::frames(const render::Drawing& drawing,
                                                   const gestures::Sight& sight,
                                                   double scale) const {
    std::vector<Eigen::AlignedBox2d> all;
    if (drawing.scene != scene_.get()) // it is followed first
        return all;
    for (const editing::Element& element : elements_) {
        if (element.kind != editing::Kind::body)
            continue;
        const auto frame = gestures::frameOf(drawing, sight, element.index, margin * scale);
        if (!frame.isEmpty())
            all.push_back(frame);
    }
    return all;
}

void drawFrames(const std::vector<Eigen::AlignedBox2d>& frames, double scale, bool isDark,
                const render::Image& into) {
    if (frames.empty())
        return;
    cairo_surface_t* surface = cairo_image_surface_create_for_data(
        reinterpret_cast<unsigned char*>(into.pixels.data()), CAIRO_FORMAT_RGB24, into.size.width,
        into.size.height, static_cast<int>(into.stride));
    cairo_t* cairo = cairo_create(surface);
    if (isDark)
        cairo_set_source_rgba(cairo, 0.43, 0.67, 1, 0.9);
    else
        cairo_set_source_rgba(cairo, 0.08, 0.35, 0.78, 0.8);
    constexpr double width = 1.3, corner = 5;
    const std::array dashes{4 * width * scale, 2 * width * scale};
    cairo_set_line_width(cairo, width * scale);
    cairo_set_dash(cairo, dashes.data(), dashes.size(), 0);
    for (const Eigen::AlignedBox2d& frame : frames) {
        // Lines far out of the picture are cut off: cairo has small numbers only.
        const Eigen::AlignedBox2d near(
            Eigen::Vector2d(-100, -100),
            Eigen::Vector2d(into.size.width + 100.0, into.size.height + 100.0));
        const Eigen::AlignedBox2d box = frame.intersection(near);
        if (box.isEmpty())
            continue;
        constexpr double quarter = std::numbers::pi / 2;
        const double r = std::min(corner * scale, box.sizes().minCoeff() / 2);
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, box.max().x() - r, box.min().y() + r, r, -quarter, 0);
        cairo_arc(cairo, box.max().x() - r, box.max().y() - r, r, 0, quarter);
        cairo_arc(cairo, box.min().x() + r, box.max().y() - r, r, quarter, 2 * quarter);
        cairo_arc(cairo, box.min().x() + r, box.min().y() + r, r, 2 * quarter, 3 * quarter);
        cairo_close_path(cairo);
        cairo_stroke(cairo);
    }
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    cairo_surface_destroy(surface);
}

} // namespace service
