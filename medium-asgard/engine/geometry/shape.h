// The shape of a body: a union of convex parts in the body's own frame.
//
// Spheres and polyhedra are one kind of thing: a polyhedral core and a radius around it. The core
// of a sphere is its centre; polyhedra have radius 0. Collision and mass need no other case.
#pragma once

#include "geometry/polyhedron.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace geometry {

struct Part {
    Polyhedron core; // in the shape's frame
    double radius = 0;
    [[nodiscard]] bool isSphere() const { return core.faces.empty(); }
    [[nodiscard]] const Vector& center() const { return core.vertices.front(); } // of a sphere
};

[[nodiscard]] Part spherePart(double radius, const Vector& center = Vector::Zero());
[[nodiscard]] Part polyhedronPart(const Polyhedron& polyhedron, const Pose& pose = {});

struct Shape {
    std::vector<Part> parts; // not empty
};

// How far the shape, or a part, reaches from a point of its frame.
[[nodiscard]] double radiusAbout(const Part& part, const Vector& center);
[[nodiscard]] double radiusAbout(const Shape& shape, const Vector& center);

// Axis-aligned box in the shape's frame, or in the world's at a pose.
using Box = Eigen::AlignedBox3d;
[[nodiscard]] Box bounds(const Shape& shape, const Pose& pose = {});

// Where a ray first enters the shape.
struct RayHit {
    double distance = 0; // along the direction, in its own length
    Vector point = Vector::Zero();
    Vector normal = Vector::Zero(); // outward
    std::size_t part = 0;
    std::optional<std::size_t> face; // none: a sphere
};

// The nearest point at a distance >= 0 where the ray crosses into a part; none when it misses. A
// ray that starts inside a part meets that part where it leaves it.
[[nodiscard]] std::optional<RayHit> castRay(const Shape& shape, const Vector& origin,
                                            const Vector& direction);

} // namespace geometry
