#include "editing/shape_library.h"

#include <cmath>
#include <numbers>

namespace editing {

using geometry::Vector;
using scene::Part;

namespace {

// To the digits that one would write oneself.
double rounded(double x) { return std::round(x * 1e4) / 1e4; }

void ring(std::vector<Vector>& points, double radius, double y, int sides) {
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        points.emplace_back(rounded(radius * std::cos(angle)), rounded(y),
                            rounded(radius * std::sin(angle)));
    }
}

Part hull(std::vector<Vector> points) {
    Part part;
    part.shape = scene::HullShape{std::move(points)};
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

Part cylinder(double radius, double height, int sides) {
    std::vector<Vector> points;
    for (const double y : {-height / 2, height / 2})
        ring(points, radius, y, sides);
    return hull(points);
}

Part capsule(double radius, double height, int sides) {
    constexpr int rings = 3;
    std::vector<Vector> points;
    for (const double end : {-1.0, 1.0}) {
        for (int k = 0; k < rings; ++k) {
            const double angle = std::numbers::pi / 2 * k / rings;
            ring(points, radius * std::cos(angle), end * (height / 2 + radius * std::sin(angle)),
                 sides);
        }
        points.emplace_back(0, rounded(end * (height / 2 + radius)), 0);
    }
    return hull(points);
}

Part tetrahedron(double size) {
    const double a = size / 2;
    return hull({{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}});
}

const std::vector<LibraryShape>& shapeLibrary() {
    static const std::vector<LibraryShape> library = {
        {"Ball", {sphere(0.5)}},
        {"Cube", {box({1, 1, 1})}},
        {"Rod", {box({4, 0.3, 0.3})}},
        {"Plate", {box({4, 0.2, 4})}},
        {"Cylinder", {cylinder(0.5, 1)}},
        {"Disc", {cylinder(1, 0.2, 24)}},
        {"Capsule", {capsule(0.3, 1)}},
        {"Tetrahedron", {tetrahedron(1)}},
        {"Octahedron",
         {hull({{0.7, 0, 0}, {-0.7, 0, 0}, {0, 0.7, 0}, {0, -0.7, 0}, {0, 0, 0.7}, {0, 0, -0.7}})}},
        {"Dodecahedron", {dodecahedron()}},
        {"Icosahedron", {icosahedron()}},
        {"Pyramid",
         {hull({{0.5, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0, -0.5}, {-0.5, 0, 0.5}, {0, 1, 0}})}},
        {"Wedge",
         {hull({{-0.5, 0, -0.5},
                {-0.5, 0, 0.5},
                {0.5, 0, -0.5},
                {0.5, 0, 0.5},
                {0.5, 0.5, -0.5},
                {0.5, 0.5, 0.5}})}},
        {"Dumbbell",
         {at(sphere(0.4), {-1, 0, 0}), at(box({2, 0.2, 0.2}), {0, 0, 0}),
          at(sphere(0.4), {1, 0, 0})}},
        {"T-handle", {box({2, 0.3, 0.3}), at(box({0.3, 1, 0.3}), {0, -0.65, 0})}},
        {"Table",
         {at(box({2, 0.1, 1.2}), {0, 1, 0}), at(box({0.1, 1, 0.1}), {-0.9, 0.45, -0.5}),
          at(box({0.1, 1, 0.1}), {0.9, 0.45, -0.5}), at(box({0.1, 1, 0.1}), {-0.9, 0.45, 0.5}),
          at(box({0.1, 1, 0.1}), {0.9, 0.45, 0.5})}},
    };
    return library;
}

} // namespace editing
