#include "editing/shape_points.h"

#include "geometry/hull.h"
#include "geometry/pose.h"

#include <algorithm>

namespace editing {

using geometry::Vector;
using scene::BoxShape;
using scene::HullShape;
using scene::Part;
using scene::SphereShape;

namespace {

geometry::Pose poseOf(const Part& part) {
    return {part.position, geometry::fromRotationVector(part.rotation)};
}

// The places of a hull, each once, in the order of the list.
std::vector<Vector> distinct(const std::vector<Vector>& points) {
    std::vector<Vector> result;
    for (const Vector& p : points)
        if (std::ranges::find(result, p) == result.end())
            result.push_back(p);
    return result;
}

Vector corner(const Vector& edges, std::size_t index) {
    return {(index & 1U) ? edges.x() / 2 : -edges.x() / 2,
            (index & 2U) ? edges.y() / 2 : -edges.y() / 2,
            (index & 4U) ? edges.z() / 2 : -edges.z() / 2};
}

// A box's corner there, its opposite where it is.
Part withCorner(Part part, BoxShape box, std::size_t index, const Vector& place) {
    const geometry::Pose pose = poseOf(part);
    const Vector still = corner(box.edges, 7 - index), now = pose.toLocal(place);
    const Vector sign = corner(Vector::Constant(2), index);
    const double least = 1e-3 * box.edges.maxCoeff();
    const Vector edges = (now - still).cwiseProduct(sign).cwiseMax(least);
    part.position = pose.toWorld(still + edges.cwiseProduct(sign) / 2);
    part.shape = BoxShape{edges};
    return part;
}

} // namespace

std::vector<Vector> pointsOf(const Part& part) {
    const geometry::Pose pose = poseOf(part);
    std::vector<Vector> points;
    if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) {
        points = {Vector::Zero(), sphere->radius * Vector::UnitX()};
    } else if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
        points.push_back(Vector::Zero());
        for (std::size_t i = 0; i < 8; ++i)
            points.push_back(corner(box->edges, i));
    } else {
        points = distinct(std::get<HullShape>(part.shape).points);
    }
    for (Vector& p : points)
        p = pose.toWorld(p);
    return points;
}

Part withPoint(const Part& part, std::size_t point, const Vector& place) {
    Part result = part;
    if (auto* hull = std::get_if<HullShape>(&result.shape)) {
        const Vector before = distinct(hull->points).at(point);
        const Vector now = poseOf(part).toLocal(place);
        std::ranges::replace(hull->points, before, now);
    } else if (point == 0) {
        result.position = place;
    } else if (auto* sphere = std::get_if<SphereShape>(&result.shape)) {
        const double radius = (place - part.position).norm();
        if (radius > 0)
            sphere->radius = radius;
    } else {
        result = withCorner(part, std::get<BoxShape>(part.shape), point - 1, place);
    }
    return result;
}

Part withNewPoint(const Part& part, const Vector& place) {
    Part result = part;
    const Vector local = poseOf(part).toLocal(place);
    if (auto* hull = std::get_if<HullShape>(&result.shape))
        if (std::ranges::find(hull->points, local) == hull->points.end())
            hull->points.push_back(local);
    return result;
}

Part withoutPoint(const Part& part, std::size_t point) {
    Part result = part;
    auto* hull = std::get_if<HullShape>(&result.shape);
    if (!hull)
        return part;
    std::erase(hull->points, Vector(distinct(hull->points).at(point)));
    return isSolid(result) ? result : part;
}

bool isSolid(const Part& part) {
    const auto* hull = std::get_if<HullShape>(&part.shape);
    return !hull || std::holds_alternative<geometry::Hull>(geometry::convexHull(hull->points));
}

std::vector<bool> innerPoints(const Part& part) {
    const auto* hull = std::get_if<HullShape>(&part.shape);
    const std::size_t count = pointsOf(part).size();
    std::vector<bool> inner(count, hull != nullptr);
    if (!hull)
        return inner;
    const auto made = geometry::convexHull(distinct(hull->points));
    const auto* solid = std::get_if<geometry::Hull>(&made);
    if (!solid)
        return std::vector<bool>(count, false);
    for (const std::size_t source : solid->sources)
        inner[source] = false;
    return inner;
}

Part withoutInnerPoints(const Part& part) {
    Part result = part;
    auto* hull = std::get_if<HullShape>(&result.shape);
    if (!hull)
        return result;
    const std::vector<Vector> points = distinct(hull->points);
    const std::vector<bool> inner = innerPoints(part);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (inner[i])
            std::erase(hull->points, points[i]);
    return result;
}

Part asPolyhedron(const Part& part) {
    Part result = part;
    if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
        HullShape hull;
        for (std::size_t i = 0; i < 8; ++i)
            hull.points.push_back(corner(box->edges, i));
        result.shape = hull;
    }
    return result;
}

} // namespace editing
