// The places of values in a picture.
#include "framing/body_places.h"
#include "framing/joint_places.h"
#include "handles/handle_layout.h"
#include "meters/meters.h"

#include <algorithm>
#include <map>

namespace meters {

namespace {

using editing::Element, editing::Kind;

// The body at which a spring's, a rope's or a contact's value stands, or the body itself; "": none.
std::string bodyOf(const scene::Scene& scene, const Element& element) {
    if (element.kind == Kind::body)
        return scene.bodies[element.index].name;
    if (element.kind == Kind::link)
        return scene.links[element.index].first.body;
    if (element.kind == Kind::rope) {
        const auto& points = scene.ropes[element.index].points;
        const auto held = std::ranges::find_if(
            points, [](const scene::Rope::Point& one) { return one.body.has_value(); });
        return held == points.end() ? std::string() : *held->body;
    }
    const scene::Contact& contact = scene.contacts[element.index];
    const scene::Body* first = scene::findBody(scene, contact.body1);
    return first && first->fixed ? contact.body2 : contact.body1;
}

} // namespace

std::optional<Place> placeOf(const render::Drawing& drawing, const gestures::Sight& sight,
                             const Element& element, double scale) {
    const scene::Scene& scene = *drawing.scene;
    if (element.index >= editing::countOf(scene, element.kind))
        return std::nullopt;
    const auto points = [&](const geometry::Vector& world) -> Eigen::Vector2d {
        return sight.pixels(world) / scale;
    };
    if (element.kind == Kind::joint) {
        const auto at = render::JointPlaces(scene, drawing.motion.get())
                            .at(scene.joints[element.index], drawing.time);
        return at ? std::optional(Place{points(at->ends[0].point)}) : std::nullopt;
    }
    const scene::Body* body = scene::findBody(scene, bodyOf(scene, element));
    if (body == nullptr || render::isHidden(drawing.display, *body))
        return std::nullopt;
    const geometry::Pose pose =
        render::poseOf(scene, drawing.motion.get(),
                       static_cast<std::size_t>(body - scene.bodies.data()), drawing.time);
    Place place{points(pose.position)};
    constexpr double farthest = 60; // a value on a large body is near its middle
    for (const render::Ball& ball : render::outlineOf(scene, *body)) {
        const geometry::Vector at = pose.toWorld(ball.center);
        const double right = points(at).x() + ball.radius / (sight.pixelLength(at) * scale);
        place.reach = std::clamp(right - place.at.x(), place.reach, farthest);
    }
    return place;
}

Eigen::AlignedBox2d inside(const Eigen::AlignedBox2d& rect, const Eigen::Vector2d& picture) {
    Eigen::Vector2d corner;
    for (const Eigen::Index i : {0, 1})
        corner[i] = std::clamp(rect.min()[i], 0.0, std::max(0.0, picture[i] - rect.sizes()[i]));
    return {corner, Eigen::Vector2d(corner + rect.sizes())};
}

namespace {

// Values that stand below each other: those of one thing, or one that was put somewhere.
struct Column {
    std::vector<std::size_t> values;
    render::LabelWish wish;
};

std::vector<Column> columnsOf(const std::vector<Wish>& wishes, const Eigen::Vector2d& picture) {
    std::map<std::pair<Kind, std::size_t>, std::size_t> ofThing;
    std::vector<Column> columns;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        const Wish& wish = wishes[i];
        const render::LabelWish alone{wish.place.at, wish.size, Place::gap, wish.place.reach, true};
        if (!wish.aside.isZero(0)) {
            const Eigen::Vector2d corner = wish.place.beside() + wish.aside;
            columns.push_back({{i}, alone});
            columns.back().wish.put = inside({corner, corner + wish.size}, picture);
            continue;
        }
        const auto [found, isNew] =
            ofThing.try_emplace({wish.of.kind, wish.of.index}, columns.size());
        if (isNew) {
            columns.push_back({{i}, alone});
            continue;
        }
        Column& column = columns[found->second];
        column.values.push_back(i);
        Eigen::Vector2d& size = column.wish.size;
        size = {std::max(size.x(), wish.size.x()), size.y() + wish.size.y()};
    }
    return columns;
}

} // namespace

std::vector<Box> boxesFor(const std::vector<Wish>& wishes, const Eigen::Vector2d& picture) {
    const Eigen::AlignedBox2d whole(Eigen::Vector2d(0, 0), picture);
    const std::vector<Column> columns = columnsOf(wishes, picture);
    std::vector<render::LabelWish> asked;
    asked.reserve(columns.size());
    for (const Column& column : columns)
        asked.push_back(column.wish);
    const auto placed = render::placedLabels(asked, whole);
    std::vector<Box> all(wishes.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const render::LabelWish& wish = columns[i].wish;
        const Eigen::AlignedBox2d room =
            whole.contains(wish.point) ? inside(placed[i], picture) : placed[i];
        const bool isLeft = room.center().x() < wish.point.x();
        double top = room.min().y();
        for (const std::size_t value : columns[i].values) {
            const Eigen::Vector2d& size = wishes[value].size;
            const Eigen::Vector2d corner(isLeft ? room.max().x() - size.x() : room.min().x(), top);
            all[value] = {wishes[value].place.beside(), {corner, corner + size}};
            top += size.y();
        }
    }
    return all;
}

} // namespace meters
