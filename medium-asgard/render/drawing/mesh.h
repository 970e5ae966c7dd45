// Shapes as triangles with normals, and as the lines that their edges make.
//
// Faces of a polyhedron are flat: each has its own vertices. Spheres are subdivided icosahedra,
// what is round about an axis has rings about y, as fine as their size on screen asks for; normals
// are those of the true surface.
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

inline constexpr int finestRing = 1536; // sides

// How many sides a circle of that radius needs for an outline that stays within a third of a pixel.
[[nodiscard]] int ringSides(double radiusInPixels);
// Cylinder, cone and capsule in their own sizes, about y; `sides` is a multiple of 4.
[[nodiscard]] Mesh cylinderMesh(double radius, double height, int sides);
[[nodiscard]] Mesh coneMesh(double radius, double height, int sides);
[[nodiscard]] Mesh capsuleMesh(double radius, double height, int sides);
// Both with a hollow of the radius `inner`; a bowl is the lower half of a shell.
[[nodiscard]] Mesh tubeMesh(double inner, double outer, double height, int sides);
[[nodiscard]] Mesh bowlMesh(double inner, double outer, int sides);
// A sphere of that level, drawn out along its axes.
[[nodiscard]] Mesh ellipsoidMesh(const geometry::Vector& halfAxes, int level);
// From -1 to 1 along x and z, seen from above.
[[nodiscard]] Mesh squareMesh();

// A convex polyhedron: flat faces, its own edges.
[[nodiscard]] Mesh polyhedronMesh(const geometry::Polyhedron& polyhedron);

// The convex hull of points; empty when they have none.
[[nodiscard]] Mesh hullMesh(const std::vector<geometry::Vector>& points);

} // namespace render
