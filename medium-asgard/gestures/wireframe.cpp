#include "gestures/wireframe.h"

#include "geometry/pose.h"

#include <cmath>

namespace gestures {

using geometry::Vector;
using Lines = std::vector<std::vector<Vector>>;

namespace {

// About the middle, by two half axes of the ellipse.
std::vector<Vector> ellipse(const Vector& middle, const Vector& u, const Vector& v, double from = 0,
                            double to = 2 * M_PI) {
    constexpr int pieces = 32;
    std::vector<Vector> line;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = from + (to - from) * i / pieces;
        line.push_back(middle + std::cos(angle) * u + std::sin(angle) * v);
    }
    return line;
}

Lines box(const Vector& middle, const Vector& half) {
    Lines lines;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0}) {
                Vector from;
                from[axis] = -1;
                from[(axis + 1) % 3] = a;
                from[(axis + 2) % 3] = b;
                Vector to = from;
                to[axis] = 1;
                lines.push_back({middle + from.cwiseProduct(half), middle + to.cwiseProduct(half)});
            }
    return lines;
}

Vector x(double length) { return {length, 0, 0}; }
Vector y(double length) { return {0, length, 0}; }
Vector z(double length) { return {0, 0, length}; }

Lines linesOf(const scene::EllipsoidShape& one) {
    const Vector zero = Vector::Zero();
    return {ellipse(zero, x(one.axes.x()), y(one.axes.y())),
            ellipse(zero, y(one.axes.y()), z(one.axes.z())),
            ellipse(zero, z(one.axes.z()), x(one.axes.x()))};
}
Lines linesOf(const scene::SphereShape& one) {
    return linesOf(scene::EllipsoidShape{Vector::Constant(one.radius)});
}
Lines linesOf(const scene::BoxShape& one) { return box(Vector::Zero(), one.edges / 2); }
Lines linesOf(const scene::HullShape& one) {
    if (one.points.empty())
        return {};
    Vector least = one.points.front(), most = least;
    for (const Vector& point : one.points) {
        least = least.cwiseMin(point);
        most = most.cwiseMax(point);
    }
    return box((least + most) / 2, (most - least) / 2);
}
Lines tube(double bottom, double top, double height) {
    const double half = height / 2;
    Lines lines{ellipse(y(-half), x(bottom), z(bottom))};
    if (top > 0)
        lines.push_back(ellipse(y(half), x(top), z(top)));
    for (const Vector& side : {x(1), x(-1), z(1), z(-1)})
        lines.push_back({y(-half) + bottom * side, y(half) + top * side});
    return lines;
}
Lines linesOf(const scene::CylinderShape& one) { return tube(one.radius, one.radius, one.height); }
Lines linesOf(const scene::ConeShape& one) { return tube(one.radius, 0, one.height); }
Lines linesOf(const scene::CapsuleShape& one) {
    Lines lines = tube(one.radius, one.radius, one.height);
    for (const Vector& side : {x(one.radius), z(one.radius)}) {
        lines.push_back(ellipse(y(one.height / 2), side, y(one.radius), 0, M_PI));
        lines.push_back(ellipse(y(-one.height / 2), side, y(-one.radius), 0, M_PI));
    }
    return lines;
}
Lines linesOf(const scene::TubeShape& one) {
    Lines lines = tube(one.outer, one.outer, one.height);
    for (const double end : {one.height / 2, -one.height / 2})
        lines.push_back(ellipse(y(end), x(one.inner), z(one.inner)));
    return lines;
}
Lines linesOf(const scene::BowlShape& one) {
    const Vector zero = Vector::Zero();
    Lines lines;
    for (const double radius : {one.inner, one.outer}) {
        lines.push_back(ellipse(zero, x(radius), z(radius)));
        for (const Vector& side : {x(radius), z(radius)})
            lines.push_back(ellipse(zero, side, y(-radius), 0, M_PI));
    }
    return lines;
}
Lines linesOf(const scene::PlaneShape&) {
    Lines lines;
    constexpr double half = 5;
    for (int i = -5; i <= 5; ++i) {
        lines.push_back({{1.0 * i, 0, -half}, {1.0 * i, 0, half}});
        lines.push_back({{-half, 0, 1.0 * i}, {half, 0, 1.0 * i}});
    }
    return lines;
}

} // namespace

Lines wireframeOf(const std::vector<scene::Part>& parts) {
    Lines all;
    for (const scene::Part& part : parts) {
        const geometry::Pose pose{part.position, geometry::fromRotationVector(part.rotation)};
        for (std::vector<Vector>& line :
             std::visit([](const auto& shape) { return linesOf(shape); }, part.shape)) {
            for (Vector& point : line)
                point = pose.toWorld(point);
            all.push_back(std::move(line));
        }
    }
    return all;
}

} // namespace gestures
