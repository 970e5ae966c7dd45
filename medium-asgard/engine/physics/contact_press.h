// How two bodies press on each other at a contact that lasts, in numbers: the force that its
// multipliers make at places of the bodies.
//
// contact_rows.h has the same as expressions.
#pragma once

#include "physics/surface_gap.h"

#include <span>
#include <vector>

namespace physics {

struct ContactSurfaces {
    std::vector<SurfaceGap> gaps;    // of the contact's points
    Vector normal = Vector::UnitX(); // world, where it was made
    double friction = 0;             // coefficient while it sticks
    // Velocities of the surfaces along themselves, in each body's frame.
    Vector bodySurface = Vector::Zero(), supportSurface = Vector::Zero();
    double resolution = 0; // a way that is no longer is none
};

struct ContactPress {
    Vector normal = Vector::UnitX(); // from the support to the body, mean of the points'
    Vector point = Vector::Zero();   // centre of pressure, world
    Vector force = Vector::Zero();   // on the body, world; 0 where nothing presses
};

// `normals`: a force for each gap. `friction`: the first two act along the surfaces, a third turns
// and is not read; empty: no friction.
[[nodiscard]] ContactPress pressOf(const ContactSurfaces& surfaces, const SurfacePose& body,
                                   const SurfacePose& support, std::span<const double> normals,
                                   std::span<const double> friction);

// How fast the surfaces move along each other at one of the contact's points.
[[nodiscard]] double slipSpeedOf(const ContactSurfaces& surfaces, std::size_t point,
                                 const SurfaceMotion& body, const SurfaceMotion& support);

// The axis of the world that is most nearly across; of several the last, which a scene in a plane
// of x and y has across it.
[[nodiscard]] Vector acrossAxis(const Vector& normal);

} // namespace physics
