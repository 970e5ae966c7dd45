// How far apart are two convex parts, and along which line?
//
// Distance by the algorithm of Gilbert, Johnson and Keerthi on the cores (a sphere is a point with
// a radius), then the best axis among the one it found and the normals of the faces beside it: any
// axis is a proof that the parts are at least so far apart, and a face's own normal has no rounding
// from the far corners of the face. Where the cores all but touch, or overlap, the line between
// closest points is lost in rounding; there all face normals and all pairs of edges that face each
// other are tried (separating axes), which gives a signed gap.
//
// LIMIT: that last search takes the product of the numbers of edges; it runs only within 1e-7 of
// the parts' size.
#pragma once

#include "geometry/shape.h"

#include <array>
#include <cstddef>
#include <vector>

namespace collision {

using geometry::Matrix;
using geometry::Part;
using geometry::Vector;

// A part at a place: world = rotation * local + offset, from any common origin near both.
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

// Pairs of vertices from the last query; the next one starts from them. Speeds up, changes nothing.
struct WarmStart {
    std::array<std::pair<std::size_t, std::size_t>, 4> pairs{};
    std::size_t count = 0;
};

struct Separation {
    double gap = 0;                  // between the surfaces along the normal; negative: overlap
    Vector normal = Vector::UnitX(); // unit, from the second part towards the first
    double coreDistance = 0;         // upper bound of the cores' distance, 0 when they overlap
    std::size_t iterations = 0;
    bool isBlurred = false; // of curved parts: the normal is lost in rounding
};

// Capsules and curved parts: curved_separation.h.
[[nodiscard]] Separation separate(const Posed& first, const Posed& second, WarmStart& warm);

// Axes along which the parts are apart, touch, or overlap by no more than `depth`: normals of faces
// and common perpendiculars of edges that face each other, each with its gap. Of two polyhedra.
[[nodiscard]] std::vector<Separation> axesOfTouch(const Posed& first, const Posed& second,
                                                  double depth);

// The signed gap by separating axes alone: exact depth and direction when the parts overlap.
[[nodiscard]] Separation separateByAxes(const Posed& first, const Posed& second);

} // namespace collision
