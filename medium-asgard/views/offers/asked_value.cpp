#include "offers/asked_value.h"

#include "element_edits/fixing.h"
#include "gestures/handle_meaning.h"
#include "gestures/new_point.h"
#include "gestures/standing.h"
#include "point_edits/shape_edit.h"
#include "point_edits/shape_points.h"
#include "point_edits/trajectory_edit.h"
#include "shapes/shape_fields.h"

#include <algorithm>

namespace views {

namespace {

using Values = std::vector<double>;

QString words(const std::string& text) { return QString::fromStdString(text); }

Values valuesOf(const std::vector<editing::Wish>& wishes) {
    Values all;
    for (const editing::Wish& wish : wishes)
        all.insert(all.end(), wish.values.begin(), wish.values.end());
    return all;
}

QStringList namesOf(const render::Handle& handle, std::size_t count) {
    if (count != 4)
        return {SceneDocument::tr("x"), SceneDocument::tr("y"), SceneDocument::tr("z")};
    return {handle.kind == render::HandleKind::orientation ? SceneDocument::tr("w")
                                                           : SceneDocument::tr("t"),
            SceneDocument::tr("x"), SceneDocument::tr("y"), SceneDocument::tr("z")};
}

std::shared_ptr<editing::Mapper> mapperOf(const std::string& text, const Shown& of) {
    return std::make_shared<editing::Mapper>(text, of.scene, [of](const std::string& name) {
        return render::constantValue(*of.scene, of.motion.get(), name);
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
QString whyNoSurface(const Values& values, bool hasOwnSticking) {
    const double restitution = values[0], sliding = values[1], sticking = values[2];
    if (!(restitution >= 0 && restitution <= 1))
        return SceneDocument::tr("The restitution is a number from 0 to 1.");
    if (!(sliding >= 0 && sticking >= 0 && values[3] >= 0))
        return SceneDocument::tr("Friction is 0 or more.");
    if (hasOwnSticking && sticking < sliding)
        return SceneDocument::tr("The static friction is at least the friction.");
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

AskedValue askedOf(SceneDocument& document, const Shown& of, const render::Handle& handle) {
    const scene::Scene& scene = *of.scene;
    AskedValue asked;
    asked.text = document.text();
    const auto mapper = mapperOf(asked.text, of);
    auto wishes = gestures::wishesFor(scene, handle, handle.place, 0, false);
    if (handle.kind == render::HandleKind::orientation && mapper->count(wishes.front()) == 4)
        wishes = gestures::wishesFor(scene, handle, handle.place, 0, true);
    std::shared_ptr<editing::TrajectoryEdits> path;
    if (handle.kind == render::HandleKind::trajectoryPoint) {
        path = std::make_shared<editing::TrajectoryEdits>(asked.text, of.scene, handle.element);
        wishes = {path->wishOf(gestures::pointOf(*path, handle))};
    }
    asked.title = SceneDocument::tr("%1: %2").arg(words(gestures::subjectOf(scene, handle)),
                                                  words(gestures::quantityOf(scene, handle)));
    asked.label = words(gestures::labelOf(scene, handle));
    asked.now = valuesOf(wishes);
    asked.names = namesOf(handle, asked.now.size());
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

std::optional<AskedValue> askedSize(SceneDocument& document, std::size_t body) {
    const auto scene = document.shown().scene;
    const std::string& shape = scene->bodies[body].shape;
    const auto sized = sizedShapeOf(*scene, shape);
    if (!sized)
        return std::nullopt;
    const scene::ShapeSet& set = scene->shapeSets[sized->shapeSet];
    AskedValue asked;
    asked.text = document.text();
    asked.title = SceneDocument::tr("%1: size").arg(words(scene->bodies[body].name));
    asked.label = SceneDocument::tr("Change the Size of %1").arg(words(shape));
    if (sized->bodies > 1)
        asked.note = SceneDocument::tr("All %1 bodies of the shape %2 change with it.")
                         .arg(sized->bodies)
                         .arg(words(shape));
    asked.now = editing::sizesOf(set.parts.front());
    asked.names = sizeNames(set.parts.front());
    asked.written.resize(asked.now.size());
    asked.answer = [text = asked.text, scene, which = sized->shapeSet](const Values& values) {
        if (!std::ranges::all_of(values, [](double size) { return size > 0; })) {
            editing::Answer answer;
            answer.reason = SceneDocument::tr("A size is a number above 0.").toStdString();
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

AskedValue askedSurface(SceneDocument& document, std::size_t body) {
    const Shown& of = document.shown();
    const scene::Body& one = of.scene->bodies[body];
    const auto mapper = mapperOf(document.text(), of);
    const auto wishes = surfaceWishes(one, body);
    AskedValue asked;
    asked.text = document.text();
    asked.title = SceneDocument::tr("%1: surface").arg(words(one.name));
    asked.label = SceneDocument::tr("Change the Surface of %1").arg(words(one.name));
    asked.note = SceneDocument::tr("Two bodies that touch have the smaller restitution, the "
                                   "geometric mean of the frictions, and the larger rolling "
                                   "friction, which is a length.");
    asked.names = {SceneDocument::tr("restitution"), SceneDocument::tr("friction"),
                   one.staticFriction ? SceneDocument::tr("static friction")
                                      : SceneDocument::tr("static friction (as friction)"),
                   SceneDocument::tr("rolling friction")};
    asked.now = valuesOf(wishes);
    for (const editing::Wish& wish : wishes)
        asked.written.push_back(mapper->written(wish).front());
    asked.answer = [mapper, wishes, now = asked.now,
                    hasOwn = one.staticFriction.has_value()](const Values& values) {
        if (const QString why = whyNoSurface(values, hasOwn || values[2] != now[2]);
            !why.isEmpty()) {
            editing::Answer answer;
            answer.reason = why.toStdString();
            return answer;
        }
        auto meant = gestures::withValues(wishes, values);
        std::erase_if(meant, [](const editing::Wish& wish) { return wish.values == wish.now; });
        return meant.empty() ? editing::Answer() : mapper->answer(meant);
    };
    return asked;
}

AskedValue askedFixed(SceneDocument& document, std::size_t body) {
    const Shown& of = document.shown();
    const scene::Body& one = of.scene->bodies[body];
    AskedValue asked;
    asked.text = document.text();
    asked.title = SceneDocument::tr("%1: fixed (1: it never moves)").arg(words(one.name));
    asked.label = (one.fixed ? SceneDocument::tr("Let %1 Move") : SceneDocument::tr("Fix %1"))
                      .arg(words(one.name));
    asked.names = {SceneDocument::tr("fixed")};
    asked.now = {one.fixed ? 1.0 : 0.0};
    editing::Wish wish;
    wish.element = {editing::Kind::body, body};
    wish.option = "-fixed";
    wish.values = wish.now = asked.now;
    wish.absent = {0};
    const auto mapper = mapperOf(asked.text, of);
    asked.written = mapper->written(wish);
    const auto properties = std::make_shared<editing::Properties>(asked.text, of.scene);
    asked.answer = [mapper, properties, wish, now = asked.now](const Values& values) {
        editing::Wish meant = wish;
        meant.values = values;
        if (values == now)
            meant.now.clear();
        if (values.front() != 0 && values.front() != 1)
            return editing::Answer{
                {}, SceneDocument::tr("1 or 0, please.").toStdString(), {}, {}, {}};
        return editing::withBounce(*properties, mapper->scene(), {wish.element},
                                   values.front() == 1, mapper->answer(meant));
    };
    return asked;
}

QString whyNotFixed(const scene::Scene& scene, std::size_t body) {
    const scene::Body& one = scene.bodies[body];
    const auto held = std::ranges::find(scene.constraints, one.name, &scene::Constraint::body);
    if (one.fixed || held == scene.constraints.end())
        return {};
    return SceneDocument::tr("%1 follows the trajectory %2 (line %3 of the text): it cannot be "
                             "fixed as well.")
        .arg(words(one.name), words(held->trajectory))
        .arg(held->source.line);
}

} // namespace views
