#include "collision/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace collision {

namespace {

constexpr double sameHeight = 1e-3; // of the tolerance
constexpr int mostDoublings = 64;

using Flat = Eigen::Vector2d; // in the plane of contact
using Outline = std::vector<Flat>;

struct Plane {
    Vector normal, right, up;
    explicit Plane(const Vector& n) : normal(n), right(n.unitOrthogonal()), up(n.cross(right)) {}
    [[nodiscard]] Flat flat(const Vector& v) const { return {right.dot(v), up.dot(v)}; }
};

double cross(const Flat& a, const Flat& b) { return a.x() * b.y() - a.y() * b.x(); }

// Counter-clockwise about the plane's normal.
void sortAround(std::vector<Vector>& points, const Plane& plane) {
    if (points.size() < 3)
        return;
    Vector middle = Vector::Zero();
    for (const Vector& p : points)
        middle += p / static_cast<double>(points.size());
    const auto angle = [&](const Vector& p) {
        const Flat f = plane.flat(p - middle);
        return std::atan2(f.y(), f.x());
    };
    std::stable_sort(points.begin(), points.end(),
                     [&](const Vector& a, const Vector& b) { return angle(a) < angle(b); });
}

Outline flattened(const std::vector<Vector>& points, const Plane& plane, const Vector& origin) {
    Outline outline;
    for (const Vector& p : points)
        outline.push_back(plane.flat(p - origin));
    return outline;
}

// The part of an outline (polygon, segment or point) on the left of the line from a to b.
Outline clipped(const Outline& outline, const Flat& a, const Flat& b, double tolerance) {
    const Flat along = (b - a).normalized();
    const auto side = [&](const Flat& p) { return cross(along, p - a); };
    Outline result;
    const std::size_t edges = outline.size() == 2 ? 1 : outline.size();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Flat& p = outline[i];
        const double s = side(p);
        if (s >= -tolerance)
            result.push_back(p);
        if (i >= edges || outline.size() == 1)
            continue;
        const Flat& q = outline[(i + 1) % outline.size()];
        const double u = side(q);
        if ((s > tolerance && u < -tolerance) || (s < -tolerance && u > tolerance))
            result.emplace_back(p + (q - p) * (s / (s - u)));
    }
    return result;
}

Outline clippedBy(Outline outline, const Outline& polygon, double tolerance) {
    for (std::size_t i = 0; i < polygon.size() && !outline.empty(); ++i)
        outline = clipped(outline, polygon[i], polygon[(i + 1) % polygon.size()], tolerance);
    return outline;
}

// Two segments: their common stretch when parallel, else where they cross or come nearest.
Outline common(const Outline& a, const Outline& b, double tolerance) {
    const Flat u = a[1] - a[0], v = b[1] - b[0], w = b[0] - a[0];
    const double turn = cross(u, v);
    if (std::abs(turn) > 1e-9 * u.norm() * v.norm()) {
        const double s = std::clamp(cross(w, v) / turn, 0.0, 1.0);
        return {a[0] + s * u};
    }
    const double length = u.squaredNorm();
    double low = w.dot(u) / length, high = (b[1] - a[0]).dot(u) / length;
    if (low > high)
        std::swap(low, high);
    low = std::max(low, 0.0);
    high = std::min(high, 1.0);
    if (high < low || (high - low) * std::sqrt(length) <= tolerance) {
        const double middle = std::clamp((low + high) / 2, 0.0, 1.0);
        return {a[0] + middle * u};
    }
    return {a[0] + low * u, a[0] + high * u};
}

Outline overlapOf(const Outline& a, const Outline& b, double tolerance) {
    Outline result;
    if (a.size() == 1)
        return a;
    if (b.size() == 1)
        return b;
    if (a.size() == 2 && b.size() == 2)
        return common(a, b, tolerance);
    // Beside each other: what of the one is nearest to the other.
    for (int i = 0; i < mostDoublings && result.empty(); ++i, tolerance *= 2)
        result = b.size() > 2 ? clippedBy(a, b, tolerance) : clippedBy(b, a, tolerance);
    return result.empty() ? Outline{a[0]} : result;
}

Flat centreOf(const Outline& outline) {
    Flat mean = Flat::Zero();
    for (const Flat& p : outline)
        mean += p / static_cast<double>(outline.size());
    if (outline.size() < 3)
        return mean;
    double area = 0;
    Flat moment = Flat::Zero();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Flat p = outline[i] - mean, q = outline[(i + 1) % outline.size()] - mean;
        area += cross(p, q) / 2;
        moment += cross(p, q) / 6 * (p + q);
    }
    double extent = 0;
    for (const Flat& p : outline)
        extent = std::max(extent, (p - mean).squaredNorm());
    return std::abs(area) > 1e-12 * extent ? Flat(mean + moment / area) : mean;
}

} // namespace

std::vector<std::size_t> furthestVertices(const Posed& posed, const Vector& direction,
                                          double tolerance) {
    const double most = direction.dot(posed.world(posed.support(direction)));
    std::vector<double> heights;
    double least = most;
    for (std::size_t i = 0; i < posed.part->core.vertices.size(); ++i) {
        heights.push_back(direction.dot(posed.world(i)));
        if (heights[i] >= most - tolerance)
            least = std::min(least, heights[i]);
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (heights[i] >= least - sameHeight * tolerance)
            result.push_back(i);
    return result;
}

namespace {

using geometry::Curved;

constexpr int roundCorners = 64;

// Across u, in the plane of it and an axis of the world: corners from there on lie symmetrically
// where the scene does.
Vector startOf(const Vector& u) {
    int best = 0;
    for (const int axis : {1, 2})
        if (std::abs(u[axis]) < std::abs(u[best]) - 1e-9)
            best = axis;
    const Vector axis = Vector::Unit(best);
    return (axis - u * u.dot(axis)).normalized();
}

// About the axis u of a curved part at its place: where the circle of an end lies.
struct Axis {
    Vector centre, u, e; // e: across u, the way in which the direction goes
    double along = 0, across = 0;
    Axis(const Posed& posed, const Vector& direction)
        : centre(posed.rotation * posed.part->curved->center + posed.offset),
          u(posed.rotation * posed.part->curved->axis()), along(u.dot(direction)) {
        const Vector sideways = direction - along * u;
        across = sideways.norm();
        e = across > 0 ? Vector(sideways / across) : u.unitOrthogonal();
    }
    [[nodiscard]] Vector at(double height, double radius) const {
        return centre + height * u + radius * e;
    }
    [[nodiscard]] std::vector<Vector> disc(double height, double radius) const {
        std::vector<Vector> corners;
        const Vector start = startOf(u), f = u.cross(start);
        for (int i = 0; i < roundCorners; ++i) {
            const double angle = 2 * std::numbers::pi * i / roundCorners;
            corners.push_back(centre + height * u +
                              radius * (std::cos(angle) * start + std::sin(angle) * f));
        }
        return corners;
    }
};

std::vector<Vector> furthestOfCurved(const Posed& posed, const Vector& direction,
                                     double tolerance) {
    const Curved& curved = *posed.part->curved;
    const Axis axis(posed, direction);
    const double r = curved.radius(), h = curved.half();
    const bool isAcross = 2 * r * axis.across <= tolerance; // an end lies in the plane
    if (curved.kind == Curved::Kind::bowl && isAcross && axis.along > 0)
        return axis.disc(0, r);
    if (curved.kind == Curved::Kind::cylinder || curved.kind == Curved::Kind::tube) {
        const double end = std::copysign(h, axis.along);
        if (isAcross)
            return axis.disc(end, r);
        if (h > 0 && 2 * h * std::abs(axis.along) <= tolerance)
            return {axis.at(-h, r), axis.at(h, r)};
        return {axis.at(end, r)};
    }
    if (curved.kind == Curved::Kind::cone) {
        const double apex = h * axis.along, rim = r * axis.across - h * axis.along;
        if (isAcross && axis.along < 0)
            return axis.disc(-h, r);
        if (std::abs(apex - rim) <= tolerance)
            return {axis.at(-h, r), axis.at(h, 0)};
        return {apex > rim ? axis.at(h, 0) : axis.at(-h, r)};
    }
    return {posed.furthest(direction)};
}

// Around the foot of the other part's feature, and wider than that part.
std::vector<Vector> squareOf(const Posed& plane, const Part& other,
                             const std::vector<Vector>& facing) {
    const Vector normal = plane.rotation * plane.part->curved->axis();
    const Vector origin = plane.rotation * plane.part->curved->center + plane.offset;
    const Plane across(normal);
    Vector middle = Vector::Zero();
    for (const Vector& p : facing)
        middle += p / static_cast<double>(facing.size());
    const double reach = 2 * geometry::radiusAbout(other, other.core.vertices[0]);
    const Vector foot = middle - normal * normal.dot(middle - origin);
    std::vector<Vector> square;
    for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
        square.emplace_back(foot + reach * (x * across.right + y * across.up));
    return square;
}

} // namespace

FacingFeatures facingFeatures(const Posed& first, const Posed& second, const Vector& normal,
                              double tolerance) {
    FacingFeatures facing;
    if (!first.part->isPlane())
        facing.first = furthestFeature(first, -normal, tolerance);
    facing.second = second.part->isPlane() ? squareOf(second, *first.part, facing.first)
                                           : furthestFeature(second, normal, tolerance);
    if (first.part->isPlane())
        facing.first = squareOf(first, *second.part, facing.second);
    return facing;
}

std::vector<Vector> furthestFeature(const Posed& posed, const Vector& direction, double tolerance) {
    std::vector<Vector> result;
    if (posed.part->curved) {
        result = furthestOfCurved(posed, direction, tolerance);
        sortAround(result, Plane(direction));
        return result;
    }
    for (const std::size_t i : furthestVertices(posed, direction, tolerance))
        result.push_back(posed.world(i));
    sortAround(result, Plane(direction));
    return result;
}

Patch patchOf(const Posed& first, const Posed& second, const Vector& normal, double tolerance,
              double beside) {
    const Plane plane(normal);
    auto [ofFirst, ofSecond] = facingFeatures(first, second, normal, tolerance);
    std::reverse(ofFirst.begin(), ofFirst.end()); // counter-clockwise about +normal, as the other
    const double height = (normal.dot(ofFirst[0]) - first.part->radius + normal.dot(ofSecond[0]) +
                           second.part->radius) /
                          2;
    const Vector origin = ofFirst[0];
    const Outline outline =
        overlapOf(flattened(ofFirst, plane, origin), flattened(ofSecond, plane, origin), beside);
    const auto lift = [&](const Flat& f) {
        const Vector flat = origin + f.x() * plane.right + f.y() * plane.up;
        return Vector(flat + (height - normal.dot(flat)) * normal);
    };
    Patch patch;
    for (const Flat& f : outline)
        patch.corners.push_back(lift(f));
    patch.centre = lift(centreOf(outline));
    return patch;
}

} // namespace collision
