#include "collision/simplex.h"

#include <limits>
#include <optional>

namespace collision {

bool Simplex::has(const SimplexPoint& p) const {
    for (std::size_t i = 0; i < count; ++i)
        if (points[i].a == p.a && points[i].b == p.b)
            return true;
    return false;
}

namespace {

struct Candidate {
    Vector nearest = Vector::Zero();
    double distance = std::numeric_limits<double>::infinity(); // squared
    std::array<std::size_t, 3> corners{};
    std::size_t count = 0;

    void offer(const Vector& v, std::array<std::size_t, 3> of, std::size_t size) {
        if (const double d = v.squaredNorm(); d < distance) {
            nearest = v;
            distance = d;
            corners = of;
            count = size;
        }
    }
};

// The foot of the perpendicular on the line, if it lies between the ends.
std::optional<Vector> footOnEdge(const Vector& a, const Vector& b) {
    const Vector along = b - a;
    const double length = along.squaredNorm();
    if (!(a.dot(along) < 0 && b.dot(along) > 0))
        return std::nullopt;
    // From the nearer end, whose error is smaller.
    const Vector& end = a.squaredNorm() < b.squaredNorm() ? a : b;
    return Vector(end - along * (end.dot(along) / length));
}

std::optional<Vector> footOnFace(const Vector& a, const Vector& b, const Vector& c) {
    const Vector normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    if (area == 0)
        return std::nullopt;
    // Inside when the origin lies on the inner side of all three edges.
    if (!(normal.dot(a.cross(b)) > 0 && normal.dot(b.cross(c)) > 0 && normal.dot(c.cross(a)) > 0))
        return std::nullopt;
    const Vector& nearest = a.squaredNorm() < b.squaredNorm()
                                ? (a.squaredNorm() < c.squaredNorm() ? a : c)
                                : (b.squaredNorm() < c.squaredNorm() ? b : c);
    return Vector(normal * (normal.dot(nearest) / area));
}

double volume(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    return (b - a).dot((c - a).cross(d - a));
}

bool around(const std::array<SimplexPoint, 4>& p) {
    const Vector o = Vector::Zero();
    const Vector &a = p[0].place, &b = p[1].place, &c = p[2].place, &d = p[3].place;
    const double whole = volume(a, b, c, d);
    const double parts[] = {volume(o, b, c, d), volume(a, o, c, d), volume(a, b, o, d),
                            volume(a, b, c, o)};
    if (whole == 0)
        return false;
    for (double part : parts)
        if (part / whole < 0)
            return false;
    return true;
}

} // namespace

Vector Simplex::reduce() {
    if (count == 4 && around(points)) {
        holdsOrigin = true;
        return Vector::Zero();
    }
    Candidate best;
    for (std::size_t i = 0; i < count; ++i)
        best.offer(points[i].place, {i, 0, 0}, 1);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (const auto foot = footOnEdge(points[i].place, points[j].place))
                best.offer(*foot, {i, j, 0}, 2);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            for (std::size_t k = j + 1; k < count; ++k)
                if (const auto foot = footOnFace(points[i].place, points[j].place, points[k].place))
                    best.offer(*foot, {i, j, k}, 3);
    std::array<SimplexPoint, 4> kept;
    for (std::size_t i = 0; i < best.count; ++i)
        kept[i] = points[best.corners[i]];
    points = kept;
    count = best.count;
    return best.nearest;
}

} // namespace collision
