#include "geometry/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace geometry {

namespace {

using Long = Eigen::Matrix<long double, 3, 1>;

// a b - c d to the last bits, however much of it cancels (Kahan).
long double differenceOfProducts(long double a, long double b, long double c, long double d) {
    const long double cd = c * d;
    const long double rounding = std::fma(-c, d, cd);
    return std::fma(a, b, -cd) + rounding;
}

Long cross(const Long& u, const Long& v) {
    return {differenceOfProducts(u.y(), v.z(), u.z(), v.y()),
            differenceOfProducts(u.z(), v.x(), u.x(), v.z()),
            differenceOfProducts(u.x(), v.y(), u.y(), v.x())};
}

// In extended precision, and without loss in the products: slivers lose as many digits as they are
// flat. Scaled since areas of tiny solids underflow when squared.
Vector normalOf(const Vector& a, const Vector& b, const Vector& c) {
    const Long la = a.cast<long double>(), lb = b.cast<long double>(), lc = c.cast<long double>();
    const Long across = cross(lb - la, lc - la);
    const long double largest = across.cwiseAbs().maxCoeff();
    if (largest == 0)
        return Vector::UnitZ();
    return (across / largest).normalized().cast<double>();
}

// The plane of the polygon's largest triangle with one corner at its first vertex.
Vector normalOf(const Face& face, const std::vector<Vector>& vertices) {
    const Vector& origin = vertices[face.vertices[0]];
    std::size_t best = 1;
    double largest = -1;
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i) {
        const Vector u = vertices[face.vertices[i]] - origin;
        const Vector v = vertices[face.vertices[i + 1]] - origin;
        if (const double area = u.cross(v).norm(); area > largest) {
            largest = area;
            best = i;
        }
    }
    return normalOf(origin, vertices[face.vertices[best]], vertices[face.vertices[best + 1]]);
}

// Through the furthest vertex, so that nothing of the polygon lies outside its own plane.
void setPlane(Face& face, const std::vector<Vector>& vertices, const Vector& normal) {
    face.normal = normal;
    face.offset = -std::numeric_limits<double>::infinity();
    for (std::size_t v : face.vertices)
        face.offset = std::max(face.offset, normal.dot(vertices[v]));
}

// False when an edge is not shared by exactly two faces in opposite directions.
bool findEdges(Polyhedron& polyhedron) {
    struct Side {
        std::size_t low, high, face;
        bool isUp; // the face goes from `low` to `high`
        auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
        const auto& loop = polyhedron.faces[f].vertices;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [low, high] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            sides.push_back({low, high, f, loop[i] == low});
        }
    }
    std::ranges::sort(sides);
    const auto areOne = [&](std::size_t i, std::size_t k) {
        return sides[i].low == sides[k].low && sides[i].high == sides[k].high;
    };
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        if (i + 1 == sides.size() || !areOne(i, i + 1) || sides[i].isUp == sides[i + 1].isUp ||
            sides[i].face == sides[i + 1].face || (i + 2 < sides.size() && areOne(i, i + 2)))
            return false;
        const auto& [up, down] =
            sides[i].isUp ? std::tie(sides[i], sides[i + 1]) : std::tie(sides[i + 1], sides[i]);
        polyhedron.edges.push_back({up.low, up.high, up.face, down.face});
    }
    return true;
}

void findNeighbours(Polyhedron& polyhedron) {
    polyhedron.neighbours.resize(polyhedron.vertices.size());
    for (const Edge& e : polyhedron.edges) {
        polyhedron.neighbours[e.from].push_back(e.to);
        polyhedron.neighbours[e.to].push_back(e.from);
    }
}

} // namespace

Polyhedron fromPolygons(std::vector<Vector> vertices, const std::vector<Polygon>& polygons) {
    Polyhedron result;
    result.vertices = std::move(vertices);
    for (const Polygon& polygon : polygons) {
        Face face;
        face.vertices = polygon.vertices;
        setPlane(face, result.vertices,
                 polygon.plane
                     ? normalOf((*polygon.plane)[0], (*polygon.plane)[1], (*polygon.plane)[2])
                     : normalOf(face, result.vertices));
        result.faces.push_back(std::move(face));
    }
    if (!findEdges(result))
        return {};
    findNeighbours(result);
    return result;
}

Polyhedron box(const Vector& edges) {
    const Vector half = edges / 2;
    std::vector<Vector> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1 ? 1 : -1) * half.x(), (i & 2 ? 1 : -1) * half.y(),
                             (i & 4 ? 1 : -1) * half.z());
    Polyhedron result = fromPolygons(std::move(corners), {{{1, 3, 7, 5}, {}},
                                                          {{0, 4, 6, 2}, {}},
                                                          {{2, 6, 7, 3}, {}},
                                                          {{0, 1, 5, 4}, {}},
                                                          {{4, 5, 7, 6}, {}},
                                                          {{0, 2, 3, 1}, {}}});
    for (int i = 0; i < 6; ++i) {
        Face& face = result.faces[static_cast<std::size_t>(i)];
        face.normal = (i % 2 ? -1 : 1) * Vector::Unit(i / 2);
        face.offset = half[i / 2];
    }
    return result;
}

Polyhedron point(const Vector& place) {
    Polyhedron result;
    result.vertices.push_back(place);
    result.neighbours.resize(1);
    return result;
}

Polyhedron transformed(Polyhedron polyhedron, const Pose& pose) {
    for (Vector& v : polyhedron.vertices)
        v = pose.toWorld(v);
    for (Face& f : polyhedron.faces)
        setPlane(f, polyhedron.vertices, (pose.attitude * f.normal).normalized());
    return polyhedron;
}

std::size_t support(const Polyhedron& polyhedron, const Vector& direction, std::size_t start) {
    const auto& vertices = polyhedron.vertices;
    if (vertices.size() <= 24) { // few: reading them in a row is faster than following edges
        std::size_t best = 0;
        double furthest = direction.dot(vertices[0]);
        for (std::size_t i = 1; i < vertices.size(); ++i)
            if (const double d = direction.dot(vertices[i]); d > furthest) {
                furthest = d;
                best = i;
            }
        return best;
    }
    std::size_t best = start < vertices.size() ? start : 0;
    double furthest = direction.dot(vertices[best]);
    for (bool climbed = true; climbed;) {
        climbed = false;
        for (std::size_t n : polyhedron.neighbours[best])
            if (const double d = direction.dot(vertices[n]); d > furthest) {
                furthest = d;
                best = n;
                climbed = true;
            }
    }
    return best;
}

} // namespace geometry
