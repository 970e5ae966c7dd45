#include "point_edits/shape_points.h"

#include "geometry/hull.h"
#include "geometry/pose.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace editing {

using geometry::Vector;
using scene::BowlShape;
using scene::BoxShape;
using scene::CapsuleShape;
using scene::ConeShape;
using scene::CylinderShape;
using scene::EllipsoidShape;
using scene::HullShape;
using scene::Part;
using scene::PlaneShape;
using scene::SphereShape;
using scene::TubeShape;

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

// Along the axes of the part.
Vector extentsOf(const HullShape& hull) {
    Eigen::AlignedBox3d box;
    for (const Vector& p : hull.points)
        box.extend(p);
    return box.sizes();
}

struct Sizes {
    std::vector<double> operator()(const SphereShape& sphere) const { return {sphere.radius}; }
    std::vector<double> operator()(const BoxShape& box) const { return listed(box.edges); }
    std::vector<double> operator()(const EllipsoidShape& e) const { return listed(e.axes); }
    std::vector<double> operator()(const CylinderShape& c) const { return {c.radius, c.height}; }
    std::vector<double> operator()(const ConeShape& c) const { return {c.radius, c.height}; }
    std::vector<double> operator()(const CapsuleShape& c) const { return {c.radius, c.height}; }
    std::vector<double> operator()(const HullShape& h) const { return listed(extentsOf(h)); }
    std::vector<double> operator()(const PlaneShape&) const { return {}; }
    std::vector<double> operator()(const TubeShape& t) const {
        return {t.inner, t.outer, t.height};
    }
    std::vector<double> operator()(const BowlShape& b) const { return {b.inner, b.outer}; }
    static std::vector<double> listed(const Vector& v) { return {v.x(), v.y(), v.z()}; }
};

struct Resize {
    const std::vector<double>& sizes;
    void operator()(SphereShape& sphere) const { sphere.radius = sizes.at(0); }
    void operator()(BoxShape& box) const { box.edges = Vector(sizes.data()); }
    void operator()(EllipsoidShape& e) const { e.axes = Vector(sizes.data()); }
    void operator()(CylinderShape& c) const { c = {sizes.at(0), sizes.at(1)}; }
    void operator()(ConeShape& c) const { c = {sizes.at(0), sizes.at(1)}; }
    void operator()(CapsuleShape& c) const { c = {sizes.at(0), sizes.at(1)}; }
    void operator()(HullShape& hull) const {
        const Vector before = extentsOf(hull), now(sizes.data());
        for (Vector& p : hull.points)
            p = p.cwiseProduct(now).cwiseQuotient(before); // so that 0.3 of 0.6 is 2.5 of 5
    }
    void operator()(PlaneShape&) const {}
    void operator()(TubeShape& t) const { t = {inner(), outer(), sizes.at(2)}; }
    void operator()(BowlShape& b) const { b = {inner(), outer()}; }
    // The wall is never without thickness.
    [[nodiscard]] double inner() const { return std::min(sizes.at(0), sizes.at(1)); }
    [[nodiscard]] double outer() const {
        return std::max({sizes.at(0), sizes.at(1), inner() * (1 + 1e-3)});
    }
};

bool isHollow(const Part& part) {
    return std::holds_alternative<TubeShape>(part.shape) ||
           std::holds_alternative<BowlShape>(part.shape);
}

// Of a round part: its centre, a point that sets each size.
std::vector<Vector> sizingPoints(const Part& part) {
    const std::vector<double> sizes = sizesOf(part);
    std::vector<Vector> points{Vector::Zero()};
    if (!sizes.empty())
        points.emplace_back(sizes[0], 0, 0);
    if (isHollow(part)) {
        points.emplace_back(sizes[1], 0, 0);
        if (sizes.size() == 3)
            points.emplace_back(0, sizes[2] / 2, 0);
    } else if (sizes.size() == 2) {
        const bool isCapsule = std::holds_alternative<CapsuleShape>(part.shape);
        points.emplace_back(0, sizes[1] / 2 + (isCapsule ? sizes[0] : 0), 0);
    } else if (sizes.size() == 3) {
        points.emplace_back(0, sizes[1], 0);
        points.emplace_back(0, 0, sizes[2]);
    }
    return points;
}

// The size that such a point sets, where it has been dragged to; never nothing.
Part withSizingPoint(const Part& part, std::size_t point, const Vector& local) {
    std::vector<double> sizes = sizesOf(part);
    if (point == 0 || point > sizes.size())
        return part;
    const double least = 1e-3 * *std::ranges::max_element(sizes);
    double now = std::abs(local[static_cast<Eigen::Index>(point - 1)]);
    if (isHollow(part))
        now = point < 3 ? std::hypot(local.x(), local.z()) : 2 * std::abs(local.y());
    else if (sizes.size() == 2)
        now = point == 1 ? std::hypot(local.x(), local.z()) : 2 * std::abs(local.y());
    if (point == 2 && std::holds_alternative<CapsuleShape>(part.shape))
        now -= 2 * sizes[0];
    sizes[point - 1] = std::max(now, least);
    return withSizes(part, sizes);
}

} // namespace

std::vector<double> sizesOf(const Part& part) { return std::visit(Sizes{}, part.shape); }

std::vector<std::string> sizeNames(const Part& part) {
    if (std::holds_alternative<TubeShape>(part.shape))
        return {"Radius inside", "outside", "Height"};
    if (std::holds_alternative<BowlShape>(part.shape))
        return {"Radius inside", "outside"};
    if (std::holds_alternative<HullShape>(part.shape))
        return {"Size x", "Size y", "Size z"};
    switch (sizesOf(part).size()) {
    case 1:
        return {"Radius"};
    case 2:
        return {"Radius", "Height"};
    case 3:
        return std::holds_alternative<BoxShape>(part.shape)
                   ? std::vector<std::string>{"Edge x", "Edge y", "Edge z"}
                   : std::vector<std::string>{"Half axis x", "Half axis y", "Half axis z"};
    default:
        return {};
    }
}

Part withSizes(Part part, const std::vector<double>& sizes) {
    std::visit(Resize{sizes}, part.shape);
    return part;
}

std::vector<Vector> pointsOf(const Part& part) {
    const geometry::Pose pose = poseOf(part);
    std::vector<Vector> points;
    if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
        points.push_back(Vector::Zero());
        for (std::size_t i = 0; i < 8; ++i)
            points.push_back(corner(box->edges, i));
    } else if (const auto* hull = std::get_if<HullShape>(&part.shape)) {
        points = distinct(hull->points);
    } else {
        points = sizingPoints(part);
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
    } else if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
        result = withCorner(part, *box, point - 1, place);
    } else {
        result = withSizingPoint(part, point, poseOf(part).toLocal(place));
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

} // namespace editing
