#include "framing/body_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <variant>

namespace render {

using geometry::Pose;

namespace {

using Box = Eigen::AlignedBox3d;

void addCorners(std::vector<Ball>& outline, const Box& box, const Pose& pose) {
    for (int i = 0; i < 8; ++i)
        outline.push_back({pose.toWorld(box.corner(static_cast<Box::CornerType>(i))), 0});
}

void addPart(std::vector<Ball>& outline, const scene::Part& part) {
    const Pose pose{part.position, geometry::fromRotationVector(part.rotation)};
    const auto ring = [&](double radius, double height) {
        constexpr int corners = 12;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * M_PI * k / corners;
            outline.push_back(
                {pose.toWorld({radius * std::cos(angle), height, radius * std::sin(angle)}), 0});
        }
    };
    if (const auto* sphere = std::get_if<scene::SphereShape>(&part.shape)) {
        outline.push_back({part.position, sphere->radius});
    } else if (const auto* box = std::get_if<scene::BoxShape>(&part.shape)) {
        addCorners(outline, Box(-box->edges / 2, box->edges / 2), pose);
    } else if (const auto* cylinder = std::get_if<scene::CylinderShape>(&part.shape)) {
        ring(cylinder->radius, cylinder->height / 2);
        ring(cylinder->radius, -cylinder->height / 2);
    } else if (const auto* tube = std::get_if<scene::TubeShape>(&part.shape)) {
        ring(tube->outer, tube->height / 2);
        ring(tube->outer, -tube->height / 2);
    } else if (const auto* bowl = std::get_if<scene::BowlShape>(&part.shape)) {
        for (const double angle : {0.0, M_PI / 4})
            ring(bowl->outer * std::cos(angle), -bowl->outer * std::sin(angle));
        outline.push_back({pose.toWorld({0, -bowl->outer, 0}), 0});
    } else if (const auto* cone = std::get_if<scene::ConeShape>(&part.shape)) {
        outline.push_back({pose.toWorld({0, cone->height / 2, 0}), 0});
        ring(cone->radius, -cone->height / 2);
    } else if (const auto* capsule = std::get_if<scene::CapsuleShape>(&part.shape)) {
        for (const double end : {-0.5, 0.5})
            outline.push_back({pose.toWorld({0, end * capsule->height, 0}), capsule->radius});
    } else if (const auto* ellipsoid = std::get_if<scene::EllipsoidShape>(&part.shape)) {
        for (int i = 0; i < 27; ++i)
            if (const Eigen::Vector3i way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1); !way.isZero(0))
                outline.push_back(
                    {pose.toWorld(ellipsoid->axes.cwiseProduct(way.cast<double>().normalized())),
                     0});
    } else if (const auto* hull = std::get_if<scene::HullShape>(&part.shape)) {
        if (hull->points.size() <= 24) {
            for (const Vector& p : hull->points)
                outline.push_back({pose.toWorld(p), 0});
            return;
        }
        Box bounds;
        for (const Vector& p : hull->points)
            bounds.extend(p);
        addCorners(outline, bounds, pose);
    }
}

} // namespace

std::vector<Ball> outlineOf(const scene::Scene& scene, const scene::Body& body) {
    std::vector<Ball> outline;
    if (const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape))
        for (const scene::Part& part : shape->parts)
            addPart(outline, part);
    return outline;
}

bool isRoundAboutY(const scene::Part& part) {
    return std::holds_alternative<scene::CylinderShape>(part.shape) ||
           std::holds_alternative<scene::ConeShape>(part.shape) ||
           std::holds_alternative<scene::CapsuleShape>(part.shape) ||
           std::holds_alternative<scene::TubeShape>(part.shape) ||
           std::holds_alternative<scene::BowlShape>(part.shape);
}

std::optional<Vector> axisOf(const scene::Scene& scene, const scene::Body& body) {
    const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
    if (shape == nullptr)
        return std::nullopt;
    const auto first = std::ranges::find_if(shape->parts, isRoundAboutY);
    if (first == shape->parts.end())
        return std::nullopt;
    const auto axisOfPart = [](const scene::Part& part) -> Vector {
        return geometry::fromRotationVector(part.rotation) * Vector::UnitY();
    };
    const Vector axis = axisOfPart(*first);
    constexpr double askew = 1e-6;
    for (const scene::Part& part : shape->parts) {
        const bool isAlong = std::holds_alternative<scene::SphereShape>(part.shape) ||
                             (isRoundAboutY(part) && axisOfPart(part).cross(axis).norm() < askew);
        const double beside = (part.position - first->position).cross(axis).norm();
        if (!isAlong || beside > askew * (1 + part.position.norm()))
            return std::nullopt;
    }
    return axis;
}

Pose poseOf(const scene::Scene& scene, const simulation::Motion* motion, std::size_t body,
            double time) {
    if (motion != nullptr && body < motion->bodies())
        return motion->shapePose(body, time);
    const scene::Body& b = scene.bodies[body];
    return {b.initialPosition, b.initialAttitude};
}

} // namespace render
