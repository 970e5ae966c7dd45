#include "drawing/mesh.h"

#include "geometry/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace render {

using geometry::Vector;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Surface {
    std::vector<Vector> points;
    std::vector<Triangle> triangles;
};

Surface icosahedron() {
    const double a = 1, b = (1 + std::sqrt(5.0)) / 2;
    Surface s;
    s.points = {{-a, b, 0},  {a, b, 0},  {-a, -b, 0}, {a, -b, 0}, {0, -a, b},  {0, a, b},
                {0, -a, -b}, {0, a, -b}, {b, 0, -a},  {b, 0, a},  {-b, 0, -a}, {-b, 0, a}};
    for (Vector& p : s.points)
        p.normalize();
    // Its faces are the triples of mutually nearest vertices.
    const double edge = 2 / std::sqrt(b * b + 1) + 1e-9;
    const auto close = [&](std::uint32_t i, std::uint32_t j) {
        return (s.points[i] - s.points[j]).norm() < edge;
    };
    for (std::uint32_t i = 0; i < 12; ++i)
        for (std::uint32_t j = i + 1; j < 12; ++j)
            for (std::uint32_t k = j + 1; k < 12; ++k)
                if (close(i, j) && close(j, k) && close(i, k)) {
                    const Vector& p = s.points[i];
                    const double side = p.dot(s.points[j].cross(s.points[k]));
                    s.triangles.push_back(side > 0 ? Triangle{i, j, k} : Triangle{i, k, j});
                }
    return s;
}

Surface subdivided(const Surface& coarse) {
    Surface fine{coarse.points, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(i, j), static_cast<std::uint32_t>(fine.points.size()));
        if (isNew)
            fine.points.push_back((coarse.points[i] + coarse.points[j]).normalized());
        return entry->second;
    };
    for (const auto& [i, j, k] : coarse.triangles) {
        const std::uint32_t a = middle(i, j), b = middle(j, k), c = middle(k, i);
        fine.triangles.insert(fine.triangles.end(), {Triangle{i, a, c}, Triangle{a, j, b},
                                                     Triangle{c, b, k}, Triangle{a, b, c}});
    }
    return fine;
}

void append(Mesh& mesh, const Vector& point, const Vector& normal) {
    for (double x : {point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z()})
        mesh.vertices.push_back(static_cast<float>(x));
}

// Rings about y, from above to below, each with one normal at all heights of its points.
class Rings {
public:
    explicit Rings(int sides) : sides_(sides) {}

    // Normal: outward and up. A radius of 0 is a point with as many normals as there are sides.
    void add(double radius, double height, double outward, double up) {
        for (int k = 0; k < sides_; ++k) {
            const double angle = 2 * M_PI * k / sides_;
            const double x = std::cos(angle), z = std::sin(angle);
            append(mesh, {radius * x, height, radius * z}, {outward * x, up, outward * z});
        }
        ++count_;
    }
    // Between the last two rings.
    void join() {
        const auto at = [&](int ring, int k) {
            return static_cast<std::uint32_t>((count_ - 2 + ring) * sides_ + k % sides_);
        };
        for (int k = 0; k < sides_; ++k)
            mesh.indices.insert(mesh.indices.end(), {at(0, k), at(0, k + 1), at(1, k), at(0, k + 1),
                                                     at(1, k + 1), at(1, k)});
    }
    // An end, and the edge about it.
    void disc(double radius, double height, double up) {
        add(radius, height, 0, up);
        const auto first = static_cast<std::uint32_t>((count_ - 1) * sides_);
        for (std::uint32_t k = 1; k + 1 < static_cast<std::uint32_t>(sides_); ++k)
            if (up > 0)
                mesh.indices.insert(mesh.indices.end(), {first, first + k + 1, first + k});
            else
                mesh.indices.insert(mesh.indices.end(), {first, first + k, first + k + 1});
        edge(radius, height);
    }

    // A flat end with a hole, and both edges of it.
    void ring(double inner, double outer, double height, double up) {
        add(up > 0 ? inner : outer, height, 0, up);
        add(up > 0 ? outer : inner, height, 0, up);
        join();
        for (const double radius : {inner, outer})
            edge(radius, height);
    }
    void edge(double radius, double height) {
        for (int k = 0; k < sides_; ++k) {
            const double from = 2 * M_PI * k / sides_, to = 2 * M_PI * (k + 1) / sides_;
            mesh.edges.emplace_back(
                Vector(radius * std::cos(from), height, radius * std::sin(from)),
                Vector(radius * std::cos(to), height, radius * std::sin(to)));
        }
    }

    Mesh mesh;

private:
    int sides_, count_ = 0;
};

} // namespace

int ringSides(double radiusInPixels) {
    int sides = 12;
    while (sides < finestRing && radiusInPixels * (1 - std::cos(M_PI / sides)) > 1.0 / 3)
        sides *= 2;
    return sides;
}

Mesh cylinderMesh(double radius, double height, int sides) {
    Rings rings(sides);
    rings.disc(radius, height / 2, 1);
    rings.add(radius, height / 2, 1, 0);
    rings.add(radius, -height / 2, 1, 0);
    rings.join();
    rings.disc(radius, -height / 2, -1);
    return std::move(rings.mesh);
}

Mesh coneMesh(double radius, double height, int sides) {
    Rings rings(sides);
    const double slant = std::hypot(radius, height);
    rings.add(0, height / 2, height / slant, radius / slant);
    rings.add(radius, -height / 2, height / slant, radius / slant);
    rings.join();
    rings.disc(radius, -height / 2, -1);
    return std::move(rings.mesh);
}

Mesh capsuleMesh(double radius, double height, int sides) {
    Rings rings(sides);
    const int quarter = sides / 4;
    for (int k = 0; k <= 2 * quarter + 1; ++k) {
        // The equator comes twice: at both ends of the tube.
        const bool isUpper = k <= quarter;
        const double angle = M_PI / 2 * (quarter - (isUpper ? k : k - 1)) / quarter;
        const double outward = std::cos(angle), up = std::sin(angle);
        rings.add(radius * outward, radius * up + (isUpper ? height : -height) / 2, outward, up);
        if (k > 0)
            rings.join();
    }
    return std::move(rings.mesh);
}

Mesh tubeMesh(double inner, double outer, double height, int sides) {
    Rings rings(sides);
    rings.ring(inner, outer, height / 2, 1);
    rings.add(outer, height / 2, 1, 0);
    rings.add(outer, -height / 2, 1, 0);
    rings.join();
    rings.ring(inner, outer, -height / 2, -1);
    rings.add(inner, -height / 2, -1, 0);
    rings.add(inner, height / 2, -1, 0);
    rings.join();
    return std::move(rings.mesh);
}

Mesh bowlMesh(double inner, double outer, int sides) {
    Rings rings(sides);
    const int quarter = sides / 4;
    rings.ring(inner, outer, 0, 1);
    for (int k = 0; k <= quarter; ++k) {
        const double angle = M_PI / 2 * k / quarter, out = std::cos(angle), up = -std::sin(angle);
        rings.add(outer * out, outer * up, out, up);
        if (k > 0)
            rings.join();
    }
    for (int k = quarter; k >= 0; --k) {
        const double angle = M_PI / 2 * k / quarter, out = std::cos(angle), up = -std::sin(angle);
        rings.add(inner * out, inner * up, -out, -up);
        if (k < quarter)
            rings.join();
    }
    return std::move(rings.mesh);
}

Mesh ellipsoidMesh(const Vector& halfAxes, int level) {
    Mesh mesh = sphereMesh(level);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 6) {
        Vector normal;
        for (std::size_t k = 0; k < 3; ++k) {
            const double axis = halfAxes[static_cast<Eigen::Index>(k)];
            mesh.vertices[i + k] *= static_cast<float>(axis);
            normal[static_cast<Eigen::Index>(k)] = mesh.vertices[i + 3 + k] / axis;
        }
        normal.normalize();
        for (std::size_t k = 0; k < 3; ++k)
            mesh.vertices[i + 3 + k] = static_cast<float>(normal[static_cast<Eigen::Index>(k)]);
    }
    return mesh;
}

Mesh squareMesh() {
    Mesh mesh;
    for (const auto& [x, z] : {std::pair(-1, -1), {-1, 1}, {1, 1}, {1, -1}})
        append(mesh, Vector(x, 0, z), Vector::UnitY());
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

int sphereLevel(double radiusInPixels) {
    // A chord over one of n parts of a circle sags by r (1 - cos(pi / n)); level l has 5 * 2^l.
    for (int level = 1; level < finestSphere; ++level)
        if (radiusInPixels * (1 - std::cos(M_PI / (5 << level))) < 1.0 / 3)
            return level;
    return finestSphere;
}

Mesh sphereMesh(int level) {
    Surface s = icosahedron();
    for (int i = 0; i < level; ++i)
        s = subdivided(s);
    const double sag = 1 - std::cos(M_PI / (5 << level));
    Mesh mesh;
    for (const Vector& p : s.points)
        append(mesh, p * (1 + sag / 2), p);
    for (const Triangle& t : s.triangles)
        mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
    return mesh;
}

Mesh polyhedronMesh(const geometry::Polyhedron& polyhedron) {
    Mesh mesh;
    for (const geometry::Face& face : polyhedron.faces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 6);
        for (std::size_t vertex : face.vertices)
            append(mesh, polyhedron.vertices[vertex], face.normal);
        for (std::uint32_t i = 1; i + 1 < face.vertices.size(); ++i)
            mesh.indices.insert(mesh.indices.end(), {first, first + i, first + i + 1});
    }
    for (const geometry::Edge& edge : polyhedron.edges)
        mesh.edges.emplace_back(polyhedron.vertices[edge.from], polyhedron.vertices[edge.to]);
    return mesh;
}

Mesh hullMesh(const std::vector<Vector>& points) {
    const auto hull = geometry::convexHull(points);
    if (const auto* found = std::get_if<geometry::Hull>(&hull))
        return polyhedronMesh(found->polyhedron);
    return {}; // the reader of the scene has said why
}

} // namespace render
