#include "commands/asked_value.h"

#include "editing/number_text.h"
#include "element_edits/fixing.h"
#include "gestures/handle_meaning.h"
#include "gestures/new_point.h"
#include "gestures/standing.h"
#include "point_edits/shape_edit.h"
#include "point_edits/shape_points.h"
#include "point_edits/trajectory_edit.h"
#include "script/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace commands {

namespace {

using Values = std::vector<double>;

Values valuesOf(const std::vector<editing::Wish>& wishes) {
    Values all;
    for (const editing::Wish& wish : wishes)
        all.insert(all.end(), wish.values.begin(), wish.values.end());
    return all;
}

std::vector<std::string> namesOf(const scene::Scene& scene, const render::Handle& handle,
                                 std::size_t count) {
    if (count == 1)
        return {gestures::quantityOf(scene, handle)};
    if (count != 4)
        return {"x", "y", "z"};
    return {handle.kind == render::HandleKind::orientation ? "w" : "t", "x", "y", "z"};
}

std::shared_ptr<editing::Mapper> mapperOf(const gestures::Ground& of) {
    return std::make_shared<editing::Mapper>(
        of.text, of.scene, [scene = of.scene, motion = of.motion](const std::string& name) {
            return render::constantValue(*scene, motion.get(), name);
        });
}

// A point that ends one curve and begins the next moves in both, with its tangents.
editing::Answer movedPoint(const editing::TrajectoryEdits& path, const render::Handle& handle,
                           const Values& to) {
    const std::size_t point = gestures::pointOf(path, handle);
    return path.move(point, path.points()[point].time, {to[0], to[1], to[2]}, 0);
}

struct SizedShape {
    std::size_t shapeSet, bodies; // how many bodies have it
};

std::optional<SizedShape> sizedShapeOf(const scene::Scene& scene, const std::string& name) {
    const auto set = std::ranges::find(scene.shapeSets, name, &scene::ShapeSet::name);
    if (set == scene.shapeSets.end() || set->parts.size() != 1 ||
        editing::sizesOf(set->parts.front()).empty())
        return std::nullopt;
    return SizedShape{
        static_cast<std::size_t>(set - scene.shapeSets.begin()),
        static_cast<std::size_t>(std::ranges::count(scene.bodies, name, &scene::Body::shape))};
}

// LIMIT: where the text computes a place, the size alone changes.
void addPlaces(editing::Answer& sized, const std::string& text,
               const std::shared_ptr<const scene::Scene>& scene,
               const std::vector<editing::Wish>& places) {
    if (!sized.possible() || places.empty())
        return;
    const editing::Answer moved = editing::Mapper(text, scene).answer(places);
    text::Edits all = sized.edits;
    for (const text::Edit& edit : moved.edits)
        if (!text::join(all, edit))
            return;
    text::putInOrder(all);
    if (moved.possible())
        sized.edits = std::move(all);
}

// "": a surface can have these, in the order of surfaceWishes().
std::string whyNoSurface(const Values& values, bool hasOwnSticking) {
    const double restitution = values[0], sliding = values[1], sticking = values[2];
    if (!(restitution >= 0 && restitution <= 1))
        return "The restitution is a number from 0 to 1.";
    if (!(sliding >= 0 && sticking >= 0 && values[3] >= 0))
        return "Friction is 0 or more.";
    if (hasOwnSticking && sticking < sliding)
        return "The static friction is at least the friction.";
    return {};
}

std::vector<editing::Wish> surfaceWishes(const scene::Body& body, std::size_t which) {
    const auto wish = [which](const char* option, double now, double absent) {
        return editing::Wish{.element = {editing::Kind::body, which},
                             .option = option,
                             .path = {},
                             .values = {now},
                             .absent = {absent},
                             .now = {now}};
    };
    return {wish("-restitution", body.restitution, scene::Body().restitution),
            wish("-friction", body.friction, 0),
            wish("-static_friction", body.staticFriction.value_or(body.friction), body.friction),
            wish("-rolling_friction", body.rollingFriction, 0)};
}

} // namespace

std::vector<std::string> shownNumbers(const AskedValue& asked) {
    std::vector<std::string> shown;
    for (std::size_t i = 0; i < asked.now.size(); ++i) {
        const double value = asked.now[i];
        const double resolution = editing::decimalStep(1e-13 * std::max(1.0, std::abs(value)));
        shown.push_back(script::decimalNumber(asked.written[i])
                            ? asked.written[i]
                            : editing::numberText(value, resolution));
    }
    return shown;
}

std::optional<std::vector<double>> typedNumbers(const AskedValue& asked,
                                                const std::vector<std::string>& fields) {
    const std::vector<std::string> shown = shownNumbers(asked);
    Values values = asked.now;
    for (std::size_t i = 0; i < values.size() && i < fields.size(); ++i) {
        if (fields[i] == shown[i])
            continue;
        const auto number = script::decimalNumber(fields[i]);
        if (!number)
            return std::nullopt;
        values[i] = *number;
    }
    return values;
}

AskedValue askedOf(const gestures::Ground& of, const render::Handle& handle) {
    const scene::Scene& scene = *of.scene;
    AskedValue asked;
    asked.text = of.text;
    const auto mapper = mapperOf(of);
    auto wishes = gestures::wishesFor(scene, handle, handle.place, 0, false);
    if (handle.kind == render::HandleKind::orientation && mapper->count(wishes.front()) == 4)
        wishes = gestures::wishesFor(scene, handle, handle.place, 0, true);
    std::shared_ptr<editing::TrajectoryEdits> path;
    if (handle.kind == render::HandleKind::trajectoryPoint) {
        path = std::make_shared<editing::TrajectoryEdits>(asked.text, of.scene, handle.element);
        wishes = {path->wishOf(gestures::pointOf(*path, handle))};
    }
    asked.title = gestures::subjectOf(scene, handle) + ": " + gestures::quantityOf(scene, handle);
    asked.label = gestures::labelOf(scene, handle);
    asked.now = valuesOf(wishes);
    asked.names = namesOf(scene, handle, asked.now.size());
    for (const editing::Wish& wish : wishes)
        for (const std::string& one : mapper->written(wish))
            asked.written.push_back(one);
    asked.answer = [mapper, wishes, path, handle, now = asked.now,
                    shown = of.scene](const Values& values) {
        if (values != now && path && path->hasOwnTangents())
            return movedPoint(*path, handle, values);
        auto meant = gestures::withFollowing(*shown, gestures::withValues(wishes, values));
        if (values == now)
            for (editing::Wish& wish : meant)
                wish.now.clear();
        return mapper->answer(meant);
    };
    return asked;
}

std::optional<AskedValue> askedSize(const gestures::Ground& of, std::size_t body) {
    const auto& scene = of.scene;
    const std::string& shape = scene->bodies[body].shape;
    const auto sized = sizedShapeOf(*scene, shape);
    if (!sized)
        return std::nullopt;
    const scene::ShapeSet& set = scene->shapeSets[sized->shapeSet];
    AskedValue asked;
    asked.text = of.text;
    asked.title = scene->bodies[body].name + ": size";
    asked.label = "Change the Size of " + shape;
    if (sized->bodies > 1)
        asked.note = "All " + std::to_string(sized->bodies) + " bodies of the shape " + shape +
                     " change with it.";
    asked.now = editing::sizesOf(set.parts.front());
    asked.names = editing::sizeNames(set.parts.front());
    asked.written.resize(asked.now.size());
    asked.answer = [text = asked.text, scene, which = sized->shapeSet](const Values& values) {
        if (!std::ranges::all_of(values, [](double size) { return size > 0; })) {
            editing::Answer answer;
            answer.reason = "A size is a number above 0.";
            return answer;
        }
        auto draft = editing::draftOf(scene->shapeSets[which]);
        draft.front().part = editing::withSizes(draft.front().part, values);
        editing::Answer answer = editing::become(text, scene, which, draft);
        addPlaces(answer, text, scene,
                  gestures::standingStill(*scene, which, {draft.front().part}));
        return answer;
    };
    return asked;
}

AskedValue askedSurface(const gestures::Ground& of, std::size_t body) {
    const scene::Body& one = of.scene->bodies[body];
    const auto mapper = mapperOf(of);
    const auto wishes = surfaceWishes(one, body);
    AskedValue asked;
    asked.text = of.text;
    asked.title = one.name + ": surface";
    asked.label = "Change the Surface of " + one.name;
    asked.note = "Two bodies that touch have the smaller restitution, the "
                 "geometric mean of the frictions, and the larger rolling "
                 "friction, which is a length.";
    asked.names = {"restitution", "friction",
                   one.staticFriction ? "static friction" : "static friction (as friction)",
                   "rolling friction"};
    asked.now = valuesOf(wishes);
    for (const editing::Wish& wish : wishes)
        asked.written.push_back(mapper->written(wish).front());
    asked.answer = [mapper, wishes, now = asked.now,
                    hasOwn = one.staticFriction.has_value()](const Values& values) {
        if (std::string why = whyNoSurface(values, hasOwn || values[2] != now[2]); !why.empty()) {
            editing::Answer answer;
            answer.reason = std::move(why);
            return answer;
        }
        auto meant = gestures::withValues(wishes, values);
        std::erase_if(meant, [](const editing::Wish& wish) { return wish.values == wish.now; });
        return meant.empty() ? editing::Answer() : mapper->answer(meant);
    };
    return asked;
}

AskedValue askedFixed(const gestures::Ground& of, std::size_t body) {
    const scene::Body& one = of.scene->bodies[body];
    AskedValue asked;
    asked.text = of.text;
    asked.title = one.name + ": fixed (1: it never moves)";
    asked.label = one.fixed ? "Let " + one.name + " Move" : "Fix " + one.name;
    asked.names = {"fixed"};
    asked.now = {one.fixed ? 1.0 : 0.0};
    editing::Wish wish;
    wish.element = {editing::Kind::body, body};
    wish.option = "-fixed";
    wish.values = wish.now = asked.now;
    wish.absent = {0};
    const auto mapper = mapperOf(of);
    asked.written = mapper->written(wish);
    const auto properties = std::make_shared<editing::Properties>(asked.text, of.scene);
    asked.answer = [mapper, properties, wish, now = asked.now](const Values& values) {
        editing::Wish meant = wish;
        meant.values = values;
        if (values == now)
            meant.now.clear();
        if (values.front() != 0 && values.front() != 1)
            return editing::Answer{{}, "1 or 0, please.", {}, {}, {}};
        return editing::withBounce(*properties, mapper->scene(), {wish.element},
                                   values.front() == 1, mapper->answer(meant));
    };
    return asked;
}

std::vector<render::Handle> handlesOf(const scene::Scene& scene,
                                      const simulation::MotionPointer& motion,
                                      const editing::Element& element) {
    render::Display all;
    all.positionHandles = all.orientationHandles = all.velocityHandles = all.spinHandles =
        all.forceHandles = all.torqueHandles = all.linkHandles = all.jointHandles =
            all.lightHandles = true;
    std::vector<render::Handle> found;
    std::set<std::string> quantities;
    for (const render::Handle& one :
         render::Handles(scene, motion).at(scene.simulator.start, all).handles)
        if (one.movable && gestures::elementOf(one) == element &&
            quantities.insert(gestures::quantityOf(scene, one)).second)
            found.push_back(one);
    return found;
}

std::string whyNotFixed(const scene::Scene& scene, std::size_t body) {
    const scene::Body& one = scene.bodies[body];
    const auto held = std::ranges::find(scene.constraints, one.name, &scene::Constraint::body);
    if (one.fixed || held == scene.constraints.end())
        return {};
    return one.name + " follows the trajectory " + held->trajectory + " (line " +
           std::to_string(held->source.line) + " of the text): it cannot be fixed as well.";
}

} // namespace commands
