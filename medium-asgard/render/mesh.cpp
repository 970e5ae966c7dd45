#include "render/mesh.h"

#include "geometry/hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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

} // namespace

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
