// A convex polyhedron: vertices, faces as planar polygons, edges, and who lies next to whom.
//
// Faces are maximal: triangles in one plane are one polygon, so that a box has six faces and
// twelve edges, a face that lands flat is known as one, and a wireframe shows no diagonals.
// A single point (no faces) is allowed: it is the core of a sphere.
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace geometry {

struct Face {
    std::vector<std::size_t> vertices; // counter-clockwise seen from outside; at least three
    Vector normal = Vector::Zero();    // unit, outward
    double offset = 0;                 // the plane is normal . x = offset
};

struct Edge {
    std::size_t from = 0, to = 0;    // vertices; `left` has the edge in this direction
    std::size_t left = 0, right = 0; // faces
};

struct Polyhedron {
    std::vector<Vector> vertices;
    std::vector<Face> faces;
    std::vector<Edge> edges;
    std::vector<std::vector<std::size_t>> neighbours; // of each vertex, along edges
};

// The box with these full edge lengths about the origin.
[[nodiscard]] Polyhedron box(const Vector& edges);

// A single point.
[[nodiscard]] Polyhedron point(const Vector& place);

struct Polygon {
    std::vector<std::size_t> vertices;          // counter-clockwise seen from outside
    std::optional<std::array<Vector, 3>> plane; // points that span its plane; none: its own
};

// The polyhedron of these polygons, with planes, edges and neighbours worked out. Empty (no
// vertices) when the polygons do not close: some edge lacks its twin or has two.
[[nodiscard]] Polyhedron fromPolygons(std::vector<Vector> vertices,
                                      const std::vector<Polygon>& polygons);

[[nodiscard]] Polyhedron transformed(Polyhedron polyhedron, const Pose& pose);

// The vertex that lies furthest in a direction, found by climbing from vertex `start` where there
// are many. The first of several equal ones depends on the start.
[[nodiscard]] std::size_t support(const Polyhedron& polyhedron, const Vector& direction,
                                  std::size_t start = 0);

} // namespace geometry
