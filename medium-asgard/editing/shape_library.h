// Shapes that an author need not make: one of size about 1, about the origin.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace editing {

struct LibraryShape {
    std::string name;
    std::vector<scene::Part> parts;
};

[[nodiscard]] scene::Part sphere(double radius);
[[nodiscard]] scene::Part box(const geometry::Vector& edges);
// Polyhedra along y with so many sides; a capsule's ends are halves of a ball of that many rings.
[[nodiscard]] scene::Part cylinder(double radius, double height, int sides = 16);
[[nodiscard]] scene::Part capsule(double radius, double height, int sides = 12);
[[nodiscard]] scene::Part tetrahedron(double size);

[[nodiscard]] const std::vector<LibraryShape>& shapeLibrary();

} // namespace editing
