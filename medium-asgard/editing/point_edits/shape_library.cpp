#include "point_edits/shape_library.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace editing {

using geometry::Vector;
using scene::Part;

namespace {

// To the digits that one would write oneself.
double rounded(double x) { return std::round(x * 1e4) / 1e4; }

Part hull(std::vector<Vector> points) {
    Part part;
    part.shape = scene::HullShape{std::move(points)};
    return part;
}

Part turned(Part part, const Vector& rotation) {
    part.rotation = rotation;
    return part;
}

Part at(Part part, const Vector& place) {
    part.position = place;
    return part;
}

Part dodecahedron() {
    const double phi = std::numbers::phi;
    std::vector<Vector> points;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0})
                points.emplace_back(x, y, z);
            points.emplace_back(0, x / phi, y * phi);
            points.emplace_back(x / phi, y * phi, 0);
            points.emplace_back(x * phi, 0, y / phi);
        }
    for (Vector& p : points)
        p = (0.4 * p).unaryExpr(&rounded);
    return hull(points);
}

Part icosahedron() {
    const double phi = std::numbers::phi;
    std::vector<Vector> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-phi, phi}) {
            points.emplace_back(0, a, b);
            points.emplace_back(a, b, 0);
            points.emplace_back(b, 0, a);
        }
    for (Vector& p : points)
        p = (0.4 * p).unaryExpr(&rounded);
    return hull(points);
}

// It stands at its origin, and its top is 1 above.
std::vector<Part> table() {
    std::vector<Part> parts{at(box({2, 0.1, 1.2}), {0, 0.95, 0})};
    for (const double z : {-0.5, 0.5})
        for (const double x : {-0.9, 0.9})
            parts.push_back(at(box({0.1, 0.9, 0.1}), {x, 0.45, z}));
    return parts;
}

} // namespace

Part sphere(double radius) {
    Part part;
    part.shape = scene::SphereShape{radius};
    return part;
}

Part box(const Vector& edges) {
    Part part;
    part.shape = scene::BoxShape{edges};
    return part;
}

Part cylinder(double radius, double height) {
    Part part;
    part.shape = scene::CylinderShape{radius, height};
    return part;
}

Part cone(double radius, double height) {
    Part part;
    part.shape = scene::ConeShape{radius, height};
    return part;
}

Part capsule(double radius, double height) {
    Part part;
    part.shape = scene::CapsuleShape{radius, height};
    return part;
}

Part ellipsoid(const Vector& halfAxes) {
    Part part;
    part.shape = scene::EllipsoidShape{halfAxes};
    return part;
}

Part plane() {
    Part part;
    part.shape = scene::PlaneShape{};
    return part;
}

Part tube(double inner, double outer, double height) {
    Part part;
    part.shape = scene::TubeShape{inner, outer, height};
    return part;
}

Part bowl(double inner, double outer) {
    Part part;
    part.shape = scene::BowlShape{inner, outer};
    return part;
}

Part tetrahedron(double size) {
    const double a = size / 2;
    return hull({{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}});
}

const LibraryShape& libraryShape(const std::string& name) {
    return *std::ranges::find(shapeLibrary(), name, &LibraryShape::name);
}

const std::vector<LibraryShape>& shapeLibrary() {
    static const std::vector<LibraryShape> library = {
        {"Ball", {sphere(0.5)}},
        {"Cube", {box({1, 1, 1})}},
        {"Floor", {plane()}, true},
        {"Table", table(), true},
        {"Plate", {box({4, 0.2, 4})}},
        {"Rod", {box({4, 0.3, 0.3})}},
        {"Wheel", {turned(cylinder(0.5, 0.2), {std::numbers::pi / 2, 0, 0})}}, // about z
        {"Wedge",
         {hull({{-0.5, 0, -0.5},
                {-0.5, 0, 0.5},
                {0.5, 0, -0.5},
                {0.5, 0, 0.5},
                {0.5, 0.5, -0.5},
                {0.5, 0.5, 0.5}})}},
        {"Cylinder", {cylinder(0.5, 1)}},
        {"Disc", {cylinder(1, 0.2)}},
        {"Hoop", {turned(tube(0.9, 1, 0.3), {std::numbers::pi / 2, 0, 0})}}, // about z
        {"Tube", {tube(0.45, 0.5, 1)}},
        {"Bowl", {bowl(0.9, 1)}},
        {"Capsule", {capsule(0.3, 1)}},
        {"Cone", {cone(0.5, 1)}},
        {"Egg", {ellipsoid({0.4, 0.6, 0.4})}},
        {"Dumbbell",
         {at(sphere(0.4), {-1, 0, 0}), at(box({2, 0.2, 0.2}), {0, 0, 0}),
          at(sphere(0.4), {1, 0, 0})}},
        {"T-handle", {box({2, 0.3, 0.3}), at(box({0.3, 1, 0.3}), {0, -0.65, 0})}},
        {"Pyramid",
         {hull({{0.5, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0, -0.5}, {-0.5, 0, 0.5}, {0, 1, 0}})}},
        {"Tetrahedron", {tetrahedron(1)}},
        {"Octahedron",
         {hull({{0.7, 0, 0}, {-0.7, 0, 0}, {0, 0.7, 0}, {0, -0.7, 0}, {0, 0, 0.7}, {0, 0, -0.7}})}},
        {"Dodecahedron", {dodecahedron()}},
        {"Icosahedron", {icosahedron()}},
    };
    return library;
}

} // namespace editing
