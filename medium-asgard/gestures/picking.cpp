#include "gestures/picking.h"

#include "render/handle_layout.h"

#include <algorithm>
#include <limits>
#include <map>

namespace gestures {

double Sight::depth(const Vector& world) const {
    return (camera.rotation * (world - camera.center)).z() * camera.scale + camera.position.z();
}

Vector Sight::beside(const Eigen::Vector2d& pixels, const Vector& world) const {
    return render::toWorld(camera, size, pixels, depth(world));
}

double Sight::pixelLength(const Vector& world) const {
    const Eigen::Vector2d here = pixels(world);
    return (beside(here + Eigen::Vector2d(1, 0), world) - beside(here, world)).norm();
}

Line lineOfSight(const Sight& sight, const Eigen::Vector2d& pixels) {
    const Vector near =
        render::toWorld(sight.camera, sight.size, pixels, 0.99 * render::eyeOf(sight.camera));
    return {near, (render::toWorld(sight.camera, sight.size, pixels, 0) - near).normalized()};
}

std::optional<std::size_t> handleAt(const render::HandleSet& set, const Sight& sight,
                                    const Eigen::Vector2d& pixels, double reach) {
    std::optional<std::size_t> nearest;
    double least = reach;
    for (std::size_t i = 0; i < set.handles.size(); ++i) {
        const render::Handle& handle = set.handles[i];
        const double distance = (render::standOf(handle, sight.camera, sight.size) - pixels).norm();
        const bool onTop = nearest && distance <= least + 0.5 &&
                           radiusOf(handle.kind) < radiusOf(set.handles[*nearest].kind);
        if (handle.movable && distance <= reach && (distance < least || onTop || !nearest)) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<render::Handle> jointAt(const render::Drawing& drawing, const Sight& sight,
                                      const Eigen::Vector2d& pixels, double reach) {
    if (!drawing.display.joints || drawing.scene->joints.empty())
        return std::nullopt;
    render::Display signs;
    signs.jointHandles = true;
    render::HandleSet set = render::Handles(*drawing.scene, drawing.motion)
                                .at(drawing.time, signs, sight.camera, sight.size);
    for (render::Handle& handle : set.handles) // a sign is where it is
        handle.aside.setZero();
    std::erase_if(set.handles, [](const render::Handle& handle) {
        return handle.kind != render::HandleKind::jointPoint;
    });
    const auto found = handleAt(set, sight, pixels, reach);
    return found ? std::optional(set.handles[*found]) : std::nullopt;
}

std::optional<Picked> bodyAt(const render::Drawing& drawing, const Sight& sight,
                             const Eigen::Vector2d& pixels, std::optional<std::size_t> but) {
    const Line line = lineOfSight(sight, pixels);
    std::map<std::string, ShapePointer> shapes;
    std::optional<Picked> front;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i) {
        if (i == but)
            continue;
        const scene::Body& body = drawing.scene->bodies[i];
        const auto [place, isNew] = shapes.try_emplace(body.shape);
        if (isNew)
            place->second = shapeOf(*drawing.scene, body.name);
        if (!place->second)
            continue;
        const geometry::Pose pose =
            render::poseOf(*drawing.scene, drawing.motion.get(), i, drawing.time);
        const auto hit = geometry::castRay(*place->second, pose.toLocal(line.from),
                                           pose.attitude.conjugate() * line.direction);
        if (hit && hit->distance < nearest) {
            nearest = hit->distance;
            front = {i, pose.toWorld(hit->point)};
        }
    }
    return front;
}

std::optional<std::size_t> trajectoryAt(const scene::Scene& scene, const Sight& sight,
                                        const Eigen::Vector2d& pixels, double reach) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < scene.trajectories.size(); ++i) {
        std::optional<Eigen::Vector2d> last;
        for (const Vector& point : render::pathOf(scene.trajectories[i])) {
            const Eigen::Vector2d next = sight.pixels(point);
            const Eigen::Vector2d from = last.value_or(next), way = next - from;
            const double along =
                way.squaredNorm() > 0
                    ? std::clamp((pixels - from).dot(way) / way.squaredNorm(), 0.0, 1.0)
                    : 0;
            const double distance = (from + along * way - pixels).norm();
            if (distance <= reach) {
                reach = distance;
                nearest = i;
            }
            last = next;
        }
    }
    return nearest;
}

} // namespace gestures
