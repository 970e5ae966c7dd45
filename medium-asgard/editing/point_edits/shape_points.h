// The points that a shape editor drags: the vertices of a polyhedron, a sphere's centre and a point
// of its surface, a box's centre and corners (dissertation 4.1.1), of what is round its centre and
// points that set its sizes, of a half space its origin. All in the shape set's frame.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace editing {

// The numbers of its option: radius, edges, radius and height, half axes; of a polyhedron how far
// it reaches along its axes, which stretch it about its origin; none of a half space.
[[nodiscard]] std::vector<double> sizesOf(const scene::Part& part);
// The words for them: "Radius", "Height".
[[nodiscard]] std::vector<std::string> sizeNames(const scene::Part& part);
[[nodiscard]] scene::Part withSizes(scene::Part part, const std::vector<double>& sizes);

// Vertices that stand several times, as in faces, are one point.
[[nodiscard]] std::vector<geometry::Vector> pointsOf(const scene::Part& part);

// The part with that point there. A sphere's surface point sets the radius; a box's corner leaves
// the opposite one where it is, and never turns the box inside out.
[[nodiscard]] scene::Part withPoint(const scene::Part& part, std::size_t point,
                                    const geometry::Vector& place);

// Polyhedra only; another part stays as it is.
[[nodiscard]] scene::Part withNewPoint(const scene::Part& part, const geometry::Vector& place);
// A polyhedron keeps four points, that bound a solid; `part` itself when it could not.
[[nodiscard]] scene::Part withoutPoint(const scene::Part& part, std::size_t point);

// False for points that lie in one plane.
[[nodiscard]] bool isSolid(const scene::Part& part);

// Which of the points are no vertices of the hull.
[[nodiscard]] std::vector<bool> innerPoints(const scene::Part& part);
[[nodiscard]] scene::Part withoutInnerPoints(const scene::Part& part);

} // namespace editing
