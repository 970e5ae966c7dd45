// Shapes that an author need not make: one of size about 1, about the origin.
#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace editing {

struct LibraryShape {
    std::string name;
    std::vector<scene::Part> parts;
    bool stands = false; // other things stand on it: its bodies are fixed
};

[[nodiscard]] scene::Part sphere(double radius);
[[nodiscard]] scene::Part box(const geometry::Vector& edges);
// Along y.
[[nodiscard]] scene::Part cylinder(double radius, double height);
[[nodiscard]] scene::Part cone(double radius, double height);
[[nodiscard]] scene::Part capsule(double radius, double height);
[[nodiscard]] scene::Part ellipsoid(const geometry::Vector& halfAxes);
[[nodiscard]] scene::Part plane();
// Radii of the hollow and of the outside; a bowl is open above.
[[nodiscard]] scene::Part tube(double inner, double outer, double height);
[[nodiscard]] scene::Part bowl(double inner, double outer);
[[nodiscard]] scene::Part tetrahedron(double size);

// Everyday things first.
[[nodiscard]] const std::vector<LibraryShape>& shapeLibrary();
// One that there is.
[[nodiscard]] const LibraryShape& libraryShape(const std::string& name);

} // namespace editing
