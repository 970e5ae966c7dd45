#include "gestures/picking.h"

#include "collision/separation.h"
#include "framing/extent.h"
#include "handles/handle_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace gestures {

double Sight::depth(const Vector& world) const {
    return (camera.rotation * (world - camera.center)).z() * camera.scale + camera.position.z();
}

Vector Sight::beside(const Eigen::Vector2d& pixels, const Vector& world) const {
    return render::toWorld(camera, size, pixels, depth(world));
}

Eigen::Index Sight::facing() const {
    Eigen::Index axis = 0;
    (camera.rotation.conjugate() * Vector::UnitZ()).cwiseAbs().maxCoeff(&axis);
    return axis;
}

bool Sight::isPlan() const {
    return (camera.rotation * Vector::Unit(facing())).head<2>().norm() < 1e-6;
}

Vector Sight::across(const Eigen::Vector2d& pixels, const Vector& world) const {
    const Line line = lineOfSight(*this, pixels);
    const Eigen::Index axis = facing();
    constexpr double grazing = 0.2; // at the rim of a wide picture
    if (std::abs(line.direction[axis]) < grazing)
        return beside(pixels, world);
    Vector place =
        line.from + line.direction * ((world[axis] - line.from[axis]) / line.direction[axis]);
    place[axis] = world[axis];
    return place;
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

std::optional<Vector> onGround(const Sight& sight, const Eigen::Vector2d& pixels, const Vector& up,
                               double height) {
    constexpr double level = 0.1;   // radians: a picture from the side is a plane to build in
    constexpr double smaller = 4.0; // than in the middle of the picture
    const Vector toViewer = sight.camera.rotation.conjugate() * Vector::UnitZ();
    if (toViewer.dot(up) < level)
        return std::nullopt;
    const Line line = lineOfSight(sight, pixels);
    const double falls = -line.direction.dot(up);
    const double above = line.from.dot(up) - height;
    if (falls <= 0 || above <= 0)
        return std::nullopt;
    const Vector place = line.from + line.direction * (above / falls);
    if (sight.pixelLength(place) > smaller * sight.pixelLength(sight.camera.center))
        return std::nullopt;
    return place;
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
        if (handle.movable && !handle.folded && distance <= reach &&
            (distance < least || onTop || !nearest)) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<render::HandleName> crowdAt(const render::HandleSet& set,
                                          const Eigen::Vector2d& pixels, double reach) {
    std::optional<render::HandleName> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const render::Crowd& crowd : set.crowds) {
        const double distance = (crowd.middle - pixels).norm();
        if (crowd.isOpen && distance <= crowd.reach + reach)
            return crowd.largest;
        if (distance <= crowd.reach && distance < least) {
            least = distance;
            nearest = crowd.largest;
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

std::vector<Picked> bodiesAt(const render::Drawing& drawing, const Sight& sight,
                             const Eigen::Vector2d& pixels) {
    const Line line = lineOfSight(sight, pixels);
    std::map<std::string, ShapePointer> shapes;
    std::vector<std::pair<double, Picked>> met;
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i) {
        const scene::Body& body = drawing.scene->bodies[i];
        const auto [place, isNew] = shapes.try_emplace(body.shape);
        if (isNew)
            place->second = shapeOf(*drawing.scene, body.name);
        if (!place->second || render::isHidden(drawing.display, body))
            continue;
        const geometry::Pose pose =
            render::poseOf(*drawing.scene, drawing.motion.get(), i, drawing.time);
        const auto hit = geometry::castRay(*place->second, pose.toLocal(line.from),
                                           pose.attitude.conjugate() * line.direction);
        if (hit)
            met.push_back(
                {hit->distance, {i, pose.toWorld(hit->point), pose.attitude * hit->normal}});
    }
    std::ranges::stable_sort(met, {}, &std::pair<double, Picked>::first);
    std::vector<Picked> all;
    all.reserve(met.size());
    for (const auto& [distance, picked] : met)
        all.push_back(picked);
    return all;
}

std::optional<Picked> bodyAt(const render::Drawing& drawing, const Sight& sight,
                             const Eigen::Vector2d& pixels, std::optional<std::size_t> but) {
    for (const Picked& picked : bodiesAt(drawing, sight, pixels))
        if (picked.body != but)
            return picked;
    return std::nullopt;
}

bool isEndless(const geometry::Shape& shape) {
    return std::ranges::any_of(shape.parts, &geometry::Part::isPlane);
}

std::optional<Picked> bodyBeside(const render::Drawing& drawing, const Sight& sight,
                                 const Eigen::Vector2d& pixels, double reach,
                                 std::optional<std::size_t> but) {
    constexpr int rings = 4, directions = 16;
    const auto ends = [&](const std::optional<Picked>& found) {
        const ShapePointer shape =
            found ? shapeOf(*drawing.scene, drawing.scene->bodies[found->body].name) : nullptr;
        return shape && !isEndless(*shape);
    };
    auto here = bodyAt(drawing, sight, pixels, but);
    for (int ring = 1; ring <= rings && !ends(here); ++ring)
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            const Eigen::Vector2d away(std::cos(angle), std::sin(angle));
            auto found = bodyAt(drawing, sight, pixels + reach * ring / rings * away, but);
            if (ends(found))
                return found;
        }
    return here;
}

bool isIn(const render::Drawing& drawing, std::size_t body, const Vector& place) {
    const ShapePointer shape = shapeOf(*drawing.scene, drawing.scene->bodies[body].name);
    if (!shape)
        return false;
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
    const double touch = 1e-4 * geometry::radiusAbout(*shape, Vector::Zero());
    const geometry::Part point = geometry::spherePart(0);
    return std::ranges::any_of(shape->parts, [&](const geometry::Part& part) {
        collision::WarmStart cold;
        return collision::separate({&part, geometry::Matrix::Identity(), Vector::Zero()},
                                   {&point, geometry::Matrix::Identity(), pose.toLocal(place)},
                                   cold)
                   .gap <= touch;
    });
}

std::optional<std::size_t> bodyAround(const render::Drawing& drawing, const Vector& place,
                                      std::optional<std::size_t> but) {
    const auto& bodies = drawing.scene->bodies;
    std::optional<std::size_t> smallest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (i == but || render::isHidden(drawing.display, bodies[i]) || !isIn(drawing, i, place))
            continue;
        const ShapePointer shape = shapeOf(*drawing.scene, bodies[i].name);
        const double size = isEndless(*shape) ? std::numeric_limits<double>::max()
                                              : geometry::bounds(*shape).volume();
        if (size < least) {
            least = size;
            smallest = i;
        }
    }
    return smallest;
}

std::vector<std::size_t> bodiesWithin(const render::Drawing& drawing, const Sight& sight,
                                      const Eigen::Vector2d& one, const Eigen::Vector2d& other) {
    const Eigen::AlignedBox2d band(one.cwiseMin(other), one.cwiseMax(other));
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i) {
        if (render::isHidden(drawing.display, drawing.scene->bodies[i]))
            continue;
        const geometry::Pose pose =
            render::poseOf(*drawing.scene, drawing.motion.get(), i, drawing.time);
        Eigen::AlignedBox2d seen;
        for (const render::Ball& ball : render::outlineOf(*drawing.scene, drawing.scene->bodies[i]))
            seen.extend(sight.pixels(pose.toWorld(ball.center)));
        if (!seen.isEmpty() && band.contains(seen.center()))
            bodies.push_back(i);
    }
    return bodies;
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
