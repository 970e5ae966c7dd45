// Shapes as triangles with normals, and as the lines that their edges make.
//
// Faces of a polyhedron are flat: each has its own vertices. Spheres are subdivided icosahedra,
// as fine as their size on screen asks for.
#pragma once

#include "geometry/polyhedron.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace render {

struct Mesh {
    std::vector<float> vertices; // position and outward normal, six numbers each
    std::vector<std::uint32_t> indices;
    std::vector<std::pair<geometry::Vector, geometry::Vector>> edges;
};

inline constexpr int finestSphere = 5; // 20 * 4^5 triangles

// The unit sphere; its vertices stand so far out that the mean radius is 1.
[[nodiscard]] Mesh sphereMesh(int level);
// The level whose outline stays within a third of a pixel of the circle of that radius.
[[nodiscard]] int sphereLevel(double radiusInPixels);

// A convex polyhedron: flat faces, its own edges.
[[nodiscard]] Mesh polyhedronMesh(const geometry::Polyhedron& polyhedron);

// The convex hull of points; empty when they have none.
[[nodiscard]] Mesh hullMesh(const std::vector<geometry::Vector>& points);

} // namespace render
