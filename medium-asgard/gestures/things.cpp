#include "gestures/things.h"

#include "framing/extent.h"
#include "gestures/grasp.h"
#include "gestures/handle_meaning.h"

#include <algorithm>

namespace gestures {

using editing::Element;
using editing::Kind;

std::vector<Thing> thingsAt(const render::Drawing& drawing, const render::HandleSet& handles,
                            const Sight& sight, const Eigen::Vector2d& pixels, double reach) {
    std::vector<Thing> things;
    const auto add = [&](const Element& element, const render::Handle* handle = nullptr) {
        if (std::ranges::find(things, element, &Thing::element) != things.end())
            return;
        Thing& thing = things.emplace_back();
        thing.element = element;
        if (handle)
            thing.handle = *handle;
    };
    if (const auto index = handleAt(handles, sight, pixels, reach))
        add(elementOf(handles.handles[*index]), &handles.handles[*index]);
    if (const auto sign = jointAt(drawing, sight, pixels, reach))
        add(elementOf(*sign), &*sign);
    for (const Picked& picked : bodiesAt(drawing, sight, pixels))
        add({Kind::body, picked.body});
    if (drawing.display.trajectories)
        if (const auto path = trajectoryAt(*drawing.scene, sight, pixels, reach))
            add({Kind::trajectory, *path});
    return things;
}

const Thing* meant(const std::vector<Thing>& things, const std::vector<Element>& selected,
                   bool isAgain) {
    if (things.empty())
        return nullptr;
    std::size_t which = 0;
    if (isAgain && selected.size() == 1) {
        const auto now = std::ranges::find(things, selected.front(), &Thing::element);
        if (now != things.end())
            which = (static_cast<std::size_t>(now - things.begin()) + 1) % things.size();
    }
    return &things[which];
}

std::optional<std::size_t> selectedBodyAt(const render::Drawing& drawing, const Sight& sight,
                                          const Eigen::Vector2d& pixels,
                                          const std::vector<Element>& selected) {
    if (std::ranges::find(selected, Kind::body, &Element::kind) == selected.end())
        return std::nullopt;
    for (const Picked& picked : bodiesAt(drawing, sight, pixels))
        if (std::ranges::find(selected, Element{Kind::body, picked.body}) != selected.end() &&
            isGrasped(*drawing.scene, picked.body))
            return picked.body;
    return std::nullopt;
}

Eigen::AlignedBox2d frameOf(const render::Drawing& drawing, const Sight& sight, std::size_t body,
                            double margin) {
    Eigen::AlignedBox2d frame;
    const scene::Scene& scene = *drawing.scene;
    if (body >= scene.bodies.size() || render::isHidden(drawing.display, scene.bodies[body]))
        return frame;
    const geometry::Pose pose = render::poseOf(scene, drawing.motion.get(), body, drawing.time);
    for (const render::Ball& ball : render::outlineOf(scene, scene.bodies[body])) {
        const Vector middle = pose.toWorld(ball.center);
        const double radius = ball.radius / sight.pixelLength(middle) + margin;
        for (const double way : {-radius, radius})
            frame.extend(sight.pixels(middle) + Eigen::Vector2d(way, way));
    }
    return frame;
}

} // namespace gestures
