// Contact points of two bodies that move in a plane.
//
// A box that slides along x has four corners on its floor, and two in the plane: those that lie
// symmetrically about it are one. A gap becomes that of pieces in the plane, which only its motion
// there changes:
//
//     across the plane    an edge, a side, a rim: the point where its axis meets the plane
//     what it crosses     an edge or a rim: the plane in which both lie
//     askew to it         crossed by an edge along the plane: the point where they cross
//
// The sides of a point (contact_sides.h) hold for where the contact is in space: with an edge
// across the plane it goes along an edge askew to it, sideways, too.
#pragma once

#include "physics/contact_rows.h"
#include "surfaces/placed.h"

#include <optional>
#include <vector>

namespace simulation {

// Bodies that move in a plane across an axis of the world, with their centres of mass at this place
// along it. Corners that lie symmetrically about the plane are one in it: so a scene in a
// plane has as few contacts as a drawing of it, and stays there.
struct MotionPlane {
    int axis = 2;
    double at = 0;
    [[nodiscard]] bool operator==(const MotionPlane&) const = default;
};

// The same points, or those that are left in the plane.
[[nodiscard]] std::vector<Vector> inPlane(const std::vector<Vector>& points,
                                          const std::optional<MotionPlane>& plane, double size);

// The contact's points, which touch at `corners`, as those in the plane; where they do not lie
// symmetrically about it, or two edges askew to it cross, they stay as they are.
void putInPlane(physics::ContactPlace& place, const std::vector<Vector>& corners,
                const MotionPlane& plane, const Placed& body, const Placed& support);

} // namespace simulation
