// Mass, centroid and inertia of a union of parts, at one density or at one for each.
//
// A polyhedron is the sum of the tetrahedra that its faces make with an inner point c. For a
// tetrahedron with corners c, c+u, c+v, c+w and volume V = u.(v x w)/6, with s = u + v + w,
//     integral of x  = V s / 4            integral of x x' = V (u u' + v v' + w w' + s s') / 20
// (coordinates from c); inertia = trace(C) 1 - C for C = integral of x x'. Parts are added about
// the common centroid (parallel axes). The integrals of what is round have closed forms.
//
// A cylinder without height is a disc, and a shape of nothing else has the masses of its areas; in
// any other shape a disc weighs nothing. A half space has no mass.
//
// LIMIT: parts that overlap count twice there.
#pragma once

#include "geometry/shape.h"

#include <span>

namespace geometry {

struct MassProperties {
    double volume = 0;
    double mass = 0;                  // of a shape of discs: density times area
    Vector centroid = Vector::Zero(); // in the shape's frame
    Matrix inertia = Matrix::Zero();  // about the centroid, along the shape's axes
};

[[nodiscard]] MassProperties massProperties(const Shape& shape, double density);
// One density for each part.
[[nodiscard]] MassProperties massProperties(const Shape& shape, std::span<const double> densities);

// The same body with another mass: inertia in proportion. Without mass before, it has no inertia.
[[nodiscard]] MassProperties scaledToMass(MassProperties properties, double mass);

} // namespace geometry
