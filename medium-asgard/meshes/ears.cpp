#include "meshes/ears.h"

#include <algorithm>

namespace meshes {

namespace {

using Point = Eigen::Vector2d;

// LIMIT: concave polygons with more corners are fans; the time for ears grows with their square.
constexpr std::size_t mostCut = 400;

double turn(const Point& a, const Point& b, const Point& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

std::vector<Point> flat(const std::vector<Vector>& vertices,
                        std::span<const std::uint32_t> corners) {
    Vector normal = Vector::Zero(); // Newell's
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += (vertices[corners[i]] - vertices[corners[0]])
                      .cross(vertices[corners[(i + 1) % corners.size()]] - vertices[corners[0]]);
    const Vector u = normal.unitOrthogonal();
    const Vector v = normal.normalized().cross(u);
    std::vector<Point> points;
    for (const std::uint32_t c : corners)
        points.emplace_back(u.dot(vertices[c]), v.dot(vertices[c]));
    return points;
}

// Whether the corner at `i` of the rest can be cut off: it is convex and no other lies in it.
bool isEar(const std::vector<Point>& points, const std::vector<std::size_t>& rest, std::size_t i) {
    const std::size_t count = rest.size();
    const Point &a = points[rest[(i + count - 1) % count]], &b = points[rest[i]],
                &c = points[rest[(i + 1) % count]];
    if (turn(a, b, c) <= 0)
        return false;
    return std::ranges::none_of(rest, [&](std::size_t other) {
        const Point& p = points[other];
        return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
               turn(c, a, p) >= 0;
    });
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> trianglesOf(const std::vector<Vector>& vertices,
                                                      std::span<const std::uint32_t> corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::size_t> rest(corners.size());
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = i;
    const std::vector<Point> points = flat(vertices, corners);
    const auto convex = [&] {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (turn(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) <
                0)
                return false;
        return true;
    };
    const bool cuts = corners.size() > 3 && corners.size() <= mostCut && !convex();
    while (rest.size() > 3) {
        std::size_t ear = 1; // of a fan
        if (cuts) {
            std::size_t found = 0;
            while (found < rest.size() && !isEar(points, rest, found))
                ++found;
            ear = found < rest.size() ? found : 1;
        }
        const std::size_t count = rest.size();
        triangles.push_back({corners[rest[(ear + count - 1) % count]], corners[rest[ear]],
                             corners[rest[(ear + 1) % count]]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({corners[rest[0]], corners[rest[1]], corners[rest[2]]});
    return triangles;
}

} // namespace meshes
