// Convex parts at their places, and what is said of the distance of two: by
// separation.h of flat ones and spheres, by curved_separation.h of the others.
#pragma once

#include "geometry/shape.h"

#include <cstddef>
#include <optional>

namespace collision {

using geometry::Matrix;
using geometry::Part;
using geometry::Vector;

// A part at a place: world = rotation * local + offset, from any common origin
// near both.
struct Posed {
    const Part* part = nullptr;
    Matrix rotation = Matrix::Identity();
    Vector offset = Vector::Zero();

    [[nodiscard]] Vector world(std::size_t vertex) const {
        return rotation * part->core.vertices[vertex] + offset;
    }
    // The vertex furthest along a world direction.
    [[nodiscard]] std::size_t support(const Vector& direction, std::size_t start = 0) const {
        return geometry::support(part->core, rotation.transpose() * direction, start);
    }
    // The point of the core furthest along it, whatever the part is.
    [[nodiscard]] Vector furthest(const Vector& direction) const {
        return rotation * geometry::supportPoint(*part, rotation.transpose() * direction) + offset;
    }
};

struct Separation {
    double gap = 0;                  // between the surfaces along the normal; negative: overlap
    Vector normal = Vector::UnitX(); // unit, from the second part towards the first
    double coreDistance = 0;         // upper bound of the cores' distance, 0 when they overlap
    std::size_t iterations = 0;
    bool isBlurred = false; // of curved parts: the normal is lost in rounding
    // Of a ball and a hollow part (hollow_separation.h): the ball is inside, or at the rim; where
    // they touch, halfway between the surfaces.
    bool isInside = false;
    std::optional<Vector> touch = {};
};

} // namespace collision
