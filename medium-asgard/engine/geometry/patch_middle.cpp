#include "geometry/patch_middle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geometry {

std::vector<Vector> inOrder(std::vector<Vector> corners, const Vector& normal) {
    Vector middle = Vector::Zero();
    for (const Vector& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    const Vector across = normal.unitOrthogonal(), along = normal.cross(across);
    std::ranges::sort(corners, {}, [&](const Vector& corner) {
        return std::atan2(along.dot(corner - middle), across.dot(corner - middle));
    });
    return corners;
}

namespace {

// Of the triangle from the origin to p and q: its area, and the integral of the distance.
std::pair<double, double> wedgeOf(const Vector& p, const Vector& q, const Vector& normal) {
    const double area = normal.dot(p.cross(q)) / 2, side = (q - p).norm();
    if (!(side > 0))
        return {0, 0};
    const double height = std::abs(2 * area) / side;
    const Vector way = (q - p) / side;
    const auto upTo = [&](double s) { // of the distance, from the foot of the height to s along
        const double far = std::hypot(height, s);
        return height * (s * far + (height > 0 ? height * height * std::asinh(s / height) : 0)) / 6;
    };
    const double integral = upTo(way.dot(q)) - upTo(way.dot(p));
    return {area, area < 0 ? -integral : integral};
}

} // namespace

PatchMiddle middleOf(const std::vector<Vector>& corners, const Vector& normal) {
    PatchMiddle middle;
    for (const Vector& corner : corners)
        middle.centre += corner / static_cast<double>(corners.size());
    if (corners.size() == 2)
        middle.reach = (corners[1] - corners[0]).norm() / 4;
    if (corners.size() < 3)
        return middle;
    const std::vector<Vector> outline = inOrder(corners, normal);
    Vector moment = Vector::Zero();
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector p = outline[i] - middle.centre,
                     q = outline[(i + 1) % outline.size()] - middle.centre;
        const double part = normal.dot(p.cross(q)) / 2;
        area += part;
        moment += part * (p + q) / 3;
    }
    if (!(std::abs(area) > 0))
        return middle;
    middle.centre += moment / area;
    double integral = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        integral += wedgeOf(outline[i] - middle.centre,
                            outline[(i + 1) % outline.size()] - middle.centre, normal)
                        .second;
    middle.reach = std::abs(integral / area);
    return middle;
}

} // namespace geometry
