// The shape of a body: a union of parts in the body's own frame, convex but for tubes and bowls.
//
// Spheres, capsules and polyhedra are one kind of thing: a polyhedral core and a radius around it.
// The core of a sphere is its centre, that of a capsule its axis; polyhedra have radius 0. What is
// curved otherwise says so itself (curved.h); its core is its own origin.
#pragma once

#include "geometry/curved.h"
#include "geometry/hollow.h"
#include "geometry/polyhedron.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace geometry {

struct Part {
    Polyhedron core; // in the shape's frame
    double radius = 0;
    std::optional<Curved> curved = {};
    [[nodiscard]] bool isPolyhedron() const { return !core.faces.empty(); }
    [[nodiscard]] bool isSphere() const { return core.vertices.size() == 1 && !curved; }
    [[nodiscard]] bool isCapsule() const { return core.vertices.size() == 2; }
    [[nodiscard]] bool isPlane() const { return curved && curved->kind == Curved::Kind::plane; }
    // A tube or a bowl: not convex; what counts it so takes its hull.
    [[nodiscard]] bool isHollow() const { return curved && geometry::isHollow(*curved); }
    [[nodiscard]] const Vector& center() const { return core.vertices.front(); } // of a sphere
};

[[nodiscard]] Part spherePart(double radius, const Vector& center = Vector::Zero());
[[nodiscard]] Part polyhedronPart(const Polyhedron& polyhedron, const Pose& pose = {});
// The others have the pose's y as their axis. `height` of a capsule lies between the centres of its
// half spheres, and may be 0, as that of a cylinder: a disc.
[[nodiscard]] Part capsulePart(double radius, double height, const Pose& pose = {});
[[nodiscard]] Part cylinderPart(double radius, double height, const Pose& pose = {});
[[nodiscard]] Part conePart(double radius, double height, const Pose& pose = {});
[[nodiscard]] Part ellipsoidPart(const Vector& halfAxes, const Pose& pose = {});
// Their radii inside and outside. A bowl is the lower half of a shell about the pose's origin.
[[nodiscard]] Part tubePart(double inner, double outer, double height, const Pose& pose = {});
[[nodiscard]] Part bowlPart(double inner, double outer, const Pose& pose = {});
// Everything below the pose's y = 0. It has no mass and no extent: it counts as its origin.
[[nodiscard]] Part planePart(const Pose& pose = {});

// The point of the core that lies furthest along a direction; what is curved is its own core.
[[nodiscard]] Vector supportPoint(const Part& part, const Vector& direction);

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
    std::optional<std::size_t> face; // none: not of a polyhedron
};

// The nearest point at a distance >= 0 where the ray crosses into a part; none when it misses. A
// ray that starts inside a part meets that part where it leaves it.
[[nodiscard]] std::optional<RayHit> castRay(const Shape& shape, const Vector& origin,
                                            const Vector& direction);

} // namespace geometry
